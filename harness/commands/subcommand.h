// The subcommands of raygrade. Each writes results to stdout and messages to stderr, and returns the exit status.
#pragma once

#include <filesystem>
#include <functional>

namespace CLI {
class App;
}

namespace harness {

/// The exit status of raygrade. Marks never change it, except under `check --fail-under`.
enum ExitStatus : int {
    all_graded = 0,
    some_not_graded = 1,  ///< also if a check gave no marks or too few
    usage = 2,            ///< the command line, a path or an assignment is wrong; nothing was graded
    our_fault = 3,
};

/// A subcommand of the command line. After parsing, `run` does what the options ask for.
struct Subcommand {
    CLI::App* app = nullptr;
    std::function<int()> run;
};

// Each adds its subcommand, with its options, to `app`.
Subcommand grade_command(CLI::App& app);
Subcommand override_command(CLI::App& app);
Subcommand reread_command(CLI::App& app);
Subcommand check_command(CLI::App& app);
Subcommand stress_command(CLI::App& app);
Subcommand serve_command(CLI::App& app);
Subcommand reference_command(CLI::App& app);
Subcommand cast_command(CLI::App& app);
Subcommand accuracy_command(CLI::App& app);
Subcommand read_command(CLI::App& app);
Subcommand explain_command(CLI::App& app);
Subcommand render_command(CLI::App& app);
Subcommand doctor_command(CLI::App& app);

/// The folder of the assignments that come with raygrade.
std::filesystem::path assignments_folder();

}  // namespace harness
