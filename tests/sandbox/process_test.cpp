#include <fcntl.h>
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <thread>

#include "harness/failure.h"
#include "harness/sandbox/sandbox.h"
#include "harness/sandbox/scratch.h"

namespace {

using namespace std::chrono_literals;
using harness::Ended;
using harness::HarnessError;
using harness::ProcessResult;
using harness::Tier;
using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;

constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20;

/// Limits no well-behaved helper comes near, even on a busy machine.
harness::Limits wide_limits() {
    return {.cpu = 10s,
            .wall = 15s,
            .memory_bytes = 512 * mebibyte,
            .file_bytes = 16 * mebibyte,
            .stack_bytes = 8 * mebibyte,
            .output_bytes = 64 * 1024,
            .error_bytes = 1024,
            .processes = 16,
            .open_files = 64};
}

/// Made once for each tier, as raygrade does before it starts threads: a fork of another thread meanwhile would keep
/// the supervisor's copy open for writing, and the kernel starts no such program.
std::shared_ptr<harness::Sandbox> sandbox_of(Tier tier) {
    static std::map<Tier, std::shared_ptr<harness::Sandbox>> made;
    auto& sandbox = made[tier];
    if (!sandbox) sandbox = std::make_shared<harness::Sandbox>(tier);
    return sandbox;
}

/// One run of the misbehaving helper, recognisable in /proc by an environment variable of its own.
class Stranger {
  public:
    Stranger(std::shared_ptr<harness::Sandbox> sandbox, std::vector<std::string> arguments)
        : sandbox_(std::move(sandbox)) {
        static std::atomic<int> count{0};
        mark_ = "RAYGRADE_TEST=" + std::to_string(getpid()) + '-' + std::to_string(count++);
        command.argv = {MISBEHAVE};
        command.argv.insert(command.argv.end(), arguments.begin(), arguments.end());
        command.working_directory = scratch_.path();
        command.account = scratch_.account();
        command.readable = {MISBEHAVE};
        command.environment = {mark_};
        command.limits = wide_limits();
    }

    ProcessResult operator()() const { return harness::run_process(command, *sandbox_); }

    /// How many processes with the mark there are, the supervisor among them.
    int alive() const {
        int found = 0;
        for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
            std::ifstream file(entry.path() / "environ", std::ios::binary);
            const std::string text{std::istreambuf_iterator<char>(file), {}};
            if (text.find(mark_ + '\0') != std::string::npos) ++found;
        }
        return found;
    }
    bool waits_for(bool (*wanted)(int)) const {
        for (int i = 0; i < 500; ++i) {
            if (wanted(alive())) return true;
            std::this_thread::sleep_for(20ms);
        }
        return false;
    }

    harness::Command command;
    const std::filesystem::path& folder() const { return scratch_.path(); }
    void remove_supervisor() const { std::filesystem::remove(sandbox_->shim()); }
    std::string inside() const { return sandbox_->inside(folder()).string(); }

  private:
    std::shared_ptr<harness::Sandbox> sandbox_;
    harness::Scratch scratch_{sandbox_->workspace()};
    std::string mark_;
};

std::string why_not(const Stranger& run) {
    try {
        run();
    } catch (const HarnessError& error) {
        return error.what();
    }
    return "no HarnessError";
}

std::ptrdiff_t open_descriptors() {
    const std::filesystem::directory_iterator all("/proc/self/fd");
    return std::distance(begin(all), end(all));
}

/// What has to hold in every tier.
class RunProcess : public testing::TestWithParam<Tier> {
  protected:
    static Stranger stranger(std::vector<std::string> arguments) {
        return {sandbox_of(GetParam()), std::move(arguments)};
    }
};

TEST_P(RunProcess, TellsEveryExitCodeAsItIs) {
    for (const int code : {0, 3, 126, 127, 134, 139, 255}) {
        const auto result = stranger({"exit", std::to_string(code)})();
        EXPECT_EQ(result.ended, Ended::exited);
        EXPECT_EQ(result.exit_code, code);
    }
}

TEST_P(RunProcess, TellsTheSignalThatEndedTheProgram) {
    const auto crash = stranger({"segv"})();
    EXPECT_EQ(crash.ended, Ended::signalled);
    EXPECT_EQ(crash.signal, SIGSEGV);
    const auto abortion = stranger({"abort"})();
    EXPECT_EQ(abortion.ended, Ended::signalled);
    EXPECT_EQ(abortion.signal, SIGABRT);
}

TEST_P(RunProcess, KeepsTheTwoOutputsApart) {
    const auto result = stranger({"both-outputs"})();
    EXPECT_EQ(result.output, "out");
    EXPECT_EQ(result.errors, "err");
    EXPECT_FALSE(result.errors_truncated);
}

TEST_P(RunProcess, GivesTheProgramItsEnvironmentAndFolderAndNothingElse) {
    const Stranger run = stranger({"surroundings"});
    const std::string home = run.inside();
    std::string expected = run.command.environment[0] + "\nHOME=" + home + "\nTMPDIR=" + home + "\n";
    if (GetParam() == Tier::bwrap) expected += "PWD=" + home + "\n";
    EXPECT_EQ(run().output, expected + home + "\n");
}

TEST_P(RunProcess, GivesAnEmptyStdinWhateverItsCallerHas) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    ASSERT_EQ(write(ends[1], "typed", 5), 5);
    const int before = dup(STDIN_FILENO);
    dup2(ends[0], STDIN_FILENO);
    EXPECT_EQ(stranger({"read-stdin"})().exit_code, 0);
    dup2(before, STDIN_FILENO);
    for (const int fd : {before, ends[0], ends[1]}) close(fd);
}

TEST_P(RunProcess, GivesNoDescriptorButTheStandardThree) {
    const int inheritable = open("/dev/null", O_RDONLY);
    EXPECT_EQ(stranger({"list-descriptors"})().output, "0 1 2 ");
    close(inheritable);
}

TEST_P(RunProcess, DoesNotBelieveAStatusTheProgramForged) {
    EXPECT_EQ(stranger({"forge-status"})().exit_code, 7);
}

TEST_P(RunProcess, RestoresTheSignalsItsCallerIgnores) {
    const auto before = signal(SIGPIPE, SIG_IGN);
    EXPECT_EQ(stranger({"signals"})().exit_code, 0);
    signal(SIGPIPE, before);
}

TEST_P(RunProcess, KillsASpinningProgramAtTheCpuLimit) {
    Stranger run = stranger({"spin"});
    run.command.limits.cpu = 300ms;
    const auto result = run();
    EXPECT_EQ(result.ended, Ended::cpu_limit);
    EXPECT_GE(result.cpu, 300ms);
    EXPECT_LE(result.cpu, 2s);
    EXPECT_GE(result.wall, 250ms);
    EXPECT_EQ(run.alive(), 0);
}

TEST_P(RunProcess, CountsTheCpuTimeOfTheWholeTree) {
    for (const char* mode : {"spinning-children", "orphan-that-spins"}) {
        Stranger run = stranger({mode});
        run.command.limits.cpu = 400ms;
        const auto result = run();
        EXPECT_EQ(result.ended, Ended::cpu_limit) << mode;
        EXPECT_GE(result.cpu, 400ms) << mode;
        EXPECT_LE(result.cpu, 3s) << mode;
        EXPECT_EQ(run.alive(), 0) << mode;
    }
}

TEST_P(RunProcess, KillsASleeperThatIgnoresEverySignalAtTheWallLimit) {
    Stranger run = stranger({"ignore-signals"});
    run.command.limits.wall = 300ms;
    const auto result = run();
    EXPECT_EQ(result.ended, Ended::wall_limit);
    EXPECT_GE(result.wall, 300ms);
    EXPECT_LE(result.wall, 5s);
    EXPECT_LE(result.cpu, 250ms);
    EXPECT_EQ(run.alive(), 0);
}

TEST_P(RunProcess, KillsAProgramThatStopsItself) {
    Stranger run = stranger({"stop-itself"});
    run.command.limits.wall = 300ms;
    EXPECT_EQ(run().ended, Ended::wall_limit);
    EXPECT_EQ(run.alive(), 0);
}

TEST_P(RunProcess, KillsAProgramThatGrowsBeyondTheMemoryLimit) {
    Stranger run = stranger({"grow-memory"});
    run.command.limits.memory_bytes = 64 * mebibyte;
    const auto result = run();
    EXPECT_EQ(result.ended, Ended::memory_limit);
    EXPECT_GT(result.peak_memory_bytes, 64 * mebibyte);
    EXPECT_EQ(run.alive(), 0);
}

TEST_P(RunProcess, CountsTheMemoryOfTheWholeTree) {
    Stranger run = stranger({"children-with-memory"});
    run.command.limits.memory_bytes = 128 * mebibyte;
    EXPECT_EQ(run().ended, Ended::memory_limit);
    EXPECT_EQ(run.alive(), 0);
}

TEST_P(RunProcess, NoticesAMemoryPeakBetweenTwoChecks) {
    Stranger run = stranger({"touch-memory", "50"});
    const auto within = run();
    EXPECT_EQ(within.ended, Ended::exited);
    EXPECT_GE(within.peak_memory_bytes, 50 * mebibyte);
    EXPECT_LE(within.peak_memory_bytes, 60 * mebibyte);
    run.command.limits.memory_bytes = 40 * mebibyte;
    EXPECT_EQ(run().ended, Ended::memory_limit);
}

TEST_P(RunProcess, DoesNotCountTheMemoryOfItsCaller) {
    const std::vector<char> large(100 * mebibyte, 'x');
    EXPECT_LE(stranger({"exit"})().peak_memory_bytes, 20 * mebibyte + large.at(0) - 'x');
}

TEST_P(RunProcess, EndsAForkBomb) {
    for (const char* mode : {"fork-bomb", "fork-bomb-in-sessions"}) {
        const Stranger run = stranger({mode});
        const auto start = std::chrono::steady_clock::now();
        EXPECT_EQ(run().ended, Ended::process_limit) << mode;
        EXPECT_LE(std::chrono::steady_clock::now() - start, 15s) << mode;
        EXPECT_EQ(run.alive(), 0) << mode;
    }
}

TEST_P(RunProcess, KillsADaemonThatHoldsTheOutputOpen) {
    const Stranger run = stranger({"daemonise"});
    const auto result = run();
    EXPECT_EQ(result.ended, Ended::exited);
    EXPECT_EQ(result.output, "done\n");
    EXPECT_LE(result.wall, 5s);
    EXPECT_EQ(run.alive(), 0);
}

TEST_P(RunProcess, KillsOrphansThatReplaceThemselves) {
    const Stranger run = stranger({"replace-itself"});
    EXPECT_EQ(run().ended, Ended::exited);
    EXPECT_EQ(run.alive(), 0);
}

TEST_P(RunProcess, CutsEndlessOutputAtTheLimit) {
    Stranger run = stranger({"endless-output"});
    run.command.limits.output_bytes = 10000;
    const auto result = run();
    EXPECT_EQ(result.ended, Ended::output_limit);
    EXPECT_EQ(result.output, std::string(10000, 'x'));
    EXPECT_EQ(run.alive(), 0);
}

TEST_P(RunProcess, AcceptsAnOutputOfExactlyTheLimit) {
    Stranger run = stranger({"write-bytes", "20000"});
    run.command.limits.output_bytes = 20000;
    EXPECT_EQ(run().ended, Ended::exited);
    EXPECT_EQ(run().output.size(), 20000U);
    run.command.limits.output_bytes = 19999;
    EXPECT_EQ(run().ended, Ended::output_limit);
}

TEST_P(RunProcess, ReadsAndDropsEndlessErrors) {
    Stranger run = stranger({"endless-errors"});
    run.command.limits.cpu = 300ms;
    const auto result = run();
    EXPECT_EQ(result.ended, Ended::cpu_limit);
    EXPECT_EQ(result.errors, std::string(1024, 'x'));
    EXPECT_TRUE(result.errors_truncated);
}

TEST_P(RunProcess, EndsACompilerWhoseFileGrowsTooLarge) {
    Stranger run = stranger({"big-file"});
    run.command.purpose = harness::Purpose::compile;
    const auto result = run();
    EXPECT_EQ(result.ended, Ended::signalled);
    EXPECT_EQ(result.signal, SIGXFSZ);
    EXPECT_EQ(std::filesystem::file_size(run.folder() / "big"), 16 * mebibyte);
}

TEST_P(RunProcess, WaitsForAProgramThatClosedItsOutputs) {
    const auto result = stranger({"close-outputs"})();
    EXPECT_EQ(result.output, "before");
    EXPECT_EQ(result.exit_code, 5);
}

TEST_P(RunProcess, LetsAProgramWriteNothing) {
    if (GetParam() == Tier::unsafe) return;
    const Stranger run = stranger({"big-file"});
    EXPECT_EQ(run().ended, Ended::exited);
    EXPECT_TRUE(std::filesystem::is_empty(run.folder()));
}

TEST_P(RunProcess, SaysThatTheMachineFailedWhenThereIsNoProgram) {
    Stranger run = stranger({});
    run.command.argv = {"/no/such/program"};
    EXPECT_THAT(why_not(run), HasSubstr("\"/no/such/program\": No such file or directory"));
    std::ofstream(run.folder() / "text") << "no program";
    run.command.argv = {"./text"};
    EXPECT_THAT(why_not(run), HasSubstr("\"./text\": Permission denied"));
    EXPECT_EQ(run.alive(), 0);
}

TEST_P(RunProcess, BlamesAProgramThatTheKernelDoesNotStart) {
    Stranger run = stranger({});
    std::ofstream(run.folder() / "script") << "#!/no/such/interpreter\n";
    std::filesystem::permissions(run.folder() / "script", static_cast<std::filesystem::perms>(0755));
    run.command.argv = {"./script"};
    const auto result = run();
    EXPECT_EQ(result.ended, Ended::refused);
    EXPECT_EQ(result.error, ENOENT);
    run.command.purpose = harness::Purpose::compile;
    EXPECT_THAT(why_not(run), HasSubstr("\"./script\": No such file or directory")) << "a compiler is the machine's";
}

TEST_P(RunProcess, SaysThatTheMachineFailedWhenTheFolderIsMissing) {
    Stranger run = stranger({"exit"});
    run.command.working_directory = "/no/such/folder";
    EXPECT_THAT(why_not(run), AllOf(HasSubstr("/no/such/folder"), HasSubstr(": No such file or directory")));
}

TEST_P(RunProcess, KeepsTheSupervisorOutOfTheProgramsReach) {
    for (const char* mode : {"kill-supervisor", "stop-supervisor"}) {
        Stranger run = stranger({mode});
        if (GetParam() == Tier::unsafe && !run.command.account) return;
        run.command.limits.wall = 300ms;
        EXPECT_EQ(run().ended, Ended::wall_limit) << mode;
        EXPECT_EQ(run.alive(), 0) << mode;
    }
}

TEST_P(RunProcess, SaysWhatFailedWhenTheSupervisorIsGone) {
    Stranger run(std::make_shared<harness::Sandbox>(GetParam()), {"exit"});
    run.remove_supervisor();
    EXPECT_THAT(why_not(run), AnyOf(HasSubstr("No word from the supervisor"), HasSubstr("Could not start")));
    EXPECT_EQ(run.alive(), 0);
}

TEST(RunProcessWithoutASandbox, DoesNotBlameTheStudentWhenTheSupervisorWasKilled) {
    Stranger run(sandbox_of(Tier::unsafe), {"kill-supervisor"});
    run.command.account.reset();
    EXPECT_THAT(why_not(run), HasSubstr("No word from the supervisor"));
    EXPECT_TRUE(run.waits_for([](int alive) { return alive == 0; }));
}

TEST(RunProcessWithoutASandbox, EndsEvenWhenTheSupervisorWasStopped) {
    Stranger run(sandbox_of(Tier::unsafe), {"stop-supervisor"});
    run.command.account.reset();
    run.command.limits.wall = 200ms;
    EXPECT_THAT(why_not(run), HasSubstr("No word from the supervisor"));
    EXPECT_TRUE(run.waits_for([](int alive) { return alive == 0; }));
}

TEST_P(RunProcess, LeavesNothingBehindWhenTheHarnessIsKilled) {
    const Stranger sleeping = stranger({"ignore-signals"});
    const pid_t harness = fork();
    ASSERT_GE(harness, 0);
    if (harness == 0) {
        sleeping();
        _exit(0);
    }
    // The fork of the test itself bears no mark: its environment is that of the test. The supervisor's is root's to
    // see.
    EXPECT_TRUE(sleeping.waits_for([](int alive) { return alive >= 1; }));
    kill(harness, SIGKILL);
    waitpid(harness, nullptr, 0);
    EXPECT_TRUE(sleeping.waits_for([](int alive) { return alive == 0; }));
}

TEST_P(RunProcess, RunsInEightThreadsAtOnceAndLeaksNoDescriptor) {
    stranger({"exit"})();
    const auto before = open_descriptors();
    std::vector<std::thread> threads;
    std::atomic<int> right{0};
    for (int i = 0; i < 8; ++i) {
        threads.emplace_back([i, &right] {
            for (int j = 0; j < 12; ++j) {
                const int code = i * 12 + j;
                const auto result = stranger({"exit", std::to_string(code)})();
                if (result.ended == Ended::exited && result.exit_code == code) ++right;
                const auto output = stranger({"write-bytes", std::to_string(1000 + code)})();
                if (output.output.size() == static_cast<std::size_t>(1000 + code)) ++right;
            }
        });
    }
    for (auto& thread : threads) thread.join();
    EXPECT_EQ(right, 8 * 12 * 2);
    EXPECT_EQ(open_descriptors(), before);
}

TEST_P(RunProcess, LeaksNoDescriptorWhenItFails) {
    Stranger run = stranger({});
    run.command.argv = {"/no/such/program"};
    why_not(run);
    const auto before = open_descriptors();
    for (int i = 0; i < 20; ++i) why_not(run);
    EXPECT_EQ(open_descriptors(), before);
}

INSTANTIATE_TEST_SUITE_P(Tiers, RunProcess, testing::Values(Tier::bwrap, Tier::landlock, Tier::unsafe),
                         [](const auto& tier) {
                             return tier.param == Tier::bwrap      ? "bwrap"
                                    : tier.param == Tier::landlock ? "landlock"
                                                                   : "unsafe";
                         });

}  // namespace
