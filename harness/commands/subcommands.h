// The subcommands about submissions, and those about raygrade itself.
#pragma once

#include "harness/commands/options/subcommand.h"

namespace harness {

// Each adds its subcommand, with its options, to `app`.
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

}  // namespace harness
