#include "harness/read/sections/question_behind.h"

#include <gtest/gtest.h>

#include <string>

namespace harness {
namespace {

TEST(QuestionBehind, GoesBeforeWhatAnswersIt) {
    EXPECT_EQ(with_questions_first("P = 1 (question 1)\nX = 2 # Q2\nM = 3 [question 3]\nV = 4 <- question 5\n"
                                   "t (question 6) = 5\nand more\n",
                                   10),
              "Q1 P = 1\nQ2 X = 2\nQ3 M = 3\nQ5 V = 4\nQ6 t = 5\nand more\n");
}

TEST(QuestionBehind, IsARemarkWhereFewAreNamedOrOthersHaveHeadings) {
    const std::string few = "P = 1\nX = 2\nt = 5 (question 6)\nN = 6 (question 7)\n";
    EXPECT_EQ(with_questions_first(few, 10), few);
    std::string headed;
    for (const char* number : {"1", "2", "3", "4", "5"})
        headed += std::string("Question ") + number + ":\nP = 1 (question " + number + ")\n";
    EXPECT_EQ(with_questions_first(headed, 10), headed);
}

}  // namespace
}  // namespace harness
