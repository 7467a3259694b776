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

TEST(ItemSentence, ExplainsNan) {
    ItemScore nan = item(ItemVerdict::wrong);
    nan.printed = "t: -nan";
    EXPECT_THAT(item_sentence(nan, Outcome::graded), HasSubstr("not a number"));
    EXPECT_THAT(item_sentence(nan, Outcome::graded), HasSubstr("If the ray misses, print none."));
    nan.verdict = ItemVerdict::follow;
    EXPECT_THAT(item_sentence(nan, Outcome::graded),
                testing::AllOf(HasSubstr("Not a number"), HasSubstr("consistent with your earlier answers")));
    nan.verdict = ItemVerdict::wrong;
    nan.spec = {5, "V", reference::Shape::vector, "V", reference::item::V};
    EXPECT_THAT(item_sentence(nan, Outcome::graded), testing::Not(HasSubstr("misses"))) << "there is always a V";
}

TEST(BeforePrinted, SaysHowADoubtfulLineWasRead) {
    ItemScore wrong = item(ItemVerdict::wrong);
    EXPECT_EQ(before_printed(wrong), "you printed");
    wrong.doubt = Doubt{Doubt::Why::right_elsewhere, 11};
    EXPECT_EQ(before_printed(wrong), "you printed") << "only the key knows";
    wrong.layout_doubt = Doubt{Doubt::Why::numbers_left, 3};
    EXPECT_EQ(before_printed(wrong), "read as t =");
    EXPECT_EQ(capitalized(before_printed(wrong)), "Read as t =");
    wrong.spec.shape = reference::Shape::first_object;
    EXPECT_EQ(before_printed(wrong), "read as the answer:");
}

TEST(ItemSentence, RevealsNoMoreThanTheRubricAllows) {
    using reference::Feedback;
    ItemScore far_root = item(ItemVerdict::wrong);
    far_root.error = 2.0;
    far_root.advice = "That is the far root.";
    far_root.diagnosis = "far root";
    const auto told = [&](Feedback feedback) {
        return item_sentence(far_root, Outcome::graded, feedback) + told_diagnosis(far_root, feedback);
    };
    EXPECT_EQ(told(Feedback::verdict), "That is not the right value.");
    EXPECT_EQ(told(Feedback::hint), "That is not the right value, and it is not consistent with your earlier answers.");
    for (const Feedback feedback : {Feedback::mistake, Feedback::expected})
        EXPECT_EQ(told(feedback), "That is the far root.far root");
    far_root.verdict = ItemVerdict::follow;
    far_root.points = far_root.max_points = 1;
    EXPECT_EQ(told(Feedback::hint), "Wrong value, but consistent with your earlier answers. No points lost.");
}

TEST(ItemSentence, MentionsEarlierAnswersOnlyIfTheyMatter) {
    ItemScore wrong = item(ItemVerdict::wrong);
    for (const reference::ItemId& alone : {reference::item::P_VCS, reference::item::Z_vcs}) {
        wrong.spec.id = alone;
        EXPECT_EQ(item_sentence(wrong, Outcome::graded), "That is not the right value.") << alone.name;
    }
    wrong.spec.id = reference::item::X_vcs;
    EXPECT_THAT(item_sentence(wrong, Outcome::graded), HasSubstr("your earlier answers"));
}

TEST(ItemSentence, SaysWhatAConsistentAnswerEarns) {
    ItemScore half = item(ItemVerdict::follow);
    half.points = 1.5;
    half.max_points = 3;
    EXPECT_THAT(item_sentence(half, Outcome::graded), testing::EndsWith("answers. That earns 50 % of its points."));
    half.advice = "Your source sets center = (1, 1, 1).";
    EXPECT_EQ(item_sentence(half, Outcome::graded),
              "Your source sets center = (1, 1, 1). That earns 50 % of its points.");
    half.points = 3;
    EXPECT_THAT(item_sentence(half, Outcome::graded), testing::Not(HasSubstr("earns")));
}

TEST(MissingSentence, SaysWhatWentToStandardError) {
    Graded one = report_samples::graded("zoe", "Question 5:\nV: 0 0 -1\n");
    const auto sentence = [&](const std::string& errors) {
        one.execution.run.errors = errors;
        return missing_sentence(one);
    };
    EXPECT_THAT(sentence("Question 6:\nt: 0.585786\n"),
                testing::EndsWith(" Your program wrote question 6 to standard error (std::cerr); only standard output "
                                  "is read."));
    EXPECT_THAT(sentence("sphere normal: 0.5 0.5 0.7\n"), HasSubstr("wrote question 7 (normal) to standard error"));
    for (const char* nothing : {"", "Question 5:\nV: 0 0 -1\n", "terminate called\n", "debug 1 2 3\n"})
        EXPECT_THAT(sentence(nothing), testing::EndsWith("ray hits sphere first\".")) << nothing;
}

Graded with_missing(const std::vector<int>& whole, Outcome outcome) {
    Graded graded;
    graded.execution.outcome = outcome;
    for (int number = 1; number <= 3; ++number) {
        QuestionScore& question = graded.score.questions.emplace_back();
        question.number = number;
        for (const char* name : {"t", "hit"}) {
            ItemScore& one = question.items.emplace_back();
            one.spec.name = name;
            const bool missing = std::find(whole.begin(), whole.end(), number) != whole.end();
            one.verdict = missing ? ItemVerdict::missing : ItemVerdict::right;
        }
    }
    return graded;
}

TEST(MissingSentence, IsOneSentenceForAllMissingAnswers) {
    Graded graded = with_missing({1, 3}, Outcome::graded);
    graded.score.questions[1].items[1].verdict = ItemVerdict::missing;
    EXPECT_EQ(missing_sentence(graded),
              "Not found in the output: question 1, question 3 and question 2 (hit). Print each answer with a label "
              "under its "
              "question's heading.");
    graded.execution.outcome = Outcome::crashed;
    EXPECT_EQ(missing_sentence(graded),
              "Not printed before the program ended: question 1, question 3 and question 2 (hit).");
    EXPECT_EQ(missing_sentence(with_missing({1, 2, 3}, Outcome::timed_out)),
              "The program printed no answer before it ended.");
    EXPECT_EQ(missing_sentence(with_missing({1, 2, 3}, Outcome::graded)),
              "No answer was found in the output. Print each answer with a label under its question's heading.");
    EXPECT_EQ(missing_sentence(with_missing({2, 3}, Outcome::crashed)),
              "Not printed before the program ended: questions 2 and 3.");
    EXPECT_EQ(missing_sentence(with_missing({}, Outcome::graded)), "");
    Graded without_verdict = with_missing({3}, Outcome::graded);
    without_verdict.score.questions[2].items[1].spec.shape = reference::Shape::first_object;
    EXPECT_EQ(missing_sentence(without_verdict),
              "Not found in the output: question 3. Print each answer with a label under its question's heading, and "
              "the first hit as \"ray hits sphere first\".");
    for (const Outcome outcome : {Outcome::compile_error, Outcome::no_output, Outcome::not_graded})
        EXPECT_EQ(missing_sentence(with_missing({1, 2, 3}, outcome)), "");
}

TEST(AcceptedSentence, IsOneForEachFormWithItsAnswers) {
    Score score = with_missing({3}, Outcome::graded).score;
    EXPECT_EQ(accepted_sentence(score), "");
    score.questions[0].items[0].accepted_as = score.questions[1].items[1].accepted_as = "the grid convention";
    score.questions[0].items[1].accepted_as = "b' = b/2";
    EXPECT_EQ(accepted_sentence(score),
              "Accepted in question 1 (t) and question 2 (hit): the grid convention; in question 1 (hit): b' = b/2.");
}

}  // namespace
}  // namespace harness::report
