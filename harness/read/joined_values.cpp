#include "harness/read/joined_values.h"

#include <re2/re2.h>

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

}  // namespace

std::vector<PrintedValue> join_values(std::vector<PrintedValue> values) {
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

}  // namespace harness
