#include "harness/mark/score/doubt.h"

#include <gtest/gtest.h>

#include "tests/given/printed_values.h"
#include "tests/given/student/scenes.h"

namespace harness {
namespace {

const student::Marking& off_axis() {
    static const student::Marking marking = student::off_axis_scene();
    return marking;
}

Score marked(const std::string& output) {
    return score(read_transcript(output, 10), off_axis().key, off_axis().assignment);
}

std::optional<Doubt> doubt_of(const std::string& output, const reference::ItemId& id) {
    const Score score = marked(output);
    return item_of(score, id).doubt;
}

// The right ray parameter of the sphere is 2.29988, P_s is (3.62297, 0.37245, 0.73491).

TEST(Doubt, IsNotRaisedForARightAnswer) {
    EXPECT_FALSE(doubt_of("Question 6:\nt: 2.29988\nother: 7.77\n", reference::item::sphere::t));
}

TEST(Doubt, IsNotRaisedIfAllIsUnderstood) {
    EXPECT_FALSE(doubt_of("Question 6:\nt: 3.29988\n", reference::item::sphere::t));
    EXPECT_FALSE(doubt_of("Question 6:\nt: 3.29988\ndebug: 4.5 5.5\nthere are 2 roots\n", reference::item::sphere::t));
    EXPECT_FALSE(doubt_of("Question 5:\nV: 1.5 2.5 3.5\n", reference::item::sphere::t)) << "nothing was printed for it";
}

TEST(Doubt, SaysWhereTheRightValueStands) {
    const auto doubt = doubt_of("Question 6:\nt: 3.29988\nfar: 2.29988\n", reference::item::sphere::t);
    ASSERT_TRUE(doubt);
    EXPECT_EQ(doubt->why, Doubt::Why::right_elsewhere);
    EXPECT_EQ(doubt->line, 3);
    const auto in_pieces = doubt_of("Question 6:\nhit: (1.5, 2.5, 3.5)\n3.62297 then\n0.37245 then\n0.73491\n",
                                    reference::item::sphere::hit);
    ASSERT_TRUE(in_pieces);
    EXPECT_EQ(in_pieces->line, 3);
}

TEST(Doubt, SeesTheColumnsOfABlock) {
    // The axes are the columns, read as the rows.
    const auto doubt =
        doubt_of("Question 2:\n0.927345 0.045822 0.371391\n-0.151241 0.953698 0.259973\n-0.342282 -0.297255 0.891338\n",
                 reference::item::Y_vcs);
    ASSERT_TRUE(doubt);
    EXPECT_EQ(doubt->why, Doubt::Why::right_elsewhere);
}

TEST(Doubt, SaysWhichNumbersWereLeft) {
    const auto doubt =
        doubt_of("Question 7:\nsomething 0.1 something 0.2 something 0.3\n", reference::item::sphere::normal);
    ASSERT_TRUE(doubt);
    EXPECT_EQ(doubt->why, Doubt::Why::numbers_left);
    EXPECT_EQ(doubt->line, 2);
}

TEST(Doubt, IsRaisedForWordsInPlaceOfAVerdict) {
    const auto doubt = doubt_of("Question 10:\nla sfera viene prima\n", reference::item::verdict);
    ASSERT_TRUE(doubt);
    EXPECT_EQ(doubt->why, Doubt::Why::words_left);
    EXPECT_FALSE(doubt_of("Question 9:\nN: 1 2 3\n", reference::item::verdict)) << "nothing was printed for it";
}

TEST(Doubt, IsRaisedIfAnotherPrintingWasPassedOver) {
    const auto doubt =
        doubt_of("Question 6:\nt: 1.75\nQuestion 7:\nN: 0 0 1\nQuestion 6:\nt: 1.85\n", reference::item::sphere::t);
    ASSERT_TRUE(doubt);
    EXPECT_EQ(doubt->why, Doubt::Why::printed_again);
    EXPECT_EQ(doubt->line, 6);
}

TEST(Doubt, IsRaisedIfLittleWasRead) {
    std::string output = "Question 1:\n";
    for (int i = 0; i < 30; ++i) output += "zzz " + std::to_string(i) + ".25 zzz " + std::to_string(i) + ".75\n";
    const Score score = marked(output);
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items)
            EXPECT_TRUE(item.verdict == ItemVerdict::right || item.doubt) << question.number << item.spec.name;
    }
}

TEST(DoubtsText, NamesItemsAndLinesAndNoValue) {
    const std::string text = doubts_text(marked("Question 6:\nt: 3.29988\nfar: 2.29988\n"));
    EXPECT_EQ(text, "6.t: line 3 has numbers that were not understood");
    EXPECT_EQ(doubts_text(marked("Question 6:\nt: 3.29988\n")), "");
}

}  // namespace
}  // namespace harness
