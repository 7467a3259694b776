// The folder that a command writes its results to: never over anybody else's files.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>

namespace harness {

enum class Replace { no, yes };

/// Makes the folder and, where `feedback` names one, that folder in it. It is new, empty, or holds the results of an
/// earlier run, known by the file `mark`, that may be replaced. Throws UsageError.
void prepare_results(const std::filesystem::path& out, const std::string& mark, Replace replace,
                     const std::string& feedback = "");

/// Writes a whole file or throws HarnessError; what was there before stays until the new one is complete.
void write_file(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);
void write_file(const std::filesystem::path& file, const std::string& text);

}  // namespace harness
