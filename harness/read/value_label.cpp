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

/// Where the name ends that what is worked out belongs to, "d" in "d: 16 - 8"; what stands before a mere name, as
/// in "sphere: d", does not end it.
std::size_t end_of_name(std::string_view part) {
    static const RE2 worked_out(R"([^:=]*\w[^:=]*?(\s*:\s*)[^:]*(?:[+*/^]|\s-\s)[^:]*)");
    re2::StringPiece colon;
    const bool has_one = RE2::FullMatch(re2::StringPiece(part.data(), part.size()), worked_out, &colon);
    return has_one ? static_cast<std::size_t>(colon.data() - part.data()) : part.size();
}

/// "t plus" for "t+", and "t minus" for the "t" of "t- = 0.59": a root's sign is no punctuation.
std::string with_sign_of_root(std::string_view name, std::string_view words) {
    static const RE2 root(R"((?i)(t|x|root|lambda)(\+?))");
    const std::size_t behind = name.empty() ? 0 : static_cast<std::size_t>(name.data() - words.data()) + name.size();
    const bool has_minus = behind + 1 < words.size() && words[behind] == '-' &&
                           std::string_view(" \t:=").find(words[behind + 1]) != std::string_view::npos;
    std::string letter, plus;
    const bool is_root = RE2::FullMatch(re2::StringPiece(name.data(), name.size()), root, &letter, &plus);
    if (is_root && !plus.empty()) return letter + " plus";
    return std::string(name) + (is_root && has_minus ? " minus" : "");
}

}  // namespace

std::string value_label(std::string_view words, std::string_view remark, bool is_first) {
    static const RE2 bound(R"((\s*[-+]?[\d.]+\s*<=?)\s*\w+\s*=\s*)");  // "0 <= u = 0.25 <= 1"
    re2::StringPiece lower;
    if (RE2::FullMatch(re2::StringPiece(words.data(), words.size()), bound, &lower)) words.remove_prefix(lower.size());
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
    static const RE2 size(R"((?i)\s*(?:\|(\w+)\||abs\s*\(\s*(\w+)\s*\))\s*[:=]\s*)");
    re2::StringPiece of[2];
    if (RE2::FullMatch(re2::StringPiece(words.data(), words.size()), size, &of[0], &of[1]))
        return "intermediate: " + std::string(of[0]) + std::string(of[1]);
    // "x = (u, v, t) = "
    static const RE2 unknowns(R"((?i)[(\[{<]?\s*[tuv](?:\s*,\s*[tuv]){2}\s*[)\]}>]?(?:\^?T)?)");
    if (first_part.data() != last_part.data() && is_named(last_part, unknowns)) return std::string(last_part);
    static const RE2 u("(?i)(?:u|beta)"), v("(?i)(?:v|gamma)");
    if (is_named(first_part, u) && is_named(last_part, v)) return "u = v";
    if (const std::size_t name_end = end_of_name(first_part); words.find('=') != std::string_view::npos)
        first_part = trim(first_part.substr(0, name_end));
    if (!remark.empty()) return std::string(remark) + " " + std::string(first_part);
    static const RE2 conjunction("(?i)and|und|et");
    if (!is_first && is_named(first_part, conjunction)) return "";
    // "P_s = {x = 2", "P_s = Some(Vec3 { x: 2", "P_s = {\"X\": 2": component x of P_s.
    static const RE2 component(R"((?:(?:\w+\s*)?[(\[{<]\s*){0,2}["']?[xX])");
    if (first_part.data() != last_part.data() && is_named(last_part, component)) return std::string(first_part) + " x";
    static const RE2 of_record(R"((\w[\w ]*?)\s*:\s*\w+\s*(?:[(\[{<]\s*\w+\s*)?[{(]\s*x)");  // "N: Vec3 { x"
    std::string name;
    if (RE2::FullMatch(re2::StringPiece(first_part.data(), first_part.size()), of_record, &name)) return name + " x";
    // Skips a remark about the previous value: "t = 0.58 (the smaller root), hit = …".
    if (!is_first && !first_part.empty() && first_part.front() == '(') {
        const std::size_t close = first_part.find(')');
        if (close != std::string_view::npos) {
            const std::string_view rest = trim(first_part.substr(close + 1));
            if (!rest.empty()) first_part = rest;
        }
    }
    return with_sign_of_root(first_part, words);
}

std::string note_about_order(std::string_view behind) {
    static const RE2 pattern(R"((?i)\W*((?:\w+\W+){0,5}(?:col(?:umn)?s?|rows?)\b.{0,40}?)\W*)");
    constexpr std::size_t longest_note = 200;
    std::string note;
    if (behind.size() <= longest_note) RE2::FullMatch(re2::StringPiece(behind.data(), behind.size()), pattern, &note);
    return note;
}

}  // namespace harness
