// The command line: its subcommands, and the messages about unknown words.
#pragma once

namespace harness {

/// Parses and runs the command line, and returns the exit status. Throws UsageError for a mistake in it, HarnessError
/// if the processor's arithmetic is wrong, and the subcommand's exceptions.
int run_command_line(int argc, char** argv);

}  // namespace harness
