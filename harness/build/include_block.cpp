#include "harness/build/include_block.h"

#include <algorithm>
#include <array>
#include <optional>

namespace harness {
namespace {

constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_";
constexpr std::string_view digits = "0123456789";
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

/// Names whose value depends on the compiler's position, and pragmas, which may affect what was included before.
constexpr std::array<std::string_view, 8> revealing{"__COUNTER__", "__INCLUDE_LEVEL__", "__BASE_FILE__", "__DATE__",
                                                    "__TIME__",    "__TIMESTAMP__",     "__FILE__",      "ragma"};

bool contains(std::string_view set, char c) {
    return set.find(c) != std::string_view::npos;
}

bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

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

std::string_view without_blanks_behind(std::string_view text) {
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

/// Removes blanks from the front and returns whether there were any.
bool skip_blanks(std::string_view& text) {
    const std::size_t before = text.size();
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    return text.size() < before;
}

bool skip_word(std::string_view& text, std::string_view word) {
    if (text.substr(0, word.size()) != word) return false;
    text.remove_prefix(word.size());
    return true;
}

/// Whether the header is found in the system's folders only, wherever the including file lies.
bool is_system_header(std::string_view name, bool quoted) {
    constexpr std::string_view others = "_./+-";
    if (name.empty() || contains("./", name.front()) || name.find("..") != std::string_view::npos ||
        name.find("/.") != std::string_view::npos || name.find("//") != std::string_view::npos) {
        return false;
    }
    // "vector.h" may be the student's file; "glm/glm.hpp" can't be, as a submission is one file.
    if (quoted && name.find('/') == std::string_view::npos) return false;
    return std::all_of(name.begin(), name.end(),
                       [&](char c) { return contains(letters, c) || contains(digits, c) || contains(others, c); });
}

/// Returns "#include <name>" from the text behind the word include.
std::optional<std::string> include_text(std::string_view rest) {
    skip_blanks(rest);
    if (rest.size() < 3) return {};
    const bool quoted = rest.front() == '"';
    if (rest.back() != (quoted ? '"' : '>') || rest.front() != (quoted ? '"' : '<')) return {};
    if (!is_system_header(rest.substr(1, rest.size() - 2), quoted)) return {};
    return "#include " + std::string(rest);
}

/// Returns "#define NAME body" from the text behind the word define.
std::optional<std::string> define_text(std::string_view rest) {
    if (!skip_blanks(rest) || rest.empty() || contains(digits, rest.front())) return {};
    std::size_t length = 0;
    while (length < rest.size() && (contains(letters, rest[length]) || contains(digits, rest[length]))) ++length;
    if (length == 0) return {};
    std::string text = "#define " + std::string(rest.substr(0, length));
    rest.remove_prefix(length);
    if (rest.empty()) return text;
    if (!is_blank(rest.front()) && rest.front() != '(') return {};
    // Literals are excluded, because text in them may look like a comment.
    constexpr std::string_view literals = "\"'\\";
    const auto is_plain = [&](char c) { return is_blank(c) || (c > ' ' && c <= '~' && !contains(literals, c)); };
    if (!std::all_of(rest.begin(), rest.end(), is_plain) || rest.find("??") != std::string_view::npos) return {};
    return text + std::string(rest);
}

std::optional<std::string> directive_text(std::string_view written) {
    std::string_view rest = written.substr(1);
    skip_blanks(rest);
    if (skip_word(rest, "include")) return include_text(rest);
    if (skip_word(rest, "define")) return define_text(rest);
    return {};
}

/// Reads the beginning of a source. Each skip_ function returns whether it could skip something and then stands behind
/// it.
class Reader {
  public:
    explicit Reader(std::string_view source) : source_(source) {
        if (source_.substr(0, byte_order_mark.size()) == byte_order_mark) at_ = byte_order_mark.size();
    }

    /// The next directive, if only white space and comments come before it.
    std::optional<Directive> next() {
        while (at_ < source_.size() && source_[at_] != '#') {
            if (!skip_blank_or_comment() && !skip_line_end()) return {};
        }
        if (at_ >= source_.size() || !first_on_its_line_) return {};
        return directive();
    }

  private:
    std::optional<Directive> directive() {
        const std::size_t begin = at_;
        const std::string_view line = source_.substr(begin, source_.find_first_of("\r\n", begin) - begin);
        const std::size_t comment = std::min(line.find("//"), line.find("/*"));
        const std::string_view written = without_blanks_behind(line.substr(0, comment));
        const auto text = directive_text(written);
        if (!text) return {};
        at_ = begin + written.size();
        const std::size_t end = at_;
        first_on_its_line_ = false;
        while (at_ < source_.size() && !first_on_its_line_) {
            if (!skip_blank_or_comment() && !skip_line_end()) return {};
        }
        return Directive{*text, begin, end};
    }

    bool skip_line_end() {
        const std::size_t length = source_.substr(at_, 2) == "\r\n" ? 2 : 1;
        if (length == 1 && source_[at_] != '\n') return false;
        at_ += length;
        first_on_its_line_ = true;
        return true;
    }

    bool skip_blank_or_comment() {
        if (is_blank(source_[at_])) {
            ++at_;
            return true;
        }
        const std::string_view two = source_.substr(at_, 2);
        if (two == "//") return skip_line_comment();
        return two == "/*" && skip_block_comment();
    }

    /// Rejects a comment that continues in the next line with a backslash or its trigraph.
    bool skip_line_comment() {
        const std::size_t end = std::min(source_.find('\n', at_), source_.size());
        const std::string_view comment = source_.substr(at_, end - at_);
        if (is_odd(comment)) return false;
        const std::size_t last = comment.find_last_not_of(" \t\r");
        if (comment[last] == '\\') return false;
        at_ = end > at_ && end < source_.size() && source_[end - 1] == '\r' ? end - 1 : end;
        return true;
    }

    bool skip_block_comment() {
        const std::size_t end = source_.find("*/", at_ + 2);
        if (end == std::string_view::npos) return false;
        const std::string_view comment = source_.substr(at_, end - at_);
        // "*\<newline>/" ends a comment too, and would do so earlier.
        if (is_odd(comment) || joined(comment).size() != comment.size()) return false;
        at_ = end + 2;
        return true;
    }

    static bool is_odd(std::string_view comment) {
        return comment.find('\0') != std::string_view::npos || comment.find("?\?/") != std::string_view::npos ||
               comment.find_first_of("\f\v") != std::string_view::npos;
    }

    std::string_view source_;
    std::size_t at_ = 0;
    bool first_on_its_line_ = true;  ///< nothing but white space and comments since the line's beginning
};

}  // namespace

std::vector<Directive> include_block(std::string_view source) {
    std::vector<Directive> block;
    if (is_revealing(source)) return block;
    Reader reader(source);
    while (auto directive = reader.next()) block.push_back(std::move(*directive));
    return block;
}

}  // namespace harness
