#include "harness/mark/score/doubts_text.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/mark/score/mark_transcript.h"
#include "tests/given/student/scenes.h"

namespace harness {
namespace {

Score scored_off_axis(const std::string& output) {
    static const student::Marking marking = student::off_axis_scene();
    return score(read_transcript(output, 10), marking.key, marking.assignment);
}

std::string told(const std::string& output) {
    return doubts_text(scored_off_axis(output), Audience::instructor);
}

TEST(DoubtsText, TellsAnInstructorWhereTheRightValueStandsAndWhatWasReadThere) {
    using testing::HasSubstr;
    EXPECT_EQ(told("Question 6:\nt: 3.29988\nb2: 2.29988\n"),
              "question 6 (t): the right value is on line 3, read as question 6 (b)");
    EXPECT_THAT(told("Question 6:\na: 1\nb: 1\nc: 1\nd: 1\nt: 3.29988\nhit: (1, 2, 3)\nzz 0.5 zz 2.29988\n"),
                HasSubstr("question 6 (t): the right value is on line 8, not read as any answer"));
    EXPECT_THAT(told("Question 6:\nt: 3.29988 (rounded 2.29988)\n"),
                HasSubstr("question 6 (t): the right value is on line 2, next to the number that was read"));
    EXPECT_THAT(told("Question 6:\nt: 3.29988\nhit: (1.5, 2.5, 3.5)\n3.62297 then\n0.37245 then\n0.73491\n"),
                HasSubstr("question 6 (hit): the right value begins on line 4"));
}

TEST(DoubtsText, TellsAnInstructorEveryOtherReason) {
    using testing::HasSubstr;
    EXPECT_THAT(
        told("Question 7:\nthis 0.1 that 0.2 other 0.3\n"),
        HasSubstr(
            "question 7 (normal), question 8 (matrix, rhs, t, u, v, hit) and question 9 (normal): line 2 has numbers "
            "that were not used for any answer"));
    EXPECT_EQ(told("Question 10:\neloszor gomb\n"),
              "question 10 (which object is hit first): line 2 has words that were not understood");
    EXPECT_THAT(told("Question 6:\nt: 1.75\nQuestion 7:\nN: 0 0 1\nQuestion 6:\nt: 1.85\n"),
                HasSubstr("question 6 (t): the question was printed more than once, also on line 6"));
    EXPECT_THAT(told("Question 5:\nV: 1 2 3\nzzz 4.25 zzz 5.75 zzz 6.5 zzz 7.5\n"),
                HasSubstr(": fewer than half of the answers were found"));
    EXPECT_EQ(told("Question 6:\nt: 3.29988\n"), "");
}

TEST(DoubtsText, DoesNotTellAStudentWhichNumbersAreRight) {
    const auto student = [](const std::string& number) {
        return doubts_text(scored_off_axis("Question 6:\na: 1\nt: 3.29988\nza 0.5 zb " + number + " zc 0.75 zd 6.5\n"),
                           Audience::student);
    };
    EXPECT_THAT(student("2.29988"),
                testing::HasSubstr("question 6 (b, c, d, t) and question 8 (t, u, v): the answer may be on line 4"));
    EXPECT_EQ(student("2.29988"), student("2.5"));
    const auto searched = [](int place) {  // with a right value among twenty
        std::string output = "Question 6:\nt: 3.29988\n";
        for (int i = 0; i < 20; ++i) output += i == place ? "2.29988\n" : fmt::format("{}.75\n", 10 + i);
        return doubts_text(scored_off_axis(output), Audience::student);
    };
    EXPECT_NE(searched(-1), "");
    for (const int place : {0, 7, 19}) EXPECT_EQ(searched(place), searched(-1));
    const auto in_order = [](const std::string& y) {  // no number is left
        return doubts_text(
            scored_off_axis("Question 2:\n0.045822 0.953698 -0.297255\n" + y + "\n0.371391 0.259973 0.891338\n"),
            Audience::student);
    };
    EXPECT_EQ(in_order("0.927345 -0.151241 -0.342282"), in_order("1.5 2.5 3.5")) << "that there is a doubt tells too";
}

}  // namespace
}  // namespace harness
