// Finds the literal #define and #include lines at the beginning of a source, which a precompiled header may replace.
//
// A precompiled header must never change a source's meaning. So a doubtful directive ends the block.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace harness {

/// One directive of the block.
struct Directive {
    std::string text;   ///< with normalized blanks and without a comment after it, e.g. "#include <cmath>"
    std::size_t begin;  ///< offset of its '#' in the source
    std::size_t end;    ///< offset after its last character that is not a blank
};

/// The source's leading directives, in order; comments and empty lines may come between them. Anything but a plain
/// directive ends the block. Plain means: no directive or comment continues in the next line with a backslash, no
/// #define contains a literal, and each #include names a system header (in angle brackets, or in quotes with a folder,
/// such as "glm/glm.hpp"). Empty if the source uses __COUNTER__, __FILE__, __DATE__ or the like, or has a pragma: a
/// precompiled header could then change its meaning.
std::vector<Directive> include_block(std::string_view source);

}  // namespace harness
