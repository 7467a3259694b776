#include "harness/experiment/identify/identify.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "harness/experiment/identify/slots.h"
#include "harness/mark/compare/key_targets.h"
#include "harness/mark/diagnose/derivations.h"
#include "harness/mark/score/gather.h"
#include "harness/mark/score/mark_transcript.h"
#include "harness/match/question_match.h"

namespace harness::experiment {
namespace {

using reference::ItemId;
using reference::ItemSpec;
using reference::Shape;

/// Slots that may be an item, in the order of its components.
struct Candidate {
    std::vector<std::size_t> slots;
    MatrixOrder order = MatrixOrder::unsaid;  ///< as the printout states it
    bool takes_signs = false;                 ///< a minus sign that is apart from a number's digits belongs to it

    bool is_negated(const NumberOfLine& number) const {
        return number.minus == MinusBefore::glued || (takes_signs && number.minus == MinusBefore::apart);
    }
};

/// How the numbers of a block may lie among all numbers: `step` from one to the next, `row` from one row to the next.
struct Pattern {
    std::size_t step;
    std::size_t row;
};

std::size_t side_of(Shape shape) {
    return shape == Shape::matrix4 ? 4 : shape == Shape::matrix3 ? 3 : 1;
}

std::size_t size_of(Shape shape) {
    return static_cast<std::size_t>(reference::component_count(shape));
}

/// Numbers may have others between them: indices, components of a neighbor in a table.
std::vector<Pattern> patterns_of(Shape shape, std::size_t widest, std::size_t widest_in_matrix,
                                 std::size_t most_between_rows) {
    std::vector<Pattern> patterns;
    if (shape == Shape::scalar) return {{1, 1}};
    if (shape == Shape::vector) {
        for (std::size_t step = 1; step <= widest; ++step) patterns.push_back({step, 3 * step});
        return patterns;
    }
    const std::size_t side = side_of(shape);
    for (std::size_t step = 1; step <= widest_in_matrix; ++step) {
        for (std::size_t between = 0; between <= most_between_rows; ++between)
            patterns.push_back({step, side * step + between});
    }
    return patterns;
}

template <class Visit>
void for_each_item(const Score& score, Visit visit) {
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) visit(item);
    }
}

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

/// Where the words at the beginning of a line end.
std::size_t begin_of_numbers(std::string_view line) {
    const std::size_t digit = std::min(line.find_first_of("0123456789"), line.size());
    return digit > 0 && (line[digit - 1] == '-' || line[digit - 1] == '+') ? digit - 1 : digit;
}

std::vector<Pattern> all_patterns(Shape shape) {
    return patterns_of(shape, 16, 4, 8);
}

/// Those that are tried for wrong answers.
std::vector<Pattern> common_patterns(Shape shape) {
    return patterns_of(shape, 4, 2, 1);
}

/// What a claim rests on.
enum class Evidence { right, follows, named_mistake, rest };

struct Claim {
    Candidate candidate;
    Evidence evidence = Evidence::right;
};

class Identifier {
  public:
    Identifier(const OwnRun& own, std::span<const Observation> others, const Slots& slots)
        : own_(own),
          others_(others),
          slots_(slots.numbers),
          lines_(slots.lines),
          differing_(slots.differing),
          used_(slots_.size(), false) {
        for (const reference::KeyQuestion& question : others.front().key.questions) {
            for (const reference::KeyItem& item : question.items) items_.push_back(item.spec);
        }
        fits_.emplace(items_);
        for_each_item(own.score, [&](const ItemScore& item) {
            (may_be_settled(item) ? doubtful_ : settled_).insert(item.spec.id);
            if (may_be_settled(item)) doubted_.insert({item.spec.question, std::string(item.spec.name)});
            if (!item.doubt && item.verdict == ItemVerdict::wrong) wrong_.insert(item.spec.id);
        });
        for (const Section& section : own.transcript.sections) headings_.insert(section.question);
        find_labels();
    }

    ExperimentReport run() {
        for (const MatchedItem& item : own_.matched) {
            if (settled_.contains(item.spec.id) && !wrong_.contains(item.spec.id)) take_as_read(item);
        }
        claim_right_items();
        const std::size_t doubtful = doubtful_.size();
        for (const MatchedItem& item : own_.matched) {
            if (wrong_.contains(item.spec.id) && !take_as_read(item)) doubtful_.insert(item.spec.id);
        }
        if (doubtful_.size() > doubtful) claim_right_items();
        for (const ItemSpec& item : items_) {
            if (is_open(item) && item.shape != Shape::first_object) claim_derived(item);
            if (is_open(item) && item.shape != Shape::first_object) claim_rest(item);
        }
        for (const ItemSpec& item : items_) {
            if (is_open(item) && item.shape == Shape::scalar) claim_constant(item);
            if (is_open(item) && item.shape == Shape::first_object) verdict_ = find_verdict(item);
        }
        return conclude();
    }

  private:
    void claim_right_items() {
        for (const Shape shape : {Shape::matrix4, Shape::matrix3, Shape::vector, Shape::scalar}) {
            for (const ItemSpec& item : items_) {
                if (item.shape == shape && is_open(item)) claim_right(item);
            }
        }
    }

    // What the printout says of its numbers.

    void find_labels() {
        labels_.assign(slots_.size(), nullptr);
        for (const Section& section : own_.transcript.sections) {
            for (const PrintedValue& value : section.values) {
                for (const std::size_t slot : slots_of(value)) labels_[slot] = &value;
            }
        }
    }

    /// The slots that a value was read from; empty if they can't be told.
    std::vector<std::size_t> slots_of(const PrintedValue& value) const {
        std::vector<std::size_t> found;
        auto slot = std::ranges::lower_bound(slots_, value.line, {}, [](const Slot& s) { return s.place.line; });
        for (const PrintedNumber& number : value.numbers) {
            while (slot != slots_.end() && slot->place.line <= value.last_line &&
                   slot->own.number.value != number.value)
                ++slot;
            if (slot == slots_.end() || slot->place.line > value.last_line) return {};
            found.push_back(static_cast<std::size_t>(slot - slots_.begin()));
            ++slot;
        }
        return found;
    }

    LabelFit fit(std::size_t slot, const ItemSpec& item) {
        return labels_[slot] == nullptr ? LabelFit::none : (*fits_)(*labels_[slot], item);
    }

    /// Whether the words of the number's line, or its label, say that it is no answer. The rows of a matrix have labels
    /// of their own: "B" is no corner of the triangle.
    bool is_no_answer(std::size_t slot, const ItemSpec& item) {
        const int line = slots_[slot].place.line;
        const auto [known, is_new] = no_answer_.try_emplace(line, false);
        for (const LineOnScenes& on_scenes : lines_) {
            if (is_new && on_scenes.own.number == line)
                known->second = known->second || says_no_answer(on_scenes.own.text);
        }
        const PrintedValue* value = side_of(item.shape) > 1 ? nullptr : labels_[slot];
        return known->second || (value != nullptr && (says_no_answer(value->label) || says_no_answer(value->above)));
    }

    /// Whether words say that the number is not this item's.
    bool is_barred(std::size_t slot, const ItemSpec& item) {
        if (is_no_answer(slot, item)) return true;
        if (side_of(item.shape) > 1) return false;
        if (labels_[slot] == nullptr || fit(slot, item) == LabelFit::exact) return false;
        return std::ranges::any_of(items_, [&](const ItemSpec& other) {
            return other.question == item.question && other.id != item.id && has_shape(*labels_[slot], other) &&
                   fit(slot, other) == LabelFit::exact;
        });
    }

    /// The lines of the number that the item's own name stands before; another number can't be meant then. Where the
    /// question has no heading, the name of another question's item may be the same.
    std::optional<std::pair<int, int>> named_lines(const ItemSpec& item) {
        const MatchedItem* matched = matched_to(item.id);
        if (matched == nullptr || !matched->value || matched->unreadable) return std::nullopt;
        const LabelFit own = (*fits_)(*matched->value, item);
        if (own < LabelFit::named) return std::nullopt;
        const bool is_ambiguous =
            !headings_.contains(item.question) && std::ranges::any_of(items_, [&](const ItemSpec& other) {
                return other.id != item.id && (*fits_)(*matched->value, other) >= own;
            });
        if (is_ambiguous) return std::nullopt;
        return std::pair(matched->value->line, matched->value->last_line);
    }

    /// The order that the labels of a matrix's rows state, or that of the value which was read from these numbers.
    MatrixOrder stated_order(const std::vector<std::size_t>& slots, const ItemSpec& item) {
        const MatchedItem* matched = matched_to(item.id);
        if (matched != nullptr && matched->value && slots_of(*matched->value) == slots) return matched->order;
        const int first = slots_[slots.front()].place.line, last = slots_[slots.back()].place.line;
        for (const LineOnScenes& line : lines_) {
            if (line.own.number < first - 1 || last < line.own.number) continue;
            const std::string_view words = std::string_view(line.own.text).substr(0, begin_of_numbers(line.own.text));
            if (const MatrixOrder order = matrix_order(words); order != MatrixOrder::unsaid) return order;
            const auto row = read_row_label(words.substr(0, words.find_last_not_of(" \t:=") + 1));
            if (row && row->is_certain && row->order != MatrixOrder::unsaid) return row->order;
        }
        return MatrixOrder::unsaid;
    }

    const MatchedItem* matched_to(const ItemId& id) const {
        const auto found =
            std::ranges::find_if(own_.matched, [&](const MatchedItem& item) { return item.spec.id == id; });
        return found == own_.matched.end() ? nullptr : &*found;
    }

    // Claims.

    bool is_open(const ItemSpec& item) const { return doubtful_.contains(item.id) && !claims_.contains(item.id); }

    void claim(const ItemSpec& item, Candidate candidate, Evidence evidence) {
        for (const std::size_t slot : candidate.slots) used_[slot] = true;
        claims_[item.id] = {std::move(candidate), evidence};
    }

    /// Claims the numbers that were read for a settled item. False if they were found to be another item's.
    bool take_as_read(const MatchedItem& item) {
        if (!item.value || item.unreadable) return true;
        std::vector<std::size_t> slots = slots_of(*item.value);
        if (std::ranges::any_of(slots, [&](std::size_t slot) { return used_[slot]; })) return false;
        if (!slots.empty()) claim(item.spec, {std::move(slots), item.order}, Evidence::right);
        return true;
    }

    MatchedItem on_scene(std::size_t scene, const ItemSpec& item, const Candidate& candidate) const {
        MatchedItem matched{item, PrintedValue(), candidate.order, {}, false, {}};
        for (const std::size_t slot : candidate.slots) {
            const NumberOfLine& on_scene = slots_[slot].numbers[scene];
            matched.value->numbers.push_back(on_scene.number);
            if (candidate.is_negated(on_scene)) matched.value->numbers.back().value = -on_scene.number.value;
            matched.value->line = slots_[slot].place.line;
        }
        matched.value->last_line = matched.value->line;
        return matched;
    }

    std::vector<MatchedItem> all_on_scene(std::size_t scene) const {
        std::vector<MatchedItem> matched;
        for (const ItemSpec& item : items_) {
            const auto claim = claims_.find(item.id);
            if (claim != claims_.end()) matched.push_back(on_scene(scene, item, claim->second.candidate));
        }
        return matched;
    }

    bool is_right(std::size_t scene, const ItemSpec& item, const Candidate& candidate) {
        return is_right(scene, on_scene(scene, item, candidate));
    }

    bool is_right(std::size_t scene, const MatchedItem& printed) {
        const ItemSpec& item = printed.spec;
        const Observation& other = others_[scene];
        auto& targets = targets_[scene][item.id];
        const reference::KeyItem& key = *reference::asked_item(other.key, item.id);
        if (targets.empty()) {
            for (const reference::Answer& answer : key.answers)
                targets.push_back(target_with_allowance(key, answer, other.assignment.rubric));
        }
        return std::ranges::any_of(targets, [&](const Target& target) {
            return !target.no_value && compare(printed, target, 0, other.assignment.rubric.min_decimals).within;
        });
    }

    bool is_right_everywhere(const ItemSpec& item, const Candidate& candidate) {
        for (std::size_t scene = 0; scene < others_.size(); ++scene) {
            if (!is_right(scene, item, candidate)) return false;
        }
        return true;
    }

    bool moves(const Candidate& candidate) const {
        return std::ranges::any_of(candidate.slots, [&](std::size_t slot) { return slots_[slot].moves(); });
    }

    /// 0 under the heading of the item's question; more for places where it is less expected.
    int distance_from_question(const Candidate& candidate, const ItemSpec& item) const {
        int farthest = 0;
        for (const std::size_t slot : candidate.slots) {
            const int question = slots_[slot].question;
            const int distance = question == item.question ? 0 : headings_.contains(item.question) ? 2 : 1;
            farthest = std::max(farthest, distance);
        }
        return farthest;
    }

    /// Calls `then` for each block of free numbers of the item's shape that words do not bar.
    template <class Then>
    void for_each_candidate(const ItemSpec& item, std::span<const Pattern> patterns, Then then) {
        const std::size_t size = size_of(item.shape), side = side_of(item.shape);
        const auto named = named_lines(item);
        for (std::size_t first = 0; first < slots_.size(); ++first) {
            if (used_[first]) continue;
            for (const auto& [step, row] : patterns) {
                Candidate candidate;
                for (std::size_t i = 0; i < size; ++i) {
                    const std::size_t slot =
                        item.shape == Shape::vector ? first + i * step : first + i / side * row + i % side * step;
                    if (slot >= slots_.size() || used_[slot]) break;
                    candidate.slots.push_back(slot);
                }
                if (candidate.slots.size() < size) continue;
                const bool is_elsewhere = named && std::ranges::any_of(candidate.slots, [&](std::size_t slot) {
                                              const int line = slots_[slot].place.line;
                                              return line < named->first || named->second < line;
                                          });
                if (is_elsewhere) continue;
                if (has_only_dashes(candidate)) then(candidate);
                candidate.takes_signs = has_signs_apart(candidate);
                if (candidate.takes_signs) then(candidate);
            }
        }
    }

    bool has_sign_apart(std::size_t slot) const {
        return slots_[slot].own.minus == MinusBefore::apart ||
               std::ranges::any_of(slots_[slot].numbers,
                                   [](const NumberOfLine& number) { return number.minus == MinusBefore::apart; });
    }

    bool has_signs_apart(const Candidate& candidate) const {
        return std::ranges::any_of(candidate.slots, [&](std::size_t slot) { return has_sign_apart(slot); });
    }

    /// Whether each minus sign apart is a dash behind a label: the reader took the number without it.
    bool has_only_dashes(const Candidate& candidate) const {
        return std::ranges::all_of(candidate.slots,
                                   [&](std::size_t slot) { return !has_sign_apart(slot) || labels_[slot] != nullptr; });
    }

    bool is_barred(const Candidate& candidate, const ItemSpec& item) {
        return std::ranges::any_of(candidate.slots, [&](std::size_t slot) { return is_barred(slot, item); });
    }

    void claim_right(const ItemSpec& item) {
        using Rank = std::tuple<int, int, int, std::size_t>;
        std::optional<std::pair<Rank, Candidate>> best;
        for_each_candidate(item, all_patterns(item.shape), [&](Candidate& candidate) {
            if (!is_right(0, item, candidate)) return;
            if (size_of(item.shape) > 3) candidate.order = stated_order(candidate.slots, item);
            if (!moves(candidate) || !is_right_everywhere(item, candidate) || is_barred(candidate, item)) return;
            const int lines = slots_[candidate.slots.back()].place.line - slots_[candidate.slots.front()].place.line;
            const int by_name = fit(candidate.slots.front(), item) >= LabelFit::weak ? 0 : 1;
            const Rank rank{distance_from_question(candidate, item), by_name, lines, candidate.slots.front()};
            if (!best || rank < best->first) best = {rank, candidate};
        });
        if (best) claim(item, std::move(best->second), Evidence::right);
    }

    /// What the candidate is on every scene, given the items that were found before; empty if it is nothing on one, or
    /// not the same on all.
    std::optional<Evidence> evidence_of(const ItemSpec& item, const Candidate& candidate) const {
        std::optional<ItemScore> first;
        for (std::size_t scene = 0; scene < others_.size(); ++scene) {
            std::vector<MatchedItem> matched = all_on_scene(scene);
            matched.push_back(on_scene(scene, item, candidate));
            const Score score = mark_answers(matched, others_[scene].key, others_[scene].assignment);
            for (const QuestionScore& question : score.questions) {
                for (const ItemScore& scored : question.items) {
                    if (scored.spec.id != item.id) continue;
                    const bool is_something = scored.verdict == ItemVerdict::right ||
                                              scored.verdict == ItemVerdict::follow || !scored.diagnosis.empty();
                    if (!is_something || scored.diagnosis == "too few decimals") return std::nullopt;
                    if (first && (first->verdict != scored.verdict || first->diagnosis != scored.diagnosis))
                        return std::nullopt;
                    first = scored;
                }
            }
        }
        if (!first) return std::nullopt;
        return first->verdict == ItemVerdict::right    ? Evidence::right
               : first->verdict == ItemVerdict::follow ? Evidence::follows
                                                       : Evidence::named_mistake;
    }

    /// Claims a value that is right in another form, follows, or is what a named mistake gives. Only numbers under the
    /// heading of the question are tried, because there are many ways to be wrong.
    void claim_derived(const ItemSpec& item) {
        std::vector<Candidate> candidates;
        if (const MatchedItem* matched = matched_to(item.id); matched != nullptr && matched->value) {
            const auto slots = slots_of(*matched->value);
            const bool is_free = std::ranges::none_of(slots, [&](std::size_t slot) { return used_[slot]; });
            if (slots.size() == size_of(item.shape) && is_free) candidates.push_back({slots, matched->order});
        }
        for_each_candidate(item, common_patterns(item.shape), [&](Candidate& candidate) {
            if (distance_from_question(candidate, item) > 1 || !moves(candidate)) return;
            if (size_of(item.shape) > 3) candidate.order = stated_order(candidate.slots, item);
            candidates.push_back(candidate);
        });
        constexpr std::size_t most = 120;
        if (candidates.size() > most) candidates.resize(most);
        std::optional<std::pair<Evidence, Candidate>> best;
        for (Candidate& candidate : candidates) {
            if (is_barred(candidate, item) || !moves(candidate)) continue;
            const auto evidence = evidence_of(item, candidate);
            if (evidence && (!best || *evidence < best->first)) best = {*evidence, std::move(candidate)};
        }
        if (best) claim(item, std::move(best->second), best->first);
    }

    /// Claims what is left under the heading of the question, if it has the item's shape and the question has no other
    /// open item. Nothing explains it, but what is computed with it may follow from it.
    void claim_rest(const ItemSpec& item) {
        const auto is_open_too = [&](const ItemSpec& other) {
            return other.question == item.question && other.id != item.id && is_open(other);
        };
        if (side_of(item.shape) > 1 || !headings_.contains(item.question)) return;
        if (std::ranges::any_of(items_, is_open_too)) return;
        Candidate rest;
        const auto [first, last] = extent_of(item);
        for (std::size_t slot = first; slot < last; ++slot) {
            if (!used_[slot] && !is_no_answer(slot, item)) rest.slots.push_back(slot);
        }
        if (rest.slots.size() != size_of(item.shape) || !moves(rest)) return;
        rest.takes_signs = !has_only_dashes(rest);
        claim(item, std::move(rest), Evidence::rest);
    }

    /// Claims a number that is the same on every scene, as a = 1 is: beside the number of the item before it or behind
    /// it in its question, or as the only such number there, if nothing else is left that may be the item.
    void claim_constant(const ItemSpec& item) {
        std::vector<std::size_t> near, all;
        const auto [first, last] = extent_of(item);
        for (std::size_t slot = first; slot < last; ++slot) {
            if (used_[slot] || slots_[slot].moves() || is_barred(slot, item)) continue;
            if (!is_right_everywhere(item, {{slot}})) continue;
            all.push_back(slot);
            if (is_beside_neighbor(slot, item)) near.push_back(slot);
        }
        if (near.size() == 1) return claim(item, {near}, Evidence::right);
        if (all.size() == 1 && !is_left_for(item)) claim(item, {all}, Evidence::right);
    }

    /// The numbers among which an item's own may be: under the heading of its question, or else between the items of
    /// the questions before and behind.
    std::pair<std::size_t, std::size_t> extent_of(const ItemSpec& item) const {
        std::size_t first = 0, last = slots_.size();
        if (headings_.contains(item.question)) {
            const auto is_own = [&](const Slot& slot) { return slot.question == item.question; };
            const auto begin = std::ranges::find_if(slots_, is_own);
            const auto end = std::find_if_not(begin, slots_.end(), is_own);
            return {static_cast<std::size_t>(begin - slots_.begin()), static_cast<std::size_t>(end - slots_.begin())};
        }
        for (const auto& [id, claim] : claims_) {
            const auto of = std::ranges::find_if(items_, [&](const ItemSpec& spec) { return spec.id == id; });
            const auto [least, most] = std::ranges::minmax(claim.candidate.slots);
            if (of->question < item.question) first = std::max(first, most + 1);
            if (of->question > item.question) last = std::min(last, least);
        }
        return {first, std::max(first, last)};
    }

    /// Whether the slot is next to one of an item that is asked for next to this one.
    bool is_beside_neighbor(std::size_t slot, const ItemSpec& item) const {
        for (std::size_t i = 0; i < items_.size(); ++i) {
            const bool is_neighbor =
                (i + 1 < items_.size() && items_[i + 1].id == item.id) || (i > 0 && items_[i - 1].id == item.id);
            const auto claim = claims_.find(items_[i].id);
            if (!is_neighbor || items_[i].question != item.question || claim == claims_.end()) continue;
            const auto [least, most] = std::ranges::minmax(claim->second.candidate.slots);
            if (slot + 1 == least || slot == most + 1) return true;
        }
        return false;
    }

    // What is hit first.

    /// The line whose words change with the object that is hit first, and what it says: in words that are known, or
    /// that the program uses where it prints what belongs to one object. Empty if there is none, or if lines disagree.
    std::optional<ItemPlace> find_verdict(const ItemSpec& item) {
        std::vector<reference::FirstObject> truths;
        for (const Observation& other : others_) {
            const reference::Answer& answer = reference::asked_item(other.key, item.id)->answers.front();
            const auto* first = std::get_if<reference::FirstObject>(&answer.value);
            if (first == nullptr) return std::nullopt;
            truths.push_back(*first);
        }
        if (std::ranges::count(truths, truths.front()) == std::ssize(truths)) return std::nullopt;
        learn_object_words();
        std::optional<ItemPlace> found;
        std::optional<bool> found_right;
        for (const bool own_section : {true, false}) {
            for (const LineOnScenes& line : lines_) {
                if (!line.words_change || (line.question == item.question) != own_section) continue;
                const auto own = said_first(line.own);
                if (!own || says_no_answer(line.own.text)) continue;
                bool all_said = true, all_right = true;
                for (std::size_t scene = 0; scene < others_.size(); ++scene) {
                    const auto said = said_first(line.lines[scene]);
                    all_said = all_said && said;
                    all_right = all_right && said == truths[scene];
                }
                if (!all_said) continue;
                if (found_right && *found_right != all_right) return std::nullopt;
                found_right = all_right;
                found = place_of(item);
                found->first_line = found->last_line = line.own.number;
                found->first_object = own;
            }
            if (found) return found;
        }
        return std::nullopt;
    }

    std::optional<reference::FirstObject> said_first(const PrintedLine& line) const {
        if (const auto first = read_first_object({line}, FirstObjectPlace::own_section)) return first->object;
        std::optional<reference::Subject> said;
        for (const std::string& word : words_of(line.text)) {
            for (const auto& [object, words] : object_words_) {
                if (!words.contains(word)) continue;
                if (said && *said != object) return std::nullopt;
                said = object;
            }
        }
        return said ? std::optional(reference::FirstObject(*said)) : std::nullopt;
    }

    static std::set<std::string> words_of(std::string_view text) {
        std::set<std::string> words;
        std::string word;
        for (const char c : std::string(text) + ' ') {
            if (is_letter(c)) {
                word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
            } else {
                constexpr std::size_t shortest = 3;
                if (word.size() >= shortest) words.insert(word);
                word.clear();
            }
        }
        return words;
    }

    /// The words that are printed with the items of one object and with no other item.
    void learn_object_words() {
        std::map<std::string, std::set<reference::Subject>> used_with;
        for (const auto& [id, claim] : claims_) {
            for (const std::size_t slot : claim.candidate.slots) {
                const int line = slots_[slot].place.line;
                for (const LineOnScenes& on_scenes : lines_) {
                    if (on_scenes.own.number != line && on_scenes.own.number + 1 != line) continue;
                    for (const std::string& word : words_of(on_scenes.own.text)) used_with[word].insert(id.subject);
                }
                if (labels_[slot] == nullptr) continue;
                for (const std::string& word : words_of(labels_[slot]->above)) used_with[word].insert(id.subject);
            }
        }
        for (const auto& [word, subjects] : used_with) {
            const bool is_of_object = std::ranges::count(reference::objects, *subjects.begin()) > 0;
            if (subjects.size() == 1 && is_of_object) object_words_[*subjects.begin()].insert(word);
        }
    }

    // What is concluded.

    /// Whether numbers that may be the item were found to be nothing: enough of them, one of which changes from scene
    /// to scene.
    bool is_left_for(const ItemSpec& item) {
        std::size_t count = 0, moving = 0;
        const MatchedItem* matched = matched_to(item.id);
        const auto own = matched != nullptr && matched->value ? slots_of(*matched->value) : std::vector<std::size_t>();
        for (std::size_t slot = 0; slot < slots_.size(); ++slot) {
            if (used_[slot] || std::ranges::count(own, slot) > 0) continue;
            if (distance_from_question({{slot}}, item) > 1 || is_no_answer(slot, item)) continue;
            ++count;
            moving += slots_[slot].moves() ? 1 : 0;
        }
        return moving > 0 && (item.shape == Shape::scalar || count >= size_of(item.shape));
    }

    /// The named mistakes of the items that are wrong on every other scene.
    std::vector<MistakeOnScenes> mistakes_everywhere() const {
        std::map<ItemId, MistakeOnScenes> wrong;
        for (std::size_t scene = 0; scene < others_.size(); ++scene) {
            const Score score = mark_answers(all_on_scene(scene), others_[scene].key, others_[scene].assignment);
            for_each_item(score, [&](const ItemScore& item) {
                const ItemId& id = item.spec.id;
                if (!claims_.contains(id) || (scene > 0 && !wrong.contains(id))) return;
                if (item.verdict != ItemVerdict::wrong) {
                    wrong.erase(id);
                } else if (scene == 0) {
                    wrong[id] = {item.spec.question, std::string(item.spec.name), item.diagnosis, item.advice};
                } else if (wrong[id].diagnosis != item.diagnosis) {
                    wrong[id].diagnosis.clear();
                    wrong[id].advice.clear();
                }
            });
        }
        std::vector<MistakeOnScenes> mistakes;
        for (auto& [id, mistake] : wrong) mistakes.push_back(std::move(mistake));
        return mistakes;
    }

    ItemPlace place_of(const ItemSpec& item) const {
        ItemPlace place;
        place.question = item.question;
        place.item = item.name;
        place.by_experiment = true;
        return place;
    }

    /// Whether the program prints something else for the question than on other scenes, as where the ray misses: what
    /// is not found there may be here.
    bool is_printed_otherwise(const ItemSpec& item) const {
        return headings_.contains(item.question) ? differing_.contains(item.question) : !differing_.empty();
    }

    /// Whether a number that never changes may be the item, of which nothing can be shown.
    bool may_be_constant(const ItemSpec& item) {
        const auto [first, last] = extent_of(item);
        for (std::size_t slot = first; slot < last && item.shape == Shape::scalar; ++slot) {
            if (!used_[slot] && !slots_[slot].moves() && !is_barred(slot, item) && is_right_everywhere(item, {{slot}}))
                return true;
        }
        return false;
    }

    /// Whether the item may follow from one of these.
    static bool depends_on(const ItemId& id, const std::set<ItemId>& inputs) {
        if (id == reference::item::first_object)
            return std::ranges::any_of(inputs,
                                       [](const ItemId& input) { return input.subject != reference::Subject::camera; });
        return std::ranges::any_of(all_derivations(), [&](const Derivation& derivation) {
            return derivation.item == id &&
                   std::ranges::any_of(derivation.inputs, [&](const ItemId& input) { return inputs.contains(input); });
        });
    }

    /// Whether the numbers that were read for the item were found to be another item's.
    bool is_anothers(const MatchedItem& matched) const {
        return std::ranges::any_of(slots_of(*matched.value), [&](std::size_t slot) { return used_[slot]; });
    }

    ItemPlace found_at(const ItemSpec& item, const Candidate& candidate) const {
        ItemPlace place = place_of(item);
        for (const std::size_t slot : candidate.slots) {
            place.numbers.push_back(slots_[slot].place);
            place.numbers.back().is_negated = candidate.is_negated(slots_[slot].own);
        }
        const auto [first, last] = std::ranges::minmax(place.numbers);
        place.first_line = first.line;
        place.last_line = last.line;
        place.order = candidate.order;
        return place;
    }

    /// Whether a matrix whose order nothing states is right only column by column, and nothing that is computed with it
    /// is right: it may be printed row by row and be the transpose.
    bool is_of_unknown_order(const ItemSpec& item, const Claim& claim) {
        if (side_of(item.shape) == 1 || claim.candidate.order != MatrixOrder::unsaid) return false;
        Candidate by_rows = claim.candidate;
        by_rows.order = MatrixOrder::rows;
        if (is_right_everywhere(item, by_rows)) return false;
        return std::ranges::none_of(claims_, [&](const auto& other) {
            return depends_on(other.first, {item.id}) && other.second.evidence == Evidence::right;
        });
    }

    /// Whether it is shown that what was read for the item, or that nothing was, is all there is of it.
    bool is_all_there(const ItemSpec& item, const MatchedItem* value, const std::set<ItemId>& unknown) {
        if (item.shape == Shape::first_object || is_left_for(item) || may_be_constant(item)) return false;
        if (is_printed_otherwise(item) || depends_on(item.id, unknown)) return false;
        const ItemId t{item.id.subject, "t"};
        if (may_be_absent(item) && !claims_.contains(t)) return false;  // words may say that the ray misses
        return value == nullptr || (!value->value->numbers.empty() && !is_anothers(*value));
    }

    ExperimentReport conclude() {
        ExperimentReport report;
        std::set<ItemId> unknown;  // items that may be in the printout, and what may follow from them
        for_each_item(own_.score, [&](const ItemScore& scored) {
            const ItemSpec& item = scored.spec;
            const auto claim = claims_.find(item.id);
            const MatchedItem* matched = matched_to(item.id);
            const bool has_value = matched != nullptr && matched->value && !matched->unreadable;
            if (!doubtful_.contains(item.id)) {
                report.places.push_back(place_of(item));
                report.places.back().as_read = true;
            } else if (claim != claims_.end() && !is_of_unknown_order(item, claim->second)) {
                report.places.push_back(found_at(item, claim->second.candidate));
            } else if (item.shape == Shape::first_object && verdict_) {
                report.places.push_back(*verdict_);
            } else if (claim == claims_.end() && is_all_there(item, has_value ? matched : nullptr, unknown)) {
                report.places.push_back(place_of(item));
                report.places.back().as_read = has_value;
            } else {
                unknown.insert(item.id);
            }
            // If it is wrong here, what it follows from may be unread, or the lines may be paired wrongly.
            const bool is_unexplained = claim != claims_.end() && claim->second.evidence == Evidence::rest;
            const bool is_open = unknown.contains(item.id) || is_unexplained || depends_on(item.id, unknown) ||
                                 is_printed_otherwise(item);
            if (scored.doubt && doubtful_.contains(item.id) && is_open)
                report.doubts.push_back({item.question, std::string(item.name), *scored.doubt, scored.layout_doubt});
        });
        for (ItemPlace& place : report.places) {
            if (doubted_.contains({place.question, place.item}) || !place.as_read)
                place.note = note_of(place, others_.size());
        }
        report.mistakes = mistakes_everywhere();
        if (!report.doubts.empty()) report.unsettled = "its runs on other scenes do not show what was meant";
        return report;
    }

    const OwnRun& own_;
    std::set<ItemId> settled_, doubtful_;
    std::set<std::pair<int, std::string>> doubted_;  ///< the doubtful items by question and name
    std::set<ItemId> wrong_;  ///< of the settled items; if its number is another item's, it was misread after all
    std::span<const Observation> others_;
    const std::vector<Slot>& slots_;
    const std::vector<LineOnScenes>& lines_;
    const std::set<int>& differing_;
    std::vector<bool> used_;
    std::vector<const PrintedValue*> labels_;  ///< the value that was read from each slot; null if none was
    std::vector<ItemSpec> items_;
    std::set<int> headings_;
    std::optional<Fits> fits_;
    std::map<int, bool> no_answer_;  ///< by line
    std::map<std::size_t, std::map<ItemId, std::vector<Target>>> targets_;
    std::map<ItemId, Claim> claims_;
    std::map<reference::Subject, std::set<std::string>> object_words_;
    std::optional<ItemPlace> verdict_;
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
        nothing.unsettled = "on other scenes its printout has other lines";
        return nothing;
    }
    if (std::ranges::none_of(slots->numbers, &Slot::moves)) {
        nothing.unsettled = "it prints the same numbers on every scene";
        return nothing;
    }
    return Identifier(own, alike, *slots).run();
}

}  // namespace harness::experiment
