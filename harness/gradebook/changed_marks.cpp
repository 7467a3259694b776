#include "harness/gradebook/changed_marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "harness/record/final_mark.h"
#include "harness/text/points.h"
#include "reference/key/key_formats.h"
#include "reference/toml/scene_toml.h"

namespace harness {
namespace {

constexpr double a_millionth = 1e-6;

std::string signed_points(double points) {
    return (points > 0 ? "+" : "") + points_text(points);
}

/// Whether an override replaces the item's automatic points.
bool is_overridden(const Graded& graded, const ItemScore& item) {
    return find_override(graded, item.spec.question, std::string(item.spec.name)) != nullptr ||
           find_override(graded, item.spec.question, "") != nullptr || find_override(graded, 0, "") != nullptr;
}

using Items = std::map<std::pair<int, std::string_view>, const ItemScore*>;

Items items_of(const Graded& graded) {
    Items items;
    for (const QuestionScore& question : graded.score.questions) {
        for (const ItemScore& item : question.items) items[{question.number, item.spec.name}] = &item;
    }
    return items;
}

/// `before` or `after` is null if the item was not asked for in that run.
std::string item_change(const ItemScore* before, const ItemScore* after, const Graded& graded) {
    const ItemScore& item = after == nullptr ? *before : *after;
    const double difference = (after == nullptr ? 0 : after->points) - (before == nullptr ? 0 : before->points);
    const bool moves = std::abs(difference) > a_millionth;
    std::string text = fmt::format("{}.{} ", item.spec.question, item.spec.name);
    if (before == nullptr) {
        text += fmt::format("is new: {}", to_string(after->verdict));
    } else if (after == nullptr) {
        text += "is no longer asked for";
    } else if (before->verdict != after->verdict) {
        text += fmt::format("{} -> {}", to_string(before->verdict), to_string(after->verdict));
    } else if (moves) {
        text = fmt::format("{}.{}: still {}, but {} {} points", item.spec.question, item.spec.name,
                           to_string(after->verdict), points_text(std::abs(difference)),
                           difference < 0 ? "fewer" : "more");
    } else {
        return "";
    }
    const bool is_said = before != nullptr && after != nullptr && before->verdict == after->verdict;
    if (moves && !is_said) text += fmt::format(" ({})", signed_points(difference));
    return text + (is_overridden(graded, item) ? ", overridden" : "");
}

void add_items(std::vector<std::string>& reasons, const Graded& before, const Graded& after) {
    const Items then = items_of(before);
    Items all = then;
    const Items now = items_of(after);
    all.insert(now.begin(), now.end());
    const auto in = [](const Items& items, const Items::key_type& key) {
        const auto found = items.find(key);
        return found == items.end() ? nullptr : found->second;
    };
    for (const auto& [key, item] : all) {
        std::string text = item_change(in(then, key), in(now, key), after);
        if (!text.empty()) reasons.push_back(std::move(text));
    }
}

/// "2 scenes of seed 1"; empty if an older raygrade did not record the seed.
std::string scenes_asked_for(const VariantsReport& report) {
    const std::size_t count = report.runs.size() + report.not_tried.size();
    return report.seed ? fmt::format("{} scene{} of seed {}", count, count == 1 ? "" : "s", *report.seed) : "";
}

void add_scenes(std::vector<std::string>& reasons, const Graded& before, const Graded& after) {
    const double then = before.score.variants ? before.score.variants->points : 0;
    const double now = after.score.variants ? after.score.variants->points : 0;
    if (is_same_mark(then, now)) return;
    std::string others;
    if (before.findings.variants && after.findings.variants) {
        const std::string asked_then = scenes_asked_for(*before.findings.variants);
        const std::string asked_now = scenes_asked_for(*after.findings.variants);
        if (asked_then != asked_now)
            others = fmt::format(": {}, before {}", asked_now, asked_then.empty() ? "not known" : asked_then);
    }
    reasons.push_back(fmt::format("other scenes ({}{})", signed_points(now - then), others));
}

/// The scenes that the assignment deals to students.
std::string dealt_toml(const reference::Assignment& assignment) {
    std::string text;
    for (const auto& [student, scene] : assignment.dealt) text += student + '\n' + reference::scene_toml(scene);
    return text;
}

}  // namespace

bool is_same_mark(const std::optional<double>& one, const std::optional<double>& other) {
    if (!one || !other) return one.has_value() == other.has_value();
    return std::abs(*one - *other) <= a_millionth;
}

MarkChange change_between(const Graded& before, const Graded& after) {
    MarkChange change{
        after.submission.id,     label_of(after.submission), points_that_count(before), points_that_count(after), {},
        before.score.max_points, after.score.max_points};
    const std::string& source_then = before.submission.source_sha256;
    const std::string& source_now = after.submission.source_sha256;
    if (source_then != source_now) {
        change.reasons.emplace_back(source_now.empty()    ? "the source is gone"
                                    : source_then.empty() ? "there is a source now"
                                                          : "the source changed");
    }
    if (before.execution.outcome != after.execution.outcome) {
        change.reasons.push_back(
            fmt::format("{} -> {}", to_string(before.execution.outcome), to_string(after.execution.outcome)));
    }
    if (before.late_share != after.late_share) {
        change.reasons.push_back(
            fmt::format("late: loses {:g} %, {:g} % before", after.late_share * 100, before.late_share * 100));
    }
    const bool both_marked =
        before.execution.outcome != Outcome::not_graded && after.execution.outcome != Outcome::not_graded;
    if (both_marked) {
        add_items(change.reasons, before, after);
        add_scenes(change.reasons, before, after);
    }
    return change;
}

void add(ClassChanges& changes, MarkChange change) {
    if (change.most_before != change.most_after) {
        changes.most_before = change.most_before;
        changes.most_after = change.most_after;
    }
    if (is_same_mark(change.before, change.after)) {
        if (change.reasons.empty()) {
            ++changes.untouched;
        } else {
            changes.level.push_back(std::move(change));
        }
        return;
    }
    constexpr double below_all = -1;
    const bool rises = change.after.value_or(below_all) > change.before.value_or(below_all);
    (rises ? changes.rising : changes.falling).push_back(std::move(change));
}

std::string assignment_change(const AssignmentText& before, const AssignmentText& after, const Marking& marking) {
    if (after.name != before.name) {
        return fmt::format("The assignment changed from {} to {}.", before.name, after.name);
    }
    if (after.toml == before.toml) return "";
    const std::string text = fmt::format("The assignment file of {} has changed", after.name);
    try {
        const reference::Assignment then = reference::parse_assignment(before.toml, before.name + ".toml");
        const bool same_key = reference::to_json(reference::make_key(then, reference::Precision::certified)) ==
                              reference::to_json(marking.key);
        if (same_key && dealt_toml(then) != dealt_toml(marking.assignment))
            return text + " and so have students' scenes.";
        return text + (same_key ? "; its key is the same." : " and so has the key.");
    } catch (const std::exception&) {
        return text + ".";  // the gradebook has an assignment that this version of raygrade cannot read
    }
}

}  // namespace harness
