// What a program writes between its numbers is learnt from its whole output.
#include "harness/read/tokens/lists.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/read/transcript.h"

namespace harness {
namespace {

using testing::ElementsAre;

/// The numbers of the values on the first of three lines, each of which is `line` with other numbers.
std::vector<std::vector<double>> read_three(const std::string& line) {
    const auto with = [&](const char* a, const char* b, const char* c) {
        std::string text = line;
        for (const auto& [name, number] : {std::pair{"A", a}, {"B", b}, {"C", c}})
            text.replace(text.find(name), 1, number);
        return text + "\n";
    };
    std::vector<std::vector<double>> values;
    const Transcript transcript =
        read_transcript(with("1.5", "-2.5", "3.5") + with("4.5", "5.5", "6.5") + with("7.5", "8.5", "9.5"), 10);
    for (const PrintedValue& value : transcript.sections.front().values) {
        if (value.line != 1) continue;
        values.emplace_back();
        for (const PrintedNumber& number : value.numbers) values.back().push_back(number.value);
    }
    return values;
}

TEST(Lists, DivideTheNumbersOfAList) {
    for (const char* line :
         {"p: A / B / C", "p: (A _ B _ C)", "p is [A and B and C]", "p A ~ B ~ C", "A # B # C = p"}) {
        EXPECT_THAT(read_three(line), ElementsAre(ElementsAre(1.5, -2.5, 3.5))) << line;
    }
}

TEST(Lists, MayNameTheComponents) {
    for (const char* line : {"p: A in x, B in y, C in z", "p: X A Y B Z C", "p: A i + B j + C k",
                             "p = [0]=A [1]=B [2]=C", "p: (x A | y B | z C)"}) {
        EXPECT_THAT(read_three(line), ElementsAre(ElementsAre(1.5, -2.5, 3.5))) << line;
    }
    EXPECT_THAT(read_three("p: A i - B j - C k"), ElementsAre(ElementsAre(1.5, 2.5, -3.5))) << "the sign stands apart";
}

TEST(Lists, AreNoArithmetic) {
    for (const char* line : {"d = A * B * C", "d = A + B + C", "d = A - B - C", "d = A ^ B ^ C"}) {
        for (const auto& numbers : read_three(line)) EXPECT_NE(numbers.size(), 3U) << line;
    }
}

TEST(Lists, AreNoNamesOfOtherThings) {
    for (const char* line : {"a A b B c C", "p: A z B y C x", "p: x A z B y C"})
        for (const auto& numbers : read_three(line)) EXPECT_NE(numbers.size(), 3U) << line;
}

TEST(Lists, ShareNoNumber) {
    EXPECT_THAT(read_three("p: 3 %% A %% B _ C _ 5 _ 6"),
                ElementsAre(ElementsAre(3, 1.5, -2.5), ElementsAre(3.5), ElementsAre(5), ElementsAre(6)));
}

TEST(Lists, KeepWhatWasPrinted) {
    const Transcript transcript = read_transcript("p: 1 / 2 / 3\nv: 4 / 5 / 6\nw: 7 / 8 / 9\n", 10);
    ASSERT_EQ(transcript.sections.front().values.size(), 3U);
    EXPECT_EQ(transcript.sections.front().values[1].printed, "4 / 5 / 6");
    EXPECT_EQ(transcript.sections.front().values[1].label, "v");
}

}  // namespace
}  // namespace harness
