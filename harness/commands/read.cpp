#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "harness/commands/options/printout.h"
#include "harness/commands/options/shared_options.h"
#include "harness/commands/options/subcommand.h"
#include "harness/machine/parts.h"
#include "harness/record/marking.h"
#include "harness/report/text/reading_text.h"

namespace harness {
namespace {

struct ReadOptions {
    std::filesystem::path printout;
    std::string assignment;
    bool json = false;
};

int show_reading(const ReadOptions& options) {
    const std::string output = read_printout(options.printout);
    const Marking marking = make_marking(reference::load_assignment(options.assignment, assignments_folder()));
    const Score score = mark_printout(options.printout, output, marking.key, marking.assignment);
    fmt::print("{}", options.json ? report::reading_json(output, score) : report::reading_text(output, score));
    return all_graded;
}

void add_options(CLI::App& command, ReadOptions& options) {
    command.add_option("printout", options.printout, "A program's output, in a file")
        ->type_name("PRINTOUT")
        ->required();
    add_scene(command, options.assignment);
    command.add_flag("--json", options.json, "Print JSON (raygrade/reading/1)");
    command.footer("Example: ./ray_cast > output.txt; raygrade read output.txt");
}

}  // namespace

Subcommand read_command(CLI::App& app) {
    return subcommand(app, "read", "Show line by line how an output is read, and mark it", add_options, show_reading);
}

}  // namespace harness
