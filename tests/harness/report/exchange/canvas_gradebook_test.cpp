// Reads the file back with python3's csv, independently of our own writer.
#include "harness/report/exchange/canvas_gradebook.h"

#include <gmock/gmock.h>

#include <clocale>
#include <nlohmann/json.hpp>

#include "tests/given/report/graded_samples.h"
#include "tests/given/report/told_by.h"
#include "tests/harness/report/exchange/refusal.h"

namespace harness::report {
namespace {

using namespace report_samples;
using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr const char* exported =
    "\xef\xbb\xbfStudent,ID,SIS User ID,SIS Login ID,Section,Assignment 5 (70),Assignment 6 (71),Current Score\r\n"
    "    Points Possible,,,,,100,100,(read only)\r\n"
    "\"Doe, Jane\",11,s11,jdoe,01,90,,90\r\n"
    "\"Doe, Jane\",12,s12,jdoe2,01,80,,80\r\n"
    "\"Łukasz, Żan\",13,s13,zan,02,70,,70\r\n"
    "\"Roe, \"\"Rick\"\"\",14,s14,rroe,02,60,55,60\r\n"
    "\"Poe, Pat\",15,s15,ppoe,02,50,,50\r\n";

std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
    return json::parse(
        python("print(json.dumps(list(csv.reader(open(sys.argv[1], newline='', encoding='utf-8'), "
               "strict=True))))",
               csv));
}

Graded in_the_class(const std::string& id, const char* canvas_name = nullptr) {
    Graded one = graded(id, output_with_a_mistake());
    if (canvas_name != nullptr) one.submission.lms = read_canvas_name(canvas_name);
    return one;
}

CanvasImport import_into_canvas(const std::vector<Graded>& graded) {
    std::setlocale(LC_CTYPE, "C.UTF-8");  // as raygrade does
    return canvas_import(read_canvas_roster(exported, "Assignment 6"), graded);
}

std::string refusal_of_gradebook(std::string_view csv, const std::string& column) {
    return refusal([&] { read_canvas_roster(csv, column); });
}

TEST(CanvasImport, ContainsOnlyTheColumnAndMatchedStudents) {
    const CanvasImport import = import_into_canvas({in_the_class("doejane_12", "doejane_12_1_ray_cast.cpp"),
                                                    in_the_class("łukaszżan", "łukaszżan_13_2_ray_cast.cpp")});
    const auto rows = rows_of(import.csv);
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_THAT(rows[0], ElementsAre("Student", "ID", "SIS User ID", "SIS Login ID", "Section", "Assignment 6 (71)"));
    EXPECT_THAT(rows[1], ElementsAre("Points Possible", "", "", "", "", "100"));
    EXPECT_THAT(rows[2], ElementsAre("Doe, Jane", "12", "s12", "jdoe2", "01", "98.33"));
    EXPECT_THAT(rows[3], ElementsAre("Łukasz, Żan", "13", "s13", "zan", "02", "98.33"));
    EXPECT_EQ(import.matched, 2U);
    EXPECT_THAT(import.without, ElementsAre("Doe, Jane", "Roe, \"Rick\"", "Poe, Pat"));
}

TEST(CanvasImport, MatchesByNumberThenBySisThenByName) {
    const CanvasImport import =
        import_into_canvas({in_the_class("s14"), in_the_class("ppoe"), in_the_class("x", "łukaszżan_999_2_a.cpp")});
    EXPECT_EQ(import.matched, 3U);
    EXPECT_THAT(import.unmatched, IsEmpty());
    EXPECT_EQ(rows_of(import.csv).size(), 2U + 3U);
}

TEST(CanvasImport, NeverGuesses) {
    const CanvasImport import =
        import_into_canvas({in_the_class("doejane"), in_the_class("nobody"), in_the_class("14"), in_the_class("rroe")});
    EXPECT_THAT(import.ambiguous,
                ElementsAre("doejane: Doe, Jane; Doe, Jane", "14: Roe, \"Rick\"", "rroe: Roe, \"Rick\""));
    EXPECT_THAT(import.unmatched, ElementsAre("nobody"));
    EXPECT_EQ(import.matched, 0U);
    EXPECT_EQ(rows_of(import.csv).size(), 2U) << "nobody's score is changed";
}

TEST(CanvasImport, HasTheFinalPoints) {
    Graded late = in_the_class("s14");
    late.late_share = 0.5;
    Graded by_hand = not_graded("ppoe");
    by_hand.review.overrides = {{0, "", 40, "by hand", "bea", ""}};
    const CanvasImport import = import_into_canvas({late, by_hand});
    const auto rows = rows_of(import.csv);
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_EQ(rows[2].back(), "49.17");
    EXPECT_EQ(rows[3].back(), "40.00");
    EXPECT_THAT(import.not_graded, IsEmpty());
}

TEST(CanvasImport, DoesNotMatchTheNumberOfADifferentSystem) {
    Graded of_moodle = in_the_class("somebody");
    of_moodle.submission.lms = read_moodle_name("Some Body_14_assignsubmission_file");
    EXPECT_THAT(import_into_canvas({of_moodle}).unmatched, ElementsAre("somebody"));
    of_moodle.submission.lms = read_moodle_name("Poe Pat_14_assignsubmission_file");
    EXPECT_EQ(rows_of(import_into_canvas({of_moodle}).csv)[2][0], "Poe, Pat") << "by name";
}

TEST(CanvasImport, ReadsAnExportWithFirstAndLastNamesApart) {
    std::setlocale(LC_CTYPE, "C.UTF-8");  // as raygrade does
    const CanvasRoster roster = read_canvas_roster(
        "LastName,FirstName,ID,SIS User ID,SIS Login ID,Section,A (7)\n    Points "
        "Possible,,,,,,100\nDoe,Jane,11,,,01,\n",
        "");
    const std::vector<Graded> all{in_the_class("doejane")};
    const auto rows = rows_of(canvas_import(roster, all).csv);
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_THAT(rows[0], ElementsAre("LastName", "FirstName", "ID", "SIS User ID", "SIS Login ID", "Section", "A (7)"));
    EXPECT_THAT(rows[2], ElementsAre("Doe", "Jane", "11", "", "", "01", "98.33"));
    EXPECT_THAT(names_of({all[0].submission}, roster), ElementsAre("Doe, Jane"));
    EXPECT_THAT(refusal_of_gradebook("LastName,ID,A (7)\n", ""), HasSubstr("not a Canvas gradebook"));
}

TEST(CanvasImport, LeavesAnExcusedStudentAloneAndListsWhatItLowers) {
    std::setlocale(LC_CTYPE, "C.UTF-8");  // as raygrade does
    const CanvasImport import = canvas_import(
        read_canvas_roster("Student,ID,Section,A (7)\n\"Ash, A\",1,,EX\n\"Bay, B\",2,,99.5\n\"Cho, C\",3,,55\n", ""),
        {in_the_class("1"), in_the_class("2"), in_the_class("3")});
    EXPECT_THAT(import.excused, ElementsAre("1"));
    EXPECT_THAT(import.lowered, ElementsAre("2: 99.5 becomes 98.33"));
    EXPECT_EQ(import.matched, 2U);
    EXPECT_THAT(import.csv, Not(HasSubstr("Ash")));
}

TEST(CanvasImport, KnowsANameInEachFormOfUnicode) {
    std::setlocale(LC_CTYPE, "C.UTF-8");  // as raygrade does
    const CanvasRoster roster = read_canvas_roster("Student,ID,Section,A (7)\n\"M\u00fcller, Z\",1,,\n", "");
    EXPECT_EQ(canvas_import(roster, {in_the_class("Mu\u0308ller, Z")}).matched, 1U);
}

TEST(CanvasImport, ReportsPointsPossibleThatDifferFromTheAssignment) {
    const CanvasImport usual = import_into_canvas({in_the_class("s14")});
    EXPECT_FALSE(usual.possible);
    EXPECT_THAT(usual.above, ElementsAre());
    Graded much = in_the_class("s14"), little = in_the_class("s15");
    for (Graded* one : {&much, &little}) one->score.max_points = 120;
    much.score.points = 100.5;
    const CanvasImport import = import_into_canvas({much, little});
    EXPECT_EQ(import.possible, 100);
    EXPECT_THAT(import.above, ElementsAre("s14"));
    EXPECT_EQ(import.matched, 2U);
    EXPECT_THAT(import.csv, HasSubstr("\"100.50\""));
}

TEST(CanvasImport, GivesEachGroupMemberThePoints) {
    Graded group = in_the_class("Rick Roe, Pat Poe, Ann Lee, Jane Doe");
    LmsName& name = group.submission.lms.emplace();
    name.system = Lms::gradescope;
    name.id = "14";
    name.submitters = {
        {"Rick Roe", "s14", ""}, {"Pat Poe", "", "ppoe"}, {"Ann Lee", "s99", "alee"}, {"Doe Jane", "", ""}};
    const CanvasImport import = import_into_canvas({group});
    const auto rows = rows_of(import.csv);
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_EQ(rows[2][0], "Roe, \"Rick\"") << "by SIS User ID";
    EXPECT_EQ(rows[3][0], "Poe, Pat") << "by SIS Login ID";
    EXPECT_THAT(import.unmatched, ElementsAre("Rick Roe, Pat Poe, Ann Lee, Jane Doe (Ann Lee)"));
    EXPECT_THAT(import.ambiguous, ElementsAre("Rick Roe, Pat Poe, Ann Lee, Jane Doe (Doe Jane): Doe, Jane; Doe, Jane"));
}

TEST(CanvasImport, CountsAGroupMemberListedTwiceOnce) {
    Graded group = in_the_class("Rick Roe, Pat Poe, Ricky");
    LmsName& name = group.submission.lms.emplace();
    name.system = Lms::gradescope;
    name.id = "901";
    name.submitters = {{"Rick Roe", "s14", ""}, {"Pat Poe", "", "ppoe"}, {"Ricky", "s14", ""}};
    const CanvasImport import = import_into_canvas({group});
    EXPECT_THAT(import.ambiguous, IsEmpty());
    EXPECT_EQ(import.matched, 2U);
    const CanvasImport two = import_into_canvas({group, in_the_class("s14")});
    EXPECT_THAT(two.ambiguous, ElementsAre("Rick Roe, Pat Poe, Ricky: Roe, \"Rick\"", "s14: Roe, \"Rick\""))
        << "another submission of the same person is one";
}

TEST(CanvasRoster, NamesItsStudentsButNoAmbiguousOnes) {
    std::setlocale(LC_CTYPE, "C.UTF-8");  // as raygrade does
    const auto name = [](const Graded& one) {
        return names_of({one.submission}, read_canvas_roster(exported, "71")).front();
    };
    EXPECT_EQ(name(in_the_class("poepat", "poepat_15_9_ray_cast.cpp")), "Poe, Pat");
    EXPECT_EQ(name(in_the_class("doejane", "doejane_12_9_ray_cast.cpp")), "Doe, Jane") << "by Canvas's number";
    EXPECT_EQ(name(in_the_class("doejane")), "") << "there are two";
    EXPECT_EQ(name(in_the_class("zan")), "Łukasz, Żan") << "by login";
    EXPECT_EQ(name(in_the_class("stranger")), "");
    Graded group = in_the_class("submission_901");
    group.submission.lms.emplace().system = Lms::gradescope;
    group.submission.lms->submitters = {{"", "s14", ""}, {"", "nobody", ""}, {"", "s15", ""}};
    EXPECT_EQ(name(group), "Roe, \"Rick\"; Poe, Pat");
}

TEST(CanvasRoster, SaysWhyAColumnCannotBeChosen) {
    EXPECT_THAT(refusal_of_gradebook(exported, ""), HasSubstr("\"Assignment 5 (70)\", \"Assignment 6 (71)\""));
    EXPECT_THAT(refusal_of_gradebook(exported, "Assignment 7"), HasSubstr("no column \"Assignment 7\""));
    EXPECT_THAT(refusal_of_gradebook("Student,ID\r\nA,1\r\n", ""), HasSubstr("no assignment column"));
    EXPECT_THAT(refusal_of_gradebook("a,b\r\n1,2\r\n", ""), HasSubstr("not a Canvas gradebook"));
    EXPECT_THAT(refusal_of_gradebook("", ""), HasSubstr("not a Canvas gradebook"));
    EXPECT_EQ(read_canvas_roster(exported, "Assignment 6 (71)").column, "Assignment 6 (71)");
    EXPECT_EQ(read_canvas_roster(exported, "70").column, "Assignment 5 (70)");
    EXPECT_EQ(read_canvas_roster("Student,ID,Section,Six (6)\r\nA,1,01,\r\n", "").column, "Six (6)");
}

TEST(CanvasImport, ContainsNoSpreadsheetFormulas) {
    const CanvasRoster roster = read_canvas_roster("Student,ID,Section,Six (6)\r\n\"=cmd|'/c calc'!A1\",1,01,\r\n", "");
    EXPECT_THAT(canvas_import(roster, {in_the_class("1")}).csv, HasSubstr("\"'=cmd"));
}

}  // namespace
}  // namespace harness::report
