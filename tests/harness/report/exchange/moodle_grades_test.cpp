// Reads the file back with python3's csv, and compares it cell by cell with the original worksheet.
#include "harness/report/exchange/moodle_grades.h"

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

constexpr const char* english =
    "Identifier,\"Full name\",Status,Grade,\"Maximum grade\",\"Grade can be changed\",\"Last modified "
    "(submission)\",\"Last modified (grade)\",\"Feedback comments\"\n"
    "\"Participant 11\",\"Jane Doe\",\"Submitted for grading\",,100.00,Yes,\"Monday, 1 November 2021, 9:00 AM\",-,\n"
    "\"Participant 12\",\"Jane Doe\",\"Submitted for grading\",90.00,100.00,Yes,-,-,\"=SUM(A1:A9)\"\n"
    "\"Participant 13\",\"Żan Łukasz\",\"Submitted for grading\",,100.00,No,-,-,\"two\nlines, \"\"quoted\"\"\"\n"
    "\"Participant 14\",Rick Roe,\"No submission\",,100.00,Yes,-,-,\n"
    "\"Participant 15\",Pat Poe,\"No submission\",55.00,100.00,Yes,-,-,  kept blanks \n";

constexpr const char* german =
    "\xef\xbb\xbfKennung;Vollständiger Name;E-Mail-Adresse;Status;Bewertung;Bestwertung;Bewertung kann geändert "
    "werden;Zuletzt geändert (Abgabe);Zuletzt geändert (Bewertung);Feedback als Kommentar\r\n"
    "Teilnehmer/in11;Jane Doe;jane@example.org;Zur Bewertung abgegeben;;100,00;Ja;Montag, 1. November 2021;-;\r\n"
    "Teilnehmer/in12;Rick Roe;rick@example.org;Keine Abgabe;;100,00;Nein;-;-;\r\n";

class MoodleTest : public testing::Test {
  protected:
    MoodleTest() { std::setlocale(LC_CTYPE, "C.UTF-8"); }  // as raygrade does
};
using MoodleWorksheetTest = MoodleTest;
using MoodleImportTest = MoodleTest;

TEST_F(MoodleWorksheetTest, SaysWhenASubmissionWasHandedIn) {
    std::vector<Submission> all(3);
    all[0].lms = read_moodle_name("Jane Doe_11_assignsubmission_file");
    all[1].lms = read_moodle_name("Jane Doe_12_assignsubmission_file");
    all[2].id = "Rick Roe";
    set_moments(all, read_moodle_worksheet(english));
    EXPECT_EQ(all[0].lms->handed_in, "2021-11-01 09:00");
    EXPECT_EQ(all[1].lms->handed_in, "");
    EXPECT_FALSE(all[2].lms);
    set_moments(all,
                read_moodle_worksheet("Identifier,Full name,Status,Grade,Maximum grade,Last modified (submission)\n"
                                      "Participant 11,Jane Doe,Submitted for grading - 2 hours late,,100.00,"
                                      "\"Monday, November 1, 2021, 11:30 PM\"\n"));
    EXPECT_EQ(all[0].lms->handed_in, "2021-11-01 23:30");
    EXPECT_EQ(all[0].lms->late, true);
    EXPECT_EQ(all[1].lms->late, std::nullopt);
}

/// The submission with these points, as by an instructor's override.
Graded worth(Graded one, double points) {
    one.review.overrides.push_back({0, "", points, "for the test", "ada", "2026-11-22T09:30:00Z"});
    return one;
}

Graded from_moodle(const std::string& folder, double points) {
    Graded one = worth(graded(folder, output_with_a_mistake()), points);
    one.submission.lms = read_moodle_name(folder);
    EXPECT_TRUE(one.submission.lms) << folder;
    return one;
}

MoodleImport import_into_moodle(const char* csv, const std::vector<Graded>& graded,
                                const std::vector<std::string>& columns = {}) {
    return moodle_import(read_moodle_worksheet(csv, columns), graded);
}

/// The changed cells: [row, heading, before, after].
json changes(const std::string& before, const std::string& after, char separator = ',') {
    const std::string program =
        "both = open(sys.argv[1], 'rb').read().decode('utf-8-sig').split('\\x00')\n"
        "import io\n"
        "a, b = [list(csv.reader(io.StringIO(t, newline=''), strict=True, delimiter='" +
        std::string(1, separator) +
        "')) for t in both]\n"
        "assert [len(r) for r in a] == [len(r) for r in b]\n"
        "print(json.dumps([[i, a[0][j], a[i][j], b[i][j]] for i in range(len(a)) for j in range(len(a[i]))\n"
        "                  if a[i][j] != b[i][j]]))\n";
    std::string second = after;
    if (second.starts_with("\xef\xbb\xbf")) second.erase(0, 3);
    return json::parse(python(program, before + std::string(1, '\0') + second));
}

std::string refusal_of_worksheet(std::string_view csv, const std::vector<std::string>& columns = {}) {
    std::setlocale(LC_CTYPE, "C.UTF-8");
    return refusal([&] { read_moodle_worksheet(csv, columns); });
}

TEST_F(MoodleImportTest, FillsInTheGradeAndChangesNoOtherCell) {
    const MoodleImport import = import_into_moodle(english, {from_moodle("Jane Doe_11_assignsubmission_file", 87.456),
                                                             from_moodle("Rick Roe_14_assignsubmission_file", 100)});
    EXPECT_EQ(changes(english, import.csv), json::parse(R"([[1, "Grade", "", "87.46"], [4, "Grade", "", "100.00"]])"));
    EXPECT_EQ(import.matched, 2U);
    EXPECT_THAT(import.without, ElementsAre("Jane Doe", "Żan Łukasz", "Pat Poe"));
}

TEST_F(MoodleImportTest, KeepsTheTeachersOwnCellsByteForByte) {
    const std::string csv =
        "\xef\xbb\xbfIdentifier,Full name,Grade,Maximum grade,Comments\r\n"
        "Participant 1,J\xe9rome,7.5,10,=cmd|' /C calc'!A1\r\n"
        "Participant 2,\"@Roe, Rick\",,10,\"a\r\nb \"\"c\"\"\"\r\n";
    EXPECT_EQ(import_into_moodle(csv.c_str(), {}).csv, csv);
}

TEST_F(MoodleImportTest, UsesTheDecimalSignAndSeparatorOfTheWorksheet) {
    const MoodleImport import = import_into_moodle(german, {from_moodle("Jane Doe_11_assignsubmission_file", 87.5)});
    EXPECT_EQ(changes(german, import.csv, ';'), json::parse(R"([[1, "Bewertung", "", "87,50"]])"));
    EXPECT_TRUE(import.csv.starts_with("\xef\xbb\xbfKennung;"));
    EXPECT_THAT(import.csv, HasSubstr("Kommentar\r\n"));
}

TEST_F(MoodleImportTest, MatchesMoodleSubmissionsOnlyByParticipantNumber) {
    const MoodleImport import = import_into_moodle(english, {from_moodle("Rick Roe_99_assignsubmission_file", 50)});
    EXPECT_THAT(import.unmatched, ElementsAre("Rick Roe_99_assignsubmission_file"))
        << "the worksheet is another assignment's";
    EXPECT_EQ(import.matched, 0U);
}

TEST_F(MoodleImportTest, MatchesOtherSubmissionsOnlyByFullName) {
    Graded of_canvas = worth(graded("patpoe", output_with_a_mistake()), 60);
    of_canvas.submission.lms = read_canvas_name("patpoe_14_5001_ray_cast.cpp");
    const MoodleImport import =
        import_into_moodle(english, {of_canvas, worth(graded("rick roe", output_with_a_mistake()), 40)});
    EXPECT_EQ(changes(english, import.csv),
              json::parse(R"([[4, "Grade", "", "40.00"], [5, "Grade", "55.00", "60.00"]])"));
}

TEST_F(MoodleImportTest, GivesEachGroupMemberThePoints) {
    Graded group = worth(graded("Rick Roe, Pat Poe, Ann Lee", output_with_a_mistake()), 70);
    LmsName& name = group.submission.lms.emplace();
    name.system = Lms::gradescope;
    name.id = "11";
    name.submitters = {{"Rick Roe", "", ""}, {"Pat Poe", "", ""}, {"Ann Lee", "", ""}};
    const MoodleImport import = import_into_moodle(english, {group});
    EXPECT_EQ(changes(english, import.csv),
              json::parse(R"([[4, "Grade", "", "70.00"], [5, "Grade", "55.00", "70.00"]])"));
    EXPECT_THAT(import.unmatched, ElementsAre("Rick Roe, Pat Poe, Ann Lee (Ann Lee)"));
}

TEST_F(MoodleImportTest, NeverGuesses) {
    const MoodleImport import = import_into_moodle(
        english, {worth(graded("Jane Doe", output_with_a_mistake()), 50),
                  from_moodle("Rick Roe_14_assignsubmission_file", 50), worth(graded("RickRoe", "x"), 60),
                  from_moodle("Somebody Else_15_assignsubmission_file", 70), worth(graded("nobody", "x"), 1)});
    EXPECT_EQ(import.csv, import_into_moodle(english, {}).csv);
    EXPECT_THAT(import.ambiguous,
                ElementsAre("Jane Doe: Jane Doe; Jane Doe", "Rick Roe_14_assignsubmission_file: Rick Roe",
                            "RickRoe: Rick Roe", "Somebody Else_15_assignsubmission_file: Pat Poe"));
    EXPECT_THAT(import.unmatched, ElementsAre("nobody"));
}

TEST_F(MoodleImportTest, MatchesANameWithAGroupAndAHiddenName) {
    const MoodleImport import =
        import_into_moodle(english, {from_moodle("Group A-Rick Roe_14_assignsubmission_file", 40),
                                     from_moodle("Participant_15_assignsubmission_file_", 60),
                                     from_moodle("Z\xcc\x87"
                                                 "an Łukasz_13_assignsubmission_file",
                                                 60)});
    EXPECT_EQ(import.matched, 2U);
    EXPECT_THAT(import.ambiguous, IsEmpty()) << "an accent may be a character of its own";
    EXPECT_THAT(import.locked, ElementsAre("Z\xcc\x87"
                                           "an Łukasz_13_assignsubmission_file"));
}

TEST_F(MoodleImportTest, LeavesOutLockedRowsAndSubmissionsWithoutMarks) {
    Graded none = not_graded("14");
    none.submission.lms = read_moodle_name("Rick Roe_14_assignsubmission_file");
    const MoodleImport import =
        import_into_moodle(english, {none, from_moodle("Żan Łukasz_13_assignsubmission_file", 50)});
    EXPECT_EQ(import.csv, import_into_moodle(english, {}).csv);
    EXPECT_THAT(import.not_graded, ElementsAre("14"));
    EXPECT_THAT(import.locked, ElementsAre("Żan Łukasz_13_assignsubmission_file"));
    EXPECT_THAT(import_into_moodle(german, {from_moodle("Rick Roe_12_assignsubmission_file", 1)}).locked,
                ElementsAre("Rick Roe_12_assignsubmission_file"));
}

TEST_F(MoodleImportTest, NeverExceedsTheMaximumAndReportsLoweredMarks) {
    const MoodleImport import = import_into_moodle(english, {from_moodle("Jane Doe_11_assignsubmission_file", 100.006),
                                                             from_moodle("Jane Doe_12_assignsubmission_file", 89.999),
                                                             from_moodle("Rick Roe_14_assignsubmission_file", 100.004),
                                                             from_moodle("Pat Poe_15_assignsubmission_file", 54.99)});
    EXPECT_EQ(changes(english, import.csv),
              json::parse(R"([[4, "Grade", "", "100.00"], [5, "Grade", "55.00", "54.99"]])"));
    EXPECT_THAT(import.above, ElementsAre("Jane Doe_11_assignsubmission_file: 100.01 of at most 100.00"));
    EXPECT_THAT(import.lowered, ElementsAre("Pat Poe_15_assignsubmission_file: 55.00 becomes 54.99"));
    EXPECT_FALSE(import.other_maximum);
}

TEST_F(MoodleImportTest, ReportsAMaximumThatDiffersFromTheAssignment) {
    const MoodleImport import = import_into_moodle("Identifier,Grade,Maximum grade\nParticipant 1,,50\n",
                                                   {from_moodle("Participant_1_assignsubmission_file", 40)});
    ASSERT_TRUE(import.other_maximum);
    EXPECT_EQ(*import.other_maximum, 50);
    EXPECT_EQ(import.matched, 1U);
}

TEST_F(MoodleWorksheetTest, FindsColumnsInOtherLanguagesByTheirContents) {
    const auto columns = [](const char* csv) {
        const MoodleWorksheet read = read_moodle_worksheet(csv);
        return std::make_tuple(read.identifier, read.name, read.grade, read.maximum, read.changeable);
    };
    EXPECT_EQ(columns(german), std::make_tuple(0, 1, 4, 5, 6));
    // The worksheet also has groups, a marker and a marking workflow. Two grades are already filled in.
    const char* const japanese =
        "ID,氏名,メール,ステータス,グループ,マーカー,評点,最大評点,ワークフロー,評点変更可,最終更新 (評点)\n"
        "参加者 1,山田太郎,a@b,提出済み,A,,80.00,100.00,未評定,はい,-\n"
        "参加者 2,鈴木花子,b@b,提出済み,A,,100.00,100.00,未評定,いいえ,-\n"
        ",,,,,,,,,,\n";
    EXPECT_EQ(columns(japanese), std::make_tuple(0, 1, 6, 7, 9));
    EXPECT_EQ(columns("Identifiant,Note,Note maximale,La note peut être modifiée\n"
                      "Participant7,,20.00,Oui\nParticipant8,,20.00,Non\n"),
              std::make_tuple(0, std::nullopt, 1, 2, 3));
}

TEST_F(MoodleWorksheetTest, TakesAmbiguousColumnsFromOptions) {
    // With a single student, a matriculation number could be the maximum grade.
    constexpr const char* single = "Kennung,Telefon,Matrikel,Bewertung,Bestwertung\nTeilnehmer/in1,,4711,,\"100,00\"\n";
    EXPECT_THAT(refusal_of_worksheet(single), HasSubstr("--moodle-column grade="));
    EXPECT_EQ(read_moodle_worksheet(single, {"grade=Bewertung"}).maximum, 4U);
    EXPECT_EQ(read_moodle_worksheet(single, {"maximum=Bestwertung"}).grade, 3U);
}

TEST_F(MoodleWorksheetTest, NamesItsParticipants) {
    const MoodleWorksheet worksheet = read_moodle_worksheet(english);
    const auto name = [&](const std::string& id, const char* folder) {
        Submission one;
        one.id = id;
        if (folder != nullptr) one.lms = read_moodle_name(folder);
        return names_of({one}, worksheet).front();
    };
    EXPECT_EQ(name("x", "Rick Roe_14_assignsubmission_file"), "Rick Roe");
    EXPECT_EQ(name("x", "Al Other_14_assignsubmission_file"), "") << "another name with this number";
    EXPECT_EQ(name("Pat Poe", nullptr), "Pat Poe");
    EXPECT_EQ(name("Jane Doe", nullptr), "") << "there are two";
}

TEST_F(MoodleWorksheetTest, SaysWhyItIsUnusable) {
    EXPECT_THAT(refusal_of_worksheet(""), HasSubstr("no participants"));
    EXPECT_THAT(refusal_of_worksheet("Identifier,Grade,Maximum grade\n"), HasSubstr("no participants"));
    EXPECT_THAT(refusal_of_worksheet("Name,Grade,Maximum grade\nJane,1,2\n"), HasSubstr("no column \"Identifier\""));
    EXPECT_THAT(refusal_of_worksheet("Identifier,Grade,Scale\nParticipant 1,,\"A\nB\"\n"),
                HasSubstr("cannot fill in a scale"));
    EXPECT_THAT(refusal_of_worksheet(english, {"grade=Note"}),
                HasSubstr("no column \"Note\"; the columns are \"Identifier\""));
    EXPECT_THAT(refusal_of_worksheet(english, {"points=Grade"}),
                HasSubstr("write identifier, name, grade, maximum or changeable"));
    EXPECT_THAT(refusal_of_worksheet(english, {"grade"}), HasSubstr("write identifier"));
    EXPECT_THAT(refusal_of_worksheet(english, {"grade=Maximum grade"}), HasSubstr("for two purposes"));
}

}  // namespace
}  // namespace harness::report
