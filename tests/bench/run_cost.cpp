// run_cost [RUNS]: compares the cost of a run in each sandbox with a plain posix_spawn of the same program, the model
// solution, which computes for a few microseconds. The ways alternate, so that changes of the machine's load affect all
// of them. Prints medians.

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "harness/run/limits.h"
#include "harness/run/run.h"

namespace {

using Clock = std::chrono::steady_clock;

void spawn(const std::string& program) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    std::string name = program;
    char* argv[] = {name.data(), nullptr};
    pid_t pid = 0;
    int status = 1;
    const bool started = posix_spawn(&pid, name.c_str(), &actions, nullptr, argv, environ) == 0;
    posix_spawn_file_actions_destroy(&actions);
    if (!started || waitpid(pid, &status, 0) < 0 || status != 0) {
        fmt::print(stderr, "run_cost: {} does not run\n", program);
        std::exit(1);
    }
}

/// A program in a tier's sandbox, ready to be run again and again.
class InSandbox {
  public:
    InSandbox(harness::Tier tier, const std::string& program) : sandbox_(tier) {
        build_.program = scratch_.path() / "ray_cast";
        std::filesystem::copy_file(program, *build_.program);
    }
    void run() const {
        const auto result = harness::run(build_, limits_, sandbox_, scratch_);
        if (result.ended == harness::Ended::exited && result.exit_code == 0 && !result.output.empty()) return;
        fmt::print(stderr, "run_cost: the program does not run in {}\n", to_string(sandbox_.tier()));
        std::exit(1);
    }

  private:
    harness::Limits limits_ = harness::read_limits({}, {}).run;
    harness::Sandbox sandbox_;
    harness::Scratch scratch_{sandbox_.workspace()};
    harness::Build build_;
};

struct Way {
    std::string name;
    std::function<void()> run;
    std::vector<double> milliseconds;
};

double quantile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace

int main(int argc, char** argv) {
    const int runs = argc > 1 ? std::max(1, std::atoi(argv[1])) : 300;
    const std::string program = RAY_CAST;
    const InSandbox bwrap(harness::Tier::bwrap, program);
    const InSandbox landlock(harness::Tier::landlock, program);
    const InSandbox unsafe(harness::Tier::unsafe, program);
    std::vector<Way> ways = {{"posix_spawn", [&] { spawn(program); }, {}},
                             {"bwrap+shim", [&] { bwrap.run(); }, {}},
                             {"landlock+shim", [&] { landlock.run(); }, {}},
                             {"unsafe", [&] { unsafe.run(); }, {}}};
    for (int i = 0; i < runs; ++i) {
        for (Way& way : ways) {
            const auto start = Clock::now();
            way.run();
            way.milliseconds.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
        }
    }
    const double plain = quantile(ways.front().milliseconds, 0.5);
    fmt::print("{} runs each, in turn, ms\n{:<14} {:>7} {:>7} {:>7} {:>9}\n", runs, "", "10 %", "median", "90 %",
               "added");
    for (const Way& way : ways) {
        const double median = quantile(way.milliseconds, 0.5);
        fmt::print("{:<14} {:>7.2f} {:>7.2f} {:>7.2f} {:>9.2f}\n", way.name, quantile(way.milliseconds, 0.1), median,
                   quantile(way.milliseconds, 0.9), median - plain);
    }
}
