#include "reference/accuracy/measure/statistics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace reference::accuracy {
namespace {

struct Published {
    std::uint64_t count, total;
    double low, high;
};

/// Newcombe, "Two-sided confidence intervals for the single proportion" (1998), table I, method 3.
TEST(Wilson, GivesThePublishedIntervals) {
    for (const auto& [count, total, low, high] :
         {Published{81, 263, 0.2553, 0.3662}, Published{15, 148, 0.0624, 0.1605}, Published{0, 20, 0, 0.1611},
          Published{1, 29, 0.0061, 0.1718}}) {
        const Range range = wilson_interval(count, total);
        EXPECT_NEAR(range.low, low, 0.00005);
        EXPECT_NEAR(range.high, high, 0.00005);
    }
}

TEST(Wilson, EndsExactlyAtZeroForNoneAndAtOneForAll) {
    EXPECT_EQ(wilson_interval(0, 1'000).low, 0);
    EXPECT_EQ(wilson_interval(1'000, 1'000).high, 1);
}

TEST(FloatUlp, IsTheStepBetweenFloatsAtThatSize) {
    EXPECT_EQ(float_ulp(1), 0x1p-23);
    EXPECT_EQ(float_ulp(std::nextafter(1.0, 0.0)), 0x1p-24);
    EXPECT_EQ(float_ulp(1.999), 0x1p-23);
    EXPECT_EQ(float_ulp(0x1p-126), 0x1p-149);
    EXPECT_EQ(float_ulp(0x1p-300), 0x1p-149);
}

TEST(WrongAnswers, HaveADifferentOutcome) {
    const std::array truth{Answer{Outcome::hit, 1}, Answer{Outcome::miss}, Answer{Outcome::tie, 1}};
    EXPECT_EQ(wrong_answers(std::array{Answer{Outcome::hit, 5}, Answer{Outcome::miss}}, truth), 0U);
    EXPECT_EQ(wrong_answers(std::array{Answer{}, Answer{Outcome::hit, 1}, Answer{Outcome::sphere_first, 1}}, truth),
              3U);
}

TEST(TErrors, CountOnlyHitsThatBothFind) {
    const std::array truth{Answer{Outcome::hit, 1}, Answer{Outcome::hit, 1}, Answer{Outcome::miss},
                           Answer{Outcome::hit, 1}, Answer{Outcome::hit, 0}};
    const std::array answers{Answer{Outcome::hit, 1 + 0x1p-23}, Answer{Outcome::hit, 1 - 0x1.8p-22},
                             Answer{Outcome::hit, 9}, Answer{}, Answer{Outcome::hit, 1}};
    const std::optional<TError> error = t_error(answers, truth);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->max_ulp, 3);
    EXPECT_EQ(error->mean_ulp, 2);
    EXPECT_FALSE(t_error(std::array{Answer{}}, truth));
}

TEST(TErrors, IncludeDigitsBelowADouble) {
    const std::array truth{Answer{Outcome::hit, 1, 0x1p-60}};
    EXPECT_EQ(t_error(std::array{Answer{Outcome::hit, 1}}, truth)->max_ulp, 0x1p-37);
}

TEST(Quartiles, LieBetweenRanks) {
    const Quartiles four = quartiles_of({4, 1, 3, 2});
    EXPECT_EQ(four.low, 1.75);
    EXPECT_EQ(four.median, 2.5);
    EXPECT_EQ(four.high, 3.25);
    EXPECT_EQ(quartiles_of({7}).high, 7);
}

Row row(double ns, double wrong) {
    Row result{};
    result.ns_per_ray = ns;
    result.wrong_per_million = wrong;
    return result;
}

TEST(Pareto, MarksRowsThatNoOtherRowBeats) {
    std::array rows{row(10, 500),   // the fastest
                    row(12, 600),   // slower and more often wrong
                    row(20, 0),     // never wrong
                    row(30, 0),     // as right as that, and slower
                    row(10, 500)};  // the same as the first
    mark_pareto(rows);
    const std::vector<bool> expected{true, false, true, false, true};
    for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows.at(i).pareto, expected[i]) << i;
}

}  // namespace
}  // namespace reference::accuracy
