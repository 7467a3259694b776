#include "harness/read/system_names.h"

#include <fmt/format.h>
#include <re2/re2.h>

#include <algorithm>
#include <string>

namespace harness {
namespace {

constexpr std::size_t longest_statement = 200;

/// The unknowns that the line lists, "uvt"; empty if it lists none.
std::string unknowns_in(const std::string& line) {
    static const RE2 list(
        R"((?i)(?:[(\[{<]|\b(?:unknowns?|variables?|order|for|solution)\b\W*(?:(?:are|is|of|x)\b\W*)*)\s*([tuv])\s*,\s*([tuv])\s*,?\s*(?:and\s+)?([tuv])\b)");
    static const RE2 columns(
        R"((?i)\bcol(?:umn)?s?\b\W*(?:(?:are|is|hold)\b\W*)?(-?\s*V|B\s*-\s*A|C\s*-\s*A)\s*[,;|]\s*(-?\s*V|B\s*-\s*A|C\s*-\s*A)\s*[,;|]?\s*(?:and\s+)?(-?\s*V|B\s*-\s*A|C\s*-\s*A))");
    static const RE2 terms(
        R"((?i)-?\s*([tuv])\s*\*?\s*\(?\s*(?:B\s*-\s*A|C\s*-\s*A|V)\s*\)?\s*[-+]\s*([tuv])\s*\*?\s*\(?\s*(?:B\s*-\s*A|C\s*-\s*A|V)\s*\)?\s*[-+]\s*([tuv])\s*\*?\s*\(?\s*(?:B\s*-\s*A|C\s*-\s*A|V)\b)");
    std::string names[3];
    if (line.size() > longest_statement) return "";
    if (RE2::PartialMatch(line, list, &names[0], &names[1], &names[2]) ||
        RE2::PartialMatch(line, terms, &names[0], &names[1], &names[2])) {
        std::string order = names[0] + names[1] + names[2];
        std::ranges::transform(order, order.begin(), [](char c) { return static_cast<char>(c | 0x20); });
        return order;
    }
    if (!RE2::PartialMatch(line, columns, &names[0], &names[1], &names[2])) return "";
    std::string order;
    for (const std::string& name : names) {
        const char first = name.front();
        order += first == 'B' || first == 'b' ? 'u' : first == 'C' || first == 'c' ? 'v' : 't';
    }
    return order;
}

bool is_permutation_of_unknowns(std::string order) {
    std::ranges::sort(order);
    return order == "tuv";
}

}  // namespace

void name_unknowns(std::vector<PrintedValue>& values, const std::vector<PrintedLine>& lines) {
    static const RE2 solution(
        R"((?i)(?:the\s+)?(?:x|sol|solutions?(?:\s+(?:vector|is|x))*|result|unknowns?|answer)(?:\s*=)?\W*)");
    std::string order;
    auto line = lines.begin();
    for (PrintedValue& value : values) {
        for (; line != lines.end() && line->number <= value.last_line; ++line) {
            std::string listed = unknowns_in(line->text);
            if (is_permutation_of_unknowns(listed)) order = std::move(listed);
        }
        const std::string& name = value.label.empty() ? value.above : value.label;
        if (order.empty() || order == "tuv" || value.numbers.size() != 3 || value.groups != 1 ||
            !RE2::FullMatch(name, solution))
            continue;
        value.label = fmt::format("({}, {}, {})", order[0], order[1], order[2]);
    }
}

void name_corners(std::vector<PrintedValue>& values) {
    for (std::size_t i = 0; i + 2 < values.size(); ++i) {
        const auto is = [&](std::size_t k, std::string_view name) {
            const std::string& label = values[i + k].label;
            return values[i + k].numbers.size() == 3 && (label == name || label.ends_with(fmt::format(" {}", name)));
        };
        if (!is(0, "A") || !is(1, "B") || !is(2, "C")) continue;
        for (std::size_t k = 0; k < 3; ++k)
            values[i + k].label = fmt::format("{} {}", corner_of_scene, values[i + k].label);
    }
}

}  // namespace harness
