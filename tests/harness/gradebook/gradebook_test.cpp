#include "harness/gradebook/gradebook.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "harness/machine/errors.h"
#include "harness/report/data/grades_json.h"
#include "tests/given/bytes_of.h"
#include "tests/given/message_of.h"
#include "tests/given/report/graded_samples.h"
#include "tests/given/saved_class.h"
#include "tests/given/temporary_folder.h"

namespace harness {
namespace {

using namespace report_samples;
using namespace saved_class;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

void alter(const TemporaryFolder& folder, const std::string& sql) {
    SQLite::Database(file_in(folder).string(), SQLite::OPEN_READWRITE).exec(sql);
}

std::string refusal(const TemporaryFolder& folder) {
    return message_of<UsageError>([&] { const Gradebook gradebook(folder.path()); }, "(taken)");
}

TEST(Gradebook, IsCreatedByTheFirstSave) {
    const TemporaryFolder folder;
    {
        const Gradebook gradebook(folder.path());
        EXPECT_FALSE(gradebook.last_run());
        EXPECT_THAT(gradebook.compare(three()).changes.fresh, SizeIs(3));
        EXPECT_THAT(gradebook.overrides(), IsEmpty());
    }
    EXPECT_FALSE(std::filesystem::exists(file_in(folder)));
}

TEST(Gradebook, ReturnsTheClassInItsOrder) {
    const TemporaryFolder folder;
    const std::vector<Graded> all = {graded("zoe", output_with_a_mistake()), hostile(), not_graded("bob")};
    save(folder.path(), all);
    const Gradebook gradebook(folder.path());
    const std::vector<Graded> restored = gradebook.restore();
    EXPECT_EQ(report::grades_json(restored, marking(), Tier::bwrap), report::grades_json(all, marking(), Tier::bwrap));
    const auto run = gradebook.last_run();
    ASSERT_TRUE(run);
    EXPECT_EQ(std::tie(run->number, run->author.name, run->author.when, run->raygrade, run->tier),
              std::make_tuple(1, "ada", "2026-11-22T09:30:00Z", "0.7.0", Tier::landlock));
    EXPECT_EQ(std::tie(run->assignment, run->assignment_file, run->toml),
              std::make_tuple("a6-2021", "/a6-2021.toml", "title = \"x\"\n"));
}

TEST(Gradebook, ReturnsPrintoutsAndSourcesAsTheyWere) {
    const TemporaryFolder folder;
    std::vector<Graded> all = three();
    all[0].execution.printout = std::string("t: 1\0\xff\n", 8);
    all[0].submission.source = std::string("int\0 main\r\n", 11);
    save(folder.path(), all);
    const std::vector<Graded> restored = Gradebook(folder.path()).restore();
    EXPECT_EQ(restored[0].execution.printout, all[0].execution.printout);
    EXPECT_EQ(restored[0].submission.source, all[0].submission.source);
    EXPECT_EQ(restored[1].execution.printout, "");
    EXPECT_EQ(restored[1].submission.source, "");
    all[0].submission.source.clear();  // grew beyond what is kept
    all[0].submission.source_sha256 = "11";
    save(folder.path(), all);
    EXPECT_EQ(Gradebook(folder.path()).restore()[0].submission.source, "");
}

TEST(Gradebook, SavesFieldsThatAnOlderRaygradeDidNotKeep) {
    const TemporaryFolder folder;
    std::vector<Graded> all = three();
    save(folder.path(), all);  // without sources, as an older raygrade
    all[0].submission.source = "int main() {}\n";
    const auto comparison = save(folder.path(), all);
    EXPECT_TRUE(comparison.changes.rising.empty() && comparison.changes.falling.empty());
    EXPECT_EQ(Gradebook(folder.path()).restore()[0].submission.source, "int main() {}\n");
    EXPECT_TRUE(Gradebook(folder.path()).compare(all).is_as_saved());
}

TEST(Gradebook, IsReadByPython) {
    const TemporaryFolder folder;
    Graded late = graded("ada", output_with_a_mistake());
    late.submission.lms = read_canvas_name("adalovelace_LATE_17_4_ray_cast.cpp");
    late.late_share = 0.5;
    save(folder.path(), {late, hostile(), not_graded("cy")});
    EXPECT_EQ(rows(folder,
                   "SELECT id, place, run, student, lms_id, late, outcome, round(automatic_points, 2), "
                   "round(final_points, 2), max_points, length(source_sha256) FROM submissions WHERE place <> 1 "
                   "ORDER BY place"),
              json::parse(R"([["ada", 0, 1, "adalovelace", "17", 1, "graded", 98.33, 49.17, 100, 64],
                              ["cy", 2, 1, null, null, 0, "not_graded", null, null, 100, 64]])"));
    EXPECT_EQ(rows(folder,
                   "SELECT verdict, points, printed, line > 0, diagnosis FROM items "
                   "WHERE submission = 'ada' AND question = 6 AND item = 't'")
                  .at(0)
                  .at(0),
              "wrong");
    EXPECT_EQ(rows(folder, "SELECT COUNT(*) FROM items"), json::parse("[[44]]")) << "none of what was not graded";
    EXPECT_EQ(rows(folder, "SELECT run, at, who, raygrade, assignment, toml, sandbox, submissions, graded FROM runs"),
              json::parse(R"([[1, "2026-11-22T09:30:00Z", "ada", "0.7.0", "a6-2021", "title = \"x\"\n",
                               "landlock+shim", 3, 2]])"));
    const json history = rows(folder, "SELECT outcome, items FROM history WHERE submission = 'ada'");
    EXPECT_EQ(json::parse(history.at(0).at(1).get<std::string>()).at("6.t"), 0);
    EXPECT_EQ(json::parse(history.at(0).at(1).get<std::string>()).size(), 22U);
    EXPECT_EQ(rows(folder, "PRAGMA user_version"), json::parse("[[1]]"));
}

TEST(Gradebook, KeepsTheMarksOfRemovedSubmissions) {
    const TemporaryFolder folder;
    save(folder.path(), three());
    const auto comparison = save(folder.path(), {three()[1]});
    ASSERT_THAT(comparison.changes.gone, SizeIs(2));
    EXPECT_EQ(comparison.changes.gone[0].id, "ada");
    EXPECT_NEAR(*comparison.changes.gone[0].before, 98.33, 0.01);
    EXPECT_EQ(rows(folder, "SELECT id FROM submissions"), json::parse(R"([["ben"]])"));
    EXPECT_EQ(rows(folder, "SELECT DISTINCT submission FROM items"), json::parse(R"([["ben"]])"));
    EXPECT_EQ(rows(folder, "SELECT run, outcome, round(final_points, 2) FROM history WHERE submission = 'ada'"),
              json::parse(R"([[1, "graded", 98.33], [2, "gone", null]])"));
    EXPECT_EQ(rows(folder, "SELECT what, before, after, who FROM audit WHERE what LIKE 'mark of ada%'"),
              json::parse(R"([["mark of ada in run 2", "98.33", null, "ada"]])"));
    EXPECT_THAT(save(folder.path(), three()).changes.fresh, SizeIs(2)) << "they may come back";
}

TEST(Gradebook, KeepsOverridesThroughRunsAndAfterTheirSubmission) {
    const TemporaryFolder folder;
    save(folder.path(), three());
    const KeptOverride kept{"ada", {6, "t", 1.5, "right \"idea\"", "bea", "2026-11-23T10:00:00Z"}};
    Gradebook(folder.path()).put_override(kept, 0, 99.83);
    for (const auto& all : {three(), std::vector<Graded>{three()[1]}, three()}) {
        save(folder.path(), all);
        const auto overrides = Gradebook(folder.path()).overrides();
        ASSERT_THAT(overrides, SizeIs(1));
        const auto& [submission, given] = overrides[0];
        EXPECT_EQ(std::tie(submission, given.question, given.item, given.points, given.why, given.by, given.when),
                  std::tie(kept.submission, kept.given.question, kept.given.item, kept.given.points, kept.given.why,
                           kept.given.by, kept.given.when));
    }
    EXPECT_EQ(
        rows(folder, "SELECT round(automatic_points, 2), round(final_points, 2) FROM submissions WHERE id = 'ada'"),
        json::parse("[[98.33, 99.83]]"));
}

/// A student of Canvas's with this number.
Graded of_canvas(const std::string& id, const std::string& number) {
    Graded one = graded(id, output_with_a_mistake());
    one.submission.lms = read_canvas_name("doejane_" + number + "_4_ray_cast.cpp");
    return one;
}

TEST(Gradebook, UsesTheNumberIfANamesakeSubmits) {
    const TemporaryFolder folder;
    save(folder.path(), {of_canvas("doejane", "1001")});
    Gradebook(folder.path()).put_override({"doejane", {6, "t", 1.5, "why", "bea", "2026-11-23T10:00:00Z"}}, 0, 99.83);
    const auto comparison = save(folder.path(), {of_canvas("doejane_1001", "1001"), of_canvas("doejane_1004", "1004")});
    EXPECT_THAT(comparison.changes.gone, SizeIs(0));
    EXPECT_THAT(comparison.changes.fresh, SizeIs(1));
    EXPECT_EQ(rows(folder, "SELECT submission FROM overrides"), json::parse(R"([["doejane_1001"]])"));
    EXPECT_EQ(rows(folder, "SELECT id, round(final_points, 2) FROM submissions ORDER BY id"),
              json::parse(R"([["doejane_1001", 99.83], ["doejane_1004", 98.33]])"));
    EXPECT_EQ(rows(folder, "SELECT what, before, after FROM audit WHERE what LIKE 'id of%'"),
              json::parse(R"([["id of doejane", "doejane", "doejane_1001"]])"));
    EXPECT_EQ(rows(folder, "SELECT DISTINCT submission FROM history WHERE run = 1"),
              json::parse(R"([["doejane_1001"]])"));
    save(folder.path(), {of_canvas("doejane", "1001")});
    EXPECT_EQ(rows(folder, "SELECT submission FROM overrides"), json::parse(R"([["doejane"]])")) << "and back";
}

TEST(Gradebook, DoesNotGiveAStudentTheOverrideOfANamesakeWhoLeft) {
    const TemporaryFolder folder;
    save(folder.path(), {of_canvas("doejane", "1001")});
    Gradebook(folder.path()).put_override({"doejane", {0, "", 40, "why", "bea", "2026-11-23T10:00:00Z"}}, 0, 40);
    const auto comparison = save(folder.path(), {of_canvas("doejane", "1004")});
    EXPECT_THAT(comparison.changes.fresh, SizeIs(1));
    ASSERT_THAT(comparison.changes.gone, SizeIs(1));
    EXPECT_EQ(comparison.changes.gone[0].id, "doejane_1001");
    EXPECT_EQ(rows(folder, "SELECT id, round(final_points, 2) FROM submissions"),
              json::parse(R"([["doejane", 98.33]])"));
    EXPECT_EQ(rows(folder, "SELECT submission FROM overrides"), json::parse(R"([["doejane_1001"]])"));
}

TEST(Gradebook, KeepsTheOverrideOfAStudentWhoLeftAndGivesItBack) {
    const TemporaryFolder folder;
    save(folder.path(), {of_canvas("doejane", "1001"), of_canvas("other", "1002")});
    Gradebook(folder.path()).put_override({"doejane", {0, "", 40, "why", "bea", "2026-11-23T10:00:00Z"}}, 0, 40);
    save(folder.path(), {of_canvas("other", "1002")});
    save(folder.path(), {of_canvas("doejane", "1004"), of_canvas("other", "1002")});
    EXPECT_EQ(rows(folder, "SELECT submission FROM overrides"), json::parse(R"([["doejane_1001"]])"));
    save(folder.path(), {of_canvas("doejane", "1001"), of_canvas("other", "1002")});
    EXPECT_EQ(rows(folder, "SELECT submission FROM overrides"), json::parse(R"([["doejane"]])"));
}

TEST(Gradebook, RecordsWhoOverrodeWhatWhenAndWhy) {
    const TemporaryFolder folder;
    save(folder.path(), three());
    Gradebook gradebook(folder.path());
    gradebook.put_override({"cy", {0, "", 40, "by hand", "bea", "2026-11-23T10:00:00Z"}}, 0, 40.0);
    gradebook.put_override({"cy", {0, "", 45, "again", "cem", "2026-11-24T10:00:00Z"}}, 0, 45.0);
    EXPECT_EQ(rows(folder, "SELECT final_points FROM submissions WHERE id = 'cy'"), json::parse("[[45]]"));
    const auto kept = gradebook.overrides();
    ASSERT_THAT(kept, SizeIs(1)) << "one for a place";
    gradebook.remove_override(kept[0], {"dee", "2026-11-25T10:00:00Z"}, "a slip", std::nullopt);
    EXPECT_THAT(gradebook.overrides(), IsEmpty());
    EXPECT_EQ(rows(folder, "SELECT at, who, what, before, after FROM audit ORDER BY entry"), json::parse(R"([
        ["2026-11-22T09:30:00Z", "ada", "run 1", null, "a6-2021"],
        ["2026-11-23T10:00:00Z", "bea", "override of total of cy", "0, automatically", "40: by hand"],
        ["2026-11-24T10:00:00Z", "cem", "override of total of cy", "40: by hand", "45: again"],
        ["2026-11-25T10:00:00Z", "dee", "override of total of cy", "45: again", "removed: a slip"]])"));
    EXPECT_EQ(rows(folder, "SELECT final_points FROM submissions WHERE id = 'cy'"), json::parse("[[null]]"));
}

TEST(Gradebook, KeepsTheInputsOfReports) {
    const TemporaryFolder folder;
    const std::string content("\xef\xbb\xbfStudent,ID\0\xff", 15);
    save(folder.path(), three(), {{"canvas-roster", "Assignment 6", content}});
    save(folder.path(), three());
    const auto kept = Gradebook(folder.path()).input("canvas-roster");
    ASSERT_TRUE(kept);
    EXPECT_EQ(kept->choice, "Assignment 6");
    EXPECT_EQ(kept->content, content);
    EXPECT_FALSE(Gradebook(folder.path()).input("another"));
    save(folder.path(), three(), {{"canvas-roster", "", "new"}});
    EXPECT_EQ(Gradebook(folder.path()).input("canvas-roster")->content, "new");
}

TEST(Gradebook, IsRefusedAndLeftUnchangedIfOfADifferentVersion) {
    const TemporaryFolder folder;
    save(folder.path(), three());
    alter(folder, "PRAGMA user_version = 2");
    const std::string before = bytes_of(file_in(folder));
    EXPECT_THAT(refusal(folder), AllOf(HasSubstr(file_in(folder).string()), HasSubstr("version 2"),
                                       HasSubstr("the raygrade that wrote it")));
    EXPECT_EQ(bytes_of(file_in(folder)), before);
}

TEST(Gradebook, IsRefusedAndLeftUnchangedIfOfADifferentProgram) {
    const TemporaryFolder folder;
    SQLite::Database(file_in(folder).string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
        .exec("CREATE TABLE photos (name TEXT)");
    const std::string before = bytes_of(file_in(folder));
    EXPECT_THAT(refusal(folder), HasSubstr("another program's database"));
    EXPECT_EQ(bytes_of(file_in(folder)), before);
}

TEST(Gradebook, IsRefusedAndLeftUnchangedIfDamaged) {
    const TemporaryFolder folder;
    for (const std::string& text : {std::string("no database at all, but longer than a header of one hundred bytes, "
                                                "which is what a database begins with, as one can read"),
                                    std::string("short")}) {
        folder.write(gradebook_name, text);
        EXPECT_THAT(refusal(folder), AllOf(HasSubstr("is damaged"), HasSubstr("backup"), HasSubstr("move it away")));
        EXPECT_EQ(bytes_of(file_in(folder)), text);
    }
    std::filesystem::remove(file_in(folder));
    save(folder.path(), three());
    alter(folder, "ALTER TABLE overrides DROP COLUMN why");
    EXPECT_THAT(refusal(folder), HasSubstr("is damaged"));
}

TEST(Gradebook, ShowsNoControlCharactersOfADamagedFile) {
    const TemporaryFolder folder;
    save(folder.path(), three());
    alter(folder,
          "PRAGMA writable_schema = ON; UPDATE sqlite_schema SET name = char(27) || '[2J' || char(10), sql = 'CREATE "
          "TABLE x(' WHERE name = 'overrides'");
    EXPECT_THAT(refusal(folder), AllOf(HasSubstr("is damaged"), HasSubstr("malformed"), HasSubstr("%1B[2J%0A")));
}

TEST(Gradebook, ReportsARecordThatTheDiskHasGarbled) {
    const TemporaryFolder folder;
    save(folder.path(), three());
    alter(folder, "UPDATE submissions SET record = x'a0' WHERE id = 'ben'");
    const Gradebook gradebook(folder.path());
    const auto damage = [](const auto& work) { return message_of<HarnessError>(work, "(nothing thrown)"); };
    EXPECT_THAT(damage([&] { gradebook.restore(); }), AllOf(HasSubstr("is damaged"), HasSubstr("ben")));
    EXPECT_THAT(damage([&] { gradebook.compare(three()); }), AllOf(HasSubstr("is damaged"), HasSubstr("ben")));
    alter(folder, "UPDATE submissions SET record = x'a0' WHERE id = 'cy'");
    EXPECT_THAT(damage([&] { gradebook.compare(three()); }), HasSubstr("ben")) << "the first of them, by all threads";
}

TEST(Gradebook, TreatsAnEmptyFileAsNoGradebook) {
    const TemporaryFolder folder;
    folder.write(gradebook_name, "");  // as of a run that was killed before it had saved
    EXPECT_FALSE(Gradebook(folder.path()).last_run());
    save(folder.path(), three());
    EXPECT_EQ(Gradebook(folder.path()).last_run()->number, 1);
}

}  // namespace
}  // namespace harness
