#include "harness/report/text/look_first.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace harness::report {
namespace {

constexpr auto right = ItemVerdict::right, follow = ItemVerdict::follow, wrong = ItemVerdict::wrong,
               missing = ItemVerdict::missing, unreadable = ItemVerdict::unreadable;

/// Questions 1, 2, … whose items have these verdicts.
Graded with(const std::vector<std::vector<ItemVerdict>>& questions, Outcome outcome = Outcome::graded) {
    Graded graded;
    graded.execution.outcome = outcome;
    for (const auto& verdicts : questions) {
        QuestionScore question;
        question.number = static_cast<int>(graded.score.questions.size()) + 1;
        for (const ItemVerdict verdict : verdicts) {
            question.items.emplace_back();
            question.items.back().verdict = verdict;
        }
        graded.score.questions.push_back(std::move(question));
    }
    return graded;
}

TEST(LookFirst, NamesTheEarliestWrongQuestionAndWhatFollows) {
    EXPECT_EQ(look_first_sentence(with({{right}, {right, wrong}, {follow}, {right, follow}, {wrong}, {follow}})),
              "Start with question 2: it has your first wrong answer. Questions 3, 4 and 6 are consistent with "
              "your earlier answers and have no mistake of their own.");
}

TEST(LookFirst, NamesTheOneMistakeThatOthersFollowFrom) {
    EXPECT_EQ(look_first_sentence(with({{wrong}, {follow}})),
              "Start with question 1: it is the only one with a wrong answer. Question 2 is consistent with it and has "
              "no mistake of its own.");
    EXPECT_EQ(look_first_sentence(with({{follow}, {wrong}})),
              "Start with question 2: it is the only one with a wrong answer. Question 1 is consistent with your "
              "earlier answers and has no mistake of its own.")
        << "not from a later one";
}

TEST(LookFirst, PutsAWrongAnswerBeforeOneThatIsOnlyMissing) {
    EXPECT_EQ(look_first(with({{missing}, {right}, {unreadable}}))->question, 3);
    EXPECT_EQ(look_first_sentence(with({{right}, {missing}, {missing}})),
              "Start with question 2: it is the first one with a missing answer.");
}

TEST(LookFirst, NamesTheQuestionsThatLackAnswersBesideAWrongOne) {
    EXPECT_EQ(look_first_sentence(with({{missing}, {right}, {right, missing}, {follow}, {wrong, missing}})),
              "Start with question 5: it is the only one with a wrong answer. Questions 1 and 3 lack answers. "
              "Question 4 is consistent with your earlier answers and has no mistake of its own.");
    EXPECT_EQ(look_first_sentence(with({{wrong}, {missing}})),
              "Start with question 1: it is the only one with a wrong answer. Question 2 lacks answers.");
}

TEST(LookFirst, DoesNotListAPartlyFollowingQuestion) {
    const auto look = look_first(with({{wrong}, {follow, wrong}, {follow, missing}}));
    EXPECT_EQ(look->question, 1);
    EXPECT_THAT(look->following, testing::IsEmpty());
}

TEST(LookFirst, IsEmptyIfThereIsNothingToLookAt) {
    EXPECT_EQ(look_first_sentence(with({{right}, {right}})), "");
    for (const Outcome outcome : {Outcome::compile_error, Outcome::no_output, Outcome::not_graded})
        EXPECT_EQ(look_first_sentence(with({{missing}}, outcome)), "");
    EXPECT_EQ(look_first_sentence(with({{missing}, {missing}})), "") << "only noise was printed";
}

TEST(LookFirst, IsTheSceneThatTheSourceStates) {
    Graded graded = with({{right}, {follow}, {follow}, {wrong}});
    graded.findings.own_scene = OwnScene{"", "Your source sets radius = 2 where the assignment has 1.5"};
    EXPECT_EQ(look_first_sentence(graded),
              "Start with the scene in your source: Your source sets radius = 2 where the assignment has 1.5. Most of "
              "the lost points come from that.");
}

TEST(LookFirst, ComesAfterTheCrash) {
    EXPECT_EQ(look_first_sentence(with({{right}, {missing}}, Outcome::crashed)),
              "Start with question 2: the program ended before it printed all of its answers.");
    EXPECT_EQ(look_first_sentence(with({{right}, {wrong}, {missing}}, Outcome::crashed)),
              "Then look at question 2: it is the only one with a wrong answer.");
}

TEST(LookFirst, IsEmptyForAProgramThatEndedBeforeItsFirstAnswer) {
    for (const Outcome outcome :
         {Outcome::crashed, Outcome::timed_out, Outcome::output_limit, Outcome::memory_limit, Outcome::no_output}) {
        EXPECT_EQ(look_first_sentence(with({{missing}, {missing, missing}}, outcome)), "");
        EXPECT_TRUE(is_without_answers(with({{missing}, {missing, missing}}, outcome)));
        EXPECT_FALSE(is_without_answers(with({{missing}, {missing, wrong}}, outcome)));
    }
    EXPECT_FALSE(is_without_answers(with({{missing}})));
}

}  // namespace
}  // namespace harness::report
