// Marks that are changed by hand stand in every report, and nothing is changed by a wrong word.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/scenario/gradebook/real_day.h"
#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST_F(RealDay, AnOverrideIsInEveryReportAndSurvivesARegrade) {
    ASSERT_EQ(grade().status, 0);
    const std::string feedback_of_ada = read(out() / "feedback/ada.md");
    const Result given = override_mark({"ben", "5.V", "7.5", "--why", "the sign of x is a slip", "--by", "Prof. X"});
    EXPECT_EQ(given.status, 0) << given.both();
    EXPECT_THAT(given.output, HasSubstr("ben: 0 -> 7.5 of 100 points in total"));
    EXPECT_EQ(points("ben"), 7.5);
    EXPECT_EQ(graded("ben").at("automatic_points"), 0.0);
    EXPECT_EQ(graded("ben").at("overrides").at(0).at("why"), "the sign of x is a slip");
    EXPECT_EQ(graded("ben").at("overrides").at(0).at("by"), "Prof. X");
    EXPECT_THAT(read(out() / "feedback/ben.md"), HasSubstr("Your instructor gave 7.5 points for question 5, V"));
    EXPECT_THAT(read(out() / "grades.csv"), HasSubstr("\"ben\",graded,7.5,100,"));
    EXPECT_EQ(read(out() / "feedback/ada.md"), feedback_of_ada);

    const std::string twice = rubric("[rubric.points]\n5 = 20\n");
    EXPECT_THAT(grade({"--assignment", twice}).output, HasSubstr("1 rises, 0 fall, 1 stays as it is."));
    const Result applied = grade({"--assignment", twice, "--apply"});
    EXPECT_EQ(applied.status, 0) << applied.both();
    EXPECT_THAT(applied.output, HasSubstr("7.5*\n"));
    EXPECT_THAT(applied.output, HasSubstr("* ben: 5.V 7.5 instead of 0, by Prof. X: the sign of x is a slip"));
    EXPECT_EQ(points("ben"), 7.5);
    EXPECT_EQ(points("ada"), 20);

    EXPECT_THAT(override_mark({"--list"}).output, HasSubstr("ben  5.V  7.5 (of 20, automatically 0)  by Prof. X"));
    const Result removed = override_mark({"ben", "5.V", "--remove", "--why", "it was no slip"});
    EXPECT_EQ(removed.status, 0) << removed.both();
    EXPECT_EQ(points("ben"), 0);
    EXPECT_THAT(read(out() / "feedback/ben.md"), Not(HasSubstr("Your instructor")));
    EXPECT_THAT(override_mark({"--list"}).output, HasSubstr("no overrides"));
}

TEST_F(RealDay, AnOverrideThatGivesMoreThanAChangedRubricIsReported) {
    ASSERT_EQ(grade().status, 0);
    ASSERT_EQ(override_mark({"ben", "5", "9", "--why", "a slip"}).status, 0);
    EXPECT_THAT(grade().voice, Not(HasSubstr("note: the override")));
    EXPECT_THAT(grade({"--assignment", rubric("[rubric.points]\n5 = 6\n")}).voice,
                HasSubstr("note: the override of 5 for ben gives 9, more than the 6 points that the rubric gives\n"));
}

TEST_F(RealDay, AnOverrideThatLowersPointsSaysFromWhatAndHowToTakeItBack) {
    grade();
    const double before = points("ada");
    const Result lower = override_mark({"ada", "5", "4", "--why", "a guess"});
    EXPECT_EQ(lower.status, 0) << lower.both();
    EXPECT_THAT(lower.voice, HasSubstr("note: this lowers question 5 from 10 to 4 points, and the mark from 10 to 4. "
                                       "To undo it: raygrade override ada 5 --remove --why \"a slip\" --results " +
                                       out().string()));
    EXPECT_EQ(points("ada"), before - 6);
    EXPECT_THAT(override_mark({"ada", "5", "5", "--why", "more"}).voice, Not(HasSubstr("lowers")));
}

TEST_F(RealDay, AWrongOverrideIsRefusedWithAdvice) {
    write(students() / "none/notes.txt", "no source");
    ASSERT_EQ(grade().status, some_not_graded);
    const auto before = files();
    const auto refused = [&](const std::vector<std::string>& words, const std::string& why) {
        const Result result = override_mark(words);
        EXPECT_EQ(result.status, usage) << result.both();
        EXPECT_THAT(result.voice, HasSubstr(why));
    };
    refused({"bne", "5.V", "1", "--why", "x"}, "did you mean ben");
    refused({"ben", "5.v", "1", "--why", "x"}, "did you mean 5.V");
    refused({"ben", "5.V", "a", "--why", "x"}, "not a number of points");
    refused({"ben", "5.V", "1"}, "--why");
    refused({"ben", "5.V", "1", "--why", "  "}, "--why is empty");
    refused({"ben", "5.V", "1", "--why", "x", "--by", " "}, "--by is empty");
    refused({"ben", "5.V", "--why", "x"}, "an item and points");
    refused({"ben", "5.V", "1", "--remove", "--why", "x"}, "needs a submission and an item");
    refused({"ben", "5.V", "--remove", "--why", "x"}, "has no override of");
    refused({"none", "5.V", "1", "--why", "x"}, "total");
    refused({}, "override needs");
    EXPECT_EQ(files(), before);
    const Result nowhere = run({"override", "ben", "5.V", "1", "--why", "x", "--results", (folder / "no").string()});
    EXPECT_EQ(nowhere.status, usage);
    EXPECT_THAT(nowhere.voice, AllOf(HasSubstr((folder / "no").string()), HasSubstr("is not a results folder")));
}

TEST_F(RealDay, AnUngradedSubmissionCanGetATotalAboveTheRubric) {
    write(students() / "none/notes.txt", "no source");
    ASSERT_EQ(grade().status, some_not_graded);
    const Result given = override_mark({"none", "total", "110", "--why", "shown at the board"});
    EXPECT_EQ(given.status, 0) << given.both();
    EXPECT_THAT(given.voice, HasSubstr("note: 110 is more than the 100 points that the rubric gives"));
    EXPECT_EQ(points("none"), 110);
    EXPECT_THAT(read(out() / "grades.csv"), HasSubstr("\"none\",not_graded,110,100,"));
    EXPECT_THAT(read(out() / "feedback/none.md"), HasSubstr("shown at the board"));
}

}  // namespace
}  // namespace scenario
