// Shards that are merged make the results of one machine.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/given/cases.h"
#include "tests/scenario/scenario.h"
#include "tests/scenario/shards/shards.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

/// Into how many shards a class is split: `usual`, and in the target nightly other numbers too.
std::vector<int> counts(int usual) {
    return is_nightly() ? std::vector{1, 2, 5} : std::vector{usual};
}

/// Every sample submission, but those that stand for a class of another year or attack; by day seven of them.
TEST_F(Shards, OfTheSampleClassMakeTheResultsOfOneMachine) {
    for (const auto& entry : fs::directory_iterator(project_folder() / "submissions")) {
        const std::string name = entry.path().filename().string();
        if (name == "hostile" || name == "2024" || (!is_nightly() && name.back() % 7 != 0)) continue;
        hand_in(name, read(entry.path() / "ray_cast.cpp"));
    }
    hand_in("nothing", "");
    fs::create_directory(hand_ins / "empty");
    // On a busy machine the clock would end a program in one run, and its computing in the other.
    options = {"--assignment", "a6-2021", "--limit", "run.wall_seconds=100"};
    ASSERT_LE(grade().status, some_not_graded);
    for (const int count : counts(5)) expect_alike(count);
}

TEST_F(Shards, OfAClassOnOtherAndHardScenesMakeTheResultsOfOneMachine) {
    const fs::path edge = project_folder() / "tests/given/labelled/edge";
    for (const char* who : {"e01", "e02", "e03"}) hand_in(who, read(edge / who / "ray_cast.cpp"));
    options = {"--assignment", (edge / "assignment.toml").string(), "--variants", "2", "--stress", "--repeat", "2"};
    ASSERT_EQ(grade().status, 0);
    expect_alike(2);
}

TEST_F(Shards, OfAClusterCarryTheListsOfStudents) {
    hand_in_by_moodle();
    ASSERT_EQ(grade().status, some_not_graded);
    ASSERT_EQ(write_scripts().status, 0);
    ASSERT_EQ(script("shard 1"), 0);
    ASSERT_EQ(script("shard 2"), 0);
    EXPECT_EQ(script("merge"), some_not_graded);
    expect_same(folder / "one", folder / "merged");
    EXPECT_THAT(read(folder / "merged/grades-moodle.csv"), HasSubstr("Participant 11,Jane Doe,5.00"));

    EXPECT_THAT(write_scripts().voice, HasSubstr("has the scripts and parts of an earlier class"));
    write(folder / "worksheet.csv",
          "Identifier,Full name,Grade,Maximum grade,Last modified (grade)\nParticipant 99,Vi Voe,,100.00,-\n");
    EXPECT_THAT(write_scripts().voice, HasSubstr("Give the roster of this class with --moodle-worksheet"));
}

TEST_F(Shards, KnowTheSceneThatWasDealtToEachStudent) {
    write(folder / "class.csv", "id,name\nada,Ada\nben,Ben\n");
    ASSERT_EQ(run({"assignment", "deal", "a6-2021", place("class.csv"), "--out", place("dealt")}).status, 0);
    hand_in_three();
    options = {"--assignment", place("dealt/a6-2021.toml")};
    ASSERT_EQ(grade().status, some_not_graded) << "no scene was dealt to cy";
    expect_alike(2);
}

TEST_F(Shards, KeepDecisionsThroughARegrade) {
    hand_in_three();
    hand_in("dee",
            "#include <cstdio>\nint main() { puts(\"Question 5:\\nDEBUG: vec3(0.000000, 0.000000, -1.000000)\"); }\n");
    ASSERT_EQ(grade().status, 0);
    expect_alike(2);
    for (const char* results : {"one", "merged"}) {
        EXPECT_EQ(run({"override", "ada", "5.V", "3", "--why", "so", "--results", place(results)}).status, 0);
        EXPECT_EQ(run({"reread", "dee", "5.V", "2", "--why", "it is V", "--results", place(results)}).status, 0);
    }
    hand_in("ben", "int main() { return 1; }\n");
    const auto before = files_of(folder / "merged");
    grade_shards(2);
    const Result shown = merge(2);
    EXPECT_THAT(shown.output, AllOf(HasSubstr("ben"), HasSubstr("The results are unchanged")));
    EXPECT_EQ(files_of(folder / "merged"), before);
    EXPECT_EQ(merge(2, {"--apply"}).status, 0);
    ASSERT_EQ(grade({"--apply"}).status, 0);
    expect_same(folder / "one", folder / "merged");
    EXPECT_THAT(read(folder / "merged/grades.json"), AllOf(HasSubstr("\"why\":\"so\""), HasSubstr("it is V")));

    EXPECT_THAT(merge(2, {"--apply"}).output, HasSubstr("Nothing has changed"));
    expect_same(folder / "one", folder / "merged");
}

/// The parts were made before the reread, so they do not know it.
TEST_F(Shards, AreMarkedAgainWithALaterCorrection) {
    hand_in_three();
    hand_in("dee",
            "#include <cstdio>\nint main() { puts(\"Question 5:\\nDEBUG: vec3(0.000000, 0.000000, -1.000000)\"); }\n");
    grade_shards(2);
    ASSERT_EQ(merge(2).status, 0);
    ASSERT_EQ(run({"reread", "dee", "5.V", "2", "--why", "it is V", "--results", place("merged")}).status, 0);
    const auto before = files_of(folder / "merged");
    EXPECT_THAT(merge(2, {"--apply"}).output, HasSubstr("Nothing has changed"));
    EXPECT_EQ(files_of(folder / "merged"), before);
    ASSERT_EQ(run({"reread", "dee", "5.V", "--remove", "--why", "no", "--results", place("merged")}).status, 0);
    const auto taken_back = files_of(folder / "merged");
    EXPECT_THAT(merge(2, {"--apply"}).output, HasSubstr("Nothing has changed"));
    EXPECT_EQ(files_of(folder / "merged"), taken_back);
}

}  // namespace
}  // namespace scenario
