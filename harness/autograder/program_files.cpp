#include "harness/autograder/program_files.h"

#include <link.h>

#include <algorithm>
#include <string_view>

#include "harness/machine/parts.h"

namespace harness::autograder {
namespace {

namespace fs = std::filesystem;

/// The paths of the shared libraries of this process, including the loader. Their file names are those that the loader
/// looks for.
std::vector<fs::path> loaded_libraries() {
    std::vector<fs::path> found;
    dl_iterate_phdr(
        [](dl_phdr_info* info, std::size_t, void* list) {
            const std::string_view name = info->dlpi_name == nullptr ? "" : info->dlpi_name;
            if (name.starts_with('/')) static_cast<std::vector<fs::path>*>(list)->emplace_back(name);
            return 0;
        },
        &found);
    return found;
}

/// Adds a file, or all files below a folder.
void add_part(std::vector<ProgramFile>& files, const std::string& path) {
    const fs::path from = find_part(path);
    if (!fs::is_directory(from)) {
        files.push_back({path, from, true});
        return;
    }
    // The folder may be a link, as in a build.
    for (const auto& entry : fs::recursive_directory_iterator(fs::canonical(from))) {
        if (!entry.is_regular_file()) continue;
        files.push_back({path + "/" + entry.path().lexically_relative(fs::canonical(from)).string(), entry.path()});
    }
}

}  // namespace

std::vector<ProgramFile> program_files() {
    std::vector<ProgramFile> files{{"bin/raygrade", fs::read_symlink("/proc/self/exe"), true}};
    for (const std::string& part : parts()) add_part(files, part);
    for (const fs::path& library : loaded_libraries()) {
        const std::string name = library.filename().string();
        files.push_back({"libraries/" + name, library, name.starts_with("ld")});
    }
    std::ranges::sort(files, {}, &ProgramFile::path);
    return files;
}

}  // namespace harness::autograder
