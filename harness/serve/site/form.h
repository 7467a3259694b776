// Parses the form for uploading a program: multipart/form-data (RFC 7578), as browsers write it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace harness::serve {

struct Part {
    std::string name;
    bool is_file = false;      ///< it has a file name
    std::string file_name{};   ///< as the browser sent it
    std::string_view content;  ///< a part of the body
};

/// The boundary in a Content-Type; empty for another type or a boundary that RFC 2046 does not allow.
std::optional<std::string> boundary_of(std::string_view content_type);

/// The parts of `body`; empty if it is incomplete, malformed or has more than a few parts. Takes linear time.
std::optional<std::vector<Part>> parts_of(std::string_view body, std::string_view boundary);

struct HandedIn {
    std::string source;   ///< empty if there is a problem
    std::string problem;  ///< a sentence for the student
    /// The file's name in printable characters, at most 100 bytes; "pasted text" if it was not a file.
    std::string file{};
};

/// The program of a form. Browsers end lines of pasted text with CR LF; this restores the line ends of a Linux file.
HandedIn source_of(std::string_view content_type, std::string_view body);

}  // namespace harness::serve
