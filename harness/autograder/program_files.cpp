#include "harness/autograder/program_files.h"

#include <link.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "harness/machine/parts.h"

namespace harness::autograder {
namespace {

namespace fs = std::filesystem;

/// The paths of the shared libraries of this process; their file names are those under which the linker looks for them.
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

/// Adds a part that is a file, or the files below one that is a folder.
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

bool is_of_the_machine(const std::string& name) {
    constexpr std::array beginnings{// C and C++
                                    "ld-linux", "ld64", "libc.so", "libm.so", "libmvec.so", "libpthread.so", "libdl.so",
                                    "librt.so", "libstdc++.so", "libgcc_s.so", "libatomic.so",
                                    // libarchive and what it needs
                                    "libarchive.so", "libacl.so", "libattr.so", "libxml2.so", "libicu", "libnettle.so",
                                    "liblzma.so", "liblz4.so", "libzstd.so", "libbz2.so", "libz.so"};
    return std::ranges::any_of(beginnings, [&](const char* beginning) { return name.starts_with(beginning); });
}

std::vector<ProgramFile> program_files() {
    std::vector<ProgramFile> files{{"bin/raygrade", fs::read_symlink("/proc/self/exe"), true}};
    for (const std::string& part : parts()) add_part(files, part);
    for (const fs::path& library : loaded_libraries()) {
        const std::string name = library.filename().string();
        if (!is_of_the_machine(name)) files.push_back({"libraries/" + name, library});
    }
    std::ranges::sort(files, {}, &ProgramFile::path);
    return files;
}

}  // namespace harness::autograder
