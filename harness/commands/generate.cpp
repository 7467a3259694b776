#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "harness/commands/help.h"
#include "harness/commands/subcommands.h"
#include "harness/machine/fresh_file.h"
#include "harness/option_table/table.h"

namespace harness {
namespace {

struct GenerateOptions {
    std::string what;
    std::filesystem::path out = ".";
};

/// The program's commands, and what can follow `help`.
option_table::Command table_of(const CLI::App& app) {
    option_table::Command program = option_table::read_table(app);
    std::vector<std::string> topics = topics_beside_commands();
    for (const option_table::Command& command : program.commands) topics.push_back(command.name());
    for (option_table::Command& command : program.commands) {
        if (command.name() == "help") command.arguments.front().choices = topics;
    }
    return program;
}

std::vector<option_table::File> files_of(const std::string& what, const option_table::Command& program) {
    if (what == "bash") return {{"raygrade.bash", option_table::bash_completion(program)}};
    if (what == "zsh") return {{"_raygrade", option_table::zsh_completion(program)}};
    if (what == "fish") return {{"raygrade.fish", option_table::fish_completion(program)}};
    return option_table::man_pages(program, "raygrade " RAYGRADE_VERSION);
}

int generate(const CLI::App& app, const GenerateOptions& options) {
    make_folder(options.out, "");
    for (const auto& [name, text] : files_of(options.what, table_of(app))) {
        write_file(options.out / name, text);
        fmt::print("{}\n", (options.out / name).string());
    }
    return all_graded;
}

}  // namespace

Subcommand generate_command(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "generate", "Write the man pages, or what completes command lines in a shell, from the program's own options");
    const auto options = std::make_shared<GenerateOptions>();
    command.add_option("what", options->what, "Which files: the man pages, or the completion for a shell")
        ->required()
        ->check(CLI::IsMember({"man", "bash", "zsh", "fish"}));
    command.add_option("-o,--out", options->out, "The folder for them; earlier ones there are replaced")
        ->type_name("DIR")
        ->capture_default_str();
    command.footer("Example: raygrade generate bash --out ~/.local/share/bash-completion/completions");
    return {&command, [&app, options] { return generate(app, *options); }};
}

}  // namespace harness
