// A page written where a person asked for it: nobody's file is lost to it.
#pragma once

#include <filesystem>
#include <string>

namespace harness {

/// Sees that a page can be written to `file` before anything is run: there is nothing, or an earlier page of
/// raygrade's, which may be replaced; a link is neither. Throws UsageError with the way out, in which `option` is what
/// named it.
void require_place_for_page(const std::filesystem::path& file, const std::string& option);

/// Writes the whole page or throws HarnessError; what was there before stays until the new one is complete.
void write_page(const std::filesystem::path& file, const std::string& page, const std::string& option);

}  // namespace harness
