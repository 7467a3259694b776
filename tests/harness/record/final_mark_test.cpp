#include "harness/record/final_mark.h"

#include <gtest/gtest.h>

namespace harness {
namespace {

/// Two questions: 5 with V (4 of 10 points), 6 with a (3 of 5) and t (0 of 5).
Graded sample() {
    Graded graded;
    graded.execution.outcome = Outcome::graded;
    const auto item = [](int question, const char* name, double points, double most) {
        ItemScore score;
        score.spec.question = question;
        score.spec.name = name;
        score.points = points;
        score.max_points = most;
        return score;
    };
    graded.score.questions = {{5, "", ItemVerdict::wrong, 4, 10, {item(5, "V", 4, 10)}},
                              {6, "", ItemVerdict::wrong, 3, 10, {item(6, "a", 3, 5), item(6, "t", 0, 5)}}};
    graded.score.points = 7;
    graded.score.max_points = 20;
    return graded;
}

TEST(FinalMark, IsTheAutomaticMarkWithoutOverrides) {
    const Graded graded = sample();
    EXPECT_EQ(final_mark(graded)->points, 7);
    EXPECT_EQ(final_mark(graded)->late_deduction, 0);
    EXPECT_EQ(final_points(graded, graded.score.questions[1]), 3);
}

TEST(FinalMark, CountsAnOverriddenItemInItsQuestionAndInTheTotal) {
    Graded graded = sample();
    graded.review.overrides = {{6, "t", 4.5, "right idea", "ada", ""}};
    const QuestionScore& sphere = graded.score.questions[1];
    EXPECT_EQ(final_points(graded, sphere, sphere.items[1]), 4.5);
    EXPECT_EQ(final_points(graded, sphere, sphere.items[0]), 3);
    EXPECT_EQ(final_points(graded, sphere), 7.5);
    EXPECT_EQ(final_points(graded, graded.score.questions[0]), 4);
    EXPECT_EQ(final_mark(graded)->points, 11.5);
}

TEST(FinalMark, UsesTheLastOverrideOfAPlace) {
    Graded graded = sample();
    graded.review.overrides = {{6, "t", 4.5, "right idea", "ada", ""}, {6, "t", 1, "on second thoughts", "ada", ""}};
    EXPECT_EQ(final_mark(graded)->points, 8);
}

TEST(FinalMark, PrefersAQuestionsOverrideToThoseOfItsItems) {
    Graded graded = sample();
    graded.review.overrides = {{6, "", 9, "shown at the board", "ada", ""}, {6, "t", 1, "part", "ada", ""}};
    EXPECT_EQ(final_points(graded, graded.score.questions[1]), 9);
    EXPECT_EQ(final_mark(graded)->points, 13);
}

TEST(FinalMark, OfAQuestionsOnlyItemIsTheQuestions) {
    Graded graded = sample();
    graded.review.overrides = {{5, "", 9, "shown at the board", "ada", ""}, {6, "", 2, "", "ada", ""}};
    const QuestionScore &ray = graded.score.questions[0], &sphere = graded.score.questions[1];
    EXPECT_EQ(final_points(graded, ray, ray.items[0]), 9);
    EXPECT_EQ(final_points(graded, sphere, sphere.items[0]), 3);
}

TEST(LoweredBy, NamesEachLoweredMarkBeforeAndAfter) {
    Graded graded = sample();
    EXPECT_EQ(lowered_by(graded, {6, "", 2, "", "", ""}), "question 6 from 3 to 2 points, and the mark from 7 to 6");
    EXPECT_EQ(lowered_by(graded, {0, "", 2, "", "", ""}), "the mark from 7 to 2");
    EXPECT_EQ(lowered_by(graded, {6, "a", 3, "", "", ""}), "") << "the same";
    EXPECT_EQ(lowered_by(graded, {6, "t", 1, "", "", ""}), "");
    EXPECT_EQ(lowered_by(graded, {6, "z", 1, "", "", ""}), "");
    graded.review.overrides = {{6, "", 9, "shown at the board", "ada", ""}};
    EXPECT_EQ(lowered_by(graded, {6, "", 5, "", "", ""}), "question 6 from 9 to 5 points, and the mark from 13 to 9")
        << "though the automatic points are fewer";
    EXPECT_EQ(lowered_by(graded, {6, "a", 1, "", "", ""}), "question 6, a from 3 to 1 points")
        << "the question's override counts";
    Graded none = sample();
    none.execution.outcome = Outcome::not_graded;
    EXPECT_EQ(lowered_by(none, {0, "", 0, "", "", ""}), "") << "no mark before";
}

TEST(FinalMark, DeductsLatenessFromPointsForVariantsToo) {
    Graded graded = sample();
    graded.late_share = 0.25;
    graded.score.variants = ScenesScore{6, 10};
    graded.score.points += 6;
    graded.score.max_points += 10;
    EXPECT_EQ(final_mark(graded)->points, 0.75 * (7 + 6));
    EXPECT_EQ(final_mark(graded)->late_deduction, 0.25 * (7 + 6));
    graded.review.overrides = {{0, "variants", 10, "it works", "ada", ""}};
    EXPECT_EQ(final_mark(graded)->points, 0.75 * (7 + 10));
    EXPECT_EQ(final_mark(graded)->late_deduction, 0.25 * (7 + 10));
}

TEST(FinalMark, DeductsAShareOfTheEarnedPointsForLateness) {
    Graded graded = sample();
    graded.late_share = 0.25;
    graded.review.overrides = {{6, "t", 5, "right idea", "ada", ""}};
    EXPECT_EQ(final_mark(graded)->points, 9);
    EXPECT_EQ(final_mark(graded)->late_deduction, 3);
}

TEST(FinalMark, TakesAnOverriddenTotalUnchangedEvenIfLateOrNotGraded) {
    Graded graded = sample();
    graded.late_share = 0.25;
    graded.execution.outcome = Outcome::not_graded;
    EXPECT_FALSE(final_mark(graded).has_value());
    graded.review.overrides = {{0, "", 15, "marked by hand", "ada", ""}};
    EXPECT_EQ(final_mark(graded)->points, 15);
    EXPECT_EQ(final_mark(graded)->late_deduction, 0);
}

TEST(FinalMark, IsMissingForAnUngradedSubmissionWithAPartialOverride) {
    Graded graded = sample();
    graded.execution.outcome = Outcome::not_graded;
    graded.review.overrides = {{6, "t", 5, "right idea", "ada", ""}};
    EXPECT_FALSE(final_mark(graded).has_value());
}

}  // namespace
}  // namespace harness
