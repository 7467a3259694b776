#include "harness/read/quadratic_line.h"

#include <gtest/gtest.h>

#include "tests/harness/read/numbers.h"

namespace harness {
namespace {

Numbers coefficients(std::string_view line) {
    const auto equation = read_quadratic(line);
    return equation ? numbers_of(equation->values) : Numbers{};
}

TEST(QuadraticLine, HasThreeCoefficients) {
    for (const char* line : {"quadratic: 1 t^2 + (-4) t + (2) = 0", "t^2 - 4t + 2 = 0", "(1)t^2 + (-4)t + (2) = 0",
                             "so 1.0 * t*t - 4.0*t + 2 = 0.0", "1t^2 + -4t + 2 = 0", "1t2 - 4 t - -2 = 0"})
        EXPECT_EQ(coefficients(line), (Numbers{1, -4, 2})) << line;
    EXPECT_EQ(coefficients("-1.5 t^2 - 4 t + 2e-1 = 0"), (Numbers{-1.5, -4, 0.2}));
    EXPECT_EQ(coefficients("- 1 t^2 - 4 t + 2 = 0"), (Numbers{1, -4, 2})) << "the mark of a list";
}

TEST(QuadraticLine, IsNoOtherFormula) {
    for (const char* line : {"a t^2 + b t + c = 0", "P = S + tV", "t^2 - 4t + 2 = 1", "2u - 2v = -1", "2 + t = 0",
                             "t^2 - 4t + 2 = 0 + 3", "t^2 - 4t + 2 = 0t", "cat^2 - 4t + 2 = 0"})
        EXPECT_EQ(coefficients(line), Numbers{}) << line;
}

TEST(QuadraticLine, EndsWhereItsEquationDoes) {
    for (const char* rest : {"", ", disc 8", " (d = 8)", " has discriminant 8", " -> t = 0.585786"}) {
        const std::string formula = "equation: t^2 - 4t + 2 = 0";
        const auto equation = read_quadratic(formula + rest);
        ASSERT_TRUE(equation) << rest;
        EXPECT_EQ(equation->end, formula.size()) << rest;
        EXPECT_EQ(equation->values.back().printed, "t^2 - 4t + 2 = 0");
    }
}

TEST(QuadraticLine, KnowsWhichNumbersOfItsLineTheyAre) {
    const auto equation = read_quadratic("6.72233 is not t^2 - 4t + 2 = 0");
    ASSERT_TRUE(equation);
    EXPECT_EQ(equation->values[0].numbers[0].index, 0) << "1 is not printed";
    EXPECT_EQ(equation->values[1].numbers[0].index, 0) << "4t is a word";
    EXPECT_EQ(equation->values[2].numbers[0].index, 3);
}

}  // namespace
}  // namespace harness
