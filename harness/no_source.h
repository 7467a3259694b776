// Files under a source's name that are none: what a student exported, built or saved in another way than a compiler
// reads.
#pragma once

#include <string>
#include <string_view>

namespace harness {

/// Why the bytes are no C++ source, to be said behind a file's name: "is a PDF; …", with what is wanted instead. Empty
/// when they may be one: all else that is wrong with it is the compiler's to say.
std::string why_no_source(std::string_view bytes);

}  // namespace harness
