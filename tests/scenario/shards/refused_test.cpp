// Shards that do not belong together, or are not whole, are refused by name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "tests/scenario/scenario.h"
#include "tests/scenario/shards/shards.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST_F(Shards, AreRefusedByNameIfOneIsMissingOrRepeated) {
    hand_in_three();
    grade_shards(3);
    const auto merge_files = [&](std::vector<std::string> files) {
        files.insert(files.begin(), {"merge", "--out", place("merged")});
        Result result = run(files);
        EXPECT_EQ(result.status, usage) << result.both();
        EXPECT_FALSE(fs::exists(folder / "merged")) << "nothing is begun";
        return result.voice;
    };
    EXPECT_THAT(merge_files({part(2, 3)}), HasSubstr("missing: parts 1 and 3 of 3"));
    EXPECT_THAT(merge_files({part(1, 3), part(2, 3)}), HasSubstr("missing: part 3 of 3"));
    fs::copy(part(1, 3), folder / "copy.part");
    EXPECT_THAT(merge_files({part(1, 3), part(2, 3), part(3, 3), place("copy.part")}),
                HasSubstr("copy.part is part 1 of 3, and so is " + part(1, 3)));
    EXPECT_THAT(merge_files({part(1, 3), part(2, 3), place("no.part")}), HasSubstr("no.part does not exist"));
    EXPECT_THAT(merge_files({part(1, 3), part(2, 3), place("class/ada/ray_cast.cpp")}),
                HasSubstr("ray_cast.cpp is not a part of a class"));
    const std::string whole = read(part(3, 3));
    write(part(3, 3), whole.substr(0, whole.size() - 1));
    EXPECT_THAT(merge_files({part(1, 3), part(2, 3), part(3, 3)}),
                HasSubstr("3-of-3.part is incomplete; grade it again with --shard 3/3"));
}

TEST_F(Shards, OfDifferentGradingsAreRefusedByName) {
    hand_in_three();
    grade_shards(2);
    const std::string original = read(part(2, 2));
    const auto refusal = [&](const std::vector<std::string>& with) {
        options = with;
        EXPECT_LE(grade_shard(2, 2).status, some_not_graded);
        options = {};
        const Result result = merge(2);
        EXPECT_EQ(result.status, usage) << result.both();
        write(part(2, 2), original);
        return result.voice;
    };
    EXPECT_THAT(refusal({"--assignment", "a6-2024"}), HasSubstr("was graded with a different assignment than"));
    EXPECT_THAT(refusal({"--limit", "run.cpu_seconds=3"}),
                HasSubstr("was graded with a different set of limits and compiler flags than"));
    EXPECT_THAT(refusal({"--repeat", "3"}), HasSubstr("different --repeat than"));
    EXPECT_THAT(refusal({"--variants", "2"}),
                AllOf(HasSubstr("different --variants than"), HasSubstr("2 from seed 1")));
    EXPECT_THAT(refusal({"--stress"}), HasSubstr("different --stress than"));
    if (holds_bwrap()) {
        EXPECT_THAT(refusal({"--sandbox", "landlock"}),
                    AllOf(HasSubstr("different sandbox than"), HasSubstr("bwrap+shim"), HasSubstr("landlock+shim")));
    }
    hand_in("dee", small_program);
    EXPECT_THAT(refusal({}), HasSubstr("was graded with a different class than"));
}

TEST_F(Shards, AreCompleteOrAbsentHoweverOftenTheyAreKilled) {
    using namespace std::chrono_literals;
    hand_in_three();
    ASSERT_EQ(grade().status, 0);
    fs::remove_all(cache);
    const std::vector<std::string> words =
        on_class("grade", {"--shard", "1/2", "--out", part(1, 2), "--merge-into", place("merged")});
    // A part that was there before stays whole too.
    for (const auto delay : {0ms, 20ms, 50ms, 100ms, 200ms, 400ms, 800ms, 1600ms}) {
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            become_raygrade(words, with_cache(cache), "/dev/null", "/dev/null");
        }
        std::this_thread::sleep_for(delay);
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        if (!fs::exists(part(1, 2))) continue;
        const Result half = run({"merge", part(1, 2), "--out", place("merged")});
        EXPECT_THAT(half.voice, AllOf(HasSubstr("missing: part 2 of 2"), Not(HasSubstr("1-of-2"))));
    }
    fs::remove_all(folder / "one");
    ASSERT_EQ(grade().status, 0);
    expect_alike(2);
}

TEST_F(Shards, RefuseOptionsThatMakeNoSenseForAShard) {
    hand_in_three();
    EXPECT_THAT(run({"grade", place("class"), "--out", place("p"), "--shard", "3/2"}).voice,
                HasSubstr("is not a share of a class"));
    EXPECT_EQ(run({"grade", place("class"), "--out", place("p"), "--shard", "1/2", "--apply"}).status, usage);
    const Result over = run({"grade", place("class"), "--out", place("class"), "--shard", "1/2"});
    EXPECT_EQ(over.status, usage);
    EXPECT_THAT(over.voice, HasSubstr("class exists and is not a part of a class; name another file with --out"));
    const Result below = run({"grade", place("class"), "--out", place("class/ada/ray_cast.cpp/p"), "--shard", "1/2"});
    EXPECT_EQ(below.status, usage);
    EXPECT_THAT(below.voice, HasSubstr("cannot make "));
}

TEST_F(Shards, MayHaveTheClassInDifferentPlaces) {
    hand_in_three();
    write(folder / "class/dan/notes.txt", "sorry");  // why it can't be graded names the folder
    const int first = grade_shard(1, 2).status;
    hand_ins = folder / "elsewhere";
    fs::rename(folder / "class", hand_ins);
    EXPECT_EQ(first + grade_shard(2, 2).status, some_not_graded) << "dan is in one of them";
    const Result merged = merge(2);
    EXPECT_EQ(merged.status, some_not_graded) << merged.both();
}

}  // namespace
}  // namespace scenario
