#include "harness/build/header_use.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "harness/build/include_block.h"

namespace harness {
namespace {

/// The headers of C++17, and the C headers that C++ defines again, except <complex.h> and <tgmath.h>, whose macros have
/// names as short as I.
constexpr std::string_view standard_headers =
    " algorithm any array assert.h atomic bits/stdc++.h bitset cassert cctype cerrno cfenv cfloat"
    " charconv chrono cinttypes climits clocale cmath complex condition_variable csetjmp csignal cstdarg"
    " cstddef cstdint cstdio cstdlib cstring ctime ctype.h cuchar cwchar cwctype deque errno.h exception"
    " execution fenv.h filesystem float.h forward_list fstream functional future initializer_list"
    " inttypes.h iomanip ios iosfwd iostream istream iterator limits limits.h list locale locale.h map"
    " math.h memory memory_resource mutex new numeric optional ostream queue random ratio regex"
    " scoped_allocator set shared_mutex signal.h sstream stack stdarg.h stddef.h stdexcept stdint.h"
    " stdio.h stdlib.h streambuf string string.h string_view system_error thread time.h tuple type_traits"
    " typeindex typeinfo unordered_map unordered_set utility valarray variant vector wchar.h wctype.h ";

/// The compiler spends nearly all of its time for a student's headers on these. With the two that most programs include
/// precompiled, a source compiles in 0.52 of the time; with all of its headers, in 0.46.
constexpr std::string_view slow_headers = " bits/stdc++.h glm/glm.hpp iostream ";

/// This header of GLM compiles only after another one.
constexpr std::string_view incomplete = "glm/gtx/fast_trigonometry.hpp";

constexpr std::string_view define = "#define ";
constexpr std::string_view include = "#include ";

bool is_define(std::string_view directive) {
    return directive.starts_with(define);
}

/// The text after #define, up to the end of the name.
std::string_view defined_name(std::string_view directive) {
    directive.remove_prefix(define.size());
    return directive.substr(0, directive.find_first_of(" \t("));
}

/// The course's flags define this macro anyway.
constexpr std::string_view known_macro = "GLM_ENABLE_EXPERIMENTAL";

/// Whether headers read the macro or may read it: names that begin with an underscore are reserved for them.
bool is_setting(std::string_view name) {
    return name.starts_with("_") || name == "NDEBUG" || name.starts_with("GLM_");
}

bool contains(std::string_view list, std::string_view name) {
    return list.find(fmt::format(" {} ", name)) != std::string_view::npos;
}

/// The header's name. A name in quotes with a folder is not a file of the student's, see include_block.h.
std::string_view included_name(std::string_view directive) {
    return directive.substr(include.size() + 1, directive.size() - include.size() - 2);
}

/// Whether the header means the same before and after any other.
bool is_for_any_order(std::string_view name) {
    return (name.starts_with("glm/") && name != incomplete) || contains(standard_headers, name);
}

}  // namespace

HeaderUse header_use(std::string_view source) {
    HeaderUse use{{}, std::string(source), 0};
    HeaderLines settings, includes;
    std::size_t end = 0;
    bool is_after_header = false;
    for (const Directive& directive : include_block(source)) {
        if (is_define(directive.text)) {
            const std::string_view name = defined_name(directive.text);
            if (name == known_macro) continue;
            if (!is_setting(name) || is_after_header) break;
            settings.push_back(directive.text);
        } else {
            const std::string_view name = included_name(directive.text);
            if (!is_for_any_order(name)) break;
            is_after_header = true;
            if (!contains(slow_headers, name)) continue;
            includes.push_back(fmt::format("#include <{}>", name));
        }
        use.rest.replace(directive.begin, directive.end - directive.begin, directive.end - directive.begin, ' ');
        end = directive.end;
    }
    if (includes.empty()) return {{}, std::string(source), 0};
    std::sort(includes.begin(), includes.end());
    includes.erase(std::unique(includes.begin(), includes.end()), includes.end());
    use.lines = std::move(settings);
    use.lines.insert(use.lines.end(), includes.begin(), includes.end());
    use.last_line = 1 + static_cast<std::size_t>(std::ranges::count(source.substr(0, end), '\n'));
    return use;
}

}  // namespace harness
