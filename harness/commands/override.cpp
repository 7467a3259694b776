#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "harness/class_run/corrections.h"
#include "harness/commands/options/shared_options.h"
#include "harness/commands/options/subcommand.h"
#include "harness/machine/errors.h"
#include "harness/machine/fresh_file.h"
#include "harness/machine/say.h"
#include "harness/record/final_mark.h"
#include "harness/results/reports.h"
#include "harness/text/escape.h"
#include "harness/text/points.h"
#include "harness/text/shell_word.h"
#include "reference/toml/near_names.h"

namespace harness {
namespace {

struct OverrideOptions : DecisionOptions {
    std::string points;  ///< as written; empty with remove
};

namespace fs = std::filesystem;

void list(const KeptClass& kept) {
    for (const KeptOverride& kept_override : kept.overrides) {
        const auto one = std::find_if(kept.graded.begin(), kept.graded.end(),
                                      [&](const Graded& any) { return any.submission.id == kept_override.submission; });
        const auto there = one == kept.graded.end() ? std::nullopt : points_at(one->score, kept_override.given);
        const std::string instead =
            there ? fmt::format("of {}, automatically {}", points_text(there->most), points_text(there->automatic))
                  : "unused: there is no such submission or item now";
        fmt::print("{}  {}  {} ({})  by {}, {}: {}\n", escape_control(kept_override.submission),
                   place_of(kept_override.given), points_text(kept_override.given.points), instead,
                   escape_control(kept_override.given.by), kept_override.given.when,
                   escape_control(kept_override.given.why));
    }
    if (kept.overrides.empty()) fmt::print("no overrides\n");
}

void put(Gradebook& gradebook, KeptClass& kept, std::size_t index, const OverrideOptions& options) {
    Graded& graded = kept.graded[index];
    const Graded before = graded;
    const OverridePlace place = read_place(options.item, graded);
    const Author author = author_of(options.by);
    Override given{place.question, place.item, 0, read_line(*options.why, "--why"), author.name, author.when};
    const PlacePoints there = points_at(graded.score, given).value();
    given.points = read_override_points(options.points, there);
    if (given.points > there.most) {
        say("note: {} is more than the {} points that the rubric gives\n", points_text(given.points),
            points_text(there.most));
    }
    const std::string lowered = lowered_by(before, given);
    put_override(gradebook, kept, index, given);
    fmt::print("{} {}: {} of {} (automatic: {})\n", escape_control(options.id), place_of(given),
               points_text(given.points), points_text(there.most),
               graded.execution.outcome == Outcome::not_graded ? "no mark" : points_text(there.automatic));
    tell_mark(before, graded);
    if (!lowered.empty()) {
        say("note: this lowers {}. To undo it: raygrade override {} {} --remove --why \"a slip\" --results {}\n",
            lowered, shell_word(options.id), place_of(given), shell_word(options.results.string()));
    }
}

/// The index of the submission in the class; empty if it is no longer there.
std::optional<std::size_t> remove(Gradebook& gradebook, KeptClass& kept, const OverrideOptions& options) {
    std::vector<std::string> places;
    for (const KeptOverride& kept_override : kept.overrides) {
        if (kept_override.submission == options.id) places.push_back(place_of(kept_override.given));
    }
    const auto removed = std::find_if(kept.overrides.begin(), kept.overrides.end(), [&](const KeptOverride& each) {
        return each.submission == options.id && place_of(each.given) == options.item;
    });
    if (removed == kept.overrides.end()) {
        throw UsageError(fmt::format("{1} has no override of {0}; {2}", escape_control(options.item),
                                     escape_control(options.id), reference::did_you_mean(options.item, places)));
    }
    const Author author = author_of(options.by);
    const std::string why = read_line(*options.why, "--why");
    const auto there = index_of(kept, options.id);
    const std::optional<Graded> before = there ? std::optional(kept.graded[*there]) : std::nullopt;
    const auto index = remove_override(gradebook, kept, *removed, author, why);
    if (index) {
        tell_mark(*before, kept.graded[*index]);
    } else {
        fmt::print("{} {}: removed\n", escape_control(options.id), escape_control(options.item));
    }
    return index;
}

void check(const OverrideOptions& options) {
    if (options.id.empty() || options.item.empty() || (options.points.empty() != options.remove)) {
        throw UsageError(options.remove ? "override --remove needs a submission and an item, e.g. raygrade override "
                                          "s05 6.t --remove --why \"a slip\""
                                        : "override needs a submission, an item and points, e.g. raygrade override s05 "
                                          "6.t 1.5 --why \"right but for a sign\"");
    }
    if (!options.why) throw UsageError("override needs a reason, e.g. --why \"right but for a sign\"");
}

int override_points(const OverrideOptions& given) {
    if (!given.list) check(given);
    OverrideOptions options = given;
    const FolderLock lock(options.results);
    Gradebook gradebook(options.results);
    KeptClass kept = restore(gradebook, options.results);
    options.id = id_called(kept.graded, options.id);
    if (options.list) {
        list(kept);
        return all_graded;
    }
    const Marking marking = marking_of(kept);
    const bool as_left = reports_are_as_left(gradebook, kept.graded, marking, options.results);
    std::vector<std::size_t> changed;
    if (options.remove) {
        if (const auto index = remove(gradebook, kept, options)) changed.push_back(*index);
    } else {
        changed.push_back(find_submission(kept.graded, options.id));
        put(gradebook, kept, changed.front(), options);
    }
    rewrite_reports(gradebook, kept, marking, as_left, changed, options.results);
    return all_graded;
}

void add_options(CLI::App& command, OverrideOptions& options) {
    add_decision(command, options,
                 "An item such as 6.t, a question such as 6, variants (the points for other scenes), or total");
    command.add_option("points", options.points, "The points to give, 0 or more")->type_name("POINTS");
    command.footer(
        "Overrides survive regrading. The reports are updated at once.\nExample: raygrade override s05 6.t 1.5 --why "
        "\"right but for a sign\"");
}

}  // namespace

Subcommand override_command(CLI::App& app) {
    return subcommand(app, "override", "Give points by hand, with a reason", add_options, override_points);
}

}  // namespace harness
