// Reads the compiler's messages about a source. They are untrusted: a source can make the compiler print nearly
// anything.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace harness {

/// The name under which every source is compiled, so messages contain it.
inline constexpr const char* source_name = "ray_cast.cpp";

/// Whether each line of the compiler's messages is about, or quotes, a line of the source below `first`. Such a message
/// has the same text with and without a precompiled header, because the compiler reads the same source below the
/// directives. Other messages may differ: "In file included from", messages about a header's macro or template, about a
/// missing #include, and suggestions, because among equally near names the compiler picks the one it read first.
bool are_about_lines_below(std::size_t first, std::string_view messages);

/// The errors in lines of the source below `first`, according to the compiler.
std::vector<std::string> errors_below(std::size_t first, std::string_view messages);

}  // namespace harness
