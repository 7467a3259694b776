#include "harness/experiment/identify/slots.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace harness::experiment {
namespace {

using testing::ElementsAre;

/// Each number of the first printout beside that of the second: "12:1 3 4" is the first number of line 12, 3 and 4.
std::vector<std::string> paired(const std::string& own, const std::string& other) {
    const Transcript here = read_transcript(own, 10), there = read_transcript(other, 10);
    const Transcript* others[] = {&there};
    std::vector<std::string> numbers;
    const auto slots = slots_of(here, others);
    if (!slots) return {"nothing"};
    for (const Slot& slot : slots->numbers) {
        std::ostringstream text;
        text << slot.place.line << ":" << slot.place.number << " " << slot.own.number.value << " "
             << slot.numbers.at(0).number.value << (slot.moves() ? " moves" : "");
        numbers.push_back(text.str());
    }
    return numbers;
}

TEST(Slots, PairNumbersOfLikeLines) {
    EXPECT_THAT(paired("a ==> 1 and 2\nb ==> 3\n", "a ==> 1 and 5\nb ==> -6\n"),
                ElementsAre("1:1 1 1", "1:2 2 5 moves", "2:1 3 -6 moves"));
    EXPECT_THAT(paired("t^2 - 6.5t + 2\n", "t^2 + 3.5t - 4\n"), testing::Contains("1:2 6.5 3.5 moves"))
        << "a sign that is apart from its digits may change";
    EXPECT_THAT(paired("x1.5y2.5\n", "x1.5y3.5\n"), ElementsAre("1:1 1.5 1.5", "1:2 2.5 3.5 moves"));
}

TEST(Slots, PairLinesAroundThoseOfOnePrintoutOnly) {
    EXPECT_THAT(paired("a 1\nextra line\nb 2\nc 3\n", "a 4\nb 5\nc 6\n"),
                ElementsAre("1:1 1 4 moves", "3:1 2 5 moves", "4:1 3 6 moves"));
    EXPECT_THAT(paired("a 1\nb 2\nsphere 3\nd 4\n", "a 5\nb 6\ntriangle 7\nd 8\n"), testing::Contains("3:1 3 7 moves"))
        << "as many lines between like ones";
}

TEST(Slots, AreNotGivenWhereTooFewNumbersHaveAPartner) {
    EXPECT_THAT(paired("a 1\nb 2\nc 3\nd 4\n", "a 1\nbb 2 3\ncc 3 4\nd 4\n"), ElementsAre("nothing"));
    EXPECT_THAT(paired("no number\n", "no number\n"), ElementsAre("nothing"));
}

TEST(Slots, SayWhereWordsDiffer) {
    const auto read = [](const std::string& t, const std::string& first) {
        return read_transcript("Question 6\nt: " + t + "\nd: 2\nQuestion 10\n" + first + "\n", 10);
    };
    const Transcript here = read("none", "sphere"), there = read("1.5", "triangle"), again = read("2.5", "sphere");
    const Transcript* others[] = {&there, &again};
    const auto slots = slots_of(here, others);
    ASSERT_TRUE(slots);
    EXPECT_THAT(slots->differing, ElementsAre(6, 10));
    std::vector<std::string> changing;
    for (const LineOnScenes& line : slots->lines) {
        if (line.words_change) changing.push_back(line.own.text);
    }
    EXPECT_THAT(changing, ElementsAre("sphere"));
}

TEST(Slots, ReadManyLinesInLinearTime) {
    std::string own, other;
    for (int i = 0; i < 1900; ++i) {
        own += "blip " + std::to_string(i) + "\n";
        other += std::string(i % 2 == 0 ? "blip " : "blop ") + std::to_string(i + 1) + "\n";
    }
    EXPECT_EQ(paired(own, other).size(), 1900) << "as many lines: each beside its like";
    for (int i = 0; i < 3000; ++i) own += "7\n";
    EXPECT_THAT(paired(own, own), ElementsAre("nothing")) << "an endless loop's";
}

}  // namespace
}  // namespace harness::experiment
