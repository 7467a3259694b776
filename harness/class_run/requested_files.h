// Where the report files go that options of grade and check name, without replacing files of anybody else.
#pragma once

#include <filesystem>
#include <string_view>

namespace harness {

/// Checks that a report can be written to `file`. The path must end in `ending`, so that no source file is overwritten.
/// Does nothing if the path is empty. Throws UsageError, which names the option.
void require_place_for_report_file(const std::filesystem::path& file, std::string_view option, std::string_view ending);

/// Checks the same and removes an earlier report, so that none is there if the new one is never written. A symbolic
/// link is removed, not followed, because the folder may be a student's.
void prepare_report_file(const std::filesystem::path& file, std::string_view option, std::string_view ending);

}  // namespace harness
