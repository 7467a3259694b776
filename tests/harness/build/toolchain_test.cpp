#include "harness/build/toolchain.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <functional>

#include "harness/build/build.h"
#include "harness/machine/errors.h"
#include "tests/given/temporary_folder.h"

namespace {

using namespace std::chrono_literals;

std::string toolchain_fingerprint(const std::filesystem::path& compiler) {
    return harness::examine_toolchain(compiler).fingerprint;
}

/// A stand-in compiler that describes itself as g++ does, with one folder of headers and one compiler part.
std::filesystem::path compiler_in(const TemporaryFolder& folder, const std::string& version) {
    const std::string here = folder.path().string();
    const auto file =
        folder.write("g++", "#!/bin/sh\nexec >&2\necho gcc version " + version +
                                "\necho '#include <...> search starts here:'\necho ' " + here +
                                "/headers'\necho End of search list.\necho COMPILER_PATH=" + here + "/parts/\n");
    chmod(file.c_str(), 0755);
    return file;
}

struct FakeToolchain {
    TemporaryFolder folder;
    std::filesystem::path compiler = compiler_in(folder, "1");
    FakeToolchain() {
        folder.write("headers/glm/glm.hpp", "glm");
        folder.write("parts/cc1plus", "compiler");
    }
    std::string fingerprint() const { return toolchain_fingerprint(compiler); }
};

TEST(ToolchainFingerprint, IsTheSameWhileNothingChanges) {
    const FakeToolchain toolchain;
    EXPECT_EQ(toolchain.fingerprint(), toolchain.fingerprint());
    const auto real = harness::default_build_settings({}).compiler;
    EXPECT_EQ(toolchain_fingerprint(real), toolchain_fingerprint(real));
    EXPECT_NE(toolchain_fingerprint(real), toolchain.fingerprint());
}

TEST(ToolchainName, IsTheVersionThatTheCompilerStates) {
    const TemporaryFolder folder;
    EXPECT_EQ(harness::examine_toolchain(compiler_in(folder, "'14.2.0 (Debian 14.2.0-19) '")).name,
              "g++ 14.2.0 (Debian 14.2.0-19)");
    const auto mute = folder.write("mute", "#!/bin/sh\n");
    chmod(mute.c_str(), 0755);
    EXPECT_EQ(harness::examine_toolchain(mute).name, mute.string());
    EXPECT_EQ(harness::examine_toolchain(harness::default_build_settings({}).compiler).name.substr(0, 4), "g++ ");
}

TEST(ToolchainFingerprint, ChangesWithTheCompilerItsPartsAndItsHeaders) {
    const FakeToolchain toolchain;
    const TemporaryFolder& folder = toolchain.folder;
    const auto header = folder.path() / "headers/glm/glm.hpp";
    const std::pair<const char*, std::function<void()>> changes[] = {
        {"a compiler as old that describes itself otherwise",
         [&] {
             const auto time = std::filesystem::last_write_time(toolchain.compiler);
             compiler_in(folder, "2");
             std::filesystem::last_write_time(toolchain.compiler, time);
         }},
        {"a part of the compiler", [&] { folder.write("parts/cc1plus", "another"); }},
        {"a header's content", [&] { folder.write("headers/glm/glm.hpp", "GLM"); }},
        {"its time", [&] { last_write_time(header, std::filesystem::file_time_type::clock::now() - 1h); }},
        {"another header", [&] { folder.write("headers/glm/new.hpp", ""); }},
        {"one less", [&] { std::filesystem::remove(header); }},
        {"a link to a folder",
         [&] {
             folder.write("elsewhere/linked.hpp", "a");
             std::filesystem::create_directory_symlink("../elsewhere", folder.path() / "headers/linked");
         }},
        {"a header behind it", [&] { folder.write("elsewhere/linked.hpp", "ab"); }},
    };
    for (const auto& [what, change] : changes) {
        const std::string before = toolchain.fingerprint();
        change();
        EXPECT_NE(toolchain.fingerprint(), before) << what;
    }
}

TEST(ToolchainFingerprint, EndsIfFoldersAreLinkedInACircle) {
    const FakeToolchain toolchain;
    std::filesystem::create_directory_symlink("..", toolchain.folder.path() / "headers/glm/circle");
    EXPECT_EQ(toolchain.fingerprint(), toolchain.fingerprint());
}

TEST(ToolchainFingerprint, ReportsAMissingCompiler) {
    EXPECT_THROW(toolchain_fingerprint("/nonexistent/g++"), harness::HarnessError);
}

}  // namespace
