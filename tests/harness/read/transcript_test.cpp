#include "harness/read/transcript.h"

#include <gtest/gtest.h>

namespace harness {
namespace {

std::vector<PrintedValue> values(std::string_view output) {
    std::vector<PrintedValue> all;
    for (const Section& section : read_transcript(output, 10).sections)
        all.insert(all.end(), section.values.begin(), section.values.end());
    return all;
}

TEST(Transcript, TakesTheWordMatrixForALabelUnlessItsBracketFollows) {
    EXPECT_FALSE(values("matrix [1 0 0; 0 1 0; 0 0 1]").front().typed);
    EXPECT_EQ(values("matrix [1 0 0; 0 1 0; 0 0 1]").front().label, "matrix");
    EXPECT_FALSE(values("matrix   1 0 0").front().typed);
    EXPECT_TRUE(values("A = Matrix([1, 0, 0], [0, 1, 0], [0, 0, 1])").front().typed);
    EXPECT_TRUE(values("A = mat3 ((1, 0, 0), (0, 1, 0), (0, 0, 1))").front().typed);
}

TEST(ReadTranscript, CountsLinesAsTheProgramPrintedThem) {
    const auto read = values("\r\n\nQuestion 1:\r\n\x1b[1m\rt = 1\n\n\nt = 2");
    ASSERT_EQ(read.size(), 2U);
    EXPECT_EQ(read[0].line, 5);
    EXPECT_EQ(read[1].line, 8);
}

TEST(ReadTranscript, JoinsComponentsOnOneLineAndOnSeveral) {
    EXPECT_EQ(values("x = 1, y = 2, z = 3").at(0).numbers.size(), 3U);
    EXPECT_EQ(values("N.x = 1\nN.y = 2\nN.z = 3").at(0).label, "N");
    EXPECT_EQ(values("Nx: 1\nNy: 2\nNz: 3\n").size(), 1U);
    EXPECT_EQ(values("P[0] = 1\nP[1] = 2\nP[2] = 3\n").size(), 1U);
    EXPECT_EQ(values("A.x = 1\nB.y = 2\nC.z = 3\n").size(), 3U);
}

TEST(ReadTranscript, ReadsWhatIsSaidBehindADiscriminant) {
    const auto read = values("d = -91 < 0, so no intersection\n");
    ASSERT_EQ(read.size(), 2U);
    EXPECT_EQ(read[0].label, "d");
    EXPECT_TRUE(read[1].numbers.empty());
    EXPECT_EQ(values("d = 91, so no intersection with the caps\n").size(), 1U);
    EXPECT_EQ(values("t = -91, no intersection before the eye\n").size(), 1U);
    for (const char* end :
         {", no hit", " none", " (no hit)", " < 0: miss", ". The ray misses the sphere.", " => no real roots"}) {
        const auto all = values("a = 1 b = -9.2 c = 3.5 d = -91.5" + std::string(end) + "\n");
        ASSERT_EQ(all.size(), 5U) << end;
        EXPECT_EQ(all[3].numbers.front().value, -91.5) << end;
        EXPECT_TRUE(all[4].numbers.empty()) << end;
    }
}

TEST(ReadTranscript, TakesANumberThatGivesAReasonForNoHitAsItsOwnValue) {
    const auto read = values("t is none since d = -91\n");
    ASSERT_EQ(read.size(), 2U);
    EXPECT_EQ(read[1].label, "t");
    EXPECT_TRUE(read[1].numbers.empty());
    const auto bare = values("There is no hit because -91 < 0\n");
    ASSERT_EQ(bare.size(), 1U);
    EXPECT_TRUE(bare[0].numbers.empty());
}

TEST(ReadTranscript, LeavesOtherDenialsBesideNumbersAlone) {
    for (const char* line : {"no hit before t = 3", "t = 2.5 (no negative roots)", "t = 2.5, no closer hit",
                             "t = 2.5, not 3.1", "hit = (1, 2, 3), no rounding", "d = 91 >= 0, so it does not miss",
                             "u + v = 0.4 <= 1, no problem", "t = 2.5 if it hits, none if d < 0",
                             "t = 2.5, the caps are not hit", "t = 2.5: the hit is not behind the eye"}) {
        for (const PrintedValue& value : values(line)) EXPECT_FALSE(value.numbers.empty()) << line;
    }
    EXPECT_EQ(values("-91.5 (no hit)\n").size(), 2U);
}

TEST(ReadTranscript, TakesAnswersBesideWordsForNumbers) {
    for (const char* line : {"root = 0", "hit point t = 0", "t = 0 (hit at the edge)", "hit = 1", "second hit: 0",
                             "d = -1 (no hit)", "t = 2.5 (no hit)", "t = -10 (no hit)", "t = 0 (no hit if negative)"})
        EXPECT_FALSE(values(line).at(0).numbers.empty()) << line;
}

TEST(ReadTranscript, TakesADashBeforeANameForTheMarkOfAList) {
    EXPECT_EQ(values("-a = 1\n-b = 10.5\n-c = 2\n").at(1).numbers.at(0).value, 10.5) << "a list";
    EXPECT_EQ(values("a = 1\n- b = 10.5\n").at(1).numbers.at(0).value, 10.5) << "a list of one";
    EXPECT_EQ(values("A:\n-V (1, 2, 3)\nB-A (4, 5, 6)\nC-A (7, 8, 9)\n").at(0).numbers.at(0).value, 1) << "a column";
    EXPECT_EQ(values("-d: (1, 2, 3)\ne1: (4, 5, 6)\ne2: (7, 8, 9)\n").at(0).numbers.at(0).value, 1) << "a column";
    EXPECT_LT(values("a = 1\n-inf\n").at(1).numbers.at(0).value, 0);
}

TEST(ReadTranscript, LabelsAValueWithTheWordsAbove) {
    const auto read = values("Hit point\n\n(1, 2, 3)\n(4, 5, 6)\n");
    ASSERT_EQ(read.size(), 2U);
    EXPECT_EQ(read[0].above, "Hit point");
    EXPECT_EQ(read[1].above, "");
}

TEST(ReadTranscript, KeepsOnlyTheBeginningAndEndOfAnEndlessLoop) {
    std::string output = "Question 6:\n";
    for (int i = 0; i < 10000; ++i) output += "t = " + std::to_string(i) + "\n";
    const auto read = values(output);
    ASSERT_EQ(read.size(), most_values_in_section);
    EXPECT_EQ(read.front().numbers[0].value, 0);
    EXPECT_EQ(read.back().numbers[0].value, 9999);
}

TEST(ReadTranscript, GivesOneEmptySectionForNothing) {
    EXPECT_EQ(read_transcript("", 10).sections.size(), 1U);
    EXPECT_TRUE(values("").empty());
}

TEST(Transcript, ReadsHeadingsBehindSymbols) {
    for (const char* before : {"📌 ", "### ★ ", "➡ "}) {
        const auto sections = read_transcript(std::string(before) + "Question 6\nt: 2.5\n", 10).sections;
        ASSERT_EQ(sections.size(), 2U) << before;
        EXPECT_EQ(sections[1].question, 6) << before;
    }
}

}  // namespace
}  // namespace harness
