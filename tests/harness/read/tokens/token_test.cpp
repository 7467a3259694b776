#include "harness/read/tokens/token.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace harness {
namespace {

using Kind = Token::Kind;

std::vector<double> numbers(std::string_view line) {
    std::vector<double> values;
    for (const Token& token : tokenize(line)) {
        if (token.kind == Kind::number) values.push_back(token.number.value);
    }
    return values;
}

std::string kinds(std::string_view line) {
    std::string letters;
    for (const Token& token : tokenize(line))
        letters +=
            "wn(),"
            "=<+|."[static_cast<std::size_t>(token.kind)];
    return letters;
}

PrintedNumber number(std::string_view text) {
    const std::vector<Token> tokens = tokenize(text);
    EXPECT_EQ(tokens.size(), 1U) << text;
    return tokens.empty() ? PrintedNumber{} : tokens.front().number;
}

TEST(Tokenize, FindsNoNumberInAWordThatBeginsWithADigit) {
    EXPECT_EQ(numbers("3x3 2nd 4ac 1st vec3 t1 P_2"), std::vector<double>{});
}

TEST(Tokenize, ReadsASignThatIsNoOperator) {
    EXPECT_EQ(numbers("-1 (-2) 3 -4 +5"), (std::vector<double>{-1, -2, 3, -4, 5}));
    EXPECT_EQ(kinds("b-4"), "w+n");
    EXPECT_EQ(kinds("2.5-0.5"), "n+n");
    EXPECT_EQ(kinds("(b)-4"), "(w)+n");
}

TEST(Tokenize, FindsTheLastDigitInEachNotation) {
    EXPECT_EQ(number("1.50").decimals, 2);
    EXPECT_EQ(number("1.5e-3").decimals, 4);
    EXPECT_EQ(number("1.5E+03").decimals, -2);
    EXPECT_EQ(number("7").decimals, 0);
    EXPECT_EQ(number("-.25").decimals, 2);
    EXPECT_EQ(number("0.0050").significant, 2);
    EXPECT_EQ(number("0e9").decimals, 0) << "no less sure than 0";
    EXPECT_EQ(number("0.00e+20").decimals, 2);
}

TEST(Tokenize, ReadsNanAndInfinityAsLibrariesPrintThem) {
    EXPECT_TRUE(std::isnan(number("-nan").value));
    EXPECT_EQ(number("-inf").value, -HUGE_VAL);
    EXPECT_EQ(number("Infinity").value, HUGE_VAL);
    EXPECT_EQ(kinds("nano infer"), "ww");
}

TEST(Tokenize, ReadsNumbersBeyondTheRangeAsInfinityOrZero) {
    EXPECT_EQ(number("1e999").value, HUGE_VAL);
    EXPECT_EQ(number("-1e999").value, -HUGE_VAL);
    EXPECT_EQ(number("1e-999").value, 0);
    EXPECT_EQ(number("1e99999999999999999999").value, HUGE_VAL);
}

TEST(Tokenize, DistinguishesAngleBracketsFromComparisons) {
    EXPECT_EQ(kinds("<0, 0, -2>"), "(n,n,n)");
    EXPECT_EQ(kinds("0 <= u < 1"), "n<w<n");
    EXPECT_EQ(kinds("a -> 1"), "w=n");
    EXPECT_EQ(kinds("t > 0"), "w<n");
}

TEST(Tokenize, SeparatesALabelFromTheNumberBeforeIt) {
    EXPECT_EQ(numbers("b^2-4ac=8"), (std::vector<double>{2, 8}));
}

TEST(Tokenize, SeparatesDecimalNumbersFromLetters) {
    EXPECT_EQ(kinds("6.7t"), "nw");
    EXPECT_EQ(numbers("t1.58579 x.5y"), (std::vector<double>{1.58579, 0.5}));
    EXPECT_EQ(kinds("4ac 3x3"), "ww");
}

TEST(Tokenize, CountsTheNumbersOfALineWithoutIndices) {
    const std::vector<Token> tokens = tokenize("[0] = 1.5, 2.5");
    EXPECT_EQ(tokens[1].number.index, 0);
    EXPECT_EQ(tokens[4].number.index, 1);
    EXPECT_EQ(tokens[6].number.index, 2);
}

TEST(Tokenize, ReadsFloatLiterals) {
    EXPECT_EQ(numbers("0.3f, -1.f"), (std::vector<double>{0.3, -1}));
}

TEST(Tokenize, CoversEveryLineWithTokensInOrder) {
    const std::string line = "P_s = S + t*V: vec3(0.5, \xEF\xBF\xBD-1e-3) | [x] -- <1>";
    std::size_t end = 0;
    for (const Token& token : tokenize(line)) {
        EXPECT_LE(end, token.begin);
        EXPECT_LT(token.begin, token.end);
        end = token.end;
    }
    EXPECT_LE(end, line.size());
}

}  // namespace
}  // namespace harness
