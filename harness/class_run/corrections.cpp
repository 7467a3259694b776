#include "harness/class_run/corrections.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/grade/grade_submission.h"
#include "harness/grade/reread.h"
#include "harness/machine/errors.h"
#include "harness/match/item_place.h"
#include "harness/report/text/sentences.h"
#include "harness/text/escape.h"

namespace harness {
namespace {

/// Updates the class's list as in the gradebook.
template <class Kept, class IsSame>
void replace(std::vector<Kept>& all, const Kept& kept, IsSame is_same) {
    std::erase_if(all, is_same);
    all.push_back(kept);
}

bool is_same_item(const KeptReread& kept_reread, const KeptReread& other) {
    return kept_reread.submission == other.submission && item_of(kept_reread.given) == item_of(other.given);
}

/// "line 12 has 3 numbers", or that the output has no such line.
std::string what_stands_at(const ItemPlace& place, const Transcript& transcript, const std::string& lines) {
    int last = 0;
    for (const Section& section : transcript.sections) {
        for (const PrintedLine& line : section.lines) last = std::max(last, line.number);
    }
    if (place.first_line > last) return fmt::format("the output has only {} lines", last);
    const std::size_t count = numbers_at(transcript, place);
    const bool is_one = place.first_line == place.last_line;
    return fmt::format("{} {} {} {} number{}", is_one ? "line" : "lines",
                       is_one ? std::to_string(place.first_line) : lines, is_one ? "has" : "have", count,
                       count == 1 ? "" : "s");
}

}  // namespace

void set_override(Graded& graded, const Override& given) {
    std::erase_if(graded.review.overrides,
                  [&](const Override& by_hand) { return place_of(by_hand) == place_of(given); });
    graded.review.overrides.push_back(given);
}

void set_reread(Graded& graded, const Marking& marking, const Reread& given) {
    std::erase_if(graded.submission.rereads, [&](const Reread& reread) { return item_of(reread) == item_of(given); });
    graded.submission.rereads.push_back(given);
    mark_again(graded, marking);
}

void put_override(Gradebook& gradebook, KeptClass& kept, std::size_t index, const Override& given) {
    Graded& graded = kept.graded[index];
    const auto there = points_at(graded.score, given);
    if (!there) throw UsageError(fmt::format("there is no item \"{}\" in this assignment", place_of(given)));
    const KeptOverride put{graded.submission.id, given};
    set_override(graded, given);
    gradebook.put_override(put, there->automatic, points_that_count(graded));
    replace(kept.overrides, put, [&](const KeptOverride& kept_override) { return is_same_place(kept_override, put); });
}

std::optional<std::size_t> remove_override(Gradebook& gradebook, KeptClass& kept, const KeptOverride& removed,
                                           const Author& author, const std::string& why) {
    const auto index = index_of(kept, removed.submission);
    std::optional<double> points;
    if (index) {
        Graded& graded = kept.graded[*index];
        std::erase_if(graded.review.overrides,
                      [&](const Override& by_hand) { return place_of(by_hand) == place_of(removed.given); });
        points = points_that_count(graded);
    }
    gradebook.remove_override(removed, author, why, points);
    std::erase_if(kept.overrides, [&, same = removed](const KeptOverride& kept_override) {
        return is_same_place(kept_override, same);
    });
    return index;
}

void put_reread(Gradebook& gradebook, KeptClass& kept, const Marking& marking, std::size_t index, const Reread& given) {
    Graded& graded = kept.graded[index];
    const Graded before = graded;
    const KeptReread put{graded.submission.id, given};
    printout_of(graded);  // throws if there is no output
    set_reread(graded, marking, given);
    gradebook.put_reread(put, before, graded, index);
    replace(kept.rereads, put, [&](const KeptReread& kept_reread) { return is_same_item(kept_reread, put); });
}

RemovedReread remove_reread(Gradebook& gradebook, KeptClass& kept, const Marking& marking, const KeptReread& removed,
                            const Author& author, const std::string& why) {
    RemovedReread done{index_of(kept, removed.submission), std::nullopt};
    Graded* graded = done.index ? &kept.graded[*done.index] : nullptr;
    if (graded != nullptr && counts(*graded, removed.given)) done.before = *graded;
    if (graded != nullptr) {
        std::erase_if(graded->submission.rereads,
                      [&](const Reread& reread) { return item_of(reread) == item_of(removed.given); });
    }
    if (done.before) {
        printout_of(*graded);  // throws if there is no output
        mark_again(*graded, marking);
        gradebook.remove_reread(removed, author, why, *done.before, *graded, *done.index);
    } else {
        gradebook.remove_reread(removed, author, why);
    }
    std::erase_if(kept.rereads,
                  [&, same = removed](const KeptReread& kept_reread) { return is_same_item(kept_reread, same); });
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
    throw UsageError(fmt::format("there is no item \"{}\" in this assignment", item_of(given)));
}

const std::string& printout_of(const Graded& kept) {
    if (!kept.execution.printout.empty()) return kept.execution.printout;
    throw UsageError(fmt::format(
        "{} has no stored output to read. The program printed nothing or more than {} KiB, or an older raygrade graded "
        "the class (then run grade with --apply again). To give points without an output, use `raygrade override`",
        escape_control(kept.submission.id), longest_kept_printout >> 10U));
}

void require_value(const Reread& given, const reference::ItemSpec& item, const Score& score,
                   const std::string& printout) {
    if (given.lines.empty()) return;
    const auto place = read_lines(given.lines);
    if (!place) {
        throw UsageError(fmt::format(
            "\"{}\" does not name lines of an output; write 12, 12-14, or 12:2 and 12:2-4 for some of a line's numbers",
            escape_control(given.lines)));
    }
    Transcript transcript = read_transcript(printout, last_question(score));
    const std::string there = what_stands_at(*place, transcript, given.lines);
    if (read_at(transcript, item, *place, asked_items(score))) return;
    throw UsageError(fmt::format(
        "{}: {}, but {} is needed for {}.{}. Name only the lines of this answer, or some of a line's numbers, e.g. "
        "{}:2-4. `raygrade read` shows the output with line numbers; use --none if the item was not printed",
        escape_control(given.lines), there, report::expected_shape(item.shape), given.question, given.item,
        place->first_line));
}

std::vector<std::size_t> with_layout(const KeptClass& kept, const std::string& layout) {
    std::vector<std::size_t> alike;
    for (std::size_t i = 0; i < kept.graded.size(); ++i) {
        const std::string& printout = kept.graded[i].execution.printout;
        if (!printout.empty() && layout_of(printout) == layout) alike.push_back(i);
    }
    return alike;
}

std::optional<std::size_t> index_of(const KeptClass& kept, const std::string& id) {
    const auto found = std::find_if(kept.graded.begin(), kept.graded.end(),
                                    [&](const Graded& any) { return any.submission.id == id; });
    if (found == kept.graded.end()) return std::nullopt;
    return static_cast<std::size_t>(found - kept.graded.begin());
}

}  // namespace harness
