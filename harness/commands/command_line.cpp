#include "harness/commands/command_line.h"

#include <fmt/format.h>
#include <re2/re2.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <string>
#include <vector>

#include "harness/commands/help_format.h"
#include "harness/commands/options/subcommand.h"
#include "harness/machine/errors.h"
#include "harness/text/escape.h"
#include "reference/kernel/self_test.h"
#include "reference/toml/near_names.h"

namespace harness {
namespace {

constexpr const char* about =
    "raygrade grades a ray-casting assignment: it compiles and runs each ray_cast.cpp and compares its answers with a "
    "certified key.";

constexpr const char* footer =
    "For example: raygrade grade class/ --assignment a6-2021 --out results\n"
    "raygrade COMMAND --help lists its options, raygrade --version the version.\n"
    "Exit status: 0 all graded, 1 some not graded (or check --fail-under, stress or\n"
    "doctor failed), 2 mistake in the command or the assignment, 3 bug in raygrade.";

/// The innermost command: `check` in `raygrade assignment check`.
const CLI::App& innermost(const CLI::App& app) {
    const auto chosen = app.get_subcommands();
    return chosen.empty() ? app : innermost(*chosen.front());
}

std::string suggestion(const std::string& word, const std::vector<std::string>& names) {
    return reference::near_names(word, names).empty() ? "" : "; " + reference::did_you_mean(word, names);
}

/// Throws UsageError with `problem` as a sentence, and names the command's help.
[[noreturn]] void refuse(std::string problem, const CLI::App& command) {
    if (!problem.ends_with('?')) problem += '.';
    throw UsageError(fmt::format("{} See `{} --help`.", escape_control(problem), way_to(command)));
}

/// Throws UsageError for a word that the command does not know.
[[noreturn]] void refuse_word(const std::string& word, const CLI::App& command) {
    if (!word.starts_with('-')) refuse(fmt::format("unexpected argument \"{}\"", word), command);
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    refuse("unknown option " + word + suggestion(word, names), command);
}

/// Throws UsageError for an argument or a command that is missing.
[[noreturn]] void refuse_too_little(const CLI::App& command) {
    std::string wanted;
    for (const CLI::App* each : command.get_subcommands({})) wanted += (wanted.empty() ? "" : ", ") + each->get_name();
    if (!wanted.empty()) wanted = "one of these commands: " + wanted;
    for (const CLI::Option* option : command.get_options()) {
        if (!option->get_required() || option->count() > 0 || !wanted.empty()) continue;
        wanted = option->get_description();  // "A class to grade: a folder …"
        wanted.resize(std::min(wanted.find_first_of(":,;"), wanted.size()));
        wanted.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(wanted.front())));
    }
    throw UsageError(fmt::format("{} needs {}, e.g. {}", command.get_name(), wanted, example_of(command)));
}

/// Throws UsageError for an option's value. CLI11's messages begin with the option's name.
[[noreturn]] void refuse_value(const CLI::ParseError& error, const CLI::App& command) {
    std::string said = error.what();
    RE2::Replace(&said, "^Could not convert: ", "");
    const std::string name = said.substr(0, said.find_first_of(": "));
    const CLI::Option* option = command.get_option_no_throw(name);
    if (option == nullptr) refuse(said, command);
    const auto& values = option->results();
    if (option->get_expected_max() == 0) refuse(name + " takes no value", command);
    if (values.empty()) refuse(fmt::format("{0} needs a value: {0} {1}", name, option->get_type_name()), command);
    if (error.get_name() == "ValidationError") {
        RE2::Replace(&said, "^[^:]*: ", "");
        RE2::Replace(&said, " not in \\{", " is not one of {");
        refuse(fmt::format("{} ({})", said, name), command);
    }
    if (error.get_name() == "ConversionError") {
        refuse(fmt::format("{} is not a whole number ({})", values.back(), name), command);
    }
    if (values.size() > 1) refuse(fmt::format("{} is given {} times; give it once", name, values.size()), command);
    RE2::Replace(&said, " requires ", " also needs ");
    RE2::Replace(&said, " excludes ", " can't be used with ");
    refuse(said, command);
}

/// Throws UsageError if the first word is neither an option nor a subcommand, and then checks the second word in the
/// same way.
void require_command(const std::vector<std::string>& words, CLI::App& app) {
    const std::string& word = words.front();
    if (word.starts_with('-')) {
        if (app.get_option_no_throw(word.substr(0, word.find('='))) == nullptr) refuse_word(word, app);
        return;
    }
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
    if (std::find(names.begin(), names.end(), word) == names.end())
        refuse(fmt::format("unknown command \"{}\"{}", word, suggestion(word, names)), app);
    CLI::App& chosen = *app.get_subcommand(word);
    if (words.size() > 1 && chosen.get_require_subcommand_min() > 0)
        require_command({words.begin() + 1, words.end()}, chosen);
}

void require_sound_arithmetic() {
    const std::string trouble = reference::kernel::arithmetic_trouble();
    if (!trouble.empty()) throw HarnessError("This build of raygrade computes wrong results. " + trouble);
}

}  // namespace

int run_command_line(int argc, char** argv) {
    CLI::App app(about, "raygrade");
    app.footer(footer);
    app.require_subcommand(1);
    app.set_version_flag("-V,--version", "raygrade " RAYGRADE_VERSION)->group("");
    app.set_help_all_flag("--help-all", "");
    app.formatter_fn([](const CLI::App* command, const std::string& way, CLI::AppFormatMode mode) {
        return help_of(*command, way, mode);
    });

    std::vector<Subcommand> commands;
    const auto add = [&](const char* task, std::initializer_list<Subcommand> added) {
        for (const Subcommand& command : added) commands.push_back(command);
        for (const Subcommand& command : added) command.app->group(task);
    };
    add("Grade a class", {grade_command(app), merge_command(app), cluster_command(app), autograder_command(app)});
    add("Decide by hand", {review_command(app), override_command(app), reread_command(app)});
    add("For students", {check_command(app), serve_command(app)});
    add("Next year's assignment", {assignment_command(app), reference_command(app)});
    add("One program's output", {read_command(app), explain_command(app)});
    add("Accuracy and pictures", {accuracy_command(app), stress_command(app), render_command(app), cast_command(app)});
    add("This machine and the manual", {doctor_command(app), help_command(app)});
    if (argc < 2) {
        fmt::print("{}", app.help());
        return usage;
    }
    require_command({argv + 1, argv + argc}, app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& help) {
        return app.exit(help);
    } catch (const CLI::ExtrasError&) {
        refuse_word(app.remaining(true).front(), innermost(app));
    } catch (const CLI::RequiredError&) {
        refuse_too_little(innermost(app));
    } catch (const CLI::ParseError& error) {
        refuse_value(error, innermost(app));
    }
    const auto chosen =
        std::find_if(commands.begin(), commands.end(), [](const Subcommand& command) { return command.app->parsed(); });
    if (chosen == commands.end()) return usage;
    if (chosen->app->get_name() != "doctor") require_sound_arithmetic();  // doctor reports it with the rest
    return chosen->run();
}

}  // namespace harness
