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

/// Everything that this raygrade needs to start on any Linux machine of the same architecture: the program, its parts
/// (harness/machine/parts.h), and under libraries/ the shared libraries it has loaded, with the C library and its
/// loader, which is the only file there whose name begins with "ld" and is executable. The program is to be started by
/// that loader, since the machine's own may be older. Sorted by path. Throws HarnessError if a part is missing.
std::vector<ProgramFile> program_files();

}  // namespace harness::autograder
