// The subcommands of raygrade. Each writes results to stdout and messages to stderr, and returns the exit status.
#pragma once

#include <functional>

#include "harness/class_run/exit_status.h"

namespace CLI {
class App;
}

namespace harness {

/// A subcommand of the command line. Call `run` after parsing the options.
struct Subcommand {
    CLI::App* app = nullptr;
    std::function<int()> run;
};

// Each function adds its subcommand, with its options, to `app`. First, subcommands about submissions and raygrade
// itself.
Subcommand grade_command(CLI::App& app);
Subcommand merge_command(CLI::App& app);
Subcommand cluster_command(CLI::App& app);
Subcommand override_command(CLI::App& app);
Subcommand reread_command(CLI::App& app);
Subcommand check_command(CLI::App& app);
Subcommand stress_command(CLI::App& app);
Subcommand serve_command(CLI::App& app);
Subcommand review_command(CLI::App& app);
Subcommand read_command(CLI::App& app);
Subcommand doctor_command(CLI::App& app);
Subcommand autograder_command(CLI::App& app);
Subcommand help_command(CLI::App& app);
// Subcommands about an assignment's scene and its answers; they need no submission.
Subcommand reference_command(CLI::App& app);
Subcommand cast_command(CLI::App& app);
Subcommand accuracy_command(CLI::App& app);
Subcommand explain_command(CLI::App& app);
Subcommand render_command(CLI::App& app);
Subcommand assignment_command(CLI::App& app);

}  // namespace harness
