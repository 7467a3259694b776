// What lists of students do to marks: late hand-ins, rosters.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/scenario/gradebook/real_day.h"
#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST_F(RealDay, ARosterOfAnotherClassIsRefusedBeforeAnythingIsGraded) {
    write(students() / "cy/ray_cast.cpp", right);
    const fs::path roster = folder / "gradebook.csv";
    write(roster, "Student,ID,Assignment 6 (71)\r\nRoe,1,\r\nDoe,2,\r\n");
    const Result refused = grade({"--canvas-roster", roster.string()});
    EXPECT_EQ(refused.status, usage);
    EXPECT_THAT(refused.voice,
                AllOf(HasSubstr("does not have 3 of 3 students, such as \"ada\""), HasSubstr("--canvas-roster")));
    EXPECT_FALSE(fs::exists(out() / "grades.json"));
    write(roster, "Student,ID,Assignment 6 (71)\r\nRoe,1,\r\nAda,ada,\r\n");
    EXPECT_THAT(grade({"--canvas-roster", roster.string()}).output, HasSubstr("1 matched"));
}

TEST_F(RealDay, LateSubmissionsLoseWhatTheScheduleSaysAndItIsKept) {
    write(students() / "ben/ray_cast.cpp", right);
    write(folder / "late.csv", "id,days_late,extension_days\nada,2,\nben,3,2\nbem,1,\n");
    const std::string schedule = rubric("late = [[1, 0.25], [2, 1.0]]\n");
    const std::vector<std::string> with_days = {"--assignment", schedule, "--late-days", folder / "late.csv",
                                                "--apply"};
    ASSERT_EQ(grade({"--assignment", schedule}).status, 0);
    const double ada = points("ada"), ben = points("ben");
    ASSERT_GT(ada, 0);
    const Result for_nothing = grade({"--assignment", rubric(""), "--late-days", folder / "late.csv"});
    EXPECT_THAT(for_nothing.voice, HasSubstr("--late-days takes no points off"));
    rubric("late = [[1, 0.25], [2, 1.0]]\n");
    const Result late = grade(with_days);
    EXPECT_THAT(late.voice, Not(HasSubstr("takes no points off")));
    EXPECT_EQ(late.status, 0) << late.both();
    EXPECT_THAT(late.voice, HasSubstr("--late-days: there is no submission \"bem\"; did you mean ben"));
    EXPECT_EQ(points("ada"), 0);
    EXPECT_EQ(points("ben"), 0.75 * ben) << "one day of three is left of the extension";
    EXPECT_THAT(grade({"--assignment", schedule}).output, HasSubstr("Nothing has changed")) << "it is kept";
}

TEST_F(RealDay, AListThatChangesNoMarkIsKeptToo) {
    const std::string schedule = rubric("late = [[1, 0.25]]\n");
    ASSERT_EQ(grade({"--assignment", schedule}).status, 0);
    write(folder / "late.csv", "id,days_late,extension_days\nada,0,2\n");
    const std::string late = (folder / "late.csv").string();
    EXPECT_THAT(grade({"--assignment", schedule, "--late-days", late}).output, HasSubstr("--apply updates them"));
    EXPECT_THAT(grade({"--assignment", schedule, "--late-days", late, "--apply"}).output,
                Not(HasSubstr("Nothing has changed")));
    EXPECT_EQ(count("SELECT count(*) FROM inputs"), 1);
    EXPECT_THAT(grade({"--assignment", schedule, "--late-days", late, "--apply"}).output,
                HasSubstr("Nothing has changed"));
}

TEST_F(RealDay, ALateSubmissionIsListedByTheNameInTheReports) {
    write(students() / "ben/ray_cast.cpp", right);
    const fs::path roster = folder / "gradebook.csv";
    write(roster, "Student,ID,Assignment 6 (71)\r\n\"Roe, Ada\",ada,\r\n\"Doe, Ben\",ben,\r\n");
    write(folder / "late.csv", "id,days_late\n\"Roe, Ada\",1\n\"Roe, Adam\",1\n");
    const Result late = grade({"--assignment", rubric("late = [[1, 1.0]]\n"), "--canvas-roster", roster.string(),
                               "--late-days", (folder / "late.csv").string()});
    EXPECT_EQ(points("ada"), 0) << late.both();
    EXPECT_GT(points("ben"), 0);
    EXPECT_THAT(late.voice, HasSubstr("--late-days: there is no submission \"Roe, Adam\""));
}

TEST_F(RealDay, TwoStudentsWithTheSameNameAreDistinguishedByTheirIds) {
    write(students() / "ben/ray_cast.cpp", right);
    const fs::path roster = folder / "gradebook.csv";
    write(roster, "Student,ID,Assignment 6 (71)\r\n\"Roe, A\",ada,\r\n\"Roe, A\",ben,\r\n");
    const Result both = grade({"--canvas-roster", roster.string()});
    EXPECT_THAT(both.output, AllOf(HasSubstr("\nada "), HasSubstr("\nben "), Not(HasSubstr("\nRoe, A "))));
    const Result refused = override_mark({"Roe, A", "5", "6", "--why", "idea"});
    EXPECT_EQ(refused.status, usage);
    EXPECT_THAT(refused.voice, HasSubstr("Roe, A is the name of 2 students; use an id: ada, ben"));
}

TEST_F(RealDay, TheCanvasRosterIsKeptForOverridesAndRegrades) {
    const fs::path roster = folder / "gradebook.csv";
    write(roster, "Student,ID,Assignment 6 (71)\r\nAda,ada,\r\nBen,ben,\r\n");
    ASSERT_EQ(grade({"--canvas-roster", roster.string()}).status, 0);
    EXPECT_THAT(read(out() / "grades-canvas.csv"), HasSubstr("\"Ben\",\"ben\",\"0.00\""));
    fs::remove(roster);
    ASSERT_EQ(override_mark({"ben", "5", "6", "--why", "idea"}).status, 0);
    EXPECT_THAT(read(out() / "grades-canvas.csv"), HasSubstr("\"Ben\",\"ben\",\"6.00\""));
    ASSERT_EQ(grade({"--apply", "--assignment", rubric("[rubric.points]\n5 = 20\n")}).status, 0);
    EXPECT_THAT(read(out() / "grades-canvas.csv"), HasSubstr("\"Ada\",\"ada\",\"20.00\""));
}

TEST_F(RealDay, ALateSubmissionLosesTheRubricsDeduction) {
    fs::remove_all(students());
    write(students() / "adalovelace_LATE_11_1_ray_cast.cpp", right);
    write(students() / "benjones_12_2_ray_cast.cpp", right);
    const Result result = grade({"--assignment", rubric("late_deduction = 0.25\n")});

    ASSERT_EQ(result.status, 0) << result.both();
    EXPECT_THAT(result.output, HasSubstr("late: adalovelace: 2.5 points taken off, 25 %"));
    EXPECT_EQ(points("adalovelace"), 7.5);
    EXPECT_EQ(points("benjones"), 10);
    EXPECT_EQ(graded("adalovelace").at("late_deduction"), 2.5);
    EXPECT_THAT(read(out() / "grades.csv"), HasSubstr("\"adalovelace\",graded,7.5,100,"));
    EXPECT_THAT(read(out() / "feedback/adalovelace.md"), HasSubstr("Handed in late: 2.5 points were taken off"));
    const Result forgiven = grade({"--assignment", rubric("late_deduction = 0\n")});
    EXPECT_THAT(forgiven.output, HasSubstr("late: loses 0 %, 25 % before"));
    EXPECT_THAT(forgiven.voice, HasSubstr("late in the download: 1. They lose no points"));
    EXPECT_THAT(result.voice, Not(HasSubstr("They lose no points")));
}

TEST_F(RealDay, WhoMayBeLateIsCountedIfNothingSaysSo) {
    fs::remove_all(students());
    write(students() / "Ada Lovelace_11_assignsubmission_file/ray_cast.cpp", right);
    const std::string late = "late = [[1, 0.5]]\n";
    EXPECT_THAT(grade({"--assignment", rubric(late)}).voice,
                HasSubstr("submissions that may be late: 1. They lose no points, because their times are unknown. "
                          "raygrade needs due in"));
    EXPECT_THAT(grade({"--apply", "--assignment", rubric(late + "due = \"2026-11-05 23:59\"\n")}).voice,
                HasSubstr("submissions that may be late: 1. They lose no points, because their times are unknown. "
                          "raygrade needs readable times"));
}

}  // namespace
}  // namespace scenario
