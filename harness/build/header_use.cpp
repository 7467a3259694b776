#include "harness/build/header_use.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace harness {
namespace {

using std::string_view_literals::operator""sv;

/// The most directives of a block that count. Students have a dozen.
constexpr std::size_t longest = 64;
/// The longest #define of a source's own, which becomes a word of the compiler's command line.
constexpr std::size_t longest_macro = 200;

/// The headers of C++17, and those of C that C++ defines again, but for <complex.h> and <tgmath.h>, whose macros have
/// names as short as I.
constexpr std::array standard_headers{
    "algorithm"sv,
    "any"sv,
    "array"sv,
    "assert.h"sv,
    "atomic"sv,
    "bits/stdc++.h"sv,
    "bitset"sv,
    "cassert"sv,
    "cctype"sv,
    "cerrno"sv,
    "cfenv"sv,
    "cfloat"sv,
    "charconv"sv,
    "chrono"sv,
    "cinttypes"sv,
    "climits"sv,
    "clocale"sv,
    "cmath"sv,
    "complex"sv,
    "condition_variable"sv,
    "csetjmp"sv,
    "csignal"sv,
    "cstdarg"sv,
    "cstddef"sv,
    "cstdint"sv,
    "cstdio"sv,
    "cstdlib"sv,
    "cstring"sv,
    "ctime"sv,
    "ctype.h"sv,
    "cuchar"sv,
    "cwchar"sv,
    "cwctype"sv,
    "deque"sv,
    "errno.h"sv,
    "exception"sv,
    "execution"sv,
    "fenv.h"sv,
    "filesystem"sv,
    "float.h"sv,
    "forward_list"sv,
    "fstream"sv,
    "functional"sv,
    "future"sv,
    "initializer_list"sv,
    "inttypes.h"sv,
    "iomanip"sv,
    "ios"sv,
    "iosfwd"sv,
    "iostream"sv,
    "istream"sv,
    "iterator"sv,
    "limits"sv,
    "limits.h"sv,
    "list"sv,
    "locale"sv,
    "locale.h"sv,
    "map"sv,
    "math.h"sv,
    "memory"sv,
    "memory_resource"sv,
    "mutex"sv,
    "new"sv,
    "numeric"sv,
    "optional"sv,
    "ostream"sv,
    "queue"sv,
    "random"sv,
    "ratio"sv,
    "regex"sv,
    "scoped_allocator"sv,
    "set"sv,
    "shared_mutex"sv,
    "signal.h"sv,
    "sstream"sv,
    "stack"sv,
    "stdarg.h"sv,
    "stddef.h"sv,
    "stdexcept"sv,
    "stdint.h"sv,
    "stdio.h"sv,
    "stdlib.h"sv,
    "streambuf"sv,
    "string"sv,
    "string.h"sv,
    "string_view"sv,
    "system_error"sv,
    "thread"sv,
    "time.h"sv,
    "tuple"sv,
    "type_traits"sv,
    "typeindex"sv,
    "typeinfo"sv,
    "unordered_map"sv,
    "unordered_set"sv,
    "utility"sv,
    "valarray"sv,
    "variant"sv,
    "vector"sv,
    "wchar.h"sv,
    "wctype.h"sv,
};
static_assert(std::is_sorted(standard_headers.begin(), standard_headers.end()));

/// A header of GLM that compiles only behind another.
constexpr std::string_view incomplete = "glm/gtx/fast_trigonometry.hpp";

constexpr std::string_view define = "#define ";
constexpr std::string_view include = "#include ";

bool is_define(std::string_view directive) {
    return directive.starts_with(define);
}

/// What stands behind #define, up to the end of the name.
std::string_view defined_name(std::string_view directive) {
    directive.remove_prefix(define.size());
    return directive.substr(0, directive.find_first_of(" \t("));
}

/// Whether headers are known to read the macro, or may: names with an underscore in front are theirs. The one that the
/// course's flags define anyway changes nothing.
bool is_setting(std::string_view name) {
    return name.starts_with("_") || name == "NDEBUG" || (name.starts_with("GLM_") && name != "GLM_ENABLE_EXPERIMENTAL");
}

/// The directive in angle brackets; empty if the header is not known to mean the same in any order. A name in quotes
/// with a folder is no file of the student's, see include_block.h.
std::optional<std::string> in_any_order(std::string_view directive) {
    const std::string_view name = directive.substr(include.size() + 1, directive.size() - include.size() - 2);
    const bool is_glm = name.starts_with("glm/") && name != incomplete;
    if (!is_glm && !std::binary_search(standard_headers.begin(), standard_headers.end(), name)) return {};
    return fmt::format("#include <{}>", name);
}

/// A block's parts, and how many of its directives they are from.
struct Understood {
    HeaderParts parts;
    std::size_t directives = 0;
};

Understood understand(const HeaderLines& lines) {
    Understood result;
    HeaderLines& includes = result.parts.includes;
    for (; result.directives < std::min(lines.size(), longest); ++result.directives) {
        const std::string& directive = lines[result.directives];
        if (is_define(directive)) {
            if (!is_setting(defined_name(directive))) {
                if (directive.size() > longest_macro) break;
                continue;
            }
            if (!includes.empty()) break;
            result.parts.settings.push_back(directive);
        } else {
            auto line = in_any_order(directive);
            if (!line) break;
            includes.push_back(std::move(*line));
        }
    }
    std::sort(includes.begin(), includes.end());
    includes.erase(std::unique(includes.begin(), includes.end()), includes.end());
    return result;
}

/// As the compiler reads the option, the first = ends the name and its parameters.
Macro macro_of(std::string_view directive) {
    const std::string_view name = defined_name(directive);
    const std::string_view rest = directive.substr(define.size());
    std::size_t head = name.size();
    if (head < rest.size() && rest[head] == '(') head = std::min(rest.find(')', head), rest.size() - 1) + 1;
    return {std::string(name), fmt::format("-D{}={}", rest.substr(0, head), rest.substr(head))};
}

}  // namespace

HeaderLines header_lines(const std::vector<Directive>& block) {
    HeaderLines lines;
    for (const Directive& directive : block) lines.push_back(directive.text);
    return lines;
}

HeaderParts header_parts(const HeaderLines& directives) {
    return understand(directives).parts;
}

HeaderLines lines_of(const HeaderParts& parts) {
    HeaderLines lines = parts.settings;
    lines.insert(lines.end(), parts.includes.begin(), parts.includes.end());
    return lines;
}

std::optional<HeaderUse> use_of_header(const HeaderLines& header, const HeaderLines& directives) {
    const HeaderParts held = header_parts(header);
    const Understood own = understand(directives);
    const HeaderLines& includes = own.parts.includes;
    if (held.settings != own.parts.settings ||
        !std::includes(includes.begin(), includes.end(), held.includes.begin(), held.includes.end()))
        return {};
    HeaderUse use;
    std::vector<Macro> macros;
    for (std::size_t i = 0; i < own.directives; ++i) {
        const std::string& text = directives[i];
        if (is_define(text) && !is_setting(defined_name(text))) {
            macros.push_back(macro_of(text));
        } else if (is_define(text) ||
                   std::binary_search(held.includes.begin(), held.includes.end(), *in_any_order(text))) {
            use.replaced.push_back(i);
            use.own_macros = macros;
        }
    }
    return use;
}

}  // namespace harness
