#include "harness/match/question_match.h"

#include <algorithm>
#include <cstdlib>

#include "harness/match/assignment_problem.h"
#include "harness/read/words/hit_words.h"

namespace harness {
namespace {

using reference::ItemSpec;
using reference::Shape;

/// The gain of each fit. The steps between are wider than what the order of printing can add.
std::int64_t gain_of(LabelFit fit) {
    switch (fit) {
        case LabelFit::exact: return 100'000;
        case LabelFit::named: return 80'000;
        case LabelFit::title: return 60'000;
        case LabelFit::weak: return 50'000;
        case LabelFit::none: return 40'000;
        case LabelFit::foreign: return 15'000;
        case LabelFit::forbidden: return 0;
    }
    return 0;
}

/// A candidate, and where it stands in its part.
struct Placed {
    Candidate candidate;
    std::size_t place;
};

/// Whether the items have the same of another object, as the t of the sphere beside that of the triangle.
bool has_twin(const ItemSpec& spec, std::span<const ItemSpec> items) {
    return std::ranges::any_of(items, [&](const ItemSpec& other) {
        return spec.id.name == other.id.name && spec.id.subject != other.id.subject;
    });
}

/// The only object that the words at a value name, or the line above it.
std::optional<reference::Subject> object_said_of(const PrintedValue& value) {
    std::optional<reference::Subject> said;
    for (const std::string* words : {&value.label, &value.after, &value.above}) {
        for (const HitWord& word : hit_words(*words)) {
            const auto object = object_of(word.meaning);
            if (object && said && object != said) return std::nullopt;
            if (object) said = object;
        }
        if (said) return said;
    }
    return std::nullopt;
}

class Matcher {
  public:
    Matcher(std::span<const ItemSpec> items, Need need, Fits& fits) : items_(items), need_(need), fits_(fits) {
        for (const ItemSpec& item : items) {
            index_.push_back(fits.index_of(item));
            has_twin_.push_back(has_twin(item, items));
        }
    }

    struct Solution {
        std::vector<std::optional<std::size_t>> candidate_of;
        std::int64_t gain = 0;
    };

    Solution solve(const std::vector<Placed>& candidates) const {
        std::vector<std::vector<std::optional<std::int64_t>>> gains(items_.size());
        for (std::vector<std::optional<std::int64_t>>& row : gains) row.reserve(candidates.size());
        std::vector<LabelFit> fit(items_.size());
        for (const Placed& placed : candidates) {
            const Fits::Row& row = fits_.of(placed.candidate.value);
            for (std::size_t i = 0; i < items_.size(); ++i) fit[i] = row[index_[i]];
            for (std::size_t i = 0; i < items_.size(); ++i) gains[i].push_back(gain(i, placed, fit));
        }
        Solution solution{solve_assignment(gains)};
        for (std::size_t i = 0; i < items_.size(); ++i) {
            if (solution.candidate_of[i]) solution.gain += *gains[i][*solution.candidate_of[i]];
        }
        return solution;
    }

    /// Whether the words around a value name an item of the question, or say that it is not an answer.
    bool is_named(const PrintedValue& value) const {
        const Fits::Row& row = fits_.of(value);
        return std::ranges::any_of(
            index_, [&](std::size_t i) { return row[i] >= LabelFit::named || row[i] == LabelFit::forbidden; });
    }

  private:
    std::optional<std::int64_t> gain(std::size_t i, const Placed& placed, const std::vector<LabelFit>& fit) const {
        const Candidate& candidate = placed.candidate;
        if (!has_shape(candidate.value, items_[i]) || fit[i] == LabelFit::forbidden) return std::nullopt;
        const auto object = has_twin_[i] ? object_said_of(candidate.value) : std::nullopt;
        if (object && object != items_[i].id.subject) return std::nullopt;
        // "no hit" is no answer for u, and "misses the sphere" none of the triangle's.
        if (candidate.value.numbers.empty() && fit[i] < LabelFit::weak &&
            (!is_of_hit(items_[i]) || is_said_of_another(candidate.value, items_[i])))
            return std::nullopt;
        if (need_ == Need::label && fit[i] < LabelFit::named) return std::nullopt;
        if (names_another(i, fit) ||
            (fit[i] == LabelFit::foreign && names_another_question(candidate.value, items_[i])))
            return std::nullopt;
        // An unnamed vec3 that is read as three scalars is still one value, so it gains no more than as a vector.
        const std::int64_t share = candidate.value.typed && fit[i] == LabelFit::none ? candidate.parts : 1;
        // A number under words that nobody knows answers rather than "no hit" does, which may be said of something
        // else.
        constexpr std::int64_t of_no_value = 8'000;
        const bool is_no_value = candidate.value.numbers.empty() && fit[i] < LabelFit::weak;
        return gain_of(fit[i]) / share + order_gain(fit[i], i, placed) - (is_no_value ? of_no_value : 0);
    }

    /// Whether the label names an item of the question better than item i: a value labelled "b" is never c.
    bool names_another(std::size_t i, const std::vector<LabelFit>& fit) const {
        if (fit[i] >= LabelFit::named) return false;
        for (std::size_t other = 0; other < items_.size(); ++other) {
            const LabelFit least = fit[i] <= LabelFit::foreign ? LabelFit::weak : LabelFit::named;
            if (other != i && items_[other].shape == items_[i].shape && fit[other] >= least) return true;
        }
        return false;
    }

    /// Whether the label names another question's item, such as "N" among those of t. False in a question with one
    /// item: its label may have been copied by mistake.
    bool names_another_question(const PrintedValue& value, const ItemSpec& item) const {
        if (items_.size() == 1) return false;
        const auto all = fits_.asked();
        const Fits::Row& row = fits_.of(value);
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (all[i].question != item.question && all[i].shape == item.shape && row[i] == LabelFit::exact)
                return true;
        }
        return false;
    }

    /// Among values with the same label, the last counts. Values without a label come in the order of the items. In a
    /// question with one item, the last value is the result of the earlier values.
    std::int64_t order_gain(LabelFit fit, std::size_t i, const Placed& placed) const {
        constexpr std::int64_t most = 4'000;
        constexpr std::int64_t later_part = 2'000;
        const auto place = static_cast<std::int64_t>(placed.place);
        const std::int64_t part =
            std::min<std::int64_t>(static_cast<std::int64_t>(placed.candidate.part), 2) * later_part;
        // Among weak names, such as "t1" and "t2" for t, the first counts: students write the near root first.
        if (fit == LabelFit::weak && items_.size() > 1 && !has_twin_[i]) return part - std::min(place, most);
        if (!has_twin_[i] && (fit >= LabelFit::title || items_.size() == 1)) return part + std::min(place, most);
        // Squared, so that a matching without crossings gains more.
        const std::int64_t apart = std::min<std::int64_t>(std::abs(static_cast<std::int64_t>(i) - place), 40);
        return part - 2 * apart * apart;
    }

    std::span<const ItemSpec> items_;
    std::vector<std::size_t> index_;  ///< of each item in fits_.asked()
    std::vector<bool> has_twin_;      ///< by item: the same of another object is asked too
    Need need_;
    Fits& fits_;
};

/// The candidates with candidate k, a list, read as scalars for the items from `first` on.
std::vector<Placed> with_list_apart(std::vector<Placed> candidates, std::size_t k, std::span<const ItemSpec> items,
                                    std::size_t first) {
    const Placed list = candidates[k];
    const auto at = candidates.erase(candidates.begin() + static_cast<std::ptrdiff_t>(k));
    std::vector<Placed> parts;
    for (Candidate& part : take_apart(list.candidate, items, first)) {
        part.value.label = list.candidate.value.label;  // only their order names them
        part.value.after = list.candidate.value.after;
        parts.push_back({std::move(part), first + parts.size()});
    }
    for (auto later = at; later != candidates.end(); ++later) {
        if (later->candidate.part == list.candidate.part) later->place += parts.size() - 1;
    }
    candidates.insert(at, parts.begin(), parts.end());
    return candidates;
}

/// Whether candidate k may answer items [first, first + count) while the others are matched as in `solution`: in the
/// order of printing, and none of these items is answered by name.
bool keeps_order(const std::vector<Placed>& candidates, const Matcher& matcher, const Matcher::Solution& solution,
                 std::size_t k, std::size_t first, std::size_t count) {
    for (std::size_t i = 0; i < solution.candidate_of.size(); ++i) {
        const auto& candidate = solution.candidate_of[i];
        if (!candidate || *candidate == k) continue;
        if ((*candidate < k && i >= first + count) || (*candidate > k && i < first)) return false;
        const bool is_within = i >= first && i < first + count;
        if (is_within && matcher.is_named(candidates[*candidate].candidate.value)) return false;
    }
    return true;
}

/// Reads one unnamed list as scalars, such as "1 -4 2" as a, b and c: the list that raises the gain most, if any does.
void take_best_list_apart(std::vector<Placed>& candidates, Matcher::Solution& solution, std::span<const ItemSpec> items,
                          const Matcher& matcher) {
    constexpr std::size_t most_candidates = 48;
    if (candidates.size() > most_candidates) return;
    const std::vector<Placed> whole = candidates;
    const Matcher::Solution by_whole = solution;
    for (std::size_t k = 0; k < whole.size(); ++k) {
        const PrintedValue& value = whole[k].candidate.value;
        const std::size_t count = value.numbers.size();
        if (value.groups != 1 || count < 2 || matcher.is_named(value)) continue;
        for (std::size_t first = 0; first + count <= items.size(); ++first) {
            if (!std::ranges::all_of(items.subspan(first, count),
                                     [](const ItemSpec& item) { return item.shape == Shape::scalar; }) ||
                !keeps_order(whole, matcher, by_whole, k, first, count))
                continue;
            std::vector<Placed> trial = with_list_apart(whole, k, items, first);
            Matcher::Solution found = matcher.solve(trial);
            if (found.gain <= solution.gain) continue;
            candidates = std::move(trial);
            solution = std::move(found);
        }
    }
}

}  // namespace

bool may_be_absent(const ItemSpec& item) {
    return reference::item_of(item.id).exists != reference::Exists::always;
}

bool is_of_hit(const ItemSpec& item) {
    return reference::item_of(item.id).exists == reference::Exists::with_hit;
}

bool is_said_of_another(const PrintedValue& value, const ItemSpec& item) {
    bool own = false, another = false;
    for (const HitWord& word : hit_words(value.printed)) {
        const auto object = object_of(word.meaning);
        own = own || object == item.id.subject;
        another = another || (object && object != item.id.subject);
    }
    return another && !own;
}

bool has_count(Shape shape, std::size_t count) {
    const auto usual = static_cast<std::size_t>(reference::component_count(shape));
    return count > 0 && (count == usual || (shape == Shape::vector && count == 4));
}

bool has_shape(const PrintedValue& value, const ItemSpec& item) {
    const std::size_t count = value.numbers.size();
    if (count == 0) return may_be_absent(item);
    return has_count(item.shape, count) && (item.shape != Shape::vector || value.groups == 1);
}

const Fits::Row& Fits::of(const PrintedValue& value) {
    std::string key;
    key.reserve(value.label.size() + value.above.size() + value.after.size() + 2);
    key.append(value.label).append(1, '\n').append(value.above).append(1, '\n').append(value.after);
    const auto [row, is_new] = known_.try_emplace(std::move(key));
    if (is_new) {
        for (const ItemSpec& item : asked_) row->second.push_back(fit_value(value, item, asked_));
    }
    return row->second;
}

std::size_t Fits::index_of(const ItemSpec& item) const {
    return static_cast<std::size_t>(std::ranges::find(asked_, item.id, &ItemSpec::id) - asked_.begin());
}

LabelFit Fits::operator()(const PrintedValue& value, const ItemSpec& item) {
    return of(value)[index_of(item)];
}

Answers answer_question(std::span<const ItemSpec> items, std::span<const std::vector<PrintedValue>> parts, Need need,
                        Fits& fits) {
    std::vector<Placed> candidates;
    for (std::size_t part = 0; part < parts.size(); ++part) {
        std::size_t place = 0;
        for (Candidate& candidate : candidates_of(parts[part], items)) {
            candidate.part = part;
            candidates.push_back({std::move(candidate), place++});
        }
    }
    const Matcher matcher(items, need, fits);
    Matcher::Solution solution = matcher.solve(candidates);
    if (need == Need::order_or_label) take_best_list_apart(candidates, solution, items, matcher);
    Answers answers{{}, std::move(solution.candidate_of)};
    answers.candidates.reserve(candidates.size());
    for (Placed& placed : candidates) answers.candidates.push_back(std::move(placed.candidate));
    return answers;
}

std::vector<PrintedValue> unused_values(std::span<const std::vector<PrintedValue>> parts, const Answers& answers) {
    std::vector<std::vector<bool>> used;
    for (const std::vector<PrintedValue>& part : parts) used.emplace_back(part.size(), false);
    for (const auto& index : answers.candidate_of) {
        if (!index) continue;
        const Candidate& candidate = answers.candidates[*index];
        const auto begin = used[candidate.part].begin() + static_cast<std::ptrdiff_t>(candidate.first);
        std::fill_n(begin, candidate.count, true);
    }
    std::vector<PrintedValue> unused;
    for (std::size_t part = 0; part < parts.size(); ++part) {
        for (std::size_t i = 0; i < parts[part].size(); ++i) {
            if (!used[part][i]) unused.push_back(parts[part][i]);
        }
    }
    return unused;
}

}  // namespace harness
