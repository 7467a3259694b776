// The instructor's real day: marks are changed by hand and by a changed rubric, and no mark is lost or lowered
// silently.
#include <SQLiteCpp/SQLiteCpp.h>
#include <fcntl.h>
#include <fmt/chrono.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <ctime>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// Prints only the answer to question 5, which is right: 10 of 100 points.
constexpr std::string_view right =
    "#include <cstdio>\nint main() { puts(\"Question 5:\\nV: vec3(0.000000, 0.000000, -1.000000)\"); }\n";
constexpr std::string_view wrong =
    "#include <cstdio>\nint main() { puts(\"Question 5:\\nV: vec3(0.500000, 0.000000, -1.000000)\"); }\n";

/// A class of ada, who is right, and ben, who is wrong.
class RealDay : public testing::Test {
  protected:
    RealDay() {
        // If root runs the tests, the programs' accounts need access to this folder.
        fs::permissions(folder.path(), static_cast<fs::perms>(0755));
        write(students() / "ada/ray_cast.cpp", right);
        write(students() / "ben/ray_cast.cpp", wrong);
    }

    fs::path students() const { return folder / "class"; }
    fs::path out() const { return folder / "out"; }
    fs::path gradebook() const { return out() / "gradebook.sqlite"; }
    Result run(const std::vector<std::string>& words) const {
        return raygrade(words, [this] { return setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1) == 0; });
    }
    Result grade(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words = {"grade", students().string(), "--out", out().string()};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }
    Result override_mark(const std::vector<std::string>& more) const {
        std::vector<std::string> words = {"override", "--results", out().string()};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }
    /// The assignment of 2021 with these lines added to its last table, [rubric].
    std::string rubric(const std::string& lines) const {
        const fs::path file = folder / "a6-2021.toml";
        write(file, read(project_folder() / "reference/assignments/a6-2021.toml") + "\n" + lines);
        return file.string();
    }
    json graded(const std::string& id) const { return submission_in(read_json(out() / "grades.json"), id); }
    double points(const std::string& id) const { return graded(id).at("points").get<double>(); }
    /// Every file of the results, with its bytes.
    std::map<std::string, std::string> files() const {
        std::map<std::string, std::string> all;
        for (const auto& entry : fs::recursive_directory_iterator(out())) {
            if (entry.is_regular_file()) all[entry.path().string()] = read(entry.path());
        }
        return all;
    }
    int count(const std::string& query) const {
        return SQLite::Database(gradebook().string(), SQLite::OPEN_READONLY).execAndGet(query).getInt();
    }

    TemporaryFolder folder;
};

TEST_F(RealDay, ARegradeShowsWhoseMarkRisesAndWhyAndWritesNothing) {
    ASSERT_EQ(grade().status, 0);
    const auto before = files();
    const Result shown = grade({"--assignment", rubric("[rubric.points]\n5 = 20\n")});
    EXPECT_EQ(shown.status, 0) << shown.both();
    EXPECT_THAT(shown.output, AllOf(HasSubstr("its key is the same"), HasSubstr("rises  ada"),
                                    HasSubstr("10 ->     20     +10  5.V: still right, now worth 10 points more")));
    EXPECT_THAT(shown.output, AllOf(HasSubstr("1 rises, 0 fall, 1 stays as it is."), HasSubstr("Nothing was written")));
    EXPECT_EQ(files(), before);

    const Result applied = grade({"--assignment", rubric("[rubric.points]\n5 = 20\n"), "--apply"});
    EXPECT_EQ(applied.status, 0) << applied.both();
    EXPECT_THAT(applied.output, HasSubstr("rises  ada"));
    EXPECT_EQ(points("ada"), 20);
    EXPECT_EQ(count("SELECT COUNT(*) FROM runs"), 2);
    EXPECT_EQ(count("SELECT automatic_points FROM history WHERE submission = 'ada' AND run = 1"), 10);
}

TEST_F(RealDay, NothingIsLoweredSilently) {
    ASSERT_EQ(grade().status, 0);
    write(students() / "ada/ray_cast.cpp", wrong);
    for (const char* apply : {"", "--apply"}) {
        const Result result = *apply == '\0' ? grade() : grade({apply});
        EXPECT_THAT(result.output, AllOf(HasSubstr("falls  ada"), HasSubstr("another source; 5.V right -> wrong (-10)"),
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
    EXPECT_THAT(grade().output, AllOf(HasSubstr("The file of the assignment a6-2021 has changed"),
                                      HasSubstr("Marks are now out of 140 points, previously out of 130.")));
    EXPECT_THAT(grade({"--assignment", "default"}).output, HasSubstr("falls  ada"));
    fs::remove(own);
    const Result gone = grade({"--apply"});
    EXPECT_EQ(gone.status, usage);
    EXPECT_THAT(gone.voice, AllOf(HasSubstr("a6-2021.toml, which is not there now"), HasSubstr("--assignment")));
    EXPECT_EQ(points("ada"), 40);
}

TEST_F(RealDay, ARegradeWithoutChangesSaysSo) {
    ASSERT_EQ(grade().status, 0);
    const Result again = grade();
    EXPECT_EQ(again.status, 0);
    EXPECT_THAT(again.output, AllOf(HasSubstr("0 rise, 0 fall, 2 stay as they are."),
                                    HasSubstr("Nothing has changed, and nothing was written to the results.")));
    EXPECT_THAT(again.output, Not(HasSubstr("ada")));
}

TEST_F(RealDay, ApplyingNoChangeWritesOnlyMissingReports) {
    ASSERT_EQ(grade().status, 0);
    const auto all = files();
    const auto written = fs::last_write_time(out() / "grades.json");
    const Result again = grade({"--apply", "--junit", (folder / "j.xml").string()});
    EXPECT_EQ(again.status, 0);
    EXPECT_THAT(again.output, AllOf(HasSubstr("2 stay as they are."), HasSubstr("nothing was written to the results."),
                                    HasSubstr("report.html")));
    EXPECT_EQ(files(), all);
    EXPECT_EQ(fs::last_write_time(out() / "grades.json"), written);
    EXPECT_TRUE(fs::exists(folder / "j.xml")) << "what was asked for is made";

    write(out() / "report.html", "edited");
    fs::remove(out() / "feedback/ben.md");
    EXPECT_THAT(grade().output,
                HasSubstr("No mark and no feedback has changed, but a file of the results is gone or was "
                          "touched; --apply writes it again.\n"));
    EXPECT_THAT(grade({"--apply"}).output, Not(HasSubstr("nothing was written")));
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
                                    HasSubstr("Apart from the marks, by number of submissions: "
                                              "sanitizers' findings new in 1"),
                                    HasSubstr("No mark changes, but the feedback of 1 submission does. Nothing was "
                                              "written to the results; --apply writes it.\n")))
        << shown.both();
    EXPECT_EQ(files(), before);
    EXPECT_THAT(grade({"--sanitize", "--apply"}).output, HasSubstr("sanitizers' findings new in 1"));
    EXPECT_THAT(read(out() / "feedback/ben.md"), HasSubstr("What the sanitizers found"));
    EXPECT_THAT(grade({"--sanitize"}).output,
                HasSubstr("Nothing has changed, and nothing was written to the results."));

    for (const char* apply : {"", "--apply"}) {
        const Result without = *apply == '\0' ? grade() : grade({apply});
        EXPECT_THAT(without.output, HasSubstr("Apart from the marks, by number of submissions: sanitizers' findings "
                                              "gone from 1 (see --sanitize)"));
    }
    EXPECT_THAT(read(out() / "feedback/ben.md"), Not(HasSubstr("What the sanitizers found")));
}

TEST_F(RealDay, ANewAssignmentOrRosterCountsAsAChange) {
    ASSERT_EQ(grade({"--assignment", rubric("")}).status, 0);
    constexpr auto unwritten = "Nothing was written to the results; --apply writes it.\n";
    EXPECT_THAT(grade({"--assignment", rubric("show_expected = true\n")}).output, HasSubstr(unwritten));
    const fs::path roster = folder / "gradebook.csv";
    write(roster, "Student,ID,Assignment 6 (71)\r\nAda,ada,\r\nBen,ben,\r\n");
    const std::vector<std::string> with_roster = {"--assignment", rubric(""), "--canvas-roster", roster.string()};
    EXPECT_THAT(grade(with_roster).output, HasSubstr(unwritten));
    ASSERT_EQ(grade({"--assignment", rubric(""), "--canvas-roster", roster.string(), "--apply"}).status, 0);
    EXPECT_THAT(grade(with_roster).output, HasSubstr("Nothing has changed"));
}

TEST_F(RealDay, PagesTellMoreOnceTheDeadlineHasPassedAndNoMarkChanges) {
    // By the clock of one time zone the deadline is ten hours off, by that of the other it is ten hours ago.
    const std::string now = fmt::format("{:%Y-%m-%d %H:%M}", fmt::gmtime(std::time(nullptr)));
    const std::string assignment =
        rubric("due = \"" + now + "\"\nfeedback = \"hint\"\nfeedback_after_due = \"expected\"\n");
    const auto in_zone = [&](const char* zone, const std::vector<std::string>& words) {
        return raygrade(words, [&] {
            return setenv("TZ", zone, 1) == 0 && setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1) == 0;
        });
    };
    constexpr auto before = "WEST+10", after = "EAST-10";
    const std::vector<std::string> regrade{"grade",        students().string(), "--out",
                                           out().string(), "--assignment",      assignment};
    const auto page = [&] { return read(out() / "feedback/ben.html"); };
    ASSERT_EQ(in_zone(before, regrade).status, 0);
    EXPECT_THAT(page(), Not(HasSubstr("Right value")));
    EXPECT_THAT(in_zone(before, regrade).output, HasSubstr("Nothing has changed"));

    EXPECT_THAT(in_zone(after, regrade).output,
                AllOf(HasSubstr("The deadline has passed: the students' pages tell \"expected\" now, \"hint\" before."),
                      HasSubstr("--apply writes it")));
    const double mark = points("ben");
    ASSERT_EQ(in_zone(after, {"override", "ada", "6.t", "1", "--why", "by hand", "--results", out().string()}).status,
              0);
    EXPECT_THAT(page(), HasSubstr("Right value")) << "all pages are written, not only ada's";
    EXPECT_EQ(points("ben"), mark);
    EXPECT_THAT(in_zone(after, regrade).output, HasSubstr("Nothing has changed"));
}

TEST_F(RealDay, ARosterOfAnotherClassIsRefusedBeforeAnythingIsGraded) {
    write(students() / "cy/ray_cast.cpp", right);
    const fs::path roster = folder / "gradebook.csv";
    write(roster, "Student,ID,Assignment 6 (71)\r\nRoe,1,\r\nDoe,2,\r\n");
    const Result refused = grade({"--canvas-roster", roster.string()});
    EXPECT_EQ(refused.status, usage);
    EXPECT_THAT(refused.voice,
                AllOf(HasSubstr("3 of 3 submissions are not in it, such as \"ada\""), HasSubstr("--canvas-roster")));
    EXPECT_FALSE(fs::exists(out() / "grades.json"));
    write(roster, "Student,ID,Assignment 6 (71)\r\nRoe,1,\r\nAda,ada,\r\n");
    EXPECT_THAT(grade({"--canvas-roster", roster.string()}).output, HasSubstr("1 matched"));
}

TEST_F(RealDay, LateHandInsLoseWhatTheScheduleSaysAndItIsKept) {
    write(students() / "ben/ray_cast.cpp", right);
    write(folder / "late.csv", "id,days_late,extension_days\nada,2,\nben,3,2\nbem,1,\n");
    const std::string schedule = rubric("late = [[1, 0.25], [2, 1.0]]\n");
    const std::vector<std::string> with_days = {"--assignment", schedule, "--late-days", folder / "late.csv",
                                                "--apply"};
    ASSERT_EQ(grade({"--assignment", schedule}).status, 0);
    const double ada = points("ada"), ben = points("ben");
    ASSERT_GT(ada, 0);
    const Result late = grade(with_days);
    EXPECT_EQ(late.status, 0) << late.both();
    EXPECT_THAT(late.voice, HasSubstr("--late-days: bem is none of the submissions; did you mean ben"));
    EXPECT_EQ(points("ada"), 0);
    EXPECT_EQ(points("ben"), 0.75 * ben) << "one day of three is left of the extension";
    EXPECT_THAT(grade({"--assignment", schedule}).output, HasSubstr("Nothing has changed")) << "it is kept";
}

TEST_F(RealDay, ALateHandInIsListedByTheNameInTheReports) {
    write(students() / "ben/ray_cast.cpp", right);
    const fs::path roster = folder / "gradebook.csv";
    write(roster, "Student,ID,Assignment 6 (71)\r\n\"Roe, Ada\",ada,\r\n\"Doe, Ben\",ben,\r\n");
    write(folder / "late.csv", "id,days_late\n\"Roe, Ada\",1\n\"Roe, Adam\",1\n");
    const Result late = grade({"--assignment", rubric("late = [[1, 1.0]]\n"), "--canvas-roster", roster.string(),
                               "--late-days", (folder / "late.csv").string()});
    EXPECT_EQ(points("ada"), 0) << late.both();
    EXPECT_GT(points("ben"), 0);
    EXPECT_THAT(late.voice, HasSubstr("--late-days: Roe, Adam is none of the submissions"));
}

TEST_F(RealDay, AnOverrideStandsInEveryReportAndSurvivesARegrade) {
    ASSERT_EQ(grade().status, 0);
    const std::string feedback_of_ada = read(out() / "feedback/ada.md");
    const Result given = override_mark({"ben", "5.V", "7.5", "--why", "the sign of x is a slip", "--by", "Prof. X"});
    EXPECT_EQ(given.status, 0) << given.both();
    EXPECT_THAT(given.output, HasSubstr("ben: 0 -> 7.5 of 100 points in all"));
    EXPECT_EQ(points("ben"), 7.5);
    EXPECT_EQ(graded("ben").at("automatic_points"), 0.0);
    EXPECT_EQ(graded("ben").at("overrides").at(0).at("why"), "the sign of x is a slip");
    EXPECT_EQ(graded("ben").at("overrides").at(0).at("by"), "Prof. X");
    EXPECT_THAT(read(out() / "feedback/ben.md"), HasSubstr("Your instructor gave 7.5 of 10 for question 5, V"));
    EXPECT_THAT(read(out() / "grades.csv"), HasSubstr("\"ben\",graded,7.5,100,"));
    EXPECT_EQ(read(out() / "feedback/ada.md"), feedback_of_ada);

    const std::string twice = rubric("[rubric.points]\n5 = 20\n");
    EXPECT_THAT(grade({"--assignment", twice}).output, HasSubstr("1 rises, 0 fall, 1 stays as it is."));
    const Result applied = grade({"--assignment", twice, "--apply"});
    EXPECT_EQ(applied.status, 0) << applied.both();
    EXPECT_THAT(applied.output, HasSubstr("7.5*\n"));
    EXPECT_THAT(applied.output, HasSubstr("* ben: 5.V 7.5 in place of 0, by Prof. X: the sign of x is a slip"));
    EXPECT_EQ(points("ben"), 7.5);
    EXPECT_EQ(points("ada"), 20);

    EXPECT_THAT(override_mark({"--list"}).output, HasSubstr("ben  5.V  7.5 (of 20, automatically 0)  by Prof. X"));
    const Result removed = override_mark({"ben", "5.V", "--remove", "--why", "it was no slip"});
    EXPECT_EQ(removed.status, 0) << removed.both();
    EXPECT_EQ(points("ben"), 0);
    EXPECT_THAT(read(out() / "feedback/ben.md"), Not(HasSubstr("Your instructor")));
    EXPECT_THAT(override_mark({"--list"}).output, HasSubstr("no overrides"));
}

TEST_F(RealDay, AnOverrideRestoresATouchedPageOfADifferentStudent) {
    grade();
    const fs::path page = out() / "feedback/ben.md";
    const std::string as_it_was = read(page);
    write(page, "edited");
    fs::last_write_time(page, fs::last_write_time(gradebook()) + std::chrono::seconds(1));
    EXPECT_EQ(override_mark({"ada", "5", "4", "--why", "a guess"}).status, 0);
    EXPECT_EQ(read(page), as_it_was);
}

TEST_F(RealDay, AnOverrideThatLowersPointsSaysFromWhatAndHowToTakeItBack) {
    grade();
    const double before = points("ada");
    const Result lower = override_mark({"ada", "5", "4", "--why", "a guess"});
    EXPECT_EQ(lower.status, 0) << lower.both();
    EXPECT_THAT(lower.voice,
                HasSubstr("note: this lowers question 5 from 10 to 4 points, and the mark from 10 to 4; to "
                          "take it back: raygrade override ada 5 --remove --why \"a slip\" --results " +
                          out().string()));
    EXPECT_EQ(points("ada"), before - 6);
    EXPECT_THAT(override_mark({"ada", "5", "5", "--why", "more"}).voice, Not(HasSubstr("lowers")));
}

TEST_F(RealDay, ReportsRewrittenFromTheGradebookEqualThoseOfARun) {
    ASSERT_EQ(grade({"-j", "1"}).status, 0);
    ASSERT_EQ(override_mark({"ben", "total", "50", "--why", "by hand"}).status, 0);
    auto by_override = files();
    ASSERT_EQ(grade({"--apply"}).status, 0);
    auto by_run = files();
    by_override.erase(gradebook().string());
    by_run.erase(gradebook().string());
    EXPECT_EQ(by_run, by_override);
    EXPECT_EQ(by_run.size(), 3U + 2 * 2U);
}

TEST_F(RealDay, AWrongOverrideIsRefusedWithTheWayOut) {
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
    refused({"ben", "5.V", "a", "--why", "x"}, "no number of points");
    refused({"ben", "5.V", "1"}, "--why");
    refused({"ben", "5.V", "1", "--why", "  "}, "--why: is blank");
    refused({"ben", "5.V", "1", "--why", "x", "--by", " "}, "--by: is blank");
    refused({"ben", "5.V", "--why", "x"}, "an item and points");
    refused({"ben", "5.V", "1", "--remove", "--why", "x"}, "takes a submission and an item");
    refused({"ben", "5.V", "--remove", "--why", "x"}, "is not overridden");
    refused({"none", "5.V", "1", "--why", "x"}, "total");
    refused({}, "override takes");
    EXPECT_EQ(files(), before);
    const Result nowhere = run({"override", "ben", "5.V", "1", "--why", "x", "--results", (folder / "no").string()});
    EXPECT_EQ(nowhere.status, usage);
    EXPECT_THAT(nowhere.voice, AllOf(HasSubstr((folder / "no").string()), HasSubstr("holds no gradebook")));
}

TEST_F(RealDay, AnUngradedSubmissionCanGetATotalAboveTheRubric) {
    write(students() / "none/notes.txt", "no source");
    ASSERT_EQ(grade().status, some_not_graded);
    const Result given = override_mark({"none", "total", "110", "--why", "shown at the board"});
    EXPECT_EQ(given.status, 0) << given.both();
    EXPECT_THAT(given.voice, HasSubstr("note: 110 is more than the 100 points of the rubric"));
    EXPECT_EQ(points("none"), 110);
    EXPECT_THAT(read(out() / "grades.csv"), HasSubstr("\"none\",not_graded,110,100,"));
    EXPECT_THAT(read(out() / "feedback/none.md"), HasSubstr("shown at the board"));
}

TEST_F(RealDay, AnOverrideStaysWhenItsSubmissionIsGone) {
    ASSERT_EQ(grade().status, 0);
    ASSERT_EQ(override_mark({"ben", "5", "6", "--why", "idea"}).status, 0);
    fs::rename(students() / "ben", folder / "ben");
    const Result without = grade({"--apply"});
    EXPECT_EQ(without.status, 0);
    EXPECT_THAT(without.output, AllOf(HasSubstr("gone   ben"), HasSubstr("1 is gone")));
    EXPECT_THAT(without.voice, HasSubstr("the override of 5 for ben is kept"));
    EXPECT_FALSE(fs::exists(out() / "feedback/ben.md"));
    EXPECT_THAT(override_mark({"--list"}).output, HasSubstr("no such submission"));
    fs::rename(folder / "ben", students() / "ben");
    EXPECT_THAT(grade({"--apply"}).output, HasSubstr("new    ben"));
    EXPECT_EQ(points("ben"), 6);
}

TEST_F(RealDay, ResultsOfAnOlderRaygradeCannotBeCompared) {
    ASSERT_EQ(grade().status, 0);
    fs::remove(gradebook());
    const auto before = files();
    const Result shown = grade();
    EXPECT_EQ(shown.status, 0) << shown.both();
    EXPECT_THAT(shown.output, AllOf(HasSubstr("nothing can be compared"), HasSubstr("--apply")));
    EXPECT_EQ(files(), before);
    EXPECT_EQ(grade({"--apply"}).status, 0);
    EXPECT_TRUE(fs::exists(gradebook()));
}

TEST_F(RealDay, ADamagedGradebookIsRefusedBeforeAnythingIsGraded) {
    ASSERT_EQ(grade().status, 0);
    write(gradebook(), std::string(5000, 'x'));
    const auto before = files();
    for (const Result& result : {grade(), grade({"--apply"}), override_mark({"ada", "5", "1", "--why", "x"})}) {
        EXPECT_EQ(result.status, usage) << result.both();
        EXPECT_THAT(result.voice, AllOf(HasSubstr(gradebook().string()), HasSubstr("is damaged"), HasSubstr("backup")));
        EXPECT_EQ(result.output, "");
    }
    EXPECT_EQ(files(), before);
}

TEST_F(RealDay, TwoCommandsAtOnceAreReported) {
    ASSERT_EQ(grade().status, 0);
    const int other = open(out().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    ASSERT_EQ(flock(other, LOCK_EX), 0);
    for (const Result& result : {grade({"--apply"}), override_mark({"ada", "5", "1", "--why", "x"})}) {
        EXPECT_EQ(result.status, usage) << result.both();
        EXPECT_THAT(result.voice, HasSubstr("another raygrade is at work"));
    }
    close(other);
    EXPECT_EQ(grade({"--apply"}).status, 0);
}

TEST_F(RealDay, ReportsThatAKilledCommandLeftUnwrittenAreCompleted) {
    ASSERT_EQ(grade().status, 0);
    SQLite::Database(gradebook().string(), SQLite::OPEN_READWRITE).exec("UPDATE reports SET entry = 0");
    fs::remove(out() / "feedback/ada.md");
    fs::remove(out() / "grades.csv");
    EXPECT_THAT(grade().output, HasSubstr("a command was ended before it had written them"));
    ASSERT_EQ(override_mark({"ben", "5", "6", "--why", "idea"}).status, 0);
    EXPECT_TRUE(fs::exists(out() / "feedback/ada.md"));
    EXPECT_THAT(read(out() / "grades.csv"), HasSubstr("\"ben\",graded,6,"));
    EXPECT_THAT(grade().output, Not(HasSubstr("was ended")));
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

TEST_F(RealDay, ALateHandInLosesTheRubricsDeduction) {
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
    EXPECT_THAT(read(out() / "feedback/adalovelace.md"), HasSubstr("Handed in late: 2.5 of 10 points are taken off"));
    const Result forgiven = grade({"--assignment", rubric("late_deduction = 0\n")});
    EXPECT_THAT(forgiven.output, HasSubstr("late: loses 0 %, 25 % before"));
}

TEST_F(RealDay, NobodyLosesPointsIfLatenessIsUnknown) {
    for (const std::string folder_name : {"Jane Doe_12_assignsubmission_file", "submission_901"}) {
        SCOPED_TRACE(folder_name);
        fs::remove_all(students());
        fs::remove_all(out());
        write(students() / folder_name / "ray_cast.cpp", right);
        const Result result = grade({"--assignment", rubric("late_deduction = 0.25\n")});
        ASSERT_EQ(result.status, 0) << result.both();
        EXPECT_THAT(result.both(), Not(HasSubstr("late")));
        const json one = read_json(out() / "grades.json").at("submissions").at(0);
        EXPECT_EQ(one.at("points"), 10.0);
        EXPECT_EQ(one.at("late_deduction"), 0.0);
        EXPECT_EQ(one.at("student").at("late"), nullptr);
    }
}

}  // namespace
}  // namespace scenario
