#include "harness/match/assignment_problem.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace harness {
namespace {

using Gains = std::vector<std::vector<std::optional<std::int64_t>>>;

std::int64_t sum(const Gains& gains, const std::vector<std::optional<std::size_t>>& columns) {
    std::int64_t total = 0;
    for (std::size_t row = 0; row < gains.size(); ++row) {
        if (columns[row]) total += gains[row][*columns[row]].value();
    }
    return total;
}

/// The largest sum, found by trying every assignment.
std::int64_t brute_force(const Gains& gains, std::size_t row, std::vector<bool>& used) {
    if (row == gains.size()) return 0;
    std::int64_t best = brute_force(gains, row + 1, used);
    for (std::size_t column = 0; column < used.size(); ++column) {
        if (used[column] || !gains[row][column]) continue;
        used[column] = true;
        best = std::max(best, *gains[row][column] + brute_force(gains, row + 1, used));
        used[column] = false;
    }
    return best;
}

TEST(SolveAssignment, IsAsGoodAsTryingEverything) {
    constexpr std::uint64_t seed = 7;
    std::mt19937_64 random(seed);
    for (int trial = 0; trial < 3000; ++trial) {
        const std::size_t rows = random() % 6;
        const std::size_t columns = random() % 7;
        const bool ties = random() % 2 == 0;
        Gains gains(rows, std::vector<std::optional<std::int64_t>>(columns));
        for (auto& row : gains) {
            for (auto& gain : row) {
                if (random() % 4 != 0)
                    gain = static_cast<std::int64_t>(random() % (ties ? 4 : 200'000)) - (ties ? 1 : 20'000);
            }
        }
        const auto solution = solve_assignment(gains);
        ASSERT_EQ(solution.size(), rows);
        std::vector<std::size_t> taken;
        for (const auto& column : solution) {
            if (column) taken.push_back(*column);
        }
        std::sort(taken.begin(), taken.end());
        ASSERT_EQ(std::adjacent_find(taken.begin(), taken.end()), taken.end())
            << "seed " << seed << ", trial " << trial;
        std::vector<bool> used(columns, false);
        ASSERT_EQ(sum(gains, solution), brute_force(gains, 0, used)) << "seed " << seed << ", trial " << trial;
    }
}

TEST(SolveAssignment, SacrificesABetterPairForABetterSum) {
    EXPECT_EQ(solve_assignment({{10, 9}, {9, std::nullopt}}), (std::vector<std::optional<std::size_t>>{1, 0}));
}

TEST(SolveAssignment, LeavesARowUnassignedRatherThanLose) {
    EXPECT_EQ(solve_assignment({{-1}}), (std::vector<std::optional<std::size_t>>{std::nullopt}));
    EXPECT_EQ(solve_assignment({{std::nullopt}, {5}}), (std::vector<std::optional<std::size_t>>{std::nullopt, 0}));
}

TEST(SolveAssignment, GivesNothingForNothing) {
    EXPECT_TRUE(solve_assignment({}).empty());
    EXPECT_EQ(solve_assignment({{}, {}}).size(), 2U);
}

}  // namespace
}  // namespace harness
