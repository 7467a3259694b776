// The headers that students include, on this machine and on others.
#pragma once

#include <string>
#include <string_view>

namespace harness::report {

/// The header that the student probably meant by a missing one: the same letters, perhaps in another case or without
/// the folder, extension or slashes, or GLM's header at the end of a path to a copy of it. Empty if there is none.
std::string header_meant(std::string_view header);

/// Whether a header, a keyword or a name of std is newer than C++17.
bool is_of_newer_standard(std::string_view name);

/// "Windows", for a header of another system; else empty.
std::string_view system_of_header(std::string_view header);

/// The header that declares this name, for names such as std::setprecision where g++ 12 does not suggest a header; else
/// empty.
std::string_view header_of_name(std::string_view name);

}  // namespace harness::report
