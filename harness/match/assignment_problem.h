// The assignment problem: the best matching of few rows to many columns.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace harness {

/// Assigns each row a column or none, so that no column is used twice and the sum of the gains is largest.
/// gains[row][column] is empty if the row must not get that column. A row without a column gains 0. All rows have the
/// same length. Uses shortest augmenting paths (Jonker and Volgenant 1987): rows^2 * (rows + columns) steps.
std::vector<std::optional<std::size_t>> solve_assignment(
    const std::vector<std::vector<std::optional<std::int64_t>>>& gains);

}  // namespace harness
