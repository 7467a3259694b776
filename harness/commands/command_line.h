// The command line: its subcommands, and what is said of a word that none of them knows.
#pragma once

namespace harness {

/// Runs what the words of the command line ask for and returns the exit status. Throws UsageError for a mistake in
/// them, HarnessError where the processor's arithmetic is wrong, and what the subcommand throws.
int run_command_line(int argc, char** argv);

}  // namespace harness
