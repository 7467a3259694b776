#include "harness/grade/repetition.h"

#include <gmock/gmock.h>

namespace {

using harness::difference;
using harness::Ended;
using harness::Repetition;

/// A run that printed these texts for items a and b of question 6.
Repetition run(const std::string& a, const std::string& b, Ended ended = Ended::exited) {
    Repetition run;
    run.ended = ended;
    harness::QuestionScore question;
    question.number = 6;
    for (const auto& [name, printed] : {std::pair("a", a), {"b", b}}) {
        harness::ItemScore item;
        item.spec.name = name;
        item.printed = printed;
        question.items.push_back(item);
    }
    run.score.questions = {question};
    return run;
}

TEST(Difference, IsEmptyBetweenTheSameAnswers) {
    EXPECT_EQ(difference({run("1", "2"), run("1", "2"), run("1", "2")}), std::nullopt);
    EXPECT_EQ(difference({run("1", "2")}), std::nullopt);
    EXPECT_EQ(difference({}), std::nullopt);
}

TEST(Difference, NamesTheFirstItemAndTheRun) {
    EXPECT_EQ(difference({run("1", "2"), run("1", "2"), run("1", "3e9")}),
              "Question 6, b: run 1 printed 2, run 3 printed 3e9.");
    EXPECT_EQ(difference({run("1", "2"), run("1", "")}), "Question 6, b: run 1 printed 2, run 2 printed nothing.");
}

TEST(Difference, IncludesADifferentEnd) {
    EXPECT_EQ(difference({run("1", "2"), run("1", "2", Ended::signalled)}), "Run 2 ended differently from run 1.");
}

}  // namespace
