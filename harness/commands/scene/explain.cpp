#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "harness/commands/options/printout.h"
#include "harness/commands/options/shared_options.h"
#include "harness/commands/options/subcommand.h"
#include "harness/machine/errors.h"
#include "harness/machine/fresh_file.h"
#include "harness/machine/parts.h"
#include "harness/report/picture/picture.h"

namespace harness {
namespace {

struct ExplainOptions {
    std::filesystem::path printout;  ///< an output; empty for the scene alone
    std::string assignment;
    std::string out = "explain.svg";  ///< "-" for stdout
    bool force = false;               ///< replace an earlier picture
    bool without_answers = false;     ///< draw nothing that reveals the key
};

namespace fs = std::filesystem;

constexpr const char* to_stdout = "-";

int draw_explanation(const ExplainOptions& options) {
    const bool writes_file = options.out != to_stdout;
    if (writes_file) {
        require_can_write({options.out, "-o", "picture of raygrade", "<title id=\"raygrade-t\">"},
                          options.force ? Earlier::replaced : Earlier::kept);
    }
    Graded graded;
    const bool has_printout = !options.printout.empty();
    if (has_printout) graded.execution.run.output = read_printout(options.printout);
    const Marking marking = make_marking(reference::load_assignment(options.assignment, assignments_folder()));
    if (has_printout)
        graded.score = mark_printout(options.printout, graded.execution.run.output, marking.key, marking.assignment);
    const std::string picture =
        report::explaining_picture(marking, has_printout ? &graded : nullptr, !options.without_answers, "raygrade-");
    if (!writes_file) {
        fmt::print("{}", picture);
        return all_graded;
    }
    write_file(options.out, picture);
    fmt::print("picture: {}\n", options.out);
    return all_graded;
}

void add_options(CLI::App& command, ExplainOptions& options) {
    command
        .add_option("printout", options.printout,
                    "A program's output: its wrong answers are drawn beside the right ones")
        ->type_name("PRINTOUT");
    add_scene(command, options.assignment);
    command.add_option("-o,--out", options.out, "Where to write the picture; - for stdout")
        ->type_name("FILE")
        ->capture_default_str();
    command.add_flag("--force", options.force, "Replace an earlier picture");
    command.add_flag("--without-answers", options.without_answers, "For students: do not draw the right answers");
    command.footer("Example: ./ray_cast > output.txt; raygrade explain output.txt -o explain.svg");
}

}  // namespace

Subcommand explain_command(CLI::App& app) {
    return subcommand(app, "explain", "Draw the scene, its ray and a program's answers as SVG", add_options,
                      draw_explanation);
}

}  // namespace harness
