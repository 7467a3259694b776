#include "harness/read/formula.h"

#include <gtest/gtest.h>

#include "tests/harness/read/numbers.h"

namespace harness {
namespace {

Numbers numbers_of_form(std::string_view line) {
    const auto form = read_linear_form(line);
    return form ? numbers_of(form->values) : Numbers{};
}

TEST(LinearForm, RejectsAFormulaWithoutNumbers) {
    for (const std::string_view line : {"P = S + tV", "a t^2 + b t + c = 0", "u + v = 0.5", "t = 0.5", "t1 = 3.4",
                                        "1 + 2 = 3", "A + u(B-A) + v(C-A) = S + tV", "2 + t"}) {
        EXPECT_EQ(numbers_of_form(line), Numbers{}) << line;
    }
}

TEST(LinearForm, ReadsAQuadratic) {
    EXPECT_EQ(numbers_of_form("quadratic: 1 t^2 + (-4) t + (2) = 0"), (Numbers{1, -4, 2}));
    EXPECT_EQ(numbers_of_form("t^2 - 4t + 2 = 0"), (Numbers{1, -4, 2}));
    EXPECT_EQ(numbers_of_form("2 - 4.0*t + 1.5*t*t = 0.0"), (Numbers{1.5, -4, 2}));
    EXPECT_EQ(numbers_of_form("t^2 - 4t + 2 = 1"), Numbers{});
    EXPECT_EQ(numbers_of_form("(1)t^2 + (-4)t + (2) = 0"), (Numbers{1, -4, 2}));
    EXPECT_EQ(numbers_of_form("- 1 t^2 - 4 t + 2 = 0"), (Numbers{1, -4, 2})) << "the mark of a list";
    EXPECT_EQ(numbers_of_form("so the sum 2 u + 2 v = 1"), Numbers{});
}

TEST(LinearForm, EndsWhereAQuadraticDoes) {
    for (const auto& [formula, rest] :
         std::vector<std::pair<std::string, std::string>>{{"1t^2 + -4t + 2 = 0", ", disc 8"},
                                                          {"quadratic: 1t^2 + -4t + 2 = 0", " (d = 8)"},
                                                          {"equation: t^2 - 4t + 2 = 0", ", disc: 8"},
                                                          {"t^2 - 4t + 2 = 0", " has discriminant 8"},
                                                          {"t^2 - 4t + 2 = 0", " -> t = 0.585786"}}) {
        const auto form = read_linear_form(formula + rest);
        ASSERT_TRUE(form) << formula + rest;
        EXPECT_EQ(numbers_of_form(formula + rest), (Numbers{1, -4, 2})) << formula + rest;
        EXPECT_EQ(form->end, formula.size()) << formula + rest;
        EXPECT_EQ(form->values.back().printed.find(rest), std::string::npos);
    }
    EXPECT_EQ(numbers_of_form("t^2 - 4t + 2 = 0 + 3"), Numbers{});
    EXPECT_EQ(numbers_of_form("t^2 - 4t + 2 = 0t"), Numbers{});
    EXPECT_EQ(numbers_of_form("2u - 2v = -1, 2t + v = 3"), Numbers{})
        << "only a quadratic is answered in part of a line";
}

TEST(LinearForm, ReadsAnEquationOfTheSystem) {
    EXPECT_EQ(numbers_of_form("-0.5 t + 2 u - 2 v = 1.5"), (Numbers{-0.5, 2, -2, 1.5}));
    EXPECT_EQ(numbers_of_form("eq 1: 2u - 2v = -1"), (Numbers{0, 2, -2, -1}));
    EXPECT_EQ(numbers_of_form("2u + 2u = 1"), Numbers{});
}

TEST(LinearForm, ReadsAVectorInUnitVectors) {
    EXPECT_EQ(numbers_of_form("N = 0.3i + 0.4j - 0.87k"), (Numbers{0.3, 0.4, -0.87}));
    EXPECT_EQ(numbers_of_form("0.3i + 0.4j"), Numbers{});
    EXPECT_EQ(numbers_of_form("V: 0i 0j -1k"), (Numbers{0, 0, -1}));
}

}  // namespace
}  // namespace harness
