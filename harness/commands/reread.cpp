#include "harness/grade/reread.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>

#include "harness/class_run/corrections.h"
#include "harness/commands/options/shared_options.h"
#include "harness/commands/options/subcommand.h"
#include "harness/machine/errors.h"
#include "harness/machine/fresh_file.h"
#include "harness/record/override_place.h"
#include "harness/results/reports.h"
#include "harness/text/escape.h"
#include "reference/toml/near_names.h"

namespace harness {
namespace {

struct RereadOptions : DecisionOptions {
    std::string lines;   ///< "12", "12-14", "12:2"; empty with none or remove
    bool none = false;   ///< the item was not printed
    bool alike = false;  ///< also for every other submission whose output has the same layout
};

constexpr const char* example = "raygrade reread s05 6.t 12 --why \"the label is misspelled\"";

void check_reread(const RereadOptions& options) {
    const bool says_where = !options.lines.empty() || options.none;
    const bool contradicts = (!options.lines.empty() && options.none) || (says_where && options.remove);
    if (options.id.empty() || options.item.empty() || contradicts || says_where == options.remove) {
        throw UsageError(
            options.remove
                ? "reread --remove needs a submission and an item, e.g. raygrade reread s05 6.t --remove --why \"a "
                  "slip\""
                : fmt::format("reread needs a submission, an item, and lines of its output or --none, e.g. {}",
                              example));
    }
    if (!options.why) throw UsageError(fmt::format("reread needs a reason, e.g. {}", example));
}

void list_rereads(const KeptClass& kept) {
    for (const KeptReread& kept_reread : kept.rereads) {
        const auto one = std::find_if(kept.graded.begin(), kept.graded.end(),
                                      [&](const Graded& any) { return any.submission.id == kept_reread.submission; });
        const bool holds = one != kept.graded.end() && counts(*one, kept_reread.given);
        fmt::print("{}  {}  {}{}  {}: {}\n", escape_control(kept_reread.submission), item_of(kept_reread.given),
                   kept_reread.given.lines.empty() ? "not printed" : "line " + kept_reread.given.lines,
                   holds ? "" : " (unused: there is no such submission, or its output has a different layout now)",
                   kept_reread.given.when, escape_control(note_of(kept_reread.given)));
    }
    if (kept.rereads.empty()) fmt::print("no rereads\n");
}

class Rereading {
  public:
    Rereading(const RereadOptions& options, Gradebook& gradebook, KeptClass& kept, const Marking& marking)
        : options_(options), gradebook_(gradebook), kept_(kept), marking_(marking) {}

    /// Stores the correction. Returns the indices of the changed submissions.
    std::vector<std::size_t> put() {
        const std::size_t index = find_submission(kept_.graded, options_.id);
        const Reread given = read_options(kept_.graded[index]);
        const std::vector<std::size_t> alike = with_layout(kept_, given.layout);
        std::vector<std::string> others;
        for (const std::size_t i : alike) {
            if (i != index) others.push_back(kept_.graded[i].submission.id);
        }
        const std::vector<std::size_t> changed = options_.alike ? alike : std::vector{index};
        for (const std::size_t i : changed) put(i, given);
        if (!options_.alike && !others.empty()) {
            fmt::print("These have the same layout: {}. To reread them too, add --alike.\n",
                       escape_control(fmt::format("{}", fmt::join(others, ", "))));
        }
        return changed;
    }

    /// Removes the correction. Returns the indices of the changed submissions.
    std::vector<std::size_t> remove() {
        const Author author = author_of(options_.by);
        const std::string why = read_line(*options_.why, "--why");
        std::vector<std::size_t> changed;
        for (const KeptReread& kept_reread : to_be_removed()) {
            if (const auto index = remove(kept_reread, author, why)) changed.push_back(*index);
        }
        return changed;
    }

  private:
    Reread read_options(const Graded& graded) const {
        const OverridePlace place = read_item_place(options_.item, graded);
        const std::string& printout = printout_of(graded);
        const Author author = author_of(options_.by);
        Reread given{place.question, place.item, options_.lines, layout_of(printout), read_line(*options_.why, "--why"),
                     author.name,    author.when};
        require_value(given, item_score(graded, given).spec, graded.score, printout);
        return given;
    }

    void put(std::size_t index, const Reread& given) {
        const Graded before = kept_.graded[index];
        put_reread(gradebook_, kept_, marking_, index, given);
        tell(before, kept_.graded[index], given);
    }

    /// The given correction, and with --alike those of the same item in outputs with the same layout.
    std::vector<KeptReread> to_be_removed() const {
        std::vector<std::string> items;
        std::optional<KeptReread> named;
        for (const KeptReread& kept_reread : kept_.rereads) {
            if (kept_reread.submission != options_.id) continue;
            items.push_back(item_of(kept_reread.given));
            if (items.back() == options_.item) named = kept_reread;
        }
        if (!named) {
            throw UsageError(fmt::format("{1} has no reread of {0}; {2}", escape_control(options_.item),
                                         escape_control(options_.id), reference::did_you_mean(options_.item, items)));
        }
        if (!options_.alike) return {*named};
        std::vector<KeptReread> alike;
        std::copy_if(kept_.rereads.begin(), kept_.rereads.end(), std::back_inserter(alike),
                     [&](const KeptReread& each) {
                         return item_of(each.given) == options_.item && each.given.layout == named->given.layout;
                     });
        return alike;
    }

    /// The submission's index in the class; empty if it is no longer there.
    std::optional<std::size_t> remove(const KeptReread& removed, const Author& author, const std::string& why) {
        const RemovedReread done = remove_reread(gradebook_, kept_, marking_, removed, author, why);
        if (done.before) {
            tell(*done.before, kept_.graded[*done.index], removed.given);
        } else {
            fmt::print("{} {}: removed\n", escape_control(removed.submission), escape_control(options_.item));
        }
        return done.index;
    }

    static void tell(const Graded& before, const Graded& after, const Reread& given) {
        const auto text = [](const ItemScore& item) {
            return item.printed.empty() ? std::string(to_string(item.verdict))
                                        : fmt::format("{} ({})", escape_control(item.printed), to_string(item.verdict));
        };
        fmt::print("{} {}: {} -> {}\n", escape_control(after.submission.id), item_of(given),
                   text(item_score(before, given)), text(item_score(after, given)));
        tell_mark(before, after);
    }

    const RereadOptions& options_;
    Gradebook& gradebook_;
    KeptClass& kept_;
    const Marking& marking_;
};

int reread(const RereadOptions& given) {
    if (!given.list) check_reread(given);
    RereadOptions options = given;
    const FolderLock lock(options.results);
    Gradebook gradebook(options.results);
    KeptClass kept = restore(gradebook, options.results);
    options.id = id_called(kept.graded, options.id);
    if (options.list) {
        list_rereads(kept);
        return all_graded;
    }
    const Marking marking = marking_of(kept);
    const bool as_left = reports_are_as_left(gradebook, kept.graded, marking, options.results);
    Rereading rereading(options, gradebook, kept, marking);
    const std::vector<std::size_t> changed = options.remove ? rereading.remove() : rereading.put();
    rewrite_reports(gradebook, kept, marking, as_left, changed, options.results);
    return all_graded;
}

void add_options(CLI::App& command, RereadOptions& options) {
    add_decision(command, options, "The misread item, such as 6.t");
    command
        .add_option("lines", options.lines,
                    "The lines of the output that hold it: 12, 12-14, or 12:2 and 12:2-4 for some of a line's numbers")
        ->type_name("LINES");
    command.add_flag("--none", options.none, "The program did not print the item (instead of LINES)");
    command.add_flag("--alike", options.alike,
                     "Also reread all other submissions whose output differs only in its numbers; with --remove, "
                     "remove those rereads too");
    command.footer(
        fmt::format("The item and all that follows from it are marked again, and the reports are updated at once. A "
                    "correction survives regrading as long as the output's layout is the same.\n\nExample: {}",
                    example));
}

}  // namespace

Subcommand reread_command(CLI::App& app) {
    return subcommand(app, "reread", "Point to the output line that holds an answer, and mark it again", add_options,
                      reread);
}

}  // namespace harness
