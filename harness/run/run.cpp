#include "harness/run/run.h"

namespace harness {

ProcessResult run(const Build& build, const Limits& limits, const Sandbox& sandbox, const Scratch& scratch,
                  const std::string& input, const std::vector<std::string>& more_environment) {
    if (!build.program) return {};
    Command command;
    // Relative to the working directory, because inside the sandbox that has another path than outside.
    command.argv = {"./" + build.program->lexically_relative(scratch.path()).string()};
    command.working_directory = scratch.path();
    command.purpose = Purpose::run;
    command.account = scratch.account();
    command.environment = {"PATH=/usr/local/bin:/usr/bin:/bin", "LANG=C.UTF-8"};
    command.preload = sandbox.line_buffer();
    command.environment.insert(command.environment.end(), more_environment.begin(), more_environment.end());
    command.input = input;
    command.limits = limits;
    return run_process(command, sandbox);
}

}  // namespace harness
