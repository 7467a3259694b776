#include "harness/arrange.h"

#include <re2/re2.h>

#include <algorithm>
#include <optional>

namespace harness {
namespace {

using reference::ItemSpec;
using reference::Shape;

std::size_t matrix_size(std::span<const ItemSpec> items) {
    for (const ItemSpec& item : items) {
        if (item.shape == Shape::matrix3) return 3;
        if (item.shape == Shape::matrix4) return 4;
    }
    return 0;
}

/// The largest fit of the value's own label to a vector item.
LabelFit vector_fit(const PrintedValue& value, std::span<const ItemSpec> items) {
    LabelFit best = LabelFit::forbidden;
    for (const ItemSpec& item : items) {
        if (item.shape == Shape::vector) best = std::max(best, fit_label(value.label, "", item));
    }
    return best;
}

/// Whether the label says that the value is no answer, whatever the item: "DEBUG", "before".
bool is_aside(const PrintedValue& value, std::span<const ItemSpec> items) {
    return fit_label(value.label, value.above, items.front()) == LabelFit::forbidden;
}

bool is_list_of(const PrintedValue& value, std::size_t count) {
    return value.groups == 1 && value.numbers.size() == count;
}

/// Whether values[at] to values[at + n - 1] are the rows or columns of one matrix, each with `count` numbers.
bool is_block(const std::vector<PrintedValue>& values, std::size_t at, std::size_t n, std::size_t count,
              std::span<const ItemSpec> items) {
    if (at + n > values.size()) return false;
    const PrintedValue& first = values[at];
    if (!is_list_of(first, count)) return false;
    if (!first.label.empty() && !is_row_label(first.label) && vector_fit(first, items) >= LabelFit::named) return false;
    if (is_aside(first, items)) return false;
    for (std::size_t k = 1; k < n; ++k) {
        const PrintedValue& value = values[at + k];
        const bool labelled_row = is_row_label(value.label);
        if (!is_list_of(value, count) || (!value.label.empty() && !labelled_row)) return false;
        if (!value.above.empty() && !is_row_label(value.above)) return false;
        if (value.line - values[at + k - 1].line > 2) return false;
    }
    return true;
}

bool is_augmented_row(const PrintedValue& value) {
    return value.bar_after == 3 || !value.typed;
}

MatrixOrder order_of(const PrintedValue& first, MatrixOrder otherwise) {
    for (const std::string* text : {&first.label, &first.above}) {
        if (const MatrixOrder said = matrix_order(*text); said != MatrixOrder::unsaid) return said;
    }
    return otherwise;
}

/// Columns are the order of a row label such as "col 0", "c1" or "-V"; rows that of "row 0" and of no label.
MatrixOrder block_order(const std::vector<PrintedValue>& values, std::size_t at, std::size_t n) {
    const PrintedValue& first = values[at];
    const PrintedValue& last = values[at + n - 1];
    static const RE2 opened(R"(mat[234](?:x[234])?\s*\(\s*$)");  // "A = mat3x3(" on the line above
    const bool typed = first.typed || RE2::PartialMatch(first.above, opened);
    MatrixOrder otherwise = typed ? MatrixOrder::columns : MatrixOrder::rows;
    if (is_row_label(last.label)) {
        const MatrixOrder said = matrix_order(last.label);
        const bool row_letter = last.label.front() == 'r' || last.label.front() == 'R';
        if (said != MatrixOrder::unsaid) return said;
        const bool digit = last.label.front() >= '0' && last.label.front() <= '9';
        otherwise = row_letter || (digit && !typed) ? MatrixOrder::rows : MatrixOrder::columns;
    }
    return order_of(first, otherwise);
}

/// A block of rows as one matrix; with four numbers a row the fourth is the right-hand side.
std::vector<Candidate> gather_block(const std::vector<PrintedValue>& values, std::size_t at, std::size_t n,
                                    std::size_t count) {
    Candidate matrix{values[at], block_order(values, at, n), 0, at, n};
    matrix.value.numbers.clear();
    matrix.value.printed.clear();
    matrix.value.groups = static_cast<int>(n);
    if (is_row_label(matrix.value.label)) matrix.value.label.clear();
    Candidate rhs{values[at], MatrixOrder::unsaid, 0, at, n};
    rhs.value.numbers.clear();
    rhs.value.printed.clear();
    rhs.value.label = "right-hand side";
    for (std::size_t k = 0; k < n; ++k) {
        const PrintedValue& row = values[at + k];
        matrix.value.numbers.insert(matrix.value.numbers.end(), row.numbers.begin(),
                                    row.numbers.begin() + static_cast<std::ptrdiff_t>(n));
        matrix.value.printed += (k == 0 ? "" : "; ") + row.printed;
        if (count > n) rhs.value.numbers.push_back(row.numbers.back());
    }
    if (count == n) return {matrix};
    matrix.order = MatrixOrder::rows;
    rhs.value.printed = matrix.value.printed;
    return {matrix, rhs};
}

/// How many values from values[at] on are the components of one vector, printed one a line; 0 for none. They are so
/// under a vector's name, between brackets, or where the question asks for no scalar.
std::size_t column_vector_size(const std::vector<PrintedValue>& values, std::size_t at,
                               std::span<const ItemSpec> items) {
    constexpr std::size_t most = 4;
    const auto is_component = [](const PrintedValue& value) {
        return value.numbers.size() == 1 && value.label.empty() && value.after.empty();
    };
    std::size_t size = 0;
    while (at + size < values.size() && size <= most && is_component(values[at + size])) {
        const PrintedValue& value = values[at + size];
        if (size > 0 &&
            (!value.above.empty() || value.framed != values[at].framed || value.line != values[at + size - 1].line + 1))
            break;
        ++size;
    }
    if (size < 3 || size > most) return 0;
    const bool any_vector =
        std::any_of(items.begin(), items.end(), [](const ItemSpec& i) { return i.shape == Shape::vector; });
    const bool any_scalar =
        std::any_of(items.begin(), items.end(), [](const ItemSpec& i) { return i.shape == Shape::scalar; });
    const bool under_name = std::any_of(items.begin(), items.end(), [&](const ItemSpec& item) {
        return item.shape == Shape::vector && fit_label("", values[at].above, item) >= LabelFit::title;
    });
    return any_vector && (under_name || values[at].framed || !any_scalar) ? size : 0;
}

/// The components of a vector printed one a line.
Candidate gather_column_vector(const std::vector<PrintedValue>& values, std::size_t at, std::size_t n) {
    Candidate vector{values[at]};
    for (std::size_t k = 1; k < n; ++k) {
        vector.value.numbers.push_back(values[at + k].numbers[0]);
        vector.value.printed += "; " + values[at + k].printed;
    }
    return vector;
}

/// A matrix in one value: nested brackets, or a flat list of all its numbers.
std::optional<Candidate> whole_matrix(const PrintedValue& value, std::size_t n) {
    if (value.numbers.size() != n * n || (value.groups != 1 && value.groups != static_cast<int>(n)))
        return std::nullopt;
    const MatrixOrder otherwise = value.typed         ? MatrixOrder::columns
                                  : value.groups == 1 ? MatrixOrder::unsaid
                                                      : MatrixOrder::rows;
    return Candidate{value, order_of(value, otherwise)};
}

/// One line "[0 2 -2 | 0; 0 4 4 | 2; …]" in nested brackets.
std::optional<std::vector<Candidate>> whole_augmented(const PrintedValue& value) {
    if (value.groups != 3 || value.numbers.size() != 12 || value.typed) return std::nullopt;
    std::vector<PrintedValue> rows;
    for (std::size_t k = 0; k < 3; ++k) {
        rows.push_back(value);
        const auto begin = value.numbers.begin() + static_cast<std::ptrdiff_t>(4 * k);
        rows.back().numbers.assign(begin, begin + 4);
        rows.back().groups = 1;
    }
    std::vector<Candidate> candidates = gather_block(rows, 0, 3, 4);
    for (Candidate& candidate : candidates) candidate.value.printed = value.printed;
    return candidates;
}

std::vector<Candidate> gather_matrices(const std::vector<PrintedValue>& values, std::span<const ItemSpec> items) {
    const std::size_t n = matrix_size(items);
    std::vector<Candidate> candidates;
    bool found_matrix = false;  // after one, only rows under a label of their own are another
    for (std::size_t i = 0; i < values.size();) {
        const bool may_gather = !found_matrix || !values[i].label.empty() || !values[i].above.empty();
        const auto append = [&](const std::vector<Candidate>& found, std::size_t used) {
            const PrintedValue& value = found.front().value;
            found_matrix = found_matrix || (n != 0 && value.numbers.size() == n * n && !is_aside(value, items));
            for (const Candidate& candidate : found) {
                candidates.push_back(candidate);
                candidates.back().first = i;
                candidates.back().count = used;
            }
            i += used;
        };
        if (may_gather && n != 0 && is_block(values, i, n, n, items)) {
            append(gather_block(values, i, n, n), n);
        } else if (may_gather && n == 3 && is_augmented_row(values[i]) && is_block(values, i, 3, 4, items)) {
            append(gather_block(values, i, 3, 4), 3);
        } else if (const auto matrix = n == 0 ? std::nullopt : whole_matrix(values[i], n)) {
            append({*matrix}, 1);
        } else if (const auto augmented = n == 3 ? whole_augmented(values[i]) : std::nullopt) {
            append(*augmented, 1);
        } else if (const std::size_t size = column_vector_size(values, i, items); size != 0) {
            append({gather_column_vector(values, i, size)}, size);
        } else {
            append({Candidate{values[i], MatrixOrder::unsaid}}, 1);
        }
    }
    return candidates;
}

/// Question 2's axes printed as one 3 x 3 block: an axis a group.
std::vector<Candidate> split_groups(const Candidate& list) {
    const PrintedValue& value = list.value;
    std::vector<Candidate> parts;
    const std::size_t size = value.numbers.size() / static_cast<std::size_t>(value.groups);
    for (std::size_t k = 0; k < static_cast<std::size_t>(value.groups); ++k) {
        Candidate part{value, MatrixOrder::unsaid, list.part, list.first, list.count};
        part.value.groups = 1;
        const auto begin = value.numbers.begin() + static_cast<std::ptrdiff_t>(k * size);
        part.value.numbers.assign(begin, begin + static_cast<std::ptrdiff_t>(size));
        part.value.label.clear();
        part.value.above.clear();
        parts.push_back(std::move(part));
    }
    return parts;
}

std::vector<ItemSpec> scalars_of(std::span<const ItemSpec> items) {
    std::vector<ItemSpec> scalars;
    std::copy_if(items.begin(), items.end(), std::back_inserter(scalars),
                 [](const ItemSpec& i) { return i.shape == Shape::scalar; });
    return scalars;
}

}  // namespace

std::vector<Candidate> take_apart(const Candidate& list, std::span<const ItemSpec> items, std::size_t first) {
    const PrintedValue& value = list.value;
    std::vector<Candidate> parts;
    for (std::size_t k = 0; k < value.numbers.size(); ++k) {
        Candidate part{value,      MatrixOrder::unsaid, list.part,
                       list.first, list.count,          static_cast<int>(value.numbers.size())};
        part.value.numbers = {value.numbers[k]};
        part.value.groups = 1;
        part.value.label = std::string(items[first + k].name);
        part.value.above.clear();
        parts.push_back(std::move(part));
    }
    return parts;
}

std::vector<Candidate> arrange(const std::vector<PrintedValue>& values, std::span<const ItemSpec> items) {
    const std::vector<ItemSpec> scalars = scalars_of(items);
    const auto vectors = static_cast<std::size_t>(
        std::count_if(items.begin(), items.end(), [](const ItemSpec& i) { return i.shape == Shape::vector; }));
    std::vector<Candidate> result;
    for (Candidate& candidate : gather_matrices(values, items)) {
        const PrintedValue& value = candidate.value;
        const std::string& names = value.label.empty() ? value.above : value.label;
        const std::vector<std::size_t> listed =
            value.groups == 1 ? listed_items(names, scalars) : std::vector<std::size_t>();
        if (listed.size() >= 2 && listed.size() == value.numbers.size()) {
            std::vector<ItemSpec> named;
            for (const std::size_t i : listed) named.push_back(scalars[i]);
            for (Candidate& part : take_apart(candidate, named, 0)) result.push_back(std::move(part));
        } else if (matrix_size(items) == 0 && vectors >= 2 && value.groups == static_cast<int>(vectors)) {
            for (Candidate& part : split_groups(candidate)) result.push_back(std::move(part));
        } else {
            result.push_back(std::move(candidate));
        }
    }
    return result;
}

}  // namespace harness
