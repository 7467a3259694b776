// The running raygrade as files that can be put on a different machine.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace harness::autograder {

struct ProgramFile {
    std::string path;  ///< where it belongs, relative: "bin/raygrade", "lib/raygrade/raygrade-canary"
    std::filesystem::path from;
    bool is_executable = false;
};

/// Everything that this raygrade needs on a machine that has its C and C++ libraries, libarchive, and what submissions
/// need: the program, its parts (harness/machine/parts.h), and under libraries/ the shared libraries that it has
/// loaded. These go along because distributions have them in different versions. Sorted by path. Throws HarnessError if
/// a part is missing.
std::vector<ProgramFile> program_files();

/// Whether every machine that can run raygrade has the library `name`, such as "libc.so.6", in a version of its own:
/// the C and C++ libraries, and libarchive with what it needs.
bool is_of_the_machine(const std::string& name);

}  // namespace harness::autograder
