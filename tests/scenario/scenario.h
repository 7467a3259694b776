// What scenario tests share: folders that go away, and the real raygrade run as a person would run it.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace scenario {

// The exit statuses other than 0, as README has them.
constexpr int some_not_graded = 1;
constexpr int usage = 2;

/// Prints the answer to question 5 alone, 10 of 100 points: quick to compile.
constexpr std::string_view small_program =
    "#include <cstdio>\nint main() { puts(\"Question 5:\\nV: vec3(0.000000, 0.000000, -1.000000)\"); }\n";

/// A new empty folder, removed with all that is in it at the end.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::filesystem::path operator/(const std::filesystem::path& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

/// Writes a file, and the folders above it that are missing.
void write(const std::filesystem::path& file, std::string_view text);
std::string read(const std::filesystem::path& file);
nlohmann::json read_json(const std::filesystem::path& file);

std::filesystem::path project_folder();
/// One of the sample class: a folder with ray_cast.cpp and expected.json.
std::filesystem::path sample(std::string_view who);

struct Result {
    int status = -1;     ///< the exit status, or 128 + the signal
    std::string output;  ///< stdout
    std::string voice;   ///< stderr
    std::string both() const { return output + voice; }
};

/// Called in the new process before raygrade takes its place there. Returns false when it could not do its work.
using Preparation = std::function<bool()>;

/// Runs build/raygrade with stdin from /dev/null; kills it after two minutes.
Result raygrade(const std::vector<std::string>& arguments, const Preparation& prepare = {});

/// File permissions count, also for root: without CAP_DAC_OVERRIDE root is held to them like everyone.
bool obey_permissions();
/// Takes raygrade's place in this process; the two files, which may be /dev/null, get stdout and stderr.
[[noreturn]] void become_raygrade(const std::vector<std::string>& arguments, const Preparation& prepare,
                                  const std::filesystem::path& output, const std::filesystem::path& voice);

/// Mounts a file system of `size` ("16m") on `folder`, seen by this process alone.
bool mount_disk(const std::filesystem::path& folder, const std::string& size);
/// One of a single page.
bool mount_tiny_disk(const std::filesystem::path& folder);
/// A PATH on which there is nothing.
bool forget_path();

/// Whether this machine holds the strongest sandbox; a container may not.
bool holds_bwrap();

/// What grades.json says of the submission called `id`; null when it says nothing.
nlohmann::json submission_in(const nlohmann::json& grades, std::string_view id);

}  // namespace scenario
