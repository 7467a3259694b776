// What the compiler's messages tell of the source. They are a stranger's text: a source can make the
// compiler say nearly anything.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace harness {

/// The name under which every source is compiled, and which messages give it.
inline constexpr const char* source_name = "ray_cast.cpp";

/// Whether each line of the compiler's messages is about, or quotes, a line of the source below `first`. Then it has
/// the same text with a precompiled header and without, as below the directives the compiler reads the same source. Not
/// so of "In file included from", of what a macro or a template of a header's is, of a missing #include, and of a
/// suggestion: of names as near, the compiler takes the one that it read first.
bool are_about_lines_below(std::size_t first, std::string_view messages);

/// The errors in lines of the source below `first`, as the compiler tells them.
std::vector<std::string> errors_below(std::size_t first, std::string_view messages);

}  // namespace harness
