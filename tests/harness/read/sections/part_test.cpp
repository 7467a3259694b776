#include "harness/read/sections/part.h"

#include <gtest/gtest.h>

#include <string>

#include "harness/read/sections/headings.h"

namespace harness {
namespace {

/// What is left of each line without the number of its part.
std::vector<std::string> without_parts(const std::vector<std::string_view>& lines) {
    const auto ends = find_parts(lines, find_headings(lines, 10));
    std::vector<std::string> rest;
    for (std::size_t i = 0; i < lines.size(); ++i) rest.emplace_back(lines[i].substr(ends[i]));
    return rest;
}

using Lines = std::vector<std::string>;

TEST(Part, IsTakenOffWhereLettersGoUp) {
    EXPECT_EQ(without_parts({"Question 2", "(a) 1 -6 7", "(b) 8", "(c) -1.5"}),
              (Lines{"Question 2", "1 -6 7", "8", "-1.5"}));
    EXPECT_EQ(without_parts({"Question 2", "a) t = 1", "  and more", "b. u = 2"}),
              (Lines{"Question 2", "t = 1", "  and more", "u = 2"}));
    EXPECT_EQ(without_parts({"Question 2", "i) 1", "ii) 2", "iii) 3", "iv) 4"}),
              (Lines{"Question 2", "1", "2", "3", "4"}));
    EXPECT_EQ(without_parts({"Question 8", "A) (1, 2, 3)", "B) 1", "[C] -1"}),
              (Lines{"Question 8", "(1, 2, 3)", "1", "-1"}));
    EXPECT_EQ(without_parts({"Question 8", "Part a: 1", "Part b: 2"}), (Lines{"Question 8", "1", "2"}));
}

TEST(Part, MayStandOnALineOfItsOwn) {
    for (const std::string form : {"*)", "(*)", "[*]", "Part *:", "part (*)", "Part *"}) {
        const auto line = [&](const char* letter) { return std::string(form).replace(form.find('*'), 1, letter); };
        const std::string first = line("a"), second = line("b");
        EXPECT_EQ(without_parts({"Question 1", first, "(1, 2, 3)", second, "4"}),
                  (Lines{"Question 1", "", "(1, 2, 3)", "", "4"}))
            << form;
    }
}

TEST(Part, MayHaveTheQuestionsNumber) {
    EXPECT_EQ(without_parts({"Question 6", "6.1 1.5", "6.2 -4", "6.3: t"}), (Lines{"Question 6", "1.5", "-4", "t"}));
    const Lines vectors = {"Question 6", "6.1 2.5 3.5", "7.2 1.5 0.5"};
    EXPECT_EQ(without_parts({vectors.begin(), vectors.end()}), vectors);
}

TEST(Part, BeginsAnewUnderEachHeading) {
    EXPECT_EQ(without_parts({"Question 1", "a) 1", "b) 2", "Question 2", "a) 3", "b) 4"}),
              (Lines{"Question 1", "1", "2", "Question 2", "3", "4"}));
}

TEST(Part, IsNoLetterThatNamesAnAnswer) {
    for (const std::vector<std::string_view>& lines : {std::vector<std::string_view>{"Question 6", "a) 1"},
                                                       {"Question 6", "b) 1", "c) 2"},
                                                       {"Question 6", "a) 1", "c) 7"},
                                                       {"Question 6", "a = 1", "b = 2"},
                                                       {"Question 6", "a: 1", "b: 2"}}) {
        const Lines same(lines.begin(), lines.end());
        EXPECT_EQ(without_parts(lines), same);
    }
}

}  // namespace
}  // namespace harness
