#include "harness/match.h"

#include <algorithm>
#include <cstdlib>
#include <map>

#include "harness/arrange.h"
#include "harness/assignment_problem.h"

namespace harness {
namespace {

using reference::ItemSpec;
using reference::Shape;

/// The items that one run of sections answers, and what was printed there. Questions without a heading of their own join the
/// question before them.
struct Group {
    int question = 0;  ///< of the heading; 0 without one
    std::vector<ItemSpec> items;
    std::vector<PrintedValue> values;
    std::vector<std::string> lines;
    std::vector<int> line_numbers;
    bool several_questions = false;
};

std::vector<Group> group_by_question(const Transcript& transcript, std::span<const ItemSpec> items) {
    std::map<int, Group> groups;  // by the question whose heading leads
    const auto has_section = [&](int question) {
        return std::any_of(transcript.sections.begin(), transcript.sections.end(), [&](const Section& s) { return s.question == question; });
    };
    int leader = 0;
    for (const ItemSpec& item : items) {
        if (has_section(item.question)) leader = item.question;
        Group& group = groups[leader];
        group.question = leader;
        group.several_questions = group.several_questions || (!group.items.empty() && group.items.back().question != item.question);
        group.items.push_back(item);
    }
    for (const Section& section : transcript.sections) {
        const auto group = groups.find(section.question);
        if (group == groups.end()) continue;
        group->second.values.insert(group->second.values.end(), section.values.begin(), section.values.end());
        for (std::size_t i = 0; i < section.lines.size(); ++i) {
            group->second.lines.push_back(section.lines[i]);
            group->second.line_numbers.push_back(section.first_line + static_cast<int>(i) + (section.question == 0 ? 1 : 0));
        }
    }
    std::vector<Group> result;
    for (auto& [question, group] : groups) result.push_back(std::move(group));
    return result;
}

/// Items whose value may not exist: a ray can miss.
bool may_be_absent(const ItemSpec& item) {
    return item.name == "t" || item.name == "hit" || item.name == "u" || item.name == "v" || (item.name == "normal" && item.question == 7);
}

bool has_shape(const PrintedValue& value, const ItemSpec& item) {
    const std::size_t count = value.numbers.size();
    if (count == 0) return may_be_absent(item);
    switch (item.shape) {
        case Shape::scalar: return count == 1;
        case Shape::vector: return value.groups == 1 && (count == 3 || count == 4);
        case Shape::matrix3: return count == 9;
        case Shape::matrix4: return count == 16;
        case Shape::verdict: return false;
    }
    return false;
}

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

class Matcher {
  public:
    explicit Matcher(const Group& group) : group_(group), items_(group.items) {}

    struct Solution {
        std::vector<std::optional<std::size_t>> candidate_of;  ///< by item
        std::int64_t gain = 0;
    };

    Solution solve(const std::vector<Candidate>& candidates) const {
        std::vector<std::vector<std::optional<std::int64_t>>> gains(items_.size());
        for (std::size_t i = 0; i < items_.size(); ++i) {
            for (std::size_t k = 0; k < candidates.size(); ++k) gains[i].push_back(gain(i, k, candidates));
        }
        Solution solution{solve_assignment(gains), 0};
        for (std::size_t i = 0; i < items_.size(); ++i) {
            if (solution.candidate_of[i]) solution.gain += *gains[i][*solution.candidate_of[i]];
        }
        return solution;
    }

  private:
    std::optional<std::int64_t> gain(std::size_t i, std::size_t k, const std::vector<Candidate>& candidates) const {
        const PrintedValue& value = candidates[k].value;
        if (!has_shape(value, items_[i])) return std::nullopt;
        const LabelFit fit = fit_label(value.label, value.above, items_[i]);
        if (fit == LabelFit::forbidden || names_another(value, i, fit)) return std::nullopt;
        // Under another question's heading only a value that names the item can be meant for it.
        if (group_.question != 0 && items_[i].question != group_.question && fit < LabelFit::named) return std::nullopt;
        return gain_of(fit) + order_gain(fit, i, k);
    }

    /// Whether the label names an item of the question better than item i: a value labelled "b" is never c.
    bool names_another(const PrintedValue& value, std::size_t i, LabelFit fit) const {
        if (fit >= LabelFit::named) return false;
        for (std::size_t other = 0; other < items_.size(); ++other) {
            if (other == i || items_[other].shape != items_[i].shape || items_[other].question != items_[i].question) continue;
            if (fit_label(value.label, value.above, items_[other]) >= LabelFit::named) return true;
        }
        return false;
    }

    /// Of values labelled alike the last counts. Values without a label come in the order of the items; the loss grows with the
    /// square of the distance, so that of two values the one printed first goes to the first item.
    std::int64_t order_gain(LabelFit fit, std::size_t i, std::size_t k) const {
        constexpr std::int64_t most = 9'000;
        if (fit >= LabelFit::title && !group_.several_questions) return std::min<std::int64_t>(static_cast<std::int64_t>(k), most);
        const std::int64_t apart = std::abs(static_cast<std::int64_t>(i) - static_cast<std::int64_t>(k));
        return -std::min<std::int64_t>(60 * apart * apart, most);
    }

    const Group& group_;
    const std::vector<ItemSpec>& items_;
};

bool names_an_item(const PrintedValue& value, const std::vector<ItemSpec>& items) {
    return std::any_of(items.begin(), items.end(), [&](const ItemSpec& item) {
        return has_shape(value, item) && fit_label(value.label, value.above, item) >= LabelFit::named;
    });
}

/// Tries to read a list without a name as several scalars, "1 -4 2" as a, b, c, where that lets more items be answered.
std::vector<Candidate> take_lists_apart(std::vector<Candidate> candidates, const Group& group, const Matcher& matcher) {
    constexpr std::size_t most_lists = 8;
    constexpr std::size_t most_candidates = 64;
    if (candidates.size() > most_candidates) return candidates;
    Matcher::Solution best = matcher.solve(candidates);
    std::vector<Candidate> best_candidates = candidates;
    std::size_t lists = 0;
    for (std::size_t k = 0; k < candidates.size() && lists < most_lists; ++k) {
        const PrintedValue& value = candidates[k].value;
        const std::size_t count = value.numbers.size();
        if (value.groups != 1 || count < 2 || names_an_item(value, group.items)) continue;
        ++lists;
        for (std::size_t first = 0; first + count <= group.items.size(); ++first) {
            const auto begin = group.items.begin() + static_cast<std::ptrdiff_t>(first);
            const bool scalars = std::all_of(begin, begin + static_cast<std::ptrdiff_t>(count), [&](const ItemSpec& item) {
                return item.shape == Shape::scalar && item.question == begin->question && fit_label(value.label, value.above, item) != LabelFit::forbidden;
            });
            if (!scalars) continue;
            std::vector<Candidate> trial(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(k));
            for (Candidate& part : take_apart(value, group.items, first)) {
                part.value.label.clear();  // the order of printing names them, no more than that
                trial.push_back(std::move(part));
            }
            trial.insert(trial.end(), candidates.begin() + static_cast<std::ptrdiff_t>(k) + 1, candidates.end());
            Matcher::Solution solution = matcher.solve(trial);
            if (solution.gain > best.gain) {
                best = std::move(solution);
                best_candidates = std::move(trial);
            }
        }
    }
    return best_candidates;
}

/// "The ray misses the sphere", said once, holds for t, the hit point and the normal alike.
void share_no_value(std::vector<MatchedItem>& matched, const std::vector<Candidate>& candidates) {
    const auto said = std::find_if(candidates.begin(), candidates.end(), [](const Candidate& c) { return c.value.numbers.empty(); });
    if (said == candidates.end()) return;
    for (MatchedItem& item : matched) {
        const bool sphere_or_hit = item.spec.subject == reference::Subject::sphere || item.spec.name == "hit";
        if (!item.value && may_be_absent(item.spec) && sphere_or_hit) item.value = said->value;
    }
}

/// A value whose label names the item but that has another shape: the item was answered, unreadably.
void find_unreadable(std::vector<MatchedItem>& matched, const std::vector<Candidate>& candidates, const std::vector<bool>& used) {
    for (MatchedItem& item : matched) {
        if (item.value || item.spec.shape == Shape::verdict) continue;
        for (std::size_t k = 0; k < candidates.size(); ++k) {
            const PrintedValue& value = candidates[k].value;
            if (used[k] || value.label.empty() || value.numbers.empty() || has_shape(value, item.spec)) continue;
            if (fit_label(value.label, value.above, item.spec) != LabelFit::exact) continue;
            item.value = value;
            item.unreadable = true;
        }
    }
}

std::vector<MatchedItem> match_group(const Group& group) {
    const Matcher matcher(group);
    std::vector<Candidate> candidates = take_lists_apart(arrange(group.values, group.items), group, matcher);
    const Matcher::Solution solution = matcher.solve(candidates);
    std::vector<MatchedItem> matched;
    std::vector<bool> used(candidates.size(), false);
    for (std::size_t i = 0; i < group.items.size(); ++i) {
        MatchedItem item{group.items[i], {}, MatrixOrder::unsaid, {}, false};
        if (solution.candidate_of[i]) {
            const Candidate& candidate = candidates[*solution.candidate_of[i]];
            used[*solution.candidate_of[i]] = true;
            item.value = candidate.value;
            item.order = candidate.order;
        }
        if (item.spec.shape == Shape::verdict) {
            item.verdict = read_verdict(group.lines, group.question == 10 ? VerdictPlace::own_section : VerdictPlace::elsewhere);
            if (item.verdict) item.verdict->line = static_cast<std::size_t>(group.line_numbers[item.verdict->line]);
        }
        matched.push_back(std::move(item));
    }
    share_no_value(matched, candidates);
    find_unreadable(matched, candidates, used);
    return matched;
}

}  // namespace

std::vector<MatchedItem> match(const Transcript& transcript, std::span<const ItemSpec> items) {
    std::vector<MatchedItem> result;
    for (const Group& group : group_by_question(transcript, items)) {
        for (MatchedItem& item : match_group(group)) result.push_back(std::move(item));
    }
    return result;
}

}  // namespace harness
