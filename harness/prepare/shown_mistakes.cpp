#include "harness/prepare/shown_mistakes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "harness/mark/compare/key_targets.h"
#include "harness/mark/diagnose/interval_scene.h"
#include "harness/mark/score/gather.h"

namespace harness::prepare {
namespace {

using reference::KeyItem;

double middle(const Interval& x) {
    return x.lo() + (x.hi() - x.lo()) / 2;
}

/// Whether a component differs from the other's by more than `margin`.
bool differs(const Target& target, const Target& other, double margin) {
    if (target.no_value != other.no_value || target.components.size() != other.components.size()) return true;
    for (std::size_t i = 0; i < target.components.size(); ++i) {
        if (!(std::abs(middle(target.components[i]) - middle(other.components[i])) <= margin)) return true;
    }
    return false;
}

bool is_finite(const Target& target) {
    return std::ranges::all_of(target.components, [](const Interval& x) { return x.is_bounded(); });
}

class Analysis {
  public:
    Analysis(const reference::Assignment& assignment, const reference::AnswerKey& key)
        : key_(key), rubric_(assignment.rubric), scene_(real_scene(assignment, key.canonical)) {
        known_ = keys_by_convention(key, rubric_).front();
    }

    ShownMistakes run() {
        for (const reference::KeyQuestion& question : key_.questions) {
            for (const KeyItem& item : question.items) look_at(item);
        }
        return std::move(result_);
    }

  private:
    void look_at(const KeyItem& item) {
        const double margin = 2 * allowance_of(item, rubric_) + 0.5 * std::pow(10.0, -rubric_.min_decimals);
        std::map<std::string_view, std::vector<Target>> wrong;  // the numbers that result from each mistake
        std::set<std::string_view> hidden;
        for (const Mistake& mistake : all_mistakes()) {
            if (mistake.item != item.spec.id) continue;
            std::vector<Target>& numbers = wrong[mistake.name];
            for (Target& target : mistake.compute(known_, scene_)) {
                const bool is_right = std::ranges::any_of(item.answers, [&](const reference::Answer& answer) {
                    return !differs(target, target_of(answer), margin);
                });
                if (is_right) hidden.insert(mistake.name);
                if (is_finite(target)) numbers.push_back(std::move(target));
            }
        }
        for (const auto& [name, numbers] : wrong) {
            if (numbers.empty()) hidden.insert(name);
        }
        for (const auto& [name, numbers] : wrong)
            (hidden.contains(name) ? result_.hidden : result_.shown).push_back({item.spec.id, name});
        std::erase_if(wrong, [&](const auto& each) { return hidden.contains(each.first); });
        group(item.spec.id, wrong, margin);
    }

    void group(const ItemId& id, const std::map<std::string_view, std::vector<Target>>& wrong, double margin) {
        std::vector<std::vector<std::string_view>> groups;
        const auto are_alike = [&](std::string_view one, std::string_view other) {
            return std::ranges::any_of(wrong.at(one), [&](const Target& target) {
                return std::ranges::any_of(wrong.at(other),
                                           [&](const Target& each) { return !differs(target, each, margin); });
            });
        };
        for (const auto& [name, numbers] : wrong) {
            const auto group = std::ranges::find_if(groups, [&](const std::vector<std::string_view>& names) {
                return std::ranges::any_of(names, [&](std::string_view other) { return are_alike(name, other); });
            });
            if (group == groups.end()) {
                groups.push_back({name});
            } else {
                group->push_back(name);
            }
        }
        for (const std::vector<std::string_view>& names : groups) {
            if (names.size() < 2) continue;
            std::vector<NamedMistake>& alike = result_.alike.emplace_back();
            for (const std::string_view name : names) alike.push_back({id, name});
        }
    }

    const reference::AnswerKey& key_;
    const reference::Rubric& rubric_;
    IntervalScene scene_;
    ItemTargets known_;
    ShownMistakes result_;
};

}  // namespace

std::size_t ShownMistakes::told_apart() const {
    std::size_t grouped = 0;
    for (const auto& group : alike) grouped += group.size();
    return shown.size() - grouped;
}

ShownMistakes shown_mistakes(const reference::Assignment& assignment, const reference::AnswerKey& key) {
    return Analysis(assignment, key).run();
}

}  // namespace harness::prepare
