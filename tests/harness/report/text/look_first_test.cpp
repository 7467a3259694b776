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

TEST(LookFirst, NamesTheQuestionToStartWithAndWhatFollowsOrIsMissing) {
    const std::string consistent = " consistent with your earlier answers and ", no_own = "no mistake of their own.",
                      only = "it is the only one with a wrong answer. ";
    const struct {
        std::vector<std::vector<ItemVerdict>> questions;
        std::string sentence;
        Outcome outcome = Outcome::graded;
    } cases[] = {
        {{{right}, {right, wrong}, {follow}, {right, follow}, {wrong}, {follow}},
         "Start with question 2: it has your first wrong answer. Questions 3, 4 and 6 are" + consistent + "have " +
             no_own},
        {{{wrong}, {follow}},
         "Start with question 1: " + only + "Question 2 is consistent with it and has no mistake of its own."},
        {{{follow}, {wrong}},
         "Start with question 2: " + only + "Question 1 is" + consistent + "has no mistake of its own."},
        {{{right}, {missing}, {missing}}, "Start with question 2: it is the first one with a missing answer."},
        {{{missing}, {right}, {right, missing}, {follow}, {wrong, missing}},
         "Start with question 5: " + only + "Questions 1 and 3 lack answers. Question 4 is" + consistent +
             "has no mistake of its own."},
        {{{wrong}, {missing}}, "Start with question 1: " + only + "Question 2 lacks answers."},
        {{{right}, {right}}, ""},
        {{{missing}}, "", Outcome::compile_error},
        {{{missing}}, "", Outcome::no_output},
        {{{missing}}, "", Outcome::not_graded},
        {{{missing}, {missing}}, ""},  // only noise was printed
        {{{right}, {missing}},
         "Start with question 2: the program ended before it printed all of its answers.",
         Outcome::crashed},
        {{{right}, {wrong}, {missing}},
         "Then look at question 2: it is the only one with a wrong answer.",
         Outcome::crashed},
    };
    for (const auto& [questions, sentence, outcome] : cases)
        EXPECT_EQ(look_first_sentence(with(questions, outcome)), sentence);
    EXPECT_EQ(look_first(with({{missing}, {right}, {unreadable}}))->question, 3) << "before one that is only missing";
    EXPECT_THAT(look_first(with({{wrong}, {follow, wrong}, {follow, missing}}))->following, testing::IsEmpty())
        << "a question that follows in part";
    Graded other_scene = with({{right}, {follow}, {follow}, {wrong}});
    other_scene.findings.own_scene = OwnScene{"", "Your source sets radius = 2 where the assignment has 1.5"};
    EXPECT_EQ(look_first_sentence(other_scene),
              "Start with the scene in your source: Your source sets radius = 2 where the assignment has 1.5. Most of "
              "the lost points come from that.");
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
