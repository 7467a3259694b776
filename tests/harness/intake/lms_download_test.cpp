// Downloads from learning management systems, as zips and unpacked, in the forms given by their documentation and code.
#include <gmock/gmock.h>

#include <map>

#include "tests/given/packed.h"
#include "tests/given/temporary_folder.h"
#include "tests/harness/intake/taken.h"

namespace {

using harness::Submission;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Takes in a zip with these entries and a folder with the same files. The results must be equal.
class LmsDownload : public testing::TestWithParam<bool> {
  protected:
    std::map<std::string, Submission> take_in(const std::vector<PackedEntry>& entries) const {
        if (GetParam()) return take(pack(folder_.path() / "submissions.zip", entries));
        for (const PackedEntry& entry : entries) folder_.write("unpacked/" + entry.path, entry.bytes);
        return take(folder_.path() / "unpacked");
    }

    TemporaryFolder folder_;
};

TEST_P(LmsDownload, OfCanvasGivesAStudentPerNumber) {
    const auto taken = take_in({{"doejane_1001_5001_ray_cast.cpp", "jane"},
                                {"doejohn_LATE_1002_5002_main.cpp", "john"},
                                {"łukaszewiczján_1003_5003_my ray (final) – ü.cpp", "jan"},
                                {"doejane_1004_5004_ray_cast.cpp", "another jane"},
                                {"anon_77_5005_ray_cast.cpp", "nobody"},
                                {"LATE_anon_78_5006_ray_cast.cpp", "nobody late"}});
    EXPECT_THAT(ids(taken),
                ElementsAre("anon_77", "anon_78", "doejane_1001", "doejane_1004", "doejohn", "łukaszewiczján"));
    EXPECT_EQ(taken.at("doejohn").source, "john");
    EXPECT_THAT(taken.at("doejohn").notes, ElementsAre("Marked late in the download."));
    EXPECT_THAT(taken.at("anon_78").notes, ElementsAre("Marked late in the download."));
    EXPECT_THAT(taken.at("doejane_1004").notes, IsEmpty());
    EXPECT_EQ(taken.at("łukaszewiczján").source, "jan");
    EXPECT_EQ(taken.at("doejane_1004").lms->id, "1004");
    EXPECT_EQ(taken.at("doejane_1004").lms->attachment, "5004");
}

TEST_P(LmsDownload, GradesTheNewestSubmissionAndListsTheOthers) {
    const auto taken = take_in({{"doejane_1_30_ray_cast-2.cpp", "third"},
                                {"doejane_1_10_ray_cast.cpp", "first"},
                                {"doejane_1_20_ray_cast-1.cpp", "second"},
                                {"roe_2_99_ray_cast.cpp", "old"},
                                {"roe_2_100_ray_cast.cpp", "new"},
                                {"poe_3_7_ray_cast (1).cpp", "the only one"}});
    EXPECT_EQ(taken.at("doejane").source, "third");
    EXPECT_THAT(taken.at("doejane").notes, ElementsAre("Handed in more than once: \"ray_cast-2.cpp\" counts, not "
                                                       "\"ray_cast.cpp\", \"ray_cast-1.cpp\"."));
    EXPECT_EQ(taken.at("roe").source, "new") << "the number of the file tells";
    EXPECT_EQ(taken.at("poe").source, "the only one");
    EXPECT_THAT(taken.at("poe").notes, IsEmpty());
}

TEST_P(LmsDownload, GradesTheRayCastOfSeveralFiles) {
    const auto taken = take_in({{"doejane_1_10_scratch.cpp", "s"},
                                {"doejane_1_11_ray_cast (2).cpp", "r"},
                                {"doejane_1_12_notes.pdf", "n"},
                                {"roe_2_20_a.cpp", "a"},
                                {"roe_2_21_b.cpp", "b"}});
    EXPECT_EQ(taken.at("doejane").source, "r");
    EXPECT_THAT(taken.at("doejane").notes, ElementsAre("Only \"ray_cast (2).cpp\" is graded, not \"scratch.cpp\"."));
    EXPECT_THAT(*taken.at("roe").problem,
                AllOf(HasSubstr("\"a.cpp\", \"b.cpp\""), HasSubstr("Hand in one file named ray_cast.cpp")));
}

TEST_P(LmsDownload, KeepsStudentsWithoutASource) {
    const auto taken = take_in({{"doejane_1_10_ray_cast.cpp", "j"},
                                {"roe_LATE_2_20_report.pdf", "%PDF"},
                                {"poe_3_text.html", "<p>here</p>"},
                                {"moe_4_40_a.pdf", "on time"},
                                {"moe_LATE_4_link.html", "<a>"},
                                {"anon_5_text.html", "t"}});
    EXPECT_THAT(ids(taken), ElementsAre("anon_5", "doejane", "moe", "poe", "roe"));
    EXPECT_THAT(*taken.at("roe").problem, AllOf(HasSubstr("report.pdf"), HasSubstr("no C++ source")));
    EXPECT_THAT(taken.at("roe").notes, ElementsAre("Marked late in the download."));
    EXPECT_THAT(*taken.at("poe").problem, HasSubstr("text.html"));
    EXPECT_THAT(*taken.at("moe").problem, AllOf(HasSubstr("a.pdf"), HasSubstr("link.html")));
    EXPECT_THAT(taken.at("moe").notes, ElementsAre("Marked late in the download.")) << "as soon as a part of it is";
}

TEST_P(LmsDownload, ReadsAStudentsArchive) {
    const auto taken = take_in({{"doejane_1_10_hw6.zip", packed({{"hw6/src/ray_cast.cpp", "deep"}, {"hw6/a.txt", ""}})},
                                {"roe_2_20_hw6.zip", packed({{"../../evil.cpp", "e"}})},
                                {"poe_3_30_hw6.zip", "no zip"},
                                {"moe_4_40_hw6.zip", packed({{"a.txt", "a"}})},
                                {"zoe_5_50_ray_cast.cpp", "z"}});
    EXPECT_EQ(taken.at("doejane").source, "deep");
    EXPECT_THAT(*taken.at("roe").problem, HasSubstr("../../evil.cpp"));
    EXPECT_THAT(*taken.at("poe").problem, HasSubstr("cannot be opened"));
    EXPECT_THAT(*taken.at("moe").problem, HasSubstr("no C++ source"));
    EXPECT_EQ(taken.at("zoe").source, "z") << "one bad archive is one student's";
}

TEST_P(LmsDownload, OfMoodleGivesAStudentPerParticipantFolder) {
    const auto taken = take_in({{"Jane Doe_2001_assignsubmission_file/ray_cast.cpp", "jane"},
                                {"Jean_Luc Picard_2002_assignsubmission_file_/ray_cast.cpp", "old form"},
                                {"Participant_2003_assignsubmission_file/ray_cast.cpp", "blind"},
                                {"Ann Lee_2004_assignsubmission_onlinetext/onlinetext.html", "text"},
                                {"Jane Doe_2001_assignsubmission_onlinetext/onlinetext.html", "text besides"}});
    EXPECT_THAT(ids(taken), ElementsAre("Ann Lee", "Jane Doe", "Jean_Luc Picard", "Participant"));
    EXPECT_EQ(taken.at("Jane Doe").source, "jane");
    EXPECT_EQ(taken.at("Jean_Luc Picard").source, "old form");
    EXPECT_EQ(taken.at("Jean_Luc Picard").lms->id, "2002");
    EXPECT_THAT(*taken.at("Ann Lee").problem, HasSubstr("onlinetext"));
}

TEST_P(LmsDownload, OfMoodleCanBeFlat) {
    const auto taken = take_in({{"Jane Doe_2001_assignsubmission_file_ray_cast.cpp", "jane"},
                                {"Participant_7_assignsubmission_file_main.cpp", "a"},
                                {"Participant_8_assignsubmission_file_main.cpp", "b"}});
    EXPECT_THAT(ids(taken), ElementsAre("Jane Doe", "Participant_7", "Participant_8"));
    EXPECT_EQ(taken.at("Participant_8").source, "b");
}

/// The problem of a hand-in that may be two students', and that both are named in it.
testing::Matcher<const std::string&> names_both(const std::string& one, const std::string& other) {
    return AllOf(HasSubstr("several meanings"), HasSubstr(one), HasSubstr(other));
}

TEST_P(LmsDownload, OfMoodleGivesNobodyAnAmbiguousFolder) {
    for (const char* attacker : {"Ann", "Zed"}) {  // before and after the victim
        const std::string file =
            std::string(attacker) + "_111_assignsubmission_file_x_222_assignsubmission_file_ray_cast-9.cpp";
        const auto taken = take_in({{file, "forged"}, {"Vic_222_assignsubmission_file_ray_cast.cpp", "own"}});
        EXPECT_THAT(ids(taken), testing::UnorderedElementsAre("Vic", file));
        EXPECT_EQ(taken.at("Vic").source, "own");
        EXPECT_EQ(taken.at(file).source, "");
        EXPECT_FALSE(taken.at(file).lms) << "so that no system gets marks for it";
        EXPECT_THAT(*taken.at(file).problem, names_both("number 222", "number 111"));
        if (!GetParam()) std::filesystem::remove_all(folder_.path() / "unpacked");
    }
}

TEST_P(LmsDownload, OfCanvasGivesNobodyAnAmbiguousFile) {
    const auto taken = take_in({{"222_111_5678_ray_cast.cpp", "display name 222"},
                                {"x_222_333_112_5679_ray_cast.cpp", "display name x_222_333"},
                                {"vic_222_5680_ray_cast.cpp", "own"}});
    EXPECT_THAT(ids(taken),
                testing::UnorderedElementsAre("222_111_5678_ray_cast.cpp", "x_222_333_112_5679_ray_cast.cpp", "vic"));
    EXPECT_EQ(taken.at("vic").source, "own");
    EXPECT_THAT(*taken.at("222_111_5678_ray_cast.cpp").problem, names_both("number 222", "number 111"));
    EXPECT_THAT(*taken.at("x_222_333_112_5679_ray_cast.cpp").problem, names_both("number 222", "number"));
}

TEST_P(LmsDownload, OfCanvasKnowsTheNumbersInAFilesOwnName) {
    const auto taken = take_in({{"doejane_4711_7081512_6_2_ray.cpp", "six"},
                                {"doejohn_4712_7081513_2021_10_24.cpp", "date"},
                                {"roe_4713_7081514_ray_cast.cpp", "plain"}});
    EXPECT_THAT(ids(taken), ElementsAre("doejane", "doejohn", "roe"));
    EXPECT_EQ(taken.at("doejane").source, "six");
    EXPECT_EQ(taken.at("doejohn").lms->id, "4712");
}

TEST_P(LmsDownload, OfCanvasGivesNobodyAFileWithManyNumbers) {
    const std::string file = "x_222_7081519_1_1_1_1_1_1_1_1_1_1_111_7081513_ray_cast.cpp";
    const auto taken = take_in({{file, "forged"}, {"roe_4713_7081514_ray_cast.cpp", "plain"}});
    ASSERT_TRUE(taken.contains(file)) << "its owner is unclear";
    EXPECT_THAT(*taken.at(file).problem, HasSubstr("several meanings"));
}

TEST_P(LmsDownload, FilesOfTwoNamesNeverMerge) {
    const auto taken =
        take_in({{"eve_5_50_ray_cast.cpp", "e"}, {"vic_5_51_ray_cast-9.cpp", "v"}, {"roe_6_52_ray_cast.cpp", "r"}});
    EXPECT_THAT(ids(taken), ElementsAre("eve", "roe", "vic"));
    EXPECT_THAT(*taken.at("eve").problem, HasSubstr("number 5"));
    EXPECT_THAT(*taken.at("vic").problem, HasSubstr("number 5"));
    EXPECT_FALSE(taken.at("vic").lms);
    EXPECT_EQ(taken.at("roe").source, "r");
}

TEST_P(LmsDownload, OfGradescopeGivesASubmissionPerFolder) {
    const auto taken = take_in(
        {{"submission_901/ray_cast.cpp", "a"}, {"submission_902/main.cpp", "b"}, {"submission_metadata.yml", "---\n"}});
    EXPECT_THAT(ids(taken), ElementsAre("submission_901", "submission_902"));
    EXPECT_EQ(taken.at("submission_902").source, "b");
    EXPECT_EQ(taken.at("submission_902").lms->id, "902");
}

TEST_P(LmsDownload, OfGradescopeIsNamedByItsMetadata) {
    const auto taken = take_in({{"submission_901/ray_cast.cpp", "a"},
                                {"submission_902/main.cpp", "b"},
                                {"submission_903/main.cpp", "c"},
                                {"submission_904/readme.txt", "no source"},
                                {"submission_metadata.yml",
                                 "submission_901:\n  :submitters:\n  - :name: Jane Doe\n    :sid: s1\n"
                                 "submission_902:\n  :submitters:\n  - :name: Jane Doe\n"
                                 "submission_903:\n  :submitters:\n  - :name: Ann/Lee\n  - :name: Żan Roe\n"
                                 "submission_904:\n  :submitters:\n  - :name: Pat Poe\n"}});
    EXPECT_THAT(ids(taken), ElementsAre("Ann/Lee, Żan Roe", "Jane Doe_901", "Jane Doe_902", "Pat Poe"));
    const Submission& jane = taken.at("Jane Doe_901");
    EXPECT_EQ(jane.source, "a");
    EXPECT_EQ(jane.lms->student, "Jane Doe");
    EXPECT_EQ(jane.lms->id, "901");
    EXPECT_EQ(jane.lms->submitters.at(0).sid, "s1");
    EXPECT_EQ(jane.lms->late, std::nullopt) << "Gradescope does not tell";
    EXPECT_THAT(jane.notes, IsEmpty());
    EXPECT_EQ(taken.at("Ann/Lee, Żan Roe").lms->submitters.size(), 2U);
    EXPECT_THAT(*taken.at("Pat Poe").problem, HasSubstr("no C++ source"));
}

TEST_P(LmsDownload, OfGradescopeIsNamedByItsFoldersIfTheMetadataAreUnusable) {
    const auto with = [&](const std::string& yaml) {
        return take_in({{"submission_901/ray_cast.cpp", "a"},
                        {"submission_902/main.cpp", "b"},
                        {"submission_metadata.yml", yaml}});
    };
    const auto broken = with("submission_901:\n  :submitters:\n  - :name: \"Jane");
    EXPECT_THAT(ids(broken), ElementsAre("submission_901", "submission_902"));
    EXPECT_THAT(broken.at("submission_902").notes,
                ElementsAre(AllOf(HasSubstr("submission_metadata.yml is not YAML from line 3 on"),
                                  HasSubstr("Export the submissions from Gradescope again"))));
    const auto one = with("submission_901:\n  :submitters:\n  - :name: Jane Doe\n");
    EXPECT_THAT(ids(one), ElementsAre("Jane Doe", "submission_902"));
    EXPECT_THAT(one.at("submission_902").notes, ElementsAre(HasSubstr("submission_metadata.yml does not mention it")));
    const std::string huge((std::size_t{64} << 20U) + 1, '#');
    EXPECT_THAT(with(huge).at("submission_901").notes, ElementsAre(HasSubstr("it is larger than 64 MiB")));
    const TemporaryFolder other;
    other.write("class/submission_901/ray_cast.cpp", "a");
    const auto none = take(other.path() / "class");
    EXPECT_THAT(none.at("submission_901").notes, ElementsAre(HasSubstr("submission_metadata.yml is missing")));
}

TEST_P(LmsDownload, TakesASourceInAFolderOfTheStudents) {
    const auto of_gradescope = take_in({{"submission_901/ray_cast.cpp", "a"},
                                        {"submission_902/RayCast/ray_cast.cpp", "b"},
                                        {"submission_metadata.yml", "---\n"}});
    EXPECT_EQ(of_gradescope.at("submission_902").source, "b");
    if (!GetParam()) std::filesystem::remove_all(folder_.path() / "unpacked");
    const auto of_moodle = take_in({{"Jane Doe_2001_assignsubmission_file/hw/src/ray_cast.cpp", "jane"},
                                    {"Jane Doe_2001_assignsubmission_file/hw/old/ray_cast.txt", "notes"}});
    EXPECT_EQ(of_moodle.at("Jane Doe").source, "jane");
}

TEST_P(LmsDownload, OfCanvasCanContainAnArchiveThatWasSubmittedAgain) {
    const auto taken = take_in({{"doejane_1_10_hw.tar.gz", packed({{"ray_cast.cpp", "first"}})},
                                {"doejane_1_11_hw.tar-1.gz", packed({{"ray_cast.cpp", "second"}})},
                                {"roe_2_20_hw-2.zip", packed({{"ray_cast.cpp", "third"}})},
                                {"roe_2_21_hw.zip", packed({{"ray_cast.cpp", "first"}})}});
    EXPECT_EQ(taken.at("doejane").source, "second");
    EXPECT_EQ(taken.at("roe").source, "third");
    EXPECT_THAT(taken.at("roe").notes, ElementsAre("Handed in more than once: \"hw-2.zip\" counts, not \"hw.zip\"."));
}

TEST_P(LmsDownload, OfBrightspaceGivesAStudentTheLastOfTheAttempts) {
    const auto taken = take_in({{"397-255 - Jane Doe - Oct 9, 2026 926 PM/ray_cast.cpp", "first"},
                                {"397-255 - Jane Doe - Oct 10, 2026 1205 AM/ray_cast.cpp", "last"},
                                {"397-255 - John Roe-Poe - Oct 9, 2026 1130 AM/hw/main.cpp", "john"},
                                {"index.html", "<html>"}});
    EXPECT_THAT(ids(taken), ElementsAre("Jane Doe", "John Roe-Poe"));
    EXPECT_EQ(taken.at("Jane Doe").source, "last");
    EXPECT_EQ(taken.at("Jane Doe").lms->handed_in, "2026-10-10 00:05");
    EXPECT_THAT(taken.at("Jane Doe").notes,
                ElementsAre("Handed in 2 times; the last one, of 2026-10-10 00:05, counts."));
    EXPECT_EQ(taken.at("John Roe-Poe").source, "john");
}

TEST_P(LmsDownload, OfBlackboardGivesAStudentTheLastOfTheAttempts) {
    const auto taken =
        take_in({{"Assignment 6_jdoe1_attempt_2026-10-09-21-26-33_ray_cast.cpp", "first"},
                 {"Assignment 6_jdoe1_attempt_2026-10-09-21-26-33.txt", "Name: Jane Doe"},
                 {"Assignment 6_jdoe1_attempt_2026-10-10-00-05-00_ray_cast.cpp", "last"},
                 {"Assignment 6_jdoe1_attempt_2026-10-10-00-05-00.txt", "Name: Jane Doe"},
                 {"Assignment 6_eve_attempt_2026-10-09-10-00-00_x_jdoe1_attempt_2026-12-10-00-05-00_a.cpp", "forged"},
                 {"Assignment 6_eve_attempt_2026-10-09-10-00-00.txt", "Name: Eve"}});
    EXPECT_THAT(ids(taken), ElementsAre("eve", "jdoe1"));
    EXPECT_EQ(taken.at("jdoe1").source, "last");
    EXPECT_EQ(taken.at("eve").source, "forged");
}

TEST_P(LmsDownload, KeepsItsStudentsBesideStrayFiles) {
    const auto taken = take_in({{"doejane_1001_5001_ray_cast.cpp", "jane"},
                                {"roe_1002_5002_report.pdf", "%PDF"},
                                {"poe_LATE_1003_5003_ray_cast.cpp", "edgar"},
                                {"loe_1004_5004_ray_cast.cpp", "lola"},
                                {"desktop.ini", "[.ShellClassInfo]"},
                                {"grading notes.txt", "strict"},
                                {"solution.cpp", "int main() { }"}});
    EXPECT_THAT(ids(taken), ElementsAre("doejane", "loe", "poe", "roe", "solution.cpp"));
    EXPECT_EQ(taken.at("doejane").lms->id, "1001");
    EXPECT_THAT(taken.at("poe").notes, ElementsAre("Marked late in the download."));
    EXPECT_THAT(taken.at("roe").problem.value_or(""), HasSubstr("report.pdf"));
    EXPECT_THAT(taken.at("solution.cpp").problem.value_or(""),
                AllOf(HasSubstr("not named like a submission from Canvas"), HasSubstr("its student is unknown")));
    EXPECT_FALSE(taken.at("solution.cpp").lms);
}

TEST_P(LmsDownload, CanLieInsideOtherFolders) {
    const auto taken = take_in({{"hw6/submissions/doejane_1001_5001_ray_cast.cpp", "jane"},
                                {"hw6/submissions/roe_1002_5002_ray_cast.cpp", "roe"},
                                {"hw6/desktop.ini", ""},
                                {"hw6/submissions/desktop.ini", ""}});
    EXPECT_THAT(ids(taken), ElementsAre("doejane", "roe"));
}

TEST_P(LmsDownload, KeepsItsStudentsIfOtherFilesLieNextToItsFolder) {
    const auto of_canvas = take_in({{"hw6/doejane_1001_5001_ray_cast.cpp", "jane"},
                                    {"hw6/roe_1002_5002_ray_cast.cpp", "roe"},
                                    {"desktop.ini", ""},
                                    {"glm/vec3.hpp", ""},
                                    {"solution.cpp", "int main() { }"}});
    EXPECT_THAT(ids(of_canvas), ElementsAre("doejane", "roe", "solution.cpp"));
    EXPECT_THAT(of_canvas.at("solution.cpp").problem.value_or(""), HasSubstr("next to the folder of a download"));
}

TEST_P(LmsDownload, OfMoodleCanLieTwoFoldersBelowAnotherFile) {
    const auto of_moodle = take_in({{"hw6/in/Jane Doe_101_assignsubmission_file/ray_cast.cpp", "jane"},
                                    {"hw6/in/John Roe_102_assignsubmission_file/ray_cast.cpp", "john"},
                                    {"ray_cast.cpp", "m"}});
    EXPECT_THAT(ids(of_moodle), ElementsAre("Jane Doe", "John Roe", "ray_cast.cpp"));
}

TEST_P(LmsDownload, CanHaveAFolderForEachSection) {
    const auto taken = take_in({{"monday/doejane_1001_5001_ray_cast.cpp", "jane"},
                                {"monday/roe_1002_5002_ray_cast.cpp", "roe"},
                                {"friday/poe_1003_5003_ray_cast.cpp", "poe"},
                                {"friday/loe_1004_5004_ray_cast.cpp", "loe"}});
    EXPECT_THAT(ids(taken), ElementsAre("doejane", "loe", "poe", "roe"));
}

TEST_P(LmsDownload, IsNotDetectedInTheFolderOfAStudent) {
    const auto taken = take_in({{"ann/ray_cast.cpp", "a"},
                                {"ben/ray_cast.cpp", "b"},
                                {"cora/doejane_1001_5001_ray_cast.cpp", "j"},
                                {"cora/roe_1002_5002_notes.txt", ""}});
    EXPECT_THAT(ids(taken), ElementsAre("ann", "ben", "cora"));
}

TEST_P(LmsDownload, OfMoodleKeepsItsStudentsBesideStrayFolders) {
    const auto taken = take_in({{"Jane Doe_101_assignsubmission_file/ray_cast.cpp", "jane"},
                                {"John Roe_102_assignsubmission_file/ray_cast.cpp", "john"},
                                {"Joan Poe_103_assignsubmission_file/ray_cast.cpp", "joan"},
                                {"mine/ray_cast.cpp", "m"},
                                {"Thumbs.db", ""}});
    EXPECT_THAT(ids(taken), ElementsAre("Jane Doe", "Joan Poe", "John Roe", "mine"));
    EXPECT_THAT(taken.at("mine").problem.value_or(""), HasSubstr("Moodle"));
}

TEST_P(LmsDownload, IsNotDetectedIfOnlyOneNameLooksLikeIt) {
    const auto taken = take_in({{"ann.cpp", "a"}, {"ben.cpp", "b"}, {"doejane_1001_5001_ray_cast.cpp", "j"}});
    EXPECT_THAT(ids(taken), ElementsAre("ann", "ben", "doejane_1001_5001_ray_cast"));
}

INSTANTIATE_TEST_SUITE_P(, LmsDownload, testing::Bool(),
                         [](const auto& tested) { return tested.param ? "packed" : "unpacked"; });

}  // namespace
