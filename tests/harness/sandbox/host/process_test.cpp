#include "harness/sandbox/host/process.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <thread>

#include "harness/machine/errors.h"
#include "tests/given/message_of.h"
#include "tests/given/sandbox/stranger.h"

namespace {
std::atomic<bool> asked_to_kill_everything{false};
}  // namespace

/// In place of the C library's, so that a fault that kills every process of the user fails a test and does no harm.
extern "C" int kill(pid_t process, int signal) noexcept {
    if (process == -1) {
        asked_to_kill_everything = true;
        return 0;
    }
    return static_cast<int>(syscall(SYS_kill, process, signal));
}

namespace {

using namespace std::chrono_literals;
using harness::Ended;
using harness::HarnessError;
using harness::Tier;
using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;

std::string why_not(const Stranger& run) {
    return message_of<HarnessError>(run, "no HarnessError");
}

std::ptrdiff_t open_descriptors() {
    const std::filesystem::directory_iterator all("/proc/self/fd");
    return std::distance(begin(all), end(all));
}

class RunProcess : public InEveryTier {};

TEST_P(RunProcess, ReportsEveryExitCodeUnchanged) {
    for (const int code : {0, 3, 126, 127, 134, 139, 255}) {
        const auto result = stranger({"exit", std::to_string(code)})();
        EXPECT_EQ(result.ended, Ended::exited);
        EXPECT_EQ(result.exit_code, code);
    }
}

TEST_P(RunProcess, ReportsTheSignalThatEndedTheProgram) {
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

TEST_P(RunProcess, GivesTheProgramOnlyItsEnvironmentAndFolder) {
    const Stranger run = stranger({"surroundings"});
    const std::string home = run.inside();
    std::string expected = run.command.environment[0] + "\nHOME=" + home + "\nTMPDIR=" + home + "\n";
    if (GetParam() == Tier::bwrap) expected += "PWD=" + home + "\n";
    EXPECT_EQ(run().output, expected + home + "\n");
}

TEST_P(RunProcess, GivesAnEmptyStdinForAnyCaller) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    ASSERT_EQ(write(ends[1], "typed", 5), 5);
    const int before = dup(STDIN_FILENO);
    dup2(ends[0], STDIN_FILENO);
    EXPECT_EQ(stranger({"read-stdin"})().exit_code, 0);
    dup2(before, STDIN_FILENO);
    for (const int fd : {before, ends[0], ends[1]}) close(fd);
}

TEST_P(RunProcess, GivesOnlyTheThreeStandardDescriptors) {
    const int inheritable = open("/dev/null", O_RDONLY);
    EXPECT_EQ(stranger({"list-descriptors"})().output, "0 1 2 ");
    close(inheritable);
}

TEST_P(RunProcess, RunsOnEachInputInTurn) {
    const Stranger run = stranger({"as-told"});
    std::vector<std::string> inputs;
    for (int i = 0; i < 20; ++i)
        inputs.push_back(i % 2 == 0 ? "say " + std::to_string(i) : "exit " + std::to_string(i));
    const auto results = run.on_each(inputs);
    ASSERT_EQ(results.size(), inputs.size());
    for (int i = 0; i < 20; ++i) {
        const auto& result = results[static_cast<std::size_t>(i)];
        EXPECT_EQ(result.ended, Ended::exited) << i;
        EXPECT_EQ(result.output, i % 2 == 0 ? std::to_string(i) : "") << i;
        EXPECT_EQ(result.exit_code, i % 2 == 0 ? 0 : i) << i;
    }
    EXPECT_EQ(run.alive(), 0);
}

TEST_P(RunProcess, GivesEachOfSeveralRunsItsOwnLimitsAndEnd) {
    Stranger run = stranger({"as-told"});
    run.command.limits.cpu = 400ms;
    run.command.limits.output_bytes = 10000;
    run.command.limits.memory_bytes = 50 * mebibyte;
    const auto results = run.on_each({"", "spin", "say a", "touch-memory 80", "say b", "endless-output", "segv",
                                      "say c", "daemonise", "endless-errors", "say d"});
    std::vector<Ended> ends;
    std::string said;
    for (const auto& result : results) {
        ends.push_back(result.ended);
        if (result.output.size() == 1) said += result.output;
    }
    EXPECT_THAT(ends, testing::ElementsAre(Ended::exited, Ended::cpu_limit, Ended::exited, Ended::memory_limit,
                                           Ended::exited, Ended::output_limit, Ended::signalled, Ended::exited,
                                           Ended::exited, Ended::cpu_limit, Ended::exited));
    EXPECT_EQ(said, "abcd");
    EXPECT_EQ(results[0].exit_code, 93) << "no input";
    EXPECT_LT(results[2].cpu, 400ms) << "not what earlier runs took";
    EXPECT_LT(results[4].peak_memory_bytes, 50 * mebibyte);
    EXPECT_EQ(results[5].output.size(), 10000U);
    EXPECT_EQ(results[8].output, "done\n");
    EXPECT_EQ(run.alive(), 0);
}

TEST_P(RunProcess, KeepsSeveralRunsApart) {
    const Stranger run = stranger({"as-told"});
    const auto results =
        run.on_each({"replace-itself", "list-descriptors", "daemonise", "list-descriptors", "forge-status", "exit 4"});
    ASSERT_EQ(results.size(), 6U);
    EXPECT_EQ(results[1].output, "0 1 2 ");
    EXPECT_EQ(results[3].output, "0 1 2 ");
    EXPECT_EQ(results[4].exit_code, 7);
    EXPECT_EQ(results[5].exit_code, 4);
    EXPECT_EQ(run.alive(), 0);
}

TEST_P(RunProcess, KeepsTheSupervisorOfSeveralRunsOutOfReach) {
    Stranger run = stranger({"as-told"});
    if (GetParam() == Tier::unsafe && !run.command.account) return;
    run.command.limits.wall = 300ms;
    const auto results = run.on_each({"kill-supervisor", "say a", "stop-supervisor", "say b"});
    ASSERT_EQ(results.size(), 4U);
    EXPECT_EQ(results[0].ended, Ended::wall_limit);
    EXPECT_EQ(results[1].output, "a");
    EXPECT_EQ(results[2].ended, Ended::wall_limit);
    EXPECT_EQ(results[3].output, "b");
}

TEST_P(RunProcess, IgnoresAStatusThatTheProgramForged) {
    EXPECT_EQ(stranger({"forge-status"})().exit_code, 7);
}

TEST_P(RunProcess, RestoresSignalsThatItsCallerIgnores) {
    const auto before = signal(SIGPIPE, SIG_IGN);
    EXPECT_EQ(stranger({"signals"})().exit_code, 0);
    signal(SIGPIPE, before);
}

TEST_P(RunProcess, KillsADaemonThatHoldsTheOutputOpen) {
    const Stranger run = stranger({"daemonise"});
    const auto result = run();
    EXPECT_EQ(result.ended, Ended::exited);
    EXPECT_EQ(result.output, "done\n");
    EXPECT_LE(result.wall, 5s);
    EXPECT_EQ(run.alive(), 0);
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

TEST_P(RunProcess, BlamesTheMachineWhenThereIsNoProgram) {
    Stranger run = stranger({});
    run.command.argv = {"/no/such/program"};
    EXPECT_THAT(why_not(run), HasSubstr("\"/no/such/program\": No such file or directory"));
    std::ofstream(run.folder() / "text") << "no program";
    run.command.argv = {"./text"};
    EXPECT_THAT(why_not(run), HasSubstr("\"./text\": Permission denied"));
    EXPECT_EQ(run.alive(), 0);
    EXPECT_THROW(run.on_each({"a", "b"}), HarnessError);
}

TEST_P(RunProcess, BlamesAProgramThatTheKernelDoesNotStart) {
    Stranger run = stranger({});
    std::ofstream(run.folder() / "script") << "#!/no/such/interpreter\n";
    std::filesystem::permissions(run.folder() / "script", static_cast<std::filesystem::perms>(0755));
    run.command.argv = {"./script"};
    const auto result = run();
    EXPECT_EQ(result.ended, Ended::refused);
    EXPECT_EQ(result.error, ENOENT);
    for (const auto& each : run.on_each({"a", "b", "c"})) EXPECT_EQ(each.ended, Ended::refused);
    run.command.purpose = harness::Purpose::compile;
    EXPECT_THAT(why_not(run), HasSubstr("\"./script\": No such file or directory")) << "a compiler is the machine's";
}

TEST_P(RunProcess, BlamesTheMachineWhenTheFolderIsMissing) {
    Stranger run = stranger({"exit"});
    run.command.working_directory = "/no/such/folder";
    EXPECT_THAT(why_not(run), AllOf(HasSubstr("/no/such/folder"), HasSubstr(": No such file or directory")));
}

TEST_P(RunProcess, ReportsTheFailureWhenTheSupervisorIsGone) {
    Stranger run(std::make_shared<harness::Sandbox>(GetParam()), {"exit"});
    run.remove_supervisor();
    EXPECT_THAT(why_not(run), AnyOf(HasSubstr("The supervisor (raygrade-supervisor) did not report"),
                                    HasSubstr("Could not start"), HasSubstr("could not create a sandbox")));
    EXPECT_EQ(run.alive(), 0);
}

TEST(RunProcessWithoutASandbox, DoesNotBlameTheStudentWhenTheSupervisorWasKilled) {
    Stranger run(sandbox_of(Tier::unsafe), {"kill-supervisor"});
    run.command.account.reset();
    EXPECT_THAT(why_not(run), HasSubstr("The supervisor (raygrade-supervisor) did not report"));
    run.command.argv.back() = "as-told";
    EXPECT_THROW(run.on_each({"say a", "kill-supervisor", "say b"}), HarnessError);
    EXPECT_TRUE(run.waits_for([](int alive) { return alive == 0; }));
}

void expect_end_of_a_run_whose_supervisor_was_stopped() {
    Stranger run(sandbox_of(Tier::unsafe), {"stop-supervisor"});
    run.command.account.reset();
    run.command.limits.wall = 200ms;
    EXPECT_THAT(why_not(run), HasSubstr("The supervisor (raygrade-supervisor) did not report"));
    EXPECT_TRUE(run.waits_for([](int alive) { return alive == 0; }));
}

TEST(RunProcessWithoutASandbox, KillsNoOtherProcessIfItWasStoppedBeyondEveryDeadline) {
    Stranger sleeping(sandbox_of(Tier::unsafe), {"ignore-signals"});
    sleeping.command.limits.wall = 2s;  // in which a busy machine sees it alive too
    const pid_t harness = fork();
    ASSERT_GE(harness, 0);
    if (harness == 0) {
        const bool ended_as_always = sleeping().ended == Ended::wall_limit;
        _exit(asked_to_kill_everything ? 3 : ended_as_always ? 0 : 1);
    }
    ASSERT_TRUE(sleeping.waits_for([](int alive) { return alive >= 1; }));
    kill(harness, SIGSTOP);
    // More than the wall limit and what the supervisor has beyond it; another run takes nearly as long.
    const auto end = std::chrono::steady_clock::now() + 13s;
    expect_end_of_a_run_whose_supervisor_was_stopped();
    std::this_thread::sleep_until(end);
    kill(harness, SIGCONT);
    int status = -1;
    waitpid(harness, &status, 0);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST_P(RunProcess, LeavesNothingBehindWhenTheHarnessIsKilled) {
    const Stranger sleeping = stranger({"ignore-signals"});
    const pid_t harness = fork();
    ASSERT_GE(harness, 0);
    if (harness == 0) {
        sleeping();
        _exit(0);
    }
    // The forked test process has the test's environment, so it does not count as a process of the run. Only root can
    // read the supervisor's environment.
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
            for (int j = 0; j < 6; ++j) {
                const int code = i * 6 + j;
                const auto result = stranger({"exit", std::to_string(code)})();
                if (result.ended == Ended::exited && result.exit_code == code) ++right;
                const auto output = stranger({"write-bytes", std::to_string(1000 + code)})();
                if (output.output.size() == static_cast<std::size_t>(1000 + code)) ++right;
            }
        });
    }
    for (auto& thread : threads) thread.join();
    EXPECT_EQ(right, 8 * 6 * 2);
    EXPECT_EQ(open_descriptors(), before);
}

TEST_P(RunProcess, LeaksNoDescriptorWhenItFails) {
    Stranger run = stranger({});
    run.command.argv = {"/no/such/program"};
    why_not(run);
    const auto before = open_descriptors();
    for (int i = 0; i < 20; ++i) why_not(run);
    EXPECT_THROW(run.on_each(std::vector<std::string>(20)), HarnessError);
    EXPECT_EQ(open_descriptors(), before);
}

INSTANTIATE_TEST_SUITE_P(Tiers, RunProcess, every_tier(), name_of_tier);

}  // namespace
