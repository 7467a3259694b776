#include "harness/read/joined_values.h"

#include <re2/re2.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace harness {
namespace {

/// The x, y, z or w that a label names, as 0 to 3, and the label without it: "hit point: x" is component 0 of "hit
/// point".
struct ComponentLabel {
    int component;
    std::string base;
};

std::optional<ComponentLabel> read_component(const PrintedValue& value) {
    if (value.numbers.size() != 1 || value.label.empty()) return std::nullopt;
    // The handout's own "x_DCS", and "x in VCS".
    static const RE2 of_frame(R"((?i)([xyz])(?:_|\s+in\s+|\s+)?(vcs|wcs|view|world|cam|s|t|c|hit))");
    std::string axis, frame;
    if (RE2::FullMatch(value.label, of_frame, &axis, &frame))
        return ComponentLabel{(axis[0] | 0x20) - 'x', "P_" + frame};
    static const RE2 pattern(R"((?i)^(?:(.*?)(?:[\s:.,(_\-]+|\[)?)?(?:([xyzw])|([0-3])\])\s*$)");
    re2::StringPiece base;
    re2::StringPiece letter;
    re2::StringPiece index;
    if (!RE2::FullMatch(value.label, pattern, &base, &letter, &index)) return std::nullopt;
    std::string name(base);
    while (!name.empty() && std::string_view(" \t=:-.,(").find(name.back()) != std::string_view::npos) name.pop_back();
    if (!letter.empty()) {
        constexpr std::string_view letters = "xyzw";
        return ComponentLabel{static_cast<int>(letters.find(static_cast<char>(letter[0] | 0x20))), name};
    }
    return ComponentLabel{index[0] - '0', name};
}

/// Joins "x = 0, y = 0, z = -2", on one line or on several, into one vector.
std::vector<PrintedValue> join_components(std::vector<PrintedValue> values) {
    std::vector<PrintedValue> joined;
    for (std::size_t i = 0; i < values.size();) {
        std::size_t count = 0;
        std::string base;
        while (i + count < values.size()) {
            const auto label = read_component(values[i + count]);
            if (!label || label->component != static_cast<int>(count)) break;
            if (count > 0 && !label->base.empty() && label->base != base) break;
            if (count > 0 && values[i + count].line - values[i + count - 1].last_line > 1) break;
            if (count == 0) base = label->base;
            ++count;
        }
        if (count < 3) {
            joined.push_back(std::move(values[i++]));
            continue;
        }
        PrintedValue vector = values[i];
        vector.label = base;
        vector.printed = values[i].label + " = " + values[i].printed;
        for (std::size_t k = 1; k < count; ++k) {
            const PrintedValue& component = values[i + k];
            vector.numbers.push_back(component.numbers[0]);
            vector.printed += ", " + component.label + " = " + component.printed;
            vector.last_line = component.last_line;
        }
        joined.push_back(std::move(vector));
        i += count;
    }
    return joined;
}

/// The place in a matrix that a label names: "M(1,2)", "M[0][1]", "m12", "row 1 col 2".
struct ElementLabel {
    std::string base;
    int first, second;
    bool is_row_first;  ///< `first` is the row; M[0][1] may be GLM's column 0
};

std::optional<ElementLabel> read_element(const PrintedValue& value) {
    if (value.numbers.size() != 1 || value.label.empty()) return std::nullopt;
    static const RE2 pattern(
        R"((?i)^(.*?)[\s_.]*(?:\[(\d)\]\s*\[(\d)\]|[(\[{]\s*(\d)\s*,\s*(\d)\s*[)\]}]|([0-4])_?([0-4])|row\s*(\d)\W+col(?:umn)?\s*(\d))$)");
    std::string base, c[8];
    if (!RE2::FullMatch(value.label, pattern, &base, &c[0], &c[1], &c[2], &c[3], &c[4], &c[5], &c[6], &c[7]))
        return std::nullopt;
    for (const std::size_t k : {0, 2, 4, 6}) {
        if (!c[k].empty()) return ElementLabel{base, c[k][0] - '0', c[k + 1][0] - '0', k != 0};
    }
    return std::nullopt;
}

/// The matrix whose elements are values[at], values[at + 1], …, in any order; empty if they are not just 3 x 3 or 4
/// x 4.
std::optional<PrintedValue> join_elements_at(const std::vector<PrintedValue>& values, std::size_t at) {
    std::vector<ElementLabel> labels;
    for (std::size_t i = at; i < values.size() && labels.size() < 16; ++i) {
        const auto label = read_element(values[i]);
        if (!label || (!labels.empty() && label->base != labels.front().base)) break;
        labels.push_back(*label);
    }
    for (const std::size_t n : {std::size_t{4}, std::size_t{3}}) {
        if (labels.size() < n * n) continue;
        const auto end = labels.begin() + static_cast<std::ptrdiff_t>(n * n);
        const int start = std::min_element(labels.begin(), end, [](const auto& a, const auto& b) {
                              return a.first < b.first;
                          })->first;
        PrintedValue matrix = values[at];
        matrix.numbers.assign(n * n, {});
        std::vector<bool> filled(n * n, false);
        for (std::size_t k = 0; k < n * n; ++k) {
            const int row = labels[k].first - start, column = labels[k].second - start;
            if (row < 0 || column < 0 || row >= static_cast<int>(n) || column >= static_cast<int>(n)) break;
            const auto place = static_cast<std::size_t>(row) * n + static_cast<std::size_t>(column);
            matrix.numbers[place] = values[at + k].numbers.front();
            filled[place] = true;
        }
        if (std::find(filled.begin(), filled.end(), false) != filled.end()) continue;
        matrix.label = labels.front().base;
        matrix.groups = labels.front().is_row_first ? static_cast<int>(n) : 1;
        matrix.last_line = values[at + n * n - 1].last_line;
        matrix.printed = values[at].label + " = " + values[at].printed;
        for (std::size_t k = 1; k < n * n; ++k)
            matrix.printed += ", " + values[at + k].label + " = " + values[at + k].printed;
        matrix.printed.resize(std::min(matrix.printed.size(), longest_printed));
        return matrix;
    }
    return std::nullopt;
}

/// Joins "M(1,1) = 0", "M(1,2) = 1", … into one matrix.
std::vector<PrintedValue> join_elements(std::vector<PrintedValue> values) {
    std::vector<PrintedValue> joined;
    for (std::size_t i = 0; i < values.size();) {
        if (auto matrix = join_elements_at(values, i)) {
            i += matrix->numbers.size();
            joined.push_back(std::move(*matrix));
        } else {
            joined.push_back(std::move(values[i++]));
        }
    }
    return joined;
}

/// Joins three or four numbers that are stacked under their own label, such as "column 0" or "N", into one list.
std::vector<PrintedValue> join_stacks(std::vector<PrintedValue> values) {
    std::vector<PrintedValue> joined;
    for (std::size_t i = 0; i < values.size();) {
        const auto continues = [&](std::size_t k) {
            const PrintedValue& value = values[k];
            return value.numbers.size() == 1 && value.label.empty() && value.after.empty() && value.above.empty() &&
                   value.line == values[k - 1].line + 1;
        };
        std::size_t count = 1;
        const bool starts = values[i].numbers.size() == 1 && values[i].label.empty() && values[i].after.empty() &&
                            !values[i].above.empty() && !values[i].above_is_title;
        while (starts && i + count < values.size() && continues(i + count)) ++count;
        PrintedValue value = std::move(values[i]);
        if (count == 3 || count == 4) {
            for (std::size_t k = 1; k < count; ++k) {
                const PrintedValue& below = values[i + k];
                value.numbers.push_back(below.numbers[0]);
                value.printed += "; " + below.printed;
                value.last_line = below.last_line;
            }
        } else {
            count = 1;
        }
        joined.push_back(std::move(value));
        i += count;
    }
    return joined;
}

/// Where the values of the line end that values[at] stands on; at if it is not one of a picture, all in brackets.
std::size_t end_of_framed_line(const std::vector<PrintedValue>& values, std::size_t at) {
    std::size_t end = at;
    while (end < values.size() && values[end].line == values[at].line && values[end].framed) ++end;
    return end;
}

/// The results of a product with a 4 x 4 matrix that begins at values[at], "[0 0 1 4] [-2] = [2]" or a matrix times a
/// matrix: the last value of each of four lines. Only the line with the '=' has no other, or one. Empty if there is
/// none.
std::vector<std::size_t> results_of_product(const std::vector<PrintedValue>& values, std::size_t at) {
    constexpr std::size_t n = 4, in_row = 3;
    std::vector<std::size_t> results;
    std::size_t whole = 0;
    for (std::size_t k = 0; k < n && at < values.size(); ++k) {
        const std::size_t end = end_of_framed_line(values, at);
        if (end == at || end - at > in_row || (k > 0 && values[at].line != values[results.back()].line + 1)) return {};
        results.push_back(end - 1);
        const std::size_t count = values[end - 1].numbers.size();
        if ((count != n && count != 1) || count != values[results.front()].numbers.size()) return {};
        if (end - at == in_row) {
            if (values[at].numbers.size() != n || values[at + 1].numbers.size() != count) return {};
            ++whole;
        }
        at = end;
    }
    return results.size() == n && whole + 1 == n ? results : std::vector<std::size_t>();
}

/// Keeps only the results of such products: a point as one value, a matrix as its rows.
std::vector<PrintedValue> join_products(std::vector<PrintedValue> values) {
    std::vector<PrintedValue> joined;
    for (std::size_t i = 0; i < values.size();) {
        const std::vector<std::size_t> results = results_of_product(values, i);
        if (results.empty()) {
            joined.push_back(std::move(values[i++]));
            continue;
        }
        PrintedValue first = values[results.front()];
        first.label = values[i].label;
        first.above = values[i].above;
        first.above_is_title = values[i].above_is_title;
        joined.push_back(std::move(first));
        for (std::size_t k = 1; k < results.size(); ++k) {
            PrintedValue& result = values[results[k]];
            if (result.numbers.size() > 1) {
                joined.push_back(std::move(result));
                continue;
            }
            joined.back().numbers.push_back(result.numbers.front());
            joined.back().printed += "; " + result.printed;
            joined.back().last_line = result.last_line;
        }
        i = results.back() + 1;
    }
    return joined;
}

}  // namespace

std::vector<PrintedValue> join_values(std::vector<PrintedValue> values) {
    return join_stacks(join_components(join_elements(join_products(std::move(values)))));
}

void join_system_row(std::vector<PrintedValue>& values, std::string_view line) {
    static const RE2 pattern(
        R"([|\[(]\s*[-+.\deE]+\s*,?\s+[-+.\deE]+\s*,?\s+[-+.\deE]+\s*[|\])]\s*[*x.]?\s*[|\[(]\s*[a-zA-Z]\w?\s*[|\])]\s*=?\s*[|\[(]\s*[-+.\deE]+\s*[|\])])");
    constexpr std::size_t longest_row = 400;
    if (values.size() != 2 || values[0].numbers.size() != 3 || values[1].numbers.size() != 1 ||
        line.size() > longest_row || !RE2::PartialMatch(re2::StringPiece(line.data(), line.size()), pattern))
        return;
    values[0].numbers.push_back(values[1].numbers[0]);
    values[0].bar_after = 3;
    values[0].printed = std::string(line.substr(0, longest_printed));
    values.pop_back();
}

}  // namespace harness
