#include "harness/read/value_label.h"

#include <re2/re2.h>

#include <cstddef>

namespace harness {
namespace {

std::string_view trim(std::string_view part) {
    constexpr std::string_view around = " \t=:-><,;.*#|~/\\\"_";
    const std::size_t first = part.find_first_not_of(around);
    if (first == std::string_view::npos) return std::string_view();
    return part.substr(first, part.find_last_not_of(around) - first + 1);
}

bool is_named(std::string_view part, const RE2& name) {
    return RE2::FullMatch(re2::StringPiece(part.data(), part.size()), name);
}

}  // namespace

std::string value_label(std::string_view words) {
    static const RE2 size(R"((?i).*(?:\|\s*(\w+)\s*\||abs\s*\(\s*(\w+)\s*\))\s*[:=]\s*)");
    re2::StringPiece of[2];
    if (RE2::FullMatch(re2::StringPiece(words.data(), words.size()), size, &of[0], &of[1]))
        return "intermediate: " + std::string(of[0]) + std::string(of[1]);
    std::string_view first_part;
    std::string_view last_part;
    for (std::string_view rest = words; !rest.empty();) {
        const std::size_t equals = rest.find('=');
        if (const std::string_view part = trim(rest.substr(0, equals)); !part.empty()) {
            last_part = part;
            if (first_part.empty()) first_part = part;
        }
        rest = equals == std::string_view::npos ? std::string_view() : rest.substr(equals + 1);
    }
    if (first_part.data() != last_part.data()) {
        static const RE2 unknowns(R"((?i)[(\[{<]?\s*[tuv](?:\s*,\s*[tuv]){2}\s*[)\]}>]?)");  // "x = (u, v, t) ="
        if (is_named(last_part, unknowns)) return std::string(last_part);
        static const RE2 component(R"((?:(?:\w+\s*)?[(\[{<]\s*){0,2}["']?[xX])");
        if (is_named(last_part, component)) return std::string(first_part) + " x";
    }
    return first_part == "and" ? "" : std::string(first_part);
}

}  // namespace harness
