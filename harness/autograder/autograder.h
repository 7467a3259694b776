// Autograders of other systems: what an instructor gives them, so that they grade each hand-in with raygrade.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace harness::autograder {

/// What hand-ins are graded with.
struct Settings {
    std::string file_name;             ///< of the assignment: "my.toml"
    std::string toml;                  ///< its text
    std::vector<std::string> options;  ///< more words for `raygrade check`, without line breaks
};

/// Writes the zip for Gradescope (gradescope/autograder_samples, docs/specs.md): setup.sh, run_autograder, the
/// assignment and the running raygrade with its libraries, the C library among them. setup.sh installs a compiler, GLM
/// and bubblewrap by apt. Throws HarnessError if a file of raygrade's can't be read or `out` not be written.
void write_gradescope_zip(std::ostream& out, const Settings& settings);

struct TextFile {
    std::string path;  ///< relative: "assignment/my.toml"
    std::string text;
};

/// The files for CLASSROOM/autograders/ASSIGNMENT/ of a classroom50 repository: autograder.py and the assignment; and
/// runtime.json for `gh teacher assignment add --runtime`, by which GitHub runs them in the container image `image`.
std::vector<TextFile> classroom50_files(const Settings& settings, std::string_view image);

}  // namespace harness::autograder
