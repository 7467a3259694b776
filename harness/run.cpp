#include "harness/run.h"

namespace harness {

Limits default_run_limits() {
    using namespace std::chrono_literals;
    constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20;
    return {.cpu = 2s,
            .wall = 10s,  // five times the CPU limit: on a busy machine a shorter one would decide by the load
            .memory_bytes = 256 * mebibyte,
            .file_bytes = 16 * mebibyte,
            .stack_bytes = 64 * mebibyte,
            .output_bytes = mebibyte,
            .error_bytes = 64 * 1024,
            .processes = 16,
            .open_files = 64};
}

ProcessResult run(const Build& build, const Limits& limits, const std::filesystem::path& scratch) {
    if (!build.program) return {};
    Command command;
    command.argv = {build.program->string()};
    command.working_directory = scratch;
    command.environment = {"PATH=/usr/local/bin:/usr/bin:/bin", "LANG=C.UTF-8", "HOME=" + scratch.string(),
                           "TMPDIR=" + scratch.string()};
    command.limits = limits;
    return run_process(command);
}

}  // namespace harness
