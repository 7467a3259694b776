#include "harness/report/text/changed_marks.h"

#include <fmt/format.h>

#include <algorithm>

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

std::string reasons_of(const MarkChange& change) {
    constexpr std::size_t enough = 6;
    std::string text;
    for (std::size_t i = 0; i < std::min(enough, change.reasons.size()); ++i)
        text += (i == 0 ? "" : "; ") + one_line(change.reasons[i]);
    if (change.reasons.size() > enough) text += fmt::format("; and {} more", change.reasons.size() - enough);
    return text;
}

/// A group and the word that begins its lines. The group that an instructor must see comes last.
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

std::string counted(std::size_t count, std::string_view one, std::string_view several) {
    return fmt::format("{} {}", count, count == 1 ? one : several);
}

}  // namespace

std::string changes_text(const ClassChanges& changes) {
    std::size_t width = narrowest_id;
    for (const Titled& each : groups(changes)) {
        for (const MarkChange& change : each.group)
            width = std::max(width, std::min(widest_id, code_points(one_line(change.label))));
    }
    std::string text;
    for (const Titled& each : groups(changes)) {
        for (const MarkChange& change : each.group) {
            std::string line =
                fmt::format("{:<6} {} {:>7} -> {:>6} {:>7}  {}", each.word, padded(one_line(change.label), width),
                            mark(change.before), mark(change.after), difference(change), reasons_of(change));
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
        text += fmt::format(", {} the same mark for other reasons", counted(changes.level.size(), "has", "have"));
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

}  // namespace harness::report
