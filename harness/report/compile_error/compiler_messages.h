// The compiler's messages, by source line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace harness::report {

struct CompilerMessage {
    int line = 0;      ///< of the source, 1-based
    std::string kind;  ///< "error" or "warning"
    std::string text;  ///< untrusted bytes, as the compiler wrote them
};

/// The errors and warnings about the submission's own lines, errors first, at most `most` of them. Leaves out messages
/// about headers and continuation lines; the complete messages show them.
std::vector<CompilerMessage> compiler_messages(std::string_view diagnostics, std::size_t most = 20);

/// The first 40 lines of the compiler's messages, each with its line break, and the number of lines left out: pages of
/// candidates would push the helpful lines out of sight.
std::string first_messages(std::string_view diagnostics);

/// At most `most` bytes of a text from a submission, cut at the end of a line if possible.
std::string beginning_of(const std::string& text, std::size_t most);

}  // namespace harness::report
