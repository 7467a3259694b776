// The running raygrade as files that can be copied to a different machine.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace harness::autograder {

struct ProgramFile {
    std::string path;  ///< relative destination: "bin/raygrade", "lib/raygrade/raygrade-canary"
    std::filesystem::path from;
    bool is_executable = false;
};

/// All files that this raygrade needs to start on any Linux machine of the same architecture: the program, its parts
/// (harness/machine/parts.h), and, under libraries/, its loaded shared libraries, including the C library and its
/// loader. The loader is the only executable file there whose name begins with "ld". Start the program with that
/// loader, because the machine's own may be older. Sorted by path. Throws HarnessError if a part is missing.
std::vector<ProgramFile> program_files();

}  // namespace harness::autograder
