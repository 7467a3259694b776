#include "harness/run/run.h"

#include "harness/sandbox/host/process.h"

namespace harness {
namespace {

Command command_of(const Build& build, const Limits& limits, const Sandbox& sandbox, const Scratch& scratch) {
    Command command;
    // Relative to the working directory, because that has a different path inside the sandbox.
    command.argv = {"./" + build.program->lexically_relative(scratch.path()).string()};
    command.working_directory = scratch.path();
    command.purpose = Purpose::run;
    command.account = scratch.account();
    command.environment = {"PATH=/usr/local/bin:/usr/bin:/bin", "LANG=C.UTF-8"};
    command.preload = sandbox.line_buffer();
    command.limits = limits;
    return command;
}

}  // namespace

ProcessResult run(const Build& build, const Limits& limits, const Sandbox& sandbox, const Scratch& scratch,
                  const std::vector<std::string>& more_environment) {
    if (!build.program) return {};
    Command command = command_of(build, limits, sandbox, scratch);
    command.environment.insert(command.environment.end(), more_environment.begin(), more_environment.end());
    return run_process(command, sandbox);
}

std::vector<ProcessResult> run_on_each(const std::vector<std::string>& inputs, const Build& build, const Limits& limits,
                                       const Sandbox& sandbox, const Scratch& scratch) {
    if (!build.program) return std::vector<ProcessResult>(inputs.size());
    return run_process_on_each(inputs, command_of(build, limits, sandbox, scratch), sandbox);
}

}  // namespace harness
