// Recognizes files that have a source's name but are not source text: exported documents, compiled programs, or text in
// an encoding that compilers don't read.
#pragma once

#include <string>
#include <string_view>

namespace harness {

/// Returns why the bytes are not C++ source and what to send instead, to follow a file's name: "is a PDF; …". Empty if
/// they may be source: the compiler reports everything else.
std::string why_no_source(std::string_view bytes);

}  // namespace harness
