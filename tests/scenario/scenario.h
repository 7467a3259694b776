// Shared by the scenario tests: temporary folders, and runs of the real raygrade as a person would start it.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tests/given/temporary_folder.h"

namespace scenario {

// The exit statuses other than 0, as manual/sandbox-and-limits.md lists them.
constexpr int some_not_graded = 1;
constexpr int usage = 2;

/// Prints only the answer to question 5, worth 10 of 100 points. Compiles quickly.
constexpr std::string_view small_program =
    "#include <cstdio>\nint main() { puts(\"Question 5:\\nV: vec3(0.000000, 0.000000, -1.000000)\"); }\n";

using ::TemporaryFolder;

/// Writes a file, and creates missing parent folders.
void write(const std::filesystem::path& file, std::string_view text);
std::string read(const std::filesystem::path& file);
nlohmann::json read_json(const std::filesystem::path& file);

std::filesystem::path project_folder();
/// A submission of the sample class: a folder with ray_cast.cpp and expected.json.
std::filesystem::path sample(std::string_view who);

struct Result {
    int status = -1;     ///< the exit status, or 128 + the signal
    std::string output;  ///< stdout
    std::string voice;   ///< stderr
    std::string both() const { return output + voice; }
};

/// Called in the new process before it executes raygrade. Returns false on failure.
using Preparation = std::function<bool()>;

/// Runs build/raygrade with stdin from /dev/null; kills it after four minutes. What programs print is kept for all
/// tests, so that each of them is compiled once.
Result raygrade(const std::vector<std::string>& arguments, const Preparation& prepare = {});
/// The same, but everything is compiled and run.
Result raygrade_from_scratch(const std::vector<std::string>& arguments, const Preparation& prepare = {});
/// Lets raygrade keep its results in this folder. For a test that compares what runs measured: in the folder of all
/// tests another test may replace it in between.
Preparation with_cache(const std::filesystem::path& folder);
/// One after the other; the second may be empty.
Preparation both(const Preparation& first, const Preparation& second);

/// Makes file permissions apply to root too, by dropping CAP_DAC_OVERRIDE.
bool obey_permissions();
/// Replaces this process by raygrade. Writes stdout and stderr to the two files, which may be /dev/null. Its cache is
/// beside the second one, unless `prepare` says otherwise.
[[noreturn]] void become_raygrade(const std::vector<std::string>& arguments, const Preparation& prepare,
                                  const std::filesystem::path& output, const std::filesystem::path& voice);

/// Mounts a file system of `size` ("16m") on `folder`. Only this process sees it.
bool mount_disk(const std::filesystem::path& folder, const std::string& size);
/// Mounts a file system of a single page.
bool mount_tiny_disk(const std::filesystem::path& folder);
/// Sets PATH to a place without any program.
bool forget_path();

/// Whether the strongest sandbox works on this machine; in a container it may not.
bool holds_bwrap();

/// The entry of grades.json for the submission `id`; null if there is none.
nlohmann::json submission_in(const nlohmann::json& grades, std::string_view id);
/// The items that a list of grades.json names, as "question.item".
std::set<std::string> item_names(const nlohmann::json& items);

}  // namespace scenario
