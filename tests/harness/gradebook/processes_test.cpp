// A gradebook that several processes write at once, or whose writer is killed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <random>
#include <thread>

#include "tests/given/cases.h"
#include "tests/given/report/graded_samples.h"
#include "tests/given/saved_class.h"

namespace harness {
namespace {

using namespace saved_class;
using nlohmann::json;
using report_samples::graded;
using testing::SizeIs;

TEST(Gradebook, TakesTheOverridesOfTwoProcessesAtOnce) {
    const TemporaryFolder folder;
    save(folder.path(), three());
    constexpr int each = 20;
    std::vector<pid_t> children;
    for (const int question : {6, 8}) {
        children.push_back(fork());
        ASSERT_GE(children.back(), 0);
        if (children.back() != 0) continue;
        try {
            Gradebook gradebook(folder.path());
            for (int i = 0; i < each; ++i) {
                gradebook.put_override({"s" + std::to_string(i), {question, "", 1, "why", "me", "now"}}, 0, {});
            }
        } catch (const std::exception&) {
            _exit(1);
        }
        _exit(0);
    }
    for (const pid_t child : children) {
        int status = 0;
        waitpid(child, &status, 0);
        EXPECT_EQ(status, 0);
    }
    EXPECT_THAT(Gradebook(folder.path()).overrides(), SizeIs(2 * each));
    EXPECT_EQ(rows(folder, "SELECT COUNT(*) FROM audit"), json::parse("[[41]]"));
}

/// The class of run n: every mark is n, and the number of submissions depends on n, so that mixed runs are recognised.
std::vector<Graded> class_of_run(int n) {
    std::vector<Graded> all;
    for (int i = 0; i < 20 + n % 2; ++i) {
        all.push_back(graded("s" + std::to_string(i), ""));
        all.back().score.points = n;
    }
    return all;
}

/// Kills the writer at some 25 moments, drawn from a fixed seed, while it saves one run after the other.
TEST(Gradebook, HoldsTheOldOrTheNewRunWhenItsWriterIsKilled) {
    const TemporaryFolder folder;
    // The writer is killed within about three times what a forked process of this build takes to save.
    const auto begun = std::chrono::steady_clock::now();
    const pid_t first = fork();
    ASSERT_GE(first, 0);
    if (first == 0) {
        save(folder.path(), class_of_run(1));
        _exit(0);
    }
    int first_status = 0;
    waitpid(first, &first_status, 0);
    ASSERT_EQ(first_status, 0);
    const auto one_save =
        std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - begun);
    const auto longest = static_cast<std::uint64_t>(3 * one_save.count() + 1000);
    std::mt19937 random(17);
    int saved = 1;
    for (std::uint64_t round = 0; round < std::max<std::uint64_t>(cases(25), 10); ++round) {
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            try {
                for (int n = saved + 1;; ++n) save(folder.path(), class_of_run(n));
            } catch (const std::exception&) {
                _exit(1);
            }
        }
        std::this_thread::sleep_for(std::chrono::microseconds(random() % longest));
        kill(child, SIGKILL);
        int status = 0;
        waitpid(child, &status, 0);
        ASSERT_TRUE(WIFSIGNALED(status)) << "it was still writing";
        const Gradebook gradebook(folder.path());
        const auto run = gradebook.last_run();
        ASSERT_TRUE(run);
        ASSERT_GE(run->number, saved) << "what was saved stays saved";
        saved = static_cast<int>(run->number);
        const std::vector<Graded> all = gradebook.restore();
        ASSERT_EQ(all.size(), class_of_run(saved).size());
        for (const Graded& one : all) ASSERT_EQ(one.score.points, saved) << one.submission.id;
    }
    EXPECT_GT(saved, 1) << "something was saved between two kills";
    EXPECT_EQ(rows(folder, "SELECT DISTINCT final_points FROM submissions"), json::array({json::array({saved})}));
    EXPECT_EQ(rows(folder, "SELECT COUNT(DISTINCT run), MAX(run) FROM history"),
              json::array({json::array({saved, saved})}))
        << "no run without its marks";
}

}  // namespace
}  // namespace harness
