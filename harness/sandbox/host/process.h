// Runs a program in the sandbox, within its limits.
#pragma once

#include <string>
#include <vector>

#include "harness/execution/process_result.h"
#include "harness/sandbox/host/command.h"
#include "harness/sandbox/host/sandbox.h"

namespace harness {

/// Runs the command in the sandbox until it ends or exceeds a limit, and leaves no process of it behind. Safe to call
/// from several threads. A program that exceeded a limit gets that verdict even if it ended by itself first. Throws
/// HarnessError if the machine could not run it (no such program or folder, no more processes, no sandbox) or could not
/// tell how it ended.
ProcessResult run_process(const Command& command, const Sandbox& sandbox);

/// The same for each of the inputs in turn: the program's stdin, at most longest_input bytes; empty for /dev/null. The
/// command's purpose is Purpose::run. The runs share a sandbox, in which none finds anything of another.
std::vector<ProcessResult> run_process_on_each(const std::vector<std::string>& inputs, const Command& command,
                                               const Sandbox& sandbox);

}  // namespace harness
