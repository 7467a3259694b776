// The subcommands about an assignment's scene and its answers, which need no submission.
#pragma once

#include "harness/commands/options/subcommand.h"

namespace harness {

// Each adds its subcommand, with its options, to `app`.
Subcommand reference_command(CLI::App& app);
Subcommand cast_command(CLI::App& app);
Subcommand accuracy_command(CLI::App& app);
Subcommand explain_command(CLI::App& app);
Subcommand render_command(CLI::App& app);
Subcommand assignment_command(CLI::App& app);

}  // namespace harness
