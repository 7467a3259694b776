// Runs a program in the sandbox, within its limits.
#pragma once

#include <string>
#include <vector>

#include "harness/execution/process_result.h"
#include "harness/sandbox/host/command.h"
#include "harness/sandbox/host/sandbox.h"

namespace harness {

/// Runs the command in the sandbox until it ends or exceeds a limit, and leaves none of its processes behind. Safe to
/// call from several threads. A program that exceeded a limit gets that verdict even if it exited first. Throws
/// HarnessError if the machine could not run it (no such program or folder, no more processes, no sandbox) or could not
/// determine how it ended.
ProcessResult run_process(const Command& command, const Sandbox& sandbox);

/// Same for each of the inputs in turn. An input is the program's stdin, at most longest_input bytes; empty for
/// /dev/null. The command's purpose is Purpose::run. The runs share a sandbox, but no run can find anything of another.
std::vector<ProcessResult> run_process_on_each(const std::vector<std::string>& inputs, const Command& command,
                                               const Sandbox& sandbox);

}  // namespace harness
