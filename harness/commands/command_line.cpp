#include "harness/commands/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "harness/commands/options/subcommand.h"
#include "harness/machine/errors.h"
#include "harness/text/escape.h"
#include "reference/kernel/self_test.h"
#include "reference/toml/near_names.h"

namespace harness {
namespace {

constexpr const char* about =
    "Grades a ray-casting assignment: compiles each ray_cast.cpp, runs it, reads its\n"
    "answers and marks them against a certified key.\n\n"
    "  raygrade grade class/ --out results     a class: marks, reports, grades.json\n"
    "  raygrade merge parts/* --out results    the same, of what several machines have graded\n"
    "  raygrade cluster slurm class/           the scripts that grade on a Slurm cluster\n"
    "  raygrade review results                 what needs a person, side by side in a browser\n"
    "  raygrade override s05 6.t 2 --why ...   an instructor's mark in place of the automatic one\n"
    "  raygrade reread s05 6.t 12 --why ...    where an answer stands that was misread; marks follow from it\n"
    "  raygrade check ray_cast.cpp             a student's own check before handing in\n"
    "  raygrade serve                          the same check as a page for browsers\n"
    "  raygrade stress ray_cast.cpp            which hard scenes a method survives\n"
    "  raygrade assignment check FILE          what an assignment's scene shows, before students see it\n"
    "  raygrade autograder gradescope          the zip that makes Gradescope grade with raygrade\n"
    "  raygrade reference                      the canonical answers\n"
    "  raygrade cast < queries.jsonl           exact answers to any rays\n"
    "  raygrade accuracy --out accuracy        what accuracy costs in time: a page of pictures\n"
    "  raygrade read output.txt                how a printout is read, line by line, and its marks\n"
    "  raygrade explain output.txt             a picture of the scene and of what a program printed\n"
    "  raygrade render -o scene.png            the scene as its camera sees it\n"
    "  raygrade doctor                         what this machine has and lacks\n"
    "  raygrade help                           every command, limits, and the manual";

constexpr const char* footer =
    "Exit status: 0 all graded, 1 some not graded, 2 a mistake in the command or the assignment, 3 a fault of "
    "raygrade.\n"
    "`stress` exits with 1 if no hard scene could be tried, `doctor` if this machine can't grade.\n"
    "Marks never change it, except under `check --fail-under`.";

/// "raygrade assignment check"
std::string way_to(const CLI::App& command) {
    const CLI::App* parent = command.get_parent();
    return (parent == nullptr ? "" : way_to(*parent) + " ") + command.get_name();
}

/// The command that was given last: `raygrade assignment check` is check's.
const CLI::App& innermost(const CLI::App& app) {
    const auto chosen = app.get_subcommands();
    return chosen.empty() ? app : innermost(*chosen.front());
}

/// The text with an end of a sentence: a question has its own.
std::string ended(std::string text) {
    if (!text.ends_with('?')) text += '.';
    return text;
}

/// Throws UsageError for the words that the command does not know.
[[noreturn]] void refuse(const std::vector<std::string>& words, const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    const std::string& word = words.front();
    const std::string what = word.starts_with('-') ? "is no option; " + reference::did_you_mean(word, names)
                                                   : "is one word too many for this command";
    throw UsageError(
        fmt::format("{}: {} `{} --help` says what there is", escape_control(word), ended(what), way_to(command)));
}

/// Throws UsageError for a first word that is no option and no subcommand, of those below the first word neither.
void require_command(const std::vector<std::string>& words, CLI::App& app) {
    const std::string& word = words.front();
    if (word.starts_with('-') && app.get_option_no_throw(word.substr(0, word.find('='))) == nullptr)
        refuse({word}, app);
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
    if (word.starts_with('-')) return;
    if (std::find(names.begin(), names.end(), word) == names.end()) {
        throw UsageError(fmt::format("{}: is no command; {} `{} --help` says what each does", escape_control(word),
                                     ended(reference::did_you_mean(word, names)), way_to(app)));
    }
    CLI::App& chosen = *app.get_subcommand(word);
    if (words.size() > 1 && chosen.get_require_subcommand_min() > 0)
        require_command({words.begin() + 1, words.end()}, chosen);
}

void require_sound_arithmetic() {
    const std::string trouble = reference::kernel::arithmetic_trouble();
    if (!trouble.empty()) throw HarnessError("This program's arithmetic is not to be trusted. " + trouble);
}

}  // namespace

int run_command_line(int argc, char** argv) {
    CLI::App app(about, "raygrade");
    app.footer(footer);
    app.require_subcommand(1);
    app.set_version_flag("-V,--version", "raygrade " RAYGRADE_VERSION);
    app.get_formatter()->column_width(36);

    const std::array commands{
        grade_command(app),      merge_command(app),      cluster_command(app), review_command(app),
        override_command(app),   reread_command(app),     check_command(app),   serve_command(app),
        stress_command(app),     reference_command(app),  cast_command(app),    accuracy_command(app),
        read_command(app),       explain_command(app),    render_command(app),  doctor_command(app),
        assignment_command(app), autograder_command(app), help_command(app),
    };
    if (argc < 2) {
        fmt::print("{}", app.help());
        return usage;
    }
    require_command({argv + 1, argv + argc}, app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ExtrasError&) {
        refuse(app.remaining(true), innermost(app));
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? all_graded : usage;
    }
    const auto chosen =
        std::find_if(commands.begin(), commands.end(), [](const Subcommand& command) { return command.app->parsed(); });
    if (chosen == commands.end()) return usage;
    if (chosen->app->get_name() != "doctor") require_sound_arithmetic();  // the doctor tells it beside the rest
    return chosen->run();
}

}  // namespace harness
