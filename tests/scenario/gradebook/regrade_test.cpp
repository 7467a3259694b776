// A regrade loses no mark and lowers none silently.
#include <SQLiteCpp/SQLiteCpp.h>
#include <fcntl.h>
#include <fmt/chrono.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <ctime>
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

TEST_F(RealDay, ARegradeShowsChangedMarksWithReasonsAndWritesNothing) {
    ASSERT_EQ(grade().status, 0);
    const auto before = files();
    const Result shown = grade({"--assignment", rubric("[rubric.points]\n5 = 20\n")});
    EXPECT_EQ(shown.status, 0) << shown.both();
    EXPECT_THAT(shown.output, AllOf(HasSubstr("its key is the same"), HasSubstr("rises  ada"),
                                    HasSubstr("10 ->     20     +10  5.V: still right, but 10 more points")));
    EXPECT_THAT(shown.output,
                AllOf(HasSubstr("1 rises, 0 fall, 1 stays as it is."), HasSubstr("The results are unchanged")));
    EXPECT_EQ(files(), before);

    const Result applied = grade({"--assignment", rubric("[rubric.points]\n5 = 20\n"), "--apply"});
    EXPECT_EQ(applied.status, 0) << applied.both();
    EXPECT_THAT(applied.output, HasSubstr("rises  ada"));
    EXPECT_EQ(points("ada"), 20);
    EXPECT_EQ(count("SELECT COUNT(*) FROM runs"), 2);
    EXPECT_EQ(count("SELECT automatic_points FROM history WHERE submission = 'ada' AND run = 1"), 10);
}

TEST_F(RealDay, StudentsWhoLeftAreNotRemovedSilently) {
    ASSERT_EQ(grade().status, 0);
    const Result shown = run({"grade", (students() / "ada").string(), "--out", out().string()});
    EXPECT_THAT(shown.output, HasSubstr("gone   ben"));
    EXPECT_THAT(shown.voice, HasSubstr("To add a submission, grade the whole class again"));
    EXPECT_EQ(points("ben"), 0) << "who is still there";
}

TEST_F(RealDay, NothingIsLoweredSilently) {
    ASSERT_EQ(grade().status, 0);
    write(students() / "ada/ray_cast.cpp", wrong);
    for (const char* apply : {"", "--apply"}) {
        const Result result = *apply == '\0' ? grade() : grade({apply});
        EXPECT_THAT(result.output,
                    AllOf(HasSubstr("falls  ada"), HasSubstr("the source changed; 5.V right -> wrong (-10)"),
                          HasSubstr("0 rise, 1 falls")))
            << result.both();
    }
    EXPECT_EQ(points("ada"), 0);
    EXPECT_EQ(count("SELECT COUNT(*) FROM audit WHERE what = 'mark of ada in run 2' AND before = '10' AND after = '0'"),
              1);
}

TEST_F(RealDay, ARegradeUsesTheAssignmentOfTheResultsByDefault) {
    const std::string own = rubric("[rubric.points]\n5 = 40\n");
    grade({"--assignment", own});
    ASSERT_EQ(points("ada"), 40);
    EXPECT_THAT(grade().output, HasSubstr("Nothing has changed"));
    write(own, read(own) + "6 = 20\n");
    EXPECT_THAT(grade().output, AllOf(HasSubstr("The assignment file of a6-2021 has changed"),
                                      HasSubstr("Marks are now out of 140 points, previously out of 130.")));
    EXPECT_THAT(grade({"--assignment", "default"}).output, HasSubstr("falls  ada"));
    fs::remove(own);
    const Result gone = grade({"--apply"});
    EXPECT_EQ(gone.status, usage);
    EXPECT_THAT(gone.voice, AllOf(HasSubstr("a6-2021.toml, which no longer exists"), HasSubstr("--assignment")));
    EXPECT_EQ(points("ada"), 40);
}

TEST_F(RealDay, ApplyingNoChangeWritesOnlyMissingReports) {
    ASSERT_EQ(grade().status, 0);
    const auto all = files();
    const auto written = fs::last_write_time(out() / "grades.json");
    const Result again = grade({"--apply"});
    EXPECT_EQ(again.status, 0);
    EXPECT_THAT(again.output, AllOf(HasSubstr("2 stay as they are."), HasSubstr("the results were not rewritten."),
                                    HasSubstr("report.html")));
    EXPECT_EQ(files(), all);
    EXPECT_EQ(fs::last_write_time(out() / "grades.json"), written);

    write(out() / "report.html", "edited");
    fs::remove(out() / "feedback/ben.md");
    EXPECT_THAT(grade().output, HasSubstr("Marks and feedback are the same, but some files of the results are missing "
                                          "or changed; --apply writes them again.\n"));
    EXPECT_THAT(grade({"--apply"}).output, Not(HasSubstr("were not rewritten")));
    auto mended = files();
    mended[gradebook()] = all.at(gradebook());
    EXPECT_EQ(mended, all);
    EXPECT_EQ(count("SELECT COUNT(*) FROM runs"), 2);
}

/// Reads memory that was never set. Its output does not show that.
constexpr std::string_view out_of_bounds =
    "#include <cstdio>\nint main() { volatile int i = 3; int a[3] = {}; volatile int b = a[i]; (void)b; "
    "puts(\"Question 5:\\nV: vec3(0.000000, 0.000000, -1.000000)\"); }\n";

TEST_F(RealDay, AChangeOfFeedbackAloneIsReportedAndApplied) {
    write(students() / "ben/ray_cast.cpp", out_of_bounds);
    ASSERT_EQ(grade().status, 0);
    const auto before = files();
    const Result shown = grade({"--sanitize"});
    EXPECT_THAT(shown.output, AllOf(HasSubstr("0 rise, 0 fall, 2 stay as they are.\n"),
                                    HasSubstr("Other changes, by number of submissions: "
                                              "sanitizers' findings new in 1"),
                                    HasSubstr("No mark changes, but the feedback of 1 submission does. The results "
                                              "are unchanged; --apply updates them.\n")))
        << shown.both();
    EXPECT_EQ(files(), before);
    EXPECT_THAT(grade({"--sanitize", "--apply"}).output, HasSubstr("sanitizers' findings new in 1"));
    EXPECT_THAT(read(out() / "feedback/ben.md"), HasSubstr("Sanitizer: "));
    EXPECT_THAT(grade({"--sanitize"}).output, HasSubstr("Nothing has changed; the results were not rewritten."));

    for (const char* apply : {"", "--apply"}) {
        const Result without = *apply == '\0' ? grade() : grade({apply});
        EXPECT_THAT(without.output, HasSubstr("Other changes, by number of submissions: sanitizers' findings "
                                              "gone from 1 (see --sanitize)"));
    }
    EXPECT_THAT(read(out() / "feedback/ben.md"), Not(HasSubstr("Sanitizer: ")));
}

TEST_F(RealDay, ANewAssignmentOrRosterCountsAsAChange) {
    ASSERT_EQ(grade({"--assignment", rubric("")}).status, 0);
    constexpr auto unwritten = "The results are unchanged; --apply updates them.\n";
    EXPECT_THAT(grade({"--assignment", rubric("show_expected = true\n")}).output, HasSubstr(unwritten));
    const fs::path roster = folder / "gradebook.csv";
    write(roster, "Student,ID,Assignment 6 (71)\r\nAda,ada,\r\nBen,ben,\r\n");
    const std::vector<std::string> with_roster = {"--assignment", rubric(""), "--canvas-roster", roster.string()};
    EXPECT_THAT(grade(with_roster).output, HasSubstr(unwritten));
    ASSERT_EQ(grade({"--assignment", rubric(""), "--canvas-roster", roster.string(), "--apply"}).status, 0);
    EXPECT_THAT(grade(with_roster).output, HasSubstr("Nothing has changed"));
}

TEST_F(RealDay, PagesRevealMoreAfterTheDeadlineAndNoMarkChanges) {
    // By the clock of one time zone the deadline is ten hours off, by that of the other it is ten hours ago.
    const std::string now = fmt::format("{:%Y-%m-%d %H:%M}", fmt::gmtime(std::time(nullptr)));
    const std::string assignment =
        rubric("due = \"" + now + "\"\nfeedback = \"hint\"\nfeedback_after_due = \"expected\"\n");
    const auto in_zone = [&](const char* zone, const std::vector<std::string>& words) {
        return raygrade(words, [&] { return setenv("TZ", zone, 1) == 0 && with_cache(folder / "cache")(); });
    };
    constexpr auto before = "WEST+10", after = "EAST-10";
    const std::vector<std::string> regrade{"grade",        students().string(), "--out",
                                           out().string(), "--assignment",      assignment};
    const auto page = [&] { return read(out() / "feedback/ben.html"); };
    ASSERT_EQ(in_zone(before, regrade).status, 0);
    EXPECT_THAT(page(), Not(HasSubstr("Correct value")));
    EXPECT_THAT(in_zone(before, regrade).output, HasSubstr("Nothing has changed"));

    EXPECT_THAT(in_zone(after, regrade).output,
                AllOf(HasSubstr("The deadline has passed: feedback is \"expected\" now, \"hint\" before."),
                      HasSubstr("--apply writes them again")));
    const double mark = points("ben");
    ASSERT_EQ(in_zone(after, {"override", "ada", "6.t", "1", "--why", "by hand", "--results", out().string()}).status,
              0);
    EXPECT_THAT(page(), HasSubstr("Correct value")) << "all pages are written, not only ada's";
    EXPECT_EQ(points("ben"), mark);
    EXPECT_THAT(in_zone(after, regrade).output, HasSubstr("Nothing has changed"));
}

TEST_F(RealDay, ResultsOfAnOlderRaygradeCannotBeCompared) {
    ASSERT_EQ(grade().status, 0);
    fs::remove(gradebook());
    const auto before = files();
    const Result shown = grade();
    EXPECT_EQ(shown.status, 0) << shown.both();
    EXPECT_THAT(shown.output, AllOf(HasSubstr("nothing to compare with"), HasSubstr("--apply")));
    EXPECT_EQ(files(), before);
    EXPECT_EQ(grade({"--apply"}).status, 0);
    EXPECT_TRUE(fs::exists(gradebook()));
}

TEST_F(RealDay, ReportsThatAKilledCommandLeftUnwrittenAreCompleted) {
    ASSERT_EQ(grade().status, 0);
    SQLite::Database(gradebook().string(), SQLite::OPEN_READWRITE).exec("UPDATE reports SET entry = 0");
    fs::remove(out() / "feedback/ada.md");
    fs::remove(out() / "grades.csv");
    EXPECT_THAT(grade().output, HasSubstr("a command was stopped before it wrote them"));
    ASSERT_EQ(override_mark({"ben", "5", "6", "--why", "idea"}).status, 0);
    EXPECT_TRUE(fs::exists(out() / "feedback/ada.md"));
    EXPECT_THAT(read(out() / "grades.csv"), HasSubstr("\"ben\",graded,6,"));
    EXPECT_THAT(grade().output, Not(HasSubstr("was stopped")));
}

}  // namespace
}  // namespace scenario
