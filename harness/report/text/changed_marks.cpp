#include "harness/report/text/changed_marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "harness/report/text/columns.h"
#include "harness/text/points.h"

namespace harness::report {
namespace {

using Group = std::vector<MarkChange>;

std::string mark(const std::optional<double>& points) {
    return points ? points_text(*points) : "-";
}

std::string difference(const MarkChange& change) {
    if (!change.before || !change.after || is_same_mark(change.before, change.after)) return "";
    const double points = *change.after - *change.before;
    return (points > 0 ? "+" : "") + points_text(points);
}

using Reasons = std::vector<std::string>;

std::string joined(const Reasons& reasons) {
    constexpr std::size_t enough = 6;
    std::string text;
    for (std::size_t i = 0; i < std::min(enough, reasons.size()); ++i)
        text += (i == 0 ? "" : "; ") + one_line(reasons[i]);
    if (reasons.size() > enough) text += fmt::format("; and {} more", reasons.size() - enough);
    return text;
}

/// Reasons that most of a class share, for example a changed rubric, appear once.
struct Shared {
    Reasons reasons;     ///< empty if most have nothing in common
    std::size_t by = 0;  ///< how many submissions change for only these reasons
    std::size_t compared = 0;

    bool tells_all_of(const MarkChange& change) const { return !reasons.empty() && change.reasons == reasons; }

    /// The reasons of this submission alone.
    std::string own(const MarkChange& change) const {
        Reasons rest;
        for (const std::string& reason : change.reasons) {
            if (std::ranges::find(reasons, reason) == reasons.end()) rest.push_back(reason);
        }
        const bool has_all = !reasons.empty() && change.reasons.size() == reasons.size() + rest.size();
        return has_all ? "the same, and " + joined(rest) : joined(change.reasons);
    }
};

Shared shared_by_most(const ClassChanges& changes) {
    constexpr std::size_t fewest = 3;
    Shared shared;
    std::map<Reasons, std::size_t> counts;
    for (const auto* group : {&changes.rising, &changes.falling, &changes.level}) {
        for (const MarkChange& change : *group) ++counts[change.reasons];
        shared.compared += group->size();
    }
    shared.compared += changes.untouched;
    for (const auto& [reasons, count] : counts) {
        if (reasons.empty() || count < fewest || 2 * count <= shared.compared) continue;
        shared.reasons = reasons;
        shared.by = count;
    }
    return shared;
}

/// A group and the word at the beginning of its lines. The most important group comes last.
struct Titled {
    std::string_view word;
    const Group& group;
};

std::vector<Titled> groups(const ClassChanges& changes) {
    return {{"gone", changes.gone},
            {"new", changes.fresh},
            {"same", changes.level},
            {"rises", changes.rising},
            {"falls", changes.falling}};
}

/// The name of a submission in a line: its label, with its id if another submission has the same label.
std::map<const MarkChange*, std::string> names_of(const ClassChanges& changes) {
    std::map<std::string, int> counts;
    for (const Titled& titled : groups(changes)) {
        for (const MarkChange& change : titled.group) ++counts[change.label];
    }
    std::map<const MarkChange*, std::string> names;
    for (const Titled& each : groups(changes)) {
        for (const MarkChange& change : each.group) {
            const std::string label = one_line(change.label);
            names[&change] = counts.at(change.label) == 1 ? label : fmt::format("{} ({})", label, one_line(change.id));
        }
    }
    return names;
}

std::string counted(std::size_t count, std::string_view one, std::string_view several) {
    return fmt::format("{} {}", count, count == 1 ? one : several);
}

std::string part_text(const PartChange& change) {
    std::string text = one_line(change.part);
    const char* comma = " ";
    const auto add = [&](std::size_t count, std::string_view words) {
        if (count == 0) return;
        text += fmt::format("{}{} {}", comma, words, count);
        comma = ", ";
    };
    add(change.fresh, "new in");
    add(change.other, "changed in");
    add(change.gone, "gone from");
    if (change.gone > 0 && !change.option.empty()) text += fmt::format(" (see {})", change.option);
    return text;
}

}  // namespace

std::string changes_text(const ClassChanges& changes) {
    const Shared shared = shared_by_most(changes);
    const auto names = names_of(changes);
    std::size_t width = narrowest_id;
    for (const auto& [change, name] : names) width = std::max(width, std::min(widest_id, code_points(name)));
    std::string text;
    if (shared.by > 0) text = fmt::format("{} of {}: {}\n", shared.by, shared.compared, joined(shared.reasons));
    for (const Titled& titled : groups(changes)) {
        for (const MarkChange& change : titled.group) {
            if (shared.tells_all_of(change)) continue;
            std::string line =
                fmt::format("{:<6} {} {:>7} -> {:>6} {:>7}  {}", titled.word, padded(names.at(&change), width),
                            mark(change.before), mark(change.after), difference(change), shared.own(change));
            line.erase(line.find_last_not_of(' ') + 1);
            text += line + "\n";
        }
    }
    return text;
}

std::string changes_summary(const ClassChanges& changes) {
    std::string text = fmt::format("{}, {}", counted(changes.rising.size(), "rises", "rise"),
                                   counted(changes.falling.size(), "falls", "fall"));
    if (!changes.level.empty()) {
        text += fmt::format(", {} the same mark but different reasons", counted(changes.level.size(), "has", "have"));
    }
    text += fmt::format(", {}", counted(changes.untouched, "stays as it is", "stay as they are"));
    if (!changes.fresh.empty()) text += fmt::format(", {} new", counted(changes.fresh.size(), "is", "are"));
    if (!changes.gone.empty()) text += fmt::format(", {} gone", counted(changes.gone.size(), "is", "are"));
    if (changes.most_before != changes.most_after) {
        text += fmt::format(".\nMarks are now out of {} points, previously out of {}", points_text(changes.most_after),
                            points_text(changes.most_before));
    }
    return text + ".";
}

std::string feedback_changes_text(const FeedbackChanges& changes) {
    std::string text;
    for (const PartChange& change : changes.parts) text += (text.empty() ? "" : "; ") + part_text(change);
    if (changes.remeasured > 0) {
        text += fmt::format("{}only time and memory changed in {}", text.empty() ? "" : "; ", changes.remeasured);
    }
    return text.empty() ? "" : fmt::format("Other changes, by number of submissions: {}.\n", text);
}

}  // namespace harness::report
