#include "harness/autograder/program_files.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

namespace harness::autograder {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::Field;
using testing::StartsWith;

TEST(ProgramFiles, HaveTheProgramItsPartsAndItsLibraries) {
    const auto files = program_files();
    const auto has = [](const char* path, bool is_executable) {
        return Contains(
            testing::AllOf(Field(&ProgramFile::path, path), Field(&ProgramFile::is_executable, is_executable)));
    };
    EXPECT_THAT(files, has("bin/raygrade", true));
    EXPECT_THAT(files, has("lib/raygrade/raygrade-supervisor", true));
    EXPECT_THAT(files, has("share/raygrade/manual/index.md", false)) << "the folder is a link in a build";
    EXPECT_THAT(files, Contains(Field(&ProgramFile::path, StartsWith("libraries/libsodium.so"))))
        << "this program has loaded it";
    for (const ProgramFile& file : files) EXPECT_TRUE(fs::is_regular_file(file.from)) << file.path;
}

TEST(ProgramFiles, HaveTheCLibraryAndOneLoader) {
    const auto files = program_files();
    EXPECT_THAT(files, Contains(Field(&ProgramFile::path, StartsWith("libraries/libc.so"))));
    EXPECT_EQ(
        std::ranges::count_if(files, [](const ProgramFile& file) { return file.path.starts_with("libraries/ld"); }), 1);
    EXPECT_EQ(
        std::ranges::count_if(
            files, [](const ProgramFile& file) { return file.path.starts_with("libraries/") && file.is_executable; }),
        1);
}

}  // namespace
}  // namespace harness::autograder
