#include "harness/build/include_block.h"

#include <fmt/format.h>
#include <re2/re2.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace harness {
namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

/// Names whose value depends on the compiler's position, and pragmas, which may affect earlier includes.
constexpr std::array<std::string_view, 8> revealing{"__COUNTER__", "__INCLUDE_LEVEL__", "__BASE_FILE__", "__DATE__",
                                                    "__TIME__",    "__TIMESTAMP__",     "__FILE__",      "ragma"};

/// Joins lines that end in a backslash, as the compiler does.
std::string joined(std::string_view source) {
    std::string text;
    text.reserve(source.size());
    for (std::size_t i = 0; i < source.size(); ++i) {
        if (source[i] == '\\') {
            const std::size_t next = source.find_first_not_of(" \t\r\f\v", i + 1);
            if (next != std::string_view::npos && source[next] == '\n') {
                i = next;
                continue;
            }
        }
        text += source[i];
    }
    return text;
}

bool is_revealing(std::string_view source) {
    const std::string text = joined(source);
    return std::any_of(revealing.begin(), revealing.end(),
                       [&](std::string_view word) { return text.find(word) != std::string::npos; });
}

/// The directive at this '#'; empty if it is not a plain one.
std::optional<Directive> directive_at(std::string_view source, std::size_t begin) {
    // "vector.h" may be the student's file; "glm/glm.hpp" can't be, as a submission is one file.
    static const std::string name = R"([\w+-]+(?:\.[\w+-]+)*)";
    static const RE2 include(fmt::format(R"(#[ \t]*include[ \t]*(<{0}(?:/{0})*>|"{0}(?:/{0})+"))", name));
    // Literals are excluded, because text in them may look like a comment.
    static const RE2 define(R"(#[ \t]*define[ \t]+([A-Za-z_]\w*(?:[ \t(][\t !#-&(-\[\]-~]*)?))");
    const std::string_view line = source.substr(begin, source.find_first_of("\r\n", begin) - begin);
    std::string_view written = line.substr(0, std::min(line.find("//"), line.find("/*")));
    written = written.substr(0, written.find_last_not_of(" \t") + 1);
    const re2::StringPiece piece(written.data(), written.size());
    std::string text;
    if (RE2::FullMatch(piece, include, &text)) return Directive{"#include " + text, begin, begin + written.size()};
    if (!RE2::FullMatch(piece, define, &text) || text.find("??") != std::string::npos) return {};
    return Directive{"#define " + text, begin, begin + written.size()};
}

/// The end of the comment that begins here; empty if it does not end, or if a backslash or its trigraph could make it
/// continue in the next line or end earlier.
std::optional<std::size_t> end_of_comment(std::string_view source, std::size_t begin) {
    const bool is_line = source[begin + 1] == '/';
    const std::size_t end = is_line ? std::min(source.find('\n', begin), source.size()) : source.find("*/", begin + 2);
    if (end == std::string_view::npos) return {};
    const std::string comment = std::string(source.substr(begin, end - begin)) + '\n';
    const bool is_odd = comment.find("?\?/") != std::string::npos ||
                        comment.find_first_of(std::string_view("\f\v\0", 3)) != std::string::npos ||
                        joined(comment).size() != comment.size();
    if (is_odd) return {};
    return is_line ? end : end + 2;
}

}  // namespace

std::vector<Directive> include_block(std::string_view source) {
    std::vector<Directive> block;
    if (is_revealing(source)) return block;
    std::optional<Directive> open;  // its line has not ended
    bool is_first = true;           // only white space and comments since the line's beginning
    for (std::size_t at = source.starts_with(byte_order_mark) ? byte_order_mark.size() : 0; at < source.size();) {
        const std::string_view two = source.substr(at, 2);
        if (two.front() == '\n' || two == "\r\n") {
            if (open) block.push_back(*std::exchange(open, {}));
            is_first = true;
            at += two.front() == '\n' ? 1 : 2;
        } else if (two.front() == ' ' || two.front() == '\t') {
            ++at;
        } else if (two == "//" || two == "/*") {
            const auto end = end_of_comment(source, at);
            if (!end) return block;
            at = *end;
        } else {
            if (two.front() == '#' && is_first) open = directive_at(source, at);
            if (!open || !is_first) return block;
            is_first = false;
            at = open->end;
        }
    }
    if (open) block.push_back(*std::move(open));
    return block;
}

}  // namespace harness
