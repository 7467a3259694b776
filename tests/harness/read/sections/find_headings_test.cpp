#include "harness/read/sections/find_headings.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace harness {
namespace {

std::vector<int> questions(const std::vector<std::string_view>& lines, int last_question = 10) {
    std::vector<int> found;
    for (const auto& heading : find_headings(lines, last_question)) found.push_back(heading ? heading->question : 0);
    return found;
}

/// A printout with a line before each question's answer, with the question's number, in Roman and in words too.
std::vector<int> questions_headed(const std::function<std::string(int)>& heading) {
    std::vector<std::string> texts;
    for (int i = 1; i <= 10; ++i) {
        texts.push_back(heading(i));
        texts.emplace_back("t: 0.25");
    }
    return questions({texts.begin(), texts.end()});
}

TEST(Headings, MayBeNumbersOfAnyKindIfThereAreMany) {
    constexpr const char* roman[] = {"I", "II", "III", "IV", "V", "VI", "VII", "VIII", "IX", "X"};
    constexpr const char* words[] = {"ONE", "TWO", "THREE", "FOUR", "FIVE", "SIX", "SEVEN", "EIGHT", "NINE", "TEN"};
    std::vector<int> all;
    for (int i = 1; i <= 10; ++i) all.insert(all.end(), {i, 0});
    const auto text = [](const char* format) {
        return [format](int i) { return fmt::format(fmt::runtime(format), i); };
    };
    for (const char* format : {"[{}/10]", "{} of 10", "({}/10)", "A{}:", "{}th question", "#{} a 1.5", "{} - the ray",
                               "HW6.{}", "Aufgabe 6.{}", "6.{}", "| {} | a | 1.5 |"})
        EXPECT_EQ(questions_headed(text(format)), all) << format;
    EXPECT_EQ(questions_headed([&](int i) { return std::string(roman[i - 1]) + "."; }), all);
    EXPECT_EQ(questions_headed([&](int i) { return std::string(words[i - 1]) + "."; }), all);
    const std::vector<int> none(20, 0);
    for (const char* format : {"{} 0.5 2", "V: {}", "{}/12", "1.{} 2.5"})
        EXPECT_EQ(questions_headed(text(format)), none) << format;
}

TEST(Headings, MayBeTheFirstColumnOfATableThatCountsUp) {
    EXPECT_EQ(questions({"| 1    | (0, 0, -2) |", "| 2 X  | (1, 0, 0) |", "| 2 Y  | (0, 1, 0) |", "| 3    | 1 0 0 |",
                         "|      | 0 1 0 |"},
                        3),
              (std::vector<int>{1, 2, 2, 3, 0}));
    EXPECT_EQ(
        questions({"Q  | answer", "---+----", "1  | 0 0 -2", "2X | 1 0 0", "2Y | 0 1 0", "3a | 1 0 0", "   | 0 1 0"},
                  3),
        (std::vector<int>{0, 0, 1, 2, 2, 3, 0}));
    EXPECT_EQ(questions({"1     0 0 -2", "2 X   1 0 0", "3     1 0 0", "      0 1 0", "4     2", "5     0 0 1"}, 5),
              (std::vector<int>{1, 2, 3, 0, 4, 5}))
        << "without lines between the columns";
    const std::vector<std::string_view> matrices = {"M", "| 1 | 0 | 0 |", "| 2 | 1 | 0 |", "| 4 | 0 | 1 |"};
    EXPECT_EQ(questions(matrices, 4), std::vector<int>(4, 0)) << "it goes up one by one";
    EXPECT_EQ(questions(matrices, 10), std::vector<int>(4, 0)) << "and to the last question";
    EXPECT_EQ(questions({"1  0  0", "2    1  0", "3   0  1", "4  0", "5  0"}, 5), std::vector<int>(5, 0))
        << "the second column stands at one place";
}

TEST(Headings, AreNoRowsInOtherBrackets) {
    EXPECT_EQ(questions({"1)", "P", "2)", "[1]: 0 4 0", "[2]: 1 2 3", "3)", "t", "4)", "u"}),
              (std::vector<int>{1, 0, 2, 0, 0, 3, 0, 4, 0}));
}

TEST(Headings, HaveOneStyleSoThatStepsAreNoHeadings) {
    EXPECT_EQ(questions({"Question 6", "Step 1: a", "Step 2: b", "1. c", "2. d", "3. e", "Question 8"}),
              (std::vector<int>{6, 0, 0, 0, 0, 0, 8}));
    EXPECT_EQ(questions({"Part 1", "Part 2", "1. x", "2. y", "3. z"}), (std::vector<int>{1, 2, 0, 0, 0}));
}

TEST(Headings, MayBeNumbersOfPartsForTheQuestionsThatHaveNoOther) {
    EXPECT_EQ(
        questions({"Question 1:", "2.1 X: 1", "2.2 Y: 1", "Question 3:", "Question 4:", "5. V", "6.1 a = 1", "6.2 b"}),
        (std::vector<int>{1, 2, 2, 3, 4, 5, 6, 6}));
    EXPECT_EQ(questions({"Question 1:", "Question 2:", "Question 3:", "1.5 is it", "2. a step", "7.1 t = 1"}),
              (std::vector<int>{1, 2, 3, 0, 0, 0}))
        << "one that has another, and one out of turn";
}

TEST(Headings, MayBeBareNumbersAndThoseOfParts) {
    EXPECT_EQ(questions({"1. P: 1 2 3", "2.1 X: 1 0 0", "2.2 Y: 0 1 0", "3. M", "4. P", "5. V"}),
              (std::vector<int>{1, 2, 2, 3, 4, 5}));
    EXPECT_EQ(questions({"1 P: 1 2 3", "2-1 X: 1 0 0", "2-2 Y: 0 1 0", "3 M", "4 P", "5 V"}),
              (std::vector<int>{1, 2, 2, 3, 4, 5}));
}

TEST(Headings, MayBeBareNumbersAndThoseOfPartsBeforeWords) {
    EXPECT_EQ(questions({"1.1 X: 1 0 0", "1.2 Y: 0 1 0", "2 P", "3 V", "4.1 t", "4.2 u", "5 no hit", "6 triangle"}, 6),
              (std::vector<int>{1, 1, 2, 3, 4, 4, 5, 6}));
}

TEST(Headings, MayBeNumbersAloneThatGoUpOneByOne) {
    EXPECT_EQ(questions({"1.1", "P", "1.2", "2", "a: 4", "3.1", "3.2", "t: 1"}, 3),
              (std::vector<int>{1, 0, 1, 2, 0, 3, 3, 0}));
    EXPECT_EQ(questions({"1", "-4", "2", "2.828427", "3", "17", "4", "5", "x"}, 5),
              (std::vector<int>{1, 0, 2, 0, 3, 0, 4, 5, 0}))
        << "other numbers alone are answers";
    EXPECT_EQ(questions({"1.1", "1.2", "1.3", "2.1", "2.3"}, 3), (std::vector<int>(5, 0))) << "not to the last";
    EXPECT_EQ(questions({"1", "2", "3", "4"}, 4), (std::vector<int>(4, 0))) << "too few to be no answers";
    EXPECT_EQ(questions({"1", "2", "4", "3", "4", "5"}, 5), (std::vector<int>(6, 0))) << "which 4 is the heading?";
}

TEST(Headings, MayHaveAnUnknownWordWhoseNumbersGoUpOneByOne) {
    EXPECT_EQ(questions({"Soru 1 (x):", "Soru 2:", "t: 1", "Soru 3", "Soru 4:", "Soru 5:"}, 5),
              (std::vector<int>{1, 2, 0, 3, 4, 5}));
    EXPECT_EQ(questions({"Fr\u00e5ga 1", "Fr\u00e5ga 2", "Fr\u00e5ga 3", "Fr\u00e5ga 4", "Fr\u00e5ga 5"}, 5),
              (std::vector<int>{1, 2, 3, 4, 5}));
    EXPECT_EQ(questions({"\u554f 1", "\u554f 2", "\u554f 3", "\u554f 4", "\u554f5"}, 5),
              (std::vector<int>{1, 2, 3, 4, 5}));
    EXPECT_EQ(questions({"Soru 1", "Soru 2", "Soru 3", "Soru 5"}, 5), (std::vector<int>(4, 0))) << "one is missing";
    EXPECT_EQ(questions({"t1: 1", "t2: 2", "t3: 3", "t4: 4", "t5: 5"}, 5), (std::vector<int>(5, 0)));
    EXPECT_EQ(questions({"row 1", "row 2", "row 3", "row 4"}, 4), (std::vector<int>(4, 0)));
}

TEST(Headings, MayBeBareNumbersIfTheyCountUp) {
    EXPECT_EQ(questions({"1.", "x", "2.", "3."}), (std::vector<int>{1, 0, 2, 3}));
    EXPECT_EQ(questions({"1.", "x", "2."}), (std::vector<int>{0, 0, 0}));
}

TEST(Headings, AreNoneInAnEmptyOutput) {
    EXPECT_TRUE(find_headings({}, 10).empty());
}

}  // namespace
}  // namespace harness
