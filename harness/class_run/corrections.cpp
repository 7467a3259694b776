#include "harness/class_run/corrections.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/class_run/kept_printout.h"
#include "harness/grade/grade_submission.h"
#include "harness/machine/errors.h"

namespace harness {
namespace {

/// Keeps the class's lists of what is in force as the gradebook has them.
template <class Kept, class IsSame>
void replace(std::vector<Kept>& all, const Kept& kept, IsSame is_same) {
    std::erase_if(all, is_same);
    all.push_back(kept);
}

bool is_same_item(const KeptReread& one, const KeptReread& other) {
    return one.submission == other.submission && item_of(one.given) == item_of(other.given);
}

}  // namespace

void set_override(Graded& one, const Override& given) {
    std::erase_if(one.review.overrides, [&](const Override& each) { return place_of(each) == place_of(given); });
    one.review.overrides.push_back(given);
}

void set_reread(Graded& one, const Marking& marking, const Reread& given) {
    std::erase_if(one.submission.rereads, [&](const Reread& each) { return item_of(each) == item_of(given); });
    one.submission.rereads.push_back(given);
    mark_again(one, marking);
}

void put_override(Gradebook& gradebook, KeptClass& kept, std::size_t index, const Override& given) {
    Graded& one = kept.graded[index];
    const auto there = points_at(one.score, given);
    if (!there) throw UsageError(fmt::format("{}: is no item of this assignment", place_of(given)));
    const KeptOverride put{one.submission.id, given};
    set_override(one, given);
    gradebook.put_override(put, there->automatic, points_that_count(one));
    replace(kept.overrides, put, [&](const KeptOverride& each) { return is_same_place(each, put); });
}

std::optional<std::size_t> remove_override(Gradebook& gradebook, KeptClass& kept, const KeptOverride& removed,
                                           const Author& author, const std::string& why) {
    const auto index = index_of(kept, removed.submission);
    std::optional<double> points;
    if (index) {
        Graded& one = kept.graded[*index];
        std::erase_if(one.review.overrides,
                      [&](const Override& each) { return place_of(each) == place_of(removed.given); });
        points = points_that_count(one);
    }
    gradebook.remove_override(removed, author, why, points);
    std::erase_if(kept.overrides, [&, same = removed](const KeptOverride& each) { return is_same_place(each, same); });
    return index;
}

void put_reread(Gradebook& gradebook, KeptClass& kept, const Marking& marking, std::size_t index, const Reread& given) {
    Graded& one = kept.graded[index];
    const Graded before = one;
    const KeptReread put{one.submission.id, given};
    printout_of(one);  // throws if it is not kept
    set_reread(one, marking, given);
    gradebook.put_reread(put, before, one, index);
    replace(kept.rereads, put, [&](const KeptReread& each) { return is_same_item(each, put); });
}

RemovedReread remove_reread(Gradebook& gradebook, KeptClass& kept, const Marking& marking, const KeptReread& removed,
                            const Author& author, const std::string& why) {
    RemovedReread done{index_of(kept, removed.submission), std::nullopt};
    Graded* one = done.index ? &kept.graded[*done.index] : nullptr;
    if (one != nullptr && counts(*one, removed.given)) done.before = *one;
    if (one != nullptr) {
        std::erase_if(one->submission.rereads,
                      [&](const Reread& each) { return item_of(each) == item_of(removed.given); });
    }
    if (done.before) {
        printout_of(*one);  // throws if it is not kept
        mark_again(*one, marking);
        gradebook.remove_reread(removed, author, why, *done.before, *one, *done.index);
    } else {
        gradebook.remove_reread(removed, author, why);
    }
    std::erase_if(kept.rereads, [&, same = removed](const KeptReread& each) { return is_same_item(each, same); });
    return done;
}

std::string item_of(const Reread& given) {
    return fmt::format("{}.{}", given.question, given.item);
}

const ItemScore& item_score(const Graded& graded, const Reread& given) {
    for (const QuestionScore& question : graded.score.questions) {
        for (const ItemScore& item : question.items) {
            if (question.number == given.question && item.spec.name == given.item) return item;
        }
    }
    throw UsageError(fmt::format("{}: is no item of this assignment", item_of(given)));
}

std::optional<std::size_t> index_of(const KeptClass& kept, const std::string& id) {
    const auto found = std::find_if(kept.graded.begin(), kept.graded.end(),
                                    [&](const Graded& any) { return any.submission.id == id; });
    if (found == kept.graded.end()) return std::nullopt;
    return static_cast<std::size_t>(found - kept.graded.begin());
}

}  // namespace harness
