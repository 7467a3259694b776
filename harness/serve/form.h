// The form that carries a program: multipart/form-data (RFC 7578), as browsers write it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace harness::serve {

struct Part {
    std::string name;
    bool is_file = false;      ///< it came with a file's name
    std::string file_name{};   ///< as it came
    std::string_view content;  ///< in the body
};

/// The boundary that a Content-Type names; empty for another type or a boundary that RFC 2046 does not allow.
std::optional<std::string> boundary_of(std::string_view content_type);

/// The parts of `body`; empty when it is not whole and well-formed, or has more than a few parts. Linear in its size.
std::optional<std::vector<Part>> parts_of(std::string_view body, std::string_view boundary);

struct HandedIn {
    std::string source;   ///< empty when there is a problem
    std::string problem;  ///< a sentence for the student
    /// The name of the file, in printable characters and at most 100 bytes; "pasted text" for what is none.
    std::string file{};
};

/// The program of a form. What was pasted, whose lines browsers end in CR LF, has the same bytes as the file it was
/// copied from on Linux.
HandedIn source_of(std::string_view content_type, std::string_view body);

}  // namespace harness::serve
