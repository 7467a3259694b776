// The headers that students include: those of this machine, and those of others.
#pragma once

#include <string>
#include <string_view>

namespace harness::report {

/// The header that was probably meant by one that is not there: the same letters, perhaps in another case or without
/// its folder, its ending or its slashes, or GLM's header at the end of a path to a copy of it. Empty if there is none.
std::string header_meant(std::string_view header);

/// Whether a header, a keyword or a name of std is newer than C++17.
bool is_of_newer_standard(std::string_view name);

/// "Windows", for a header of another system; else empty.
std::string_view system_of_header(std::string_view header);

/// The header that declares a name for which g++ 12 does not say it, such as std::setprecision; else empty.
std::string_view header_of_name(std::string_view name);

}  // namespace harness::report
