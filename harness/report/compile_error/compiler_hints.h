// Advice on the most common mistakes that keep students' sources from compiling.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/record/graded.h"

namespace harness::report {

/// Sentences such as "Line 3: there is no * for a double and a glm::vec3; …", one for each fix, in the order of the
/// compiler's messages, at most `most`. Empty if there is no known mistake. Mistakes are found in the messages of g++
/// and the linkers that it calls; the source only helps to guess what the student meant. Both may contain any bytes,
/// and the sentences contain names from them.
std::vector<std::string> compiler_hints(std::string_view diagnostics, std::string_view source, std::size_t most = 5);

/// The same for a submission whose source does not compile; empty for any other.
std::vector<std::string> compiler_hints(const Graded& graded);

/// The hints and the first compiler messages, for a terminal; empty if there are no messages.
std::string compiler_text(const Graded& graded);

}  // namespace harness::report
