#include "harness/match/assignment_problem.h"

#include <limits>

namespace harness {

std::vector<std::optional<std::size_t>> solve_assignment(
    const std::vector<std::vector<std::optional<std::int64_t>>>& gains) {
    const std::size_t rows = gains.size();
    const std::size_t real_columns = rows == 0 ? 0 : gains.front().size();
    // After the real columns, each row has its own column that stands for "no column".
    const std::size_t columns = real_columns + rows;
    constexpr std::int64_t never = std::int64_t{1} << 40;
    constexpr std::int64_t infinite = std::numeric_limits<std::int64_t>::max() / 4;
    const auto cost = [&](std::size_t row, std::size_t column) {
        if (column >= real_columns) return column - real_columns == row ? std::int64_t{0} : never;
        return gains[row][column] ? -*gains[row][column] : never;
    };
    // Rows and columns count from 1 here; column 0 holds the row that is being placed.
    std::vector<std::int64_t> row_potential(rows + 1, 0);
    std::vector<std::int64_t> column_potential(columns + 1, 0);
    std::vector<std::size_t> row_of(columns + 1, 0);
    std::vector<std::size_t> way(columns + 1, 0);
    for (std::size_t row = 1; row <= rows; ++row) {
        row_of[0] = row;
        std::size_t column = 0;
        std::vector<std::int64_t> shortest(columns + 1, infinite);
        std::vector<bool> used(columns + 1, false);
        do {
            used[column] = true;
            const std::size_t from = row_of[column];
            std::int64_t delta = infinite;
            std::size_t next = 0;
            for (std::size_t j = 1; j <= columns; ++j) {
                if (used[j]) continue;
                const std::int64_t reduced = cost(from - 1, j - 1) - row_potential[from] - column_potential[j];
                if (reduced < shortest[j]) {
                    shortest[j] = reduced;
                    way[j] = column;
                }
                if (shortest[j] < delta) {
                    delta = shortest[j];
                    next = j;
                }
            }
            for (std::size_t j = 0; j <= columns; ++j) {
                if (used[j]) {
                    row_potential[row_of[j]] += delta;
                    column_potential[j] -= delta;
                } else {
                    shortest[j] -= delta;
                }
            }
            column = next;
        } while (row_of[column] != 0);
        while (column != 0) {
            const std::size_t previous = way[column];
            row_of[column] = row_of[previous];
            column = previous;
        }
    }
    std::vector<std::optional<std::size_t>> result(rows);
    for (std::size_t j = 1; j <= real_columns; ++j) {
        if (row_of[j] != 0 && gains[row_of[j] - 1][j - 1]) result[row_of[j] - 1] = j - 1;
    }
    return result;
}

}  // namespace harness
