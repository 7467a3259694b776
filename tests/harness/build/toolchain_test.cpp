#include "harness/build/toolchain.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "harness/build/build.h"
#include "harness/machine/errors.h"
#include "tests/given/temporary_folder.h"

namespace {

using harness::toolchain_fingerprint;

/// A stand-in compiler that describes itself as g++ does, with one folder of headers and one compiler part.
std::filesystem::path compiler_in(const TemporaryFolder& folder, const std::string& version) {
    const std::string here = folder.path().string();
    const auto file = folder.write(
        "g++", "#!/bin/sh\nexec >&2\necho version " + version + "\necho '#include <...> search starts here:'\necho ' " +
                   here + "/headers'\necho End of search list.\necho COMPILER_PATH=" + here + "/parts/\n");
    chmod(file.c_str(), 0755);
    return file;
}

struct Machine {
    TemporaryFolder folder;
    std::filesystem::path compiler = compiler_in(folder, "1");
    Machine() {
        folder.write("headers/glm/glm.hpp", "glm");
        folder.write("parts/cc1plus", "compiler");
    }
    std::string fingerprint() const { return toolchain_fingerprint(compiler); }
};

TEST(ToolchainFingerprint, IsTheSameWhileNothingChanges) {
    const Machine machine;
    EXPECT_EQ(machine.fingerprint(), machine.fingerprint());
    const auto real = harness::default_build_settings({}).compiler;
    EXPECT_EQ(toolchain_fingerprint(real), toolchain_fingerprint(real));
    EXPECT_NE(toolchain_fingerprint(real), machine.fingerprint());
}

TEST(ToolchainFingerprint, ChangesWithTheCompilersDescription) {
    const Machine machine;
    const std::string before = machine.fingerprint();
    const auto time = std::filesystem::last_write_time(machine.compiler);
    compiler_in(machine.folder, "2");
    std::filesystem::last_write_time(machine.compiler, time);
    EXPECT_NE(machine.fingerprint(), before);
}

TEST(ToolchainFingerprint, ChangesWithAPartOfTheCompiler) {
    const Machine machine;
    const std::string before = machine.fingerprint();
    machine.folder.write("parts/cc1plus", "another");
    EXPECT_NE(machine.fingerprint(), before);
}

TEST(ToolchainFingerprint, ChangesWithAHeader) {
    const Machine machine;
    const std::string before = machine.fingerprint();
    const auto file = machine.folder.write("headers/glm/glm.hpp", "GLM");
    const std::string edited = machine.fingerprint();
    EXPECT_NE(edited, before);
    std::filesystem::last_write_time(file, std::filesystem::file_time_type::clock::now() - std::chrono::hours(1));
    EXPECT_NE(machine.fingerprint(), edited);
}

TEST(ToolchainFingerprint, ChangesWithAnAddedOrRemovedHeader) {
    const Machine machine;
    const std::string before = machine.fingerprint();
    const auto file = machine.folder.write("headers/glm/new.hpp", "");
    EXPECT_NE(machine.fingerprint(), before);
    std::filesystem::remove(file);
    // The folder's own time has changed too, so the fingerprint stays different. That recompiles too much, never too
    // little.
    std::filesystem::remove(machine.folder.path() / "headers/glm/glm.hpp");
    EXPECT_NE(machine.fingerprint(), before);
}

TEST(ToolchainFingerprint, EndsIfFoldersAreLinkedInACircle) {
    const Machine machine;
    std::filesystem::create_directory_symlink("..", machine.folder.path() / "headers/glm/circle");
    EXPECT_EQ(machine.fingerprint(), machine.fingerprint());
}

TEST(ToolchainFingerprint, IsTheSameWhicheverThreadFindsAFolderFirst) {
    const Machine machine;
    machine.folder.write("elsewhere/deeper/y.hpp", "");
    for (const std::string folder : {"a", "b", "c", "d", "e", "f"}) {
        for (int i = 0; i < 50; ++i) machine.folder.write("headers/" + folder + "/x" + std::to_string(i) + ".hpp", "");
        std::filesystem::create_directory_symlink("../../elsewhere", machine.folder.path() / "headers" / folder / "to");
    }
    const std::string first = machine.fingerprint();
    for (int i = 0; i < 50; ++i) ASSERT_EQ(machine.fingerprint(), first);
}

TEST(ToolchainFingerprint, FollowsALinkToAFolder) {
    const Machine machine;
    machine.folder.write("elsewhere/linked.hpp", "a");
    std::filesystem::create_directory_symlink("../elsewhere", machine.folder.path() / "headers/linked");
    const std::string before = machine.fingerprint();
    machine.folder.write("elsewhere/linked.hpp", "ab");
    EXPECT_NE(machine.fingerprint(), before);
}

TEST(ToolchainFingerprint, ReportsAMissingCompiler) {
    EXPECT_THROW(toolchain_fingerprint("/nonexistent/g++"), harness::HarnessError);
}

}  // namespace
