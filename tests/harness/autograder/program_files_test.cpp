#include "harness/autograder/program_files.h"

#include <gmock/gmock.h>

#include <filesystem>

namespace harness::autograder {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::Field;
using testing::Not;
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

TEST(ProgramFiles, LeaveOutWhatTheMachineHas) {
    for (const ProgramFile& file : program_files()) {
        EXPECT_THAT(file.path, Not(testing::ContainsRegex("libraries/lib(c|m|stdc\\+\\+|gcc_s|archive)\\.so")));
        EXPECT_THAT(file.path, Not(StartsWith("libraries/ld-")));
    }
    EXPECT_TRUE(is_of_the_machine("ld-linux-aarch64.so.1"));
    EXPECT_FALSE(is_of_the_machine("libcsv.so.3")) << "not every library that begins with libc";
}

}  // namespace
}  // namespace harness::autograder
