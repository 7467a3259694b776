#include "harness/report/text/sentences.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/text/points.h"
#include "tests/given/report/graded_samples.h"

namespace harness::report {
namespace {

using testing::HasSubstr;

ItemScore item(ItemVerdict verdict) {
    ItemScore score;
    score.spec = {6, "t", reference::Shape::scalar, "t", reference::item::sphere::t};
    score.verdict = verdict;
    return score;
}

TEST(PointsText, HasAtMostTwoDecimalsAndNoTrailingZeros) {
    EXPECT_EQ(points_text(10), "10");
    EXPECT_EQ(points_text(1.5), "1.5");
    EXPECT_EQ(points_text(5.0 / 3), "1.67");
    EXPECT_EQ(points_text(0), "0");
    EXPECT_EQ(points_text(-0.0001), "0");
    EXPECT_EQ(points_text(100), "100");
}

TEST(ItemSentence, IsEmptyForASimplyRightItem) {
    EXPECT_EQ(item_sentence(item(ItemVerdict::right), Outcome::graded), "");
}

TEST(ItemSentence, SaysWhyADifferentFormIsRight) {
    ItemScore accepted = item(ItemVerdict::right);
    accepted.accepted_as = "the form with b' = b/2";
    EXPECT_EQ(item_sentence(accepted, Outcome::graded), "Accepted: the form with b' = b/2.");
}

TEST(ItemSentence, NamesTheMissingShape) {
    EXPECT_THAT(item_sentence(item(ItemVerdict::missing), Outcome::graded), HasSubstr("one number"));
    EXPECT_THAT(item_sentence(item(ItemVerdict::unreadable), Outcome::graded), HasSubstr("one number"));
    ItemScore matrix = item(ItemVerdict::missing);
    matrix.spec.shape = reference::Shape::matrix4;
    EXPECT_THAT(item_sentence(matrix, Outcome::graded), HasSubstr("4 x 4 matrix"));
}

TEST(ItemSentence, DoesNotBlameTheLabelsOfAProgramThatWasCutShort) {
    for (const Outcome outcome : {Outcome::crashed, Outcome::timed_out, Outcome::output_limit, Outcome::memory_limit}) {
        EXPECT_EQ(item_sentence(item(ItemVerdict::missing), outcome),
                  "Not found in what the program printed before it ended.");
    }
}

TEST(ItemSentence, ExplainsNan) {
    ItemScore nan = item(ItemVerdict::wrong);
    nan.printed = "t: -nan";
    EXPECT_THAT(item_sentence(nan, Outcome::graded), HasSubstr("not a number"));
}

TEST(ItemSentence, GivesTheAdviceOfANamedMistake) {
    ItemScore far_root = item(ItemVerdict::wrong);
    far_root.error = 2.0;
    far_root.advice = "That is the far root.";
    EXPECT_EQ(item_sentence(far_root, Outcome::graded), "That is the far root.");
}

}  // namespace
}  // namespace harness::report
