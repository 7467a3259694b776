#include "harness/serve/results/suspects.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace harness::serve {
namespace {

using namespace std::chrono_literals;

TEST(InOwnProcess, GivesTheResultOrNothingIfTheWorkCrashesOrTakesTooLong) {
    const std::string page(3'000'000, '\xff');
    const auto result = in_own_process([&] { return Result{page, 12.5, 100}; }, 60s);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->page, page);
    EXPECT_EQ(result->points, 12.5);
    EXPECT_EQ(result->max_points, 100);
    EXPECT_EQ(in_own_process([] { return Result{"", std::nullopt, 0}; }, 60s).value().points, std::nullopt);
    EXPECT_FALSE(in_own_process(
        []() -> Result {
            raise(SIGKILL);
            return {};
        },
        60s));
    EXPECT_FALSE(in_own_process([]() -> Result { throw 1; }, 60s));
    EXPECT_FALSE(in_own_process(
        []() -> Result {
            for (;;) pause();
        },
        1s));
}

TEST(Suspects, OnlyTheOneThatCrashesIsGivenUp) {
    std::string folder = (std::filesystem::temp_directory_path() / "raygrade-test.XXXXXX").string();
    ASSERT_NE(mkdtemp(folder.data()), nullptr);
    std::string deadly, innocent, later;
    {
        KeptPrograms kept_programs(folder);
        Queue queue(kept_programs, 10);
        deadly = std::get<std::string>(queue.accept("deadly"));
        innocent = std::get<std::string>(queue.accept("innocent"));
        later = std::get<std::string>(queue.accept("later"));
        queue.next();
        queue.next();  // two graders are at work when raygrade crashes
    }
    {
        KeptPrograms kept_programs(folder);
        Queue queue(kept_programs, 10);
        const auto grade = [](const Task& task) {
            if (task.source == "deadly") raise(SIGKILL);
            return Result{"page of " + task.source, 7.0, 10};
        };
        try_suspects(queue, grade, {"given up", std::nullopt, 0});
        EXPECT_EQ(queue.page(deadly), "given up");
        EXPECT_EQ(queue.page(innocent), "page of innocent");
        EXPECT_EQ(std::get<Waiting>(queue.standing(later)).position, 1U);
        EXPECT_EQ(queue.unfinished(), 1U);
    }
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace harness::serve
