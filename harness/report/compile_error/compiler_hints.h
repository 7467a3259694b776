// What to do about the mistakes for which students' sources most often do not compile.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/record/graded.h"

namespace harness::report {

/// Sentences such as "Line 3: there is no * for a double and a glm::vec3; …", one for each thing to do, in the order of
/// the compiler's messages, at most `most`. Empty if none of the known mistakes is among them. They are found in the
/// messages of g++ and of the linkers that it calls; the source only tells what was probably meant. Both may contain
/// any bytes, and the sentences contain names from them.
std::vector<std::string> compiler_hints(std::string_view diagnostics, std::string_view source, std::size_t most = 5);

/// The same for a submission whose source does not compile; empty for any other.
std::vector<std::string> compiler_hints(const Graded& graded);

/// These, and the first of what the compiler said, for a terminal; empty if it said nothing.
std::string compiler_text(const Graded& graded);

}  // namespace harness::report
