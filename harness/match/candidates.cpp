#include "harness/match/candidates.h"

#include <re2/re2.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "harness/match/label.h"

namespace harness {
namespace {

using reference::ItemSpec;
using reference::Shape;

bool is_matrix(Shape shape) {
    return shape == Shape::matrix3 || shape == Shape::matrix4;
}

/// Whether the value's own label names a vector item, and no matrix better: "M_VCS_to_WCS" holds P_VCS's name too.
bool names_vector(const PrintedValue& value, std::span<const ItemSpec> items) {
    LabelFit vector = LabelFit::forbidden, matrix = LabelFit::forbidden;
    for (const ItemSpec& item : items) {
        LabelFit& best = is_matrix(item.shape) ? matrix : vector;
        if (item.shape == Shape::vector || is_matrix(item.shape))
            best = std::max(best, fit_label(value.label, "", item));
    }
    return vector >= LabelFit::named && vector >= matrix;
}

/// Whether the label says that the value is no answer, whatever the item: "DEBUG", "before".
bool is_aside(const PrintedValue& value, std::span<const ItemSpec> items) {
    return fit_label(value.label, value.above, items.front()) == LabelFit::forbidden;
}

bool is_list_of(const PrintedValue& value, std::size_t count) {
    return value.groups == 1 && value.numbers.size() == count;
}

/// Whether a value may be part of a block. Rows of a matrix have no labels except "row 1", but one row or each may
/// carry the matrix's label, as in "    [ 0 -2 ]" over "A = [ 3 0 ]".
bool may_be_in_block(const PrintedValue& value, std::span<const ItemSpec> items) {
    if (value.label.empty() || read_row_label(value.label)) return true;
    return !names_vector(value, items) && !is_aside(value, items);
}

/// Whether values[at] to values[at + n - 1] are the rows or columns of one matrix, each with `count` numbers.
bool is_block(const std::vector<PrintedValue>& values, std::size_t at, std::size_t n, std::size_t count,
              std::span<const ItemSpec> items) {
    if (at + n > values.size() || !is_list_of(values[at], count) || is_aside(values[at], items)) return false;
    std::size_t own_labels = 0;
    for (std::size_t k = 0; k < n; ++k) {
        const PrintedValue& value = values[at + k];
        if (!is_list_of(value, count) || !may_be_in_block(value, items)) return false;
        const bool repeats = k > 0 && value.label == values[at].label;  // as in a table: "A | 1 2 3" over "A | 4 5 6"
        const bool is_row = read_row_label(value.label).has_value();
        if (!value.label.empty() && !is_row && !repeats) ++own_labels;
        if (k == 0) continue;
        if (!value.above.empty() && !read_row_label(value.above)) return false;
        if (value.line - values[at + k - 1].last_line > 2) return false;
    }
    return own_labels <= 1;
}

bool is_augmented_row(const PrintedValue& value) {
    return value.bar_after == 3 || !value.typed;
}

MatrixOrder order_of(const PrintedValue& first, MatrixOrder otherwise) {
    for (const std::string* text : {&first.label, &first.above}) {
        if (const MatrixOrder said = matrix_order(*text); said != MatrixOrder::unsaid) return said;
        if (otherwise == MatrixOrder::rows && tells_columns(*text)) return MatrixOrder::unsaid;
    }
    return otherwise;
}

/// The order that the row labels tell: columns for "col 0", "c1" or "-V", rows for "row 0". Without row labels: columns
/// after a type name, else rows.
MatrixOrder block_order(const std::vector<PrintedValue>& values, std::size_t at, std::size_t n) {
    const PrintedValue& first = values[at];
    const PrintedValue& last = values[at + n - 1];
    static const RE2 opened(R"(mat[234](?:x[234])?\s*\(\s*$)");  // "A = mat3x3(" on the line above
    const bool typed = first.typed || RE2::PartialMatch(first.above, opened);
    MatrixOrder otherwise = typed ? MatrixOrder::columns : MatrixOrder::rows;
    const std::string& row_label = last.label.empty() ? last.above : last.label;
    if (const auto row = read_row_label(row_label)) {
        if (row->is_certain) return row->order;
        if (!typed) otherwise = row->order;
    }
    return order_of(first, otherwise);
}

/// Gathers a block of rows into one matrix. If n = 3 and the rows have four numbers, the fourth is the right-hand side.
std::vector<Candidate> gather_block(const std::vector<PrintedValue>& values, std::size_t at, std::size_t n,
                                    std::size_t count) {
    Candidate matrix{values[at], block_order(values, at, n), 0, at, n};
    matrix.value.numbers.clear();
    matrix.value.printed.clear();
    matrix.value.groups = static_cast<int>(n);
    for (std::size_t k = 0; k < n; ++k) {
        if (!values[at + k].label.empty()) matrix.value.label = values[at + k].label;
    }
    if (const auto row = read_row_label(matrix.value.label)) matrix.value.label = std::string(row->matrix);
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
    matrix.value.last_line = rhs.value.last_line = values[at + n - 1].last_line;
    if (count == n) return {matrix};
    matrix.order = MatrixOrder::rows;
    rhs.value.printed = matrix.value.printed;
    return {matrix, rhs};
}

/// How many values from values[at] on are single numbers on consecutive lines, all of them framed or all unframed.
std::size_t stack_height(const std::vector<PrintedValue>& values, std::size_t at) {
    constexpr std::size_t most = 64;
    std::size_t height = 0;
    while (at + height < values.size() && height < most) {
        const PrintedValue& value = values[at + height];
        if (value.numbers.size() != 1 || value.framed != values[at].framed || !value.after.empty()) break;
        if (height > 0 && !value.framed && !value.label.empty()) break;
        if (height > 0 && (!value.above.empty() || value.line != values[at + height - 1].line + 1)) break;
        ++height;
    }
    return height;
}

/// How many values from values[at] on are the components of one vector or matrix, printed one per line; 0 if none are.
/// They are one if they stand under its name, and those of a vector also if they stand in brackets or the question asks
/// for no scalar. At most one has a label: "  | 0.5 |" over "N = | 0.2 |" over "  | 0.1 |".
std::size_t stack_size(const std::vector<PrintedValue>& values, std::size_t at, std::span<const ItemSpec> items) {
    const std::size_t height = stack_height(values, at);
    const auto is_under_name = [&](Shape shape) {
        return std::ranges::any_of(items, [&](const ItemSpec& item) {
            return item.shape == shape && fit_label(values[at].label, values[at].above, item) >= LabelFit::title;
        });
    };
    for (const auto& [shape, count] : {std::pair(Shape::matrix4, 16), {Shape::matrix3, 9}}) {
        if (height == static_cast<std::size_t>(count) && is_under_name(shape)) return height;
    }
    const std::size_t size = height % 3 == 0 ? 3 : height % 4 == 0 ? 4 : 0;
    if (height == 0 || size == 0) return 0;
    // "step 0.5" above three numbers is not the first of four.
    if (size == 4 && !values[at].framed && !values[at].label.empty() && !is_under_name(Shape::vector)) return 0;
    const auto labels = std::ranges::count_if(std::span(values).subspan(at, size),
                                              [](const PrintedValue& value) { return !value.label.empty(); });
    if (labels > 1) return 0;
    const auto is_asked = [&](Shape shape) { return std::ranges::count(items, shape, &ItemSpec::shape) > 0; };
    const bool may_be_vector = is_under_name(Shape::vector) || values[at].framed || !is_asked(Shape::scalar);
    return is_asked(Shape::vector) && may_be_vector ? size : 0;
}

/// Joins the components of a vector or a matrix printed one per line.
Candidate gather_stack(const std::vector<PrintedValue>& values, std::size_t at, std::size_t n) {
    Candidate vector{values[at], order_of(values[at], MatrixOrder::unsaid)};
    for (std::size_t k = 1; k < n; ++k) {
        const PrintedValue& value = values[at + k];
        vector.value.numbers.push_back(value.numbers[0]);
        vector.value.printed += "; " + value.printed;
        vector.value.last_line = value.last_line;
        if (!value.label.empty()) vector.value.label = value.label;
    }
    return vector;
}

/// Reads a matrix in one value: nested brackets, or a flat list of all its numbers.
std::optional<Candidate> whole_matrix(const PrintedValue& value, const std::vector<std::size_t>& sizes) {
    const bool is_matrix = std::ranges::any_of(sizes, [&](std::size_t n) {
        return value.numbers.size() == n * n && (value.groups == 1 || value.groups == static_cast<int>(n));
    });
    if (!is_matrix) return std::nullopt;
    const MatrixOrder otherwise = value.typed         ? MatrixOrder::columns
                                  : value.groups == 1 ? MatrixOrder::unsaid
                                                      : MatrixOrder::rows;
    return Candidate{value, order_of(value, otherwise)};
}

/// The row counts of the matrices among `items`, 4 before 3.
std::vector<std::size_t> matrix_sizes(std::span<const ItemSpec> items) {
    std::vector<std::size_t> sizes;
    for (const auto& [shape, size] : {std::pair(Shape::matrix4, std::size_t{4}), {Shape::matrix3, std::size_t{3}}}) {
        if (std::ranges::count(items, shape, &ItemSpec::shape) > 0) sizes.push_back(size);
    }
    return sizes;
}

/// The values in printing order. Values that form one answer of `items` are joined.
std::vector<Candidate> gather_rows(const std::vector<PrintedValue>& values, std::span<const ItemSpec> items) {
    const std::vector<std::size_t> sizes = matrix_sizes(items);
    const bool has_system = !sizes.empty() && sizes.back() == 3;
    std::vector<Candidate> candidates;
    bool found_matrix = false;     // later rows form a matrix only under their own label
    bool found_augmented = false;  // later augmented matrices are steps of an elimination
    for (std::size_t i = 0; i < values.size();) {
        const bool may_gather = !found_matrix || !values[i].label.empty() || !values[i].above.empty();
        const auto append = [&](const std::vector<Candidate>& found, std::size_t used) {
            const PrintedValue& value = found.front().value;
            found_matrix = found_matrix || (!sizes.empty() && value.numbers.size() >= 9 && !is_aside(value, items));
            for (const Candidate& candidate : found) {
                candidates.push_back(candidate);
                candidates.back().first = i;
                candidates.back().count = used;
            }
            i += used;
        };
        const auto block =
            std::ranges::find_if(sizes, [&](std::size_t n) { return may_gather && is_block(values, i, n, n, items); });
        if (block != sizes.end()) {
            append(gather_block(values, i, *block, *block), *block);
        } else if (may_gather && has_system && is_augmented_row(values[i]) && is_block(values, i, 3, 4, items)) {
            std::vector<Candidate> system = gather_block(values, i, 3, 4);
            if (found_augmented) {
                for (Candidate& part : system) part.value.label = "reduced";
            }
            found_augmented = found_augmented || !is_aside(values[i], items);
            append(system, 3);
        } else if (const auto matrix = whole_matrix(values[i], sizes)) {
            append({*matrix}, 1);
        } else if (const std::size_t size = stack_size(values, i, items); size != 0) {
            append({gather_stack(values, i, size)}, size);
        } else {
            append({Candidate{values[i], MatrixOrder::unsaid}}, 1);
        }
    }
    return candidates;
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

std::vector<Candidate> candidates_of(const std::vector<PrintedValue>& values, std::span<const ItemSpec> items) {
    const std::vector<ItemSpec> scalars = scalars_of(items);
    std::vector<Candidate> result;
    for (Candidate& candidate : gather_rows(values, items)) {
        const PrintedValue& value = candidate.value;
        const std::string& names = value.label.empty() ? value.above : value.label;
        const std::vector<std::size_t> listed =
            value.groups == 1 ? listed_items(names, scalars) : std::vector<std::size_t>();
        if (listed.size() >= 2 && listed.size() == value.numbers.size()) {
            std::vector<ItemSpec> named;
            for (const std::size_t i : listed) named.push_back(scalars[i]);
            for (Candidate& part : take_apart(candidate, named, 0)) result.push_back(std::move(part));
        } else {
            result.push_back(std::move(candidate));
        }
    }
    return result;
}

}  // namespace harness
