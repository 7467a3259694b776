// Makes the files with which an instructor sets up other systems' autograders to grade each hand-in with raygrade.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace harness::autograder {

/// The assignment and options for grading hand-ins.
struct Settings {
    std::string file_name;             ///< the assignment's: "my.toml"
    std::string toml;                  ///< the assignment's text
    std::vector<std::string> options;  ///< more words for `raygrade check`, without line breaks
};

/// Writes the zip for Gradescope (gradescope/autograder_samples, docs/specs.md): setup.sh, run_autograder, the
/// assignment and the running raygrade with its libraries, including the C library. setup.sh installs a compiler, GLM
/// and bubblewrap with apt. Throws HarnessError if one of raygrade's files can't be read or `out` can't be written.
void write_gradescope_zip(std::ostream& out, const Settings& settings);

struct TextFile {
    std::string path;  ///< relative: "assignment/my.toml"
    std::string text;
};

/// The files for CLASSROOM/autograders/ASSIGNMENT/ of a classroom50 repository: autograder.py, the assignment, and
/// runtime.json for `gh teacher assignment add --runtime`, which makes GitHub run them in the container image `image`.
std::vector<TextFile> classroom50_files(const Settings& settings, std::string_view image);

}  // namespace harness::autograder
