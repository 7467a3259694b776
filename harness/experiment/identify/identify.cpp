#include "harness/experiment/identify/identify.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "harness/experiment/identify/search.h"
#include "harness/experiment/identify/verdict.h"

namespace harness::experiment {
namespace {

using reference::ItemId;
using reference::ItemSpec;
using reference::Shape;

/// "Line 14 was read as t because it changes as t does on 2 other scenes."
std::string note_of(const ItemPlace& place, std::size_t scenes) {
    const std::string on_scenes = scenes == 1 ? "another scene" : fmt::format("{} other scenes", scenes);
    if (place.first_line == 0 && !place.as_read)
        return fmt::format("Nothing printed changes as {} does on {}.", place.item, on_scenes);
    if (place.as_read) return fmt::format("No other number changes as {} does on {}.", place.item, on_scenes);
    const bool is_one = place.first_line == place.last_line;
    return fmt::format("{} read as {} because {} as {} does on {}.",
                       is_one ? fmt::format("Line {} was", place.first_line)
                              : fmt::format("Lines {}-{} were", place.first_line, place.last_line),
                       place.item, is_one ? "it changes" : "they change", place.item, on_scenes);
}

ItemPlace place_of(const ItemSpec& item) {
    ItemPlace place;
    place.question = item.question;
    place.item = item.name;
    place.by_experiment = true;
    return place;
}

std::vector<ItemSpec> items_of(const reference::AnswerKey& key) {
    std::vector<ItemSpec> items;
    for (const reference::KeyQuestion& question : key.questions) {
        for (const reference::KeyItem& item : question.items) items.push_back(item.spec);
    }
    return items;
}

class Identifier {
  public:
    Identifier(const OwnRun& own, std::span<const Observation> others, const Slots& slots)
        : own_(own),
          others_(others),
          slots_(slots),
          items_(items_of(others.front().key)),
          words_(own.transcript, own.matched, slots, items_),
          claims_(slots, others, items_),
          search_(slots, items_, words_, claims_) {
        for_each_item(own.score, [&](const ItemScore& item) {
            if (may_be_settled(item)) open_.insert(item.spec.id);
        });
    }

    ExperimentReport run() {
        for_each_item(own_.score, [&](const ItemScore& item) {
            const bool is_right = item.verdict == ItemVerdict::right && !open_.contains(item.spec.id);
            if (is_right && !may_be_right_by_luck(item.spec)) take_as_read(item.spec);
        });
        find_right_items();
        // An item that was read without a doubt is elsewhere if its number belongs to another item.
        for_each_item(own_.score, [&](const ItemScore& item) {
            if (item.doubt || claims_.of(item.spec.id) != nullptr || take_as_read(item.spec)) return;
            if (item.verdict != ItemVerdict::right) {
                open_.insert(item.spec.id);
            } else {
                search_.find_right(item.spec);
            }
        });
        find_right_items();
        for (const ItemSpec& item : items_) {
            if (item.shape == Shape::first_object) continue;
            if (is_open(item)) search_.find_derived(item);
            if (is_open(item) && is_last_open(item)) search_.find_rest(item);
        }
        for (const ItemSpec& item : items_) {
            if (is_open(item) && item.shape == Shape::scalar) search_.find_constant(item);
        }
        return conclude();
    }

  private:
    bool is_open(const ItemSpec& item) const { return open_.contains(item.id) && claims_.of(item.id) == nullptr; }

    /// Whether every other item of the question is settled.
    bool is_last_open(const ItemSpec& item) const {
        return std::ranges::none_of(items_, [&](const ItemSpec& other) {
            return other.question == item.question && other.id != item.id && is_open(other);
        });
    }

    /// Whether the item was matched only by order, to numbers that are not right on other scenes.
    bool may_be_right_by_luck(const ItemSpec& item) {
        const MatchedItem* read = words_.value_of(item.id);
        return read != nullptr && read->by_order &&
               !claims_.is_right(item, {words_.slots_of(*read->value), read->order});
    }

    /// Claims the numbers that were read for the item. False if they belong to another item.
    bool take_as_read(const ItemSpec& item) {
        const MatchedItem* read = words_.value_of(item.id);
        if (read == nullptr) return true;
        std::vector<std::size_t> slots = words_.slots_of(*read->value);
        if (claims_.is_used(slots)) return false;
        if (!slots.empty()) claims_.add(item, {std::move(slots), read->order}, Evidence::right);
        return true;
    }

    void find_right_items() {
        for (const Shape shape : {Shape::matrix4, Shape::matrix3, Shape::vector, Shape::scalar}) {
            for (const ItemSpec& item : items_) {
                if (item.shape == shape && is_open(item)) search_.find_right(item);
            }
        }
    }

    ItemPlace found_at(const ItemSpec& item, const Candidate& candidate) const {
        ItemPlace place = place_of(item);
        for (const std::size_t slot : candidate.slots) {
            place.numbers.push_back(slots_.numbers[slot].place);
            place.numbers.back().is_negated = candidate.is_negated(slots_.numbers[slot].own);
        }
        const auto [first, last] = std::ranges::minmax(place.numbers);
        place.first_line = first.line;
        place.last_line = last.line;
        place.order = candidate.order;
        return place;
    }

    /// Whether the program prints something else for the question than on other scenes, as if the ray missed: an answer
    /// that is not found there may be printed here.
    bool is_printed_otherwise(const ItemSpec& item) const {
        return words_.has_heading(item.question) ? slots_.differing.contains(item.question) : !slots_.differing.empty();
    }

    /// Whether nothing states the order of a matrix, it is right only column by column, and nothing that is computed
    /// with it is right: the program may have printed it row by row, so that it is the transpose.
    bool is_of_unknown_order(const ItemSpec& item, const Claim& claim) {
        if (side_of(item.shape) == 1 || claim.candidate.order != MatrixOrder::unsaid) return false;
        Candidate by_rows = claim.candidate;
        by_rows.order = MatrixOrder::rows;
        if (claims_.is_right(item, by_rows)) return false;
        return std::ranges::none_of(items_, [&](const ItemSpec& other) {
            const Claim* of_other = depends_on(other.id, {item.id}) ? claims_.of(other.id) : nullptr;
            return of_other != nullptr && claims_.is_right(other, of_other->candidate);
        });
    }

    /// Whether the item has another candidate: a number that belongs to no other item, on the same line, with the same
    /// name, or unnamed in a line of the same layout that has more such numbers than open items.
    bool is_one_of_several(const ItemSpec& item, const Claim& claim) {
        const std::size_t first = claim.candidate.slots.front();
        const Slot& own = slots_.numbers[first];
        const LabelFit own_fit = words_.fit(first, item);
        const auto is_open_alike = [&](const ItemSpec& other) {
            const bool may_be_there = other.question == item.question || !words_.has_heading(item.question);
            return may_be_there && other.shape == item.shape && is_open(other);
        };
        const std::ptrdiff_t open =
            std::ranges::count_if(items_, is_open_alike) * static_cast<std::ptrdiff_t>(size_of(item.shape));
        std::ptrdiff_t of_same_layout = 0;
        for (std::size_t slot = 0; slot < slots_.numbers.size(); ++slot) {
            const Slot& other = slots_.numbers[slot];
            const bool is_again = other.own.number.value == own.own.number.value;
            if (claims_.is_used(slot) || !other.moves() || is_again) continue;
            if (std::ranges::any_of(claim.candidate.slots, [&](std::size_t of_claim) {
                    return slots_.numbers[of_claim].place.line == other.place.line;
                }))
                return true;
            const LabelFit least = own_fit >= LabelFit::named ? LabelFit::named : LabelFit::weak;
            if (own_fit >= LabelFit::weak && words_.fit(slot, item) >= least && words_.may_be_named_at(slot, item))
                return true;
            const bool is_alike = other.question == own.question && other.layout == own.layout;
            of_same_layout += own_fit < LabelFit::weak && is_alike ? 1 : 0;
        }
        return of_same_layout > open;
    }

    /// For an item that was read without a doubt: the line on which another number has the item's name, if the number
    /// that was read does not; or its own line, if that says that it is not an answer. 0 if there is none.
    int line_of_better_name(const ItemSpec& item) {
        const Claim* claim = claims_.of(item.id);
        if (open_.contains(item.id) || claim == nullptr || side_of(item.shape) > 1) return 0;
        const std::size_t first = claim->candidate.slots.front();
        if (words_.is_no_answer(first, item)) return slots_.numbers[first].place.line;
        if (words_.fit(first, item) >= LabelFit::named) return 0;
        for (std::size_t slot = 0; slot < slots_.numbers.size(); ++slot) {
            const Slot& other = slots_.numbers[slot];
            if (claims_.is_used(slot) || !other.moves()) continue;
            if (words_.fit(slot, item) >= LabelFit::named && words_.may_be_named_at(slot, item))
                return other.place.line;
        }
        return 0;
    }

    /// Whether it is certain that nothing else was printed for the item.
    bool is_all_there(const ItemSpec& item) {
        if (item.shape == Shape::first_object || search_.is_left_for(item) || search_.may_be_constant(item))
            return false;
        if (is_printed_otherwise(item) || depends_on(item.id, unknown_)) return false;
        const ItemId t{item.id.subject, "t"};
        if (may_be_absent(item) && claims_.of(t) == nullptr) return false;  // words may say that the ray misses
        const MatchedItem* read = words_.value_of(item.id);
        if (read == nullptr) return true;
        return !read->value->numbers.empty() && !claims_.is_used(words_.slots_of(*read->value));
    }

    /// Where the item is; empty if the runs do not show it.
    std::optional<ItemPlace> place_shown(const ItemSpec& item) {
        ItemPlace place = place_of(item);
        if (!open_.contains(item.id)) {
            place.as_read = true;
            return place;
        }
        if (item.shape == Shape::first_object) {
            auto verdict = find_verdict(item, slots_, others_, claims_, words_);
            if (!verdict) return std::nullopt;
            place.first_line = verdict->first_line;
            place.last_line = verdict->last_line;
            place.first_object = verdict->first_object;
            return place;
        }
        if (const Claim* claim = claims_.of(item.id)) {
            if (is_of_unknown_order(item, *claim) || is_one_of_several(item, *claim)) return std::nullopt;
            return found_at(item, claim->candidate);
        }
        if (!is_all_there(item)) return std::nullopt;
        place.as_read = words_.value_of(item.id) != nullptr;
        return place;
    }

    ExperimentReport conclude() {
        ExperimentReport report;
        for_each_item(own_.score, [&](const ItemScore& scored) {
            const ItemSpec& item = scored.spec;
            if (auto place = place_shown(item)) {
                if (may_be_settled(scored) || !place->as_read) place->note = note_of(*place, others_.size());
                report.places.push_back(std::move(*place));
            } else {
                unknown_.insert(item.id);
            }
            if (const int line = line_of_better_name(item); line != 0)
                report.doubts.push_back(
                    {item.question, std::string(item.name), {Doubt::Why::another_answer, line}, std::nullopt});
            if (!may_be_settled(scored)) return;
            // If the answer is wrong here, an answer that it follows from may be unread, or the lines may be paired
            // wrongly.
            const Claim* claim = claims_.of(item.id);
            const bool is_unexplained = claim != nullptr && claim->evidence == Evidence::rest;
            if (unknown_.contains(item.id) || is_unexplained || depends_on(item.id, unknown_) ||
                is_printed_otherwise(item)) {
                report.doubts.push_back({item.question, std::string(item.name), *scored.doubt, scored.layout_doubt});
            }
        });
        report.mistakes = claims_.mistakes();
        if (!report.doubts.empty()) report.unsettled = "they do not show which answer was meant";
        return report;
    }

    const OwnRun& own_;
    std::span<const Observation> others_;
    const Slots& slots_;
    std::vector<ItemSpec> items_;
    PrintedWords words_;
    Claims claims_;
    Search search_;
    std::set<ItemId> open_;     ///< the doubtful items, and those that were misread after all
    std::set<ItemId> unknown_;  ///< items that may be in the output, but nothing shows where
};

}  // namespace

bool may_be_settled(const ItemScore& item) {
    return item.doubt && item.doubt->why != Doubt::Why::another_answer && item.doubt->why != Doubt::Why::by_columns;
}

ExperimentReport identify(const OwnRun& own, std::span<const Observation> others) {
    std::vector<Observation> alike;  // where the program prints the same lines
    std::vector<const Transcript*> transcripts;
    for (const Observation& other : others) {
        const Transcript* only[] = {&other.transcript};
        if (!slots_of(own.transcript, only)) continue;
        alike.push_back(other);
        transcripts.push_back(&other.transcript);
    }
    const auto slots = slots_of(own.transcript, transcripts);
    ExperimentReport nothing;
    if (alike.empty() || !slots) {
        nothing.unsettled = "its output has different lines on other scenes";
        return nothing;
    }
    if (std::ranges::none_of(slots->numbers, &Slot::moves)) {
        nothing.unsettled = "the program prints the same numbers on every scene";
        return nothing;
    }
    return Identifier(own, alike, *slots).run();
}

}  // namespace harness::experiment
