#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "harness/class_run/installation.h"
#include "harness/commands/printout.h"
#include "harness/commands/shared_options.h"
#include "harness/commands/subcommand.h"
#include "harness/machine/bounded_file.h"
#include "harness/machine/errors.h"
#include "harness/machine/fresh_file.h"
#include "harness/report/picture/picture.h"

namespace harness {
namespace {

struct ExplainOptions {
    std::filesystem::path transcript;  ///< what a program printed; empty for the scene alone
    std::string assignment;
    std::string out = "explain.svg";  ///< "-" for stdout
    bool force = false;               ///< replace an earlier picture
    bool without_answers = false;     ///< draw nothing that reveals the key
};

namespace fs = std::filesystem;

constexpr const char* to_stdout = "-";

/// Every picture of raygrade's contains it, and hardly any other file does.
constexpr std::string_view mark_of_ours = "<title id=\"raygrade-t\">";

/// Throws UsageError unless there is nothing at `out` or an earlier picture that may be replaced.
void check_out(const fs::path& out, bool may_replace) {
    std::error_code error;
    const fs::path folder = out.has_parent_path() ? out.parent_path() : ".";
    if (!fs::is_directory(folder, error)) {
        throw UsageError(
            fmt::format("{}: there is no such folder; make it, or name another file with -o", folder.string()));
    }
    const fs::path fresh = place_beside(out);
    if (fs::exists(fs::symlink_status(fresh, error))) {
        throw UsageError(fmt::format("{}: is in the way; remove it, or name another file with -o", fresh.string()));
    }
    const fs::file_status status = fs::symlink_status(out, error);
    if (!fs::exists(status)) return;
    constexpr std::size_t enough = 1000;
    const bool ours = read_bounded(out, enough, Links::refuse).bytes.find(mark_of_ours) != std::string::npos;
    if (!ours) {
        throw UsageError(
            fmt::format("{}: is there already and is no picture of raygrade; name another file with -o", out.string()));
    }
    if (!may_replace) {
        throw UsageError(fmt::format(
            "{}: holds an earlier picture; replace it with --force, or name another file with -o", out.string()));
    }
}

int draw_explanation(const ExplainOptions& options) {
    const bool writes_file = options.out != to_stdout;
    if (writes_file) check_out(options.out, options.force);
    Graded graded;
    const bool has_transcript = !options.transcript.empty();
    if (has_transcript) graded.run.output = read_printout(options.transcript);
    const Marking marking = make_marking(reference::load_assignment(options.assignment, assignments_folder()));
    if (has_transcript)
        graded.score = mark_printout(options.transcript, graded.run.output, marking.key, marking.assignment);
    const std::string picture =
        report::explaining_picture(marking, has_transcript ? &graded : nullptr, !options.without_answers, "raygrade-");
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
        .add_option("transcript", options.transcript,
                    "What a program printed: its wrong points and vectors are drawn beside the right ones")
        ->type_name("TRANSCRIPT");
    add_assignment(command, options.assignment);
    command.add_option("-o,--out", options.out, "Where to write the picture; - for stdout")
        ->type_name("FILE")
        ->capture_default_str();
    command.add_flag("--force", options.force, "Replace an earlier picture");
    command.add_flag("--without-answers", options.without_answers,
                     "For a student: draw what the handout gives and what was printed, and nothing of the key");
    command.footer("Example: ./ray_cast > output.txt; raygrade explain output.txt -o explain.svg");
}

}  // namespace

Subcommand explain_command(CLI::App& app) {
    return subcommand(
        app, "explain",
        "Draw the assignment as SVG: camera, image plane, ray, objects, hit points, by the handout's names",
        add_options, draw_explanation);
}

}  // namespace harness
