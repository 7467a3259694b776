#include "harness/build/build.h"

#include <gmock/gmock.h>
#include <stdlib.h>

#include <stdexcept>

#include "harness/machine/errors.h"
#include "harness/run/limits.h"
#include "tests/given/message_of.h"
#include "tests/given/strongest_tier.h"
#include "tests/given/temporary_folder.h"

namespace {

using namespace std::chrono_literals;
using harness::Build;
using harness::Submission;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

Submission with_source(std::string source) {
    Submission submission;
    submission.id = "s01";
    submission.source = std::move(source);
    return submission;
}

harness::BuildSettings default_settings() {
    return harness::default_build_settings(harness::read_limits({}, {}).compile);
}

/// The strongest sandbox and a scratch folder in it.
class Folder {
  public:
    const std::filesystem::path& path() const { return scratch_.path(); }
    Build build(const Submission& submission, const harness::BuildSettings& settings = default_settings(),
                const std::optional<std::filesystem::path>& header = {}) const {
        return harness::build(submission, settings, sandbox_, scratch_, header);
    }

  private:
    harness::Sandbox sandbox_{strongest_tier()};
    harness::Scratch scratch_{sandbox_.workspace()};
};

Build compile(const std::string& source, const Folder& folder) {
    return folder.build(with_source(source));
}

TEST(Build, CompilesAProgram) {
    const Folder folder;
    const Build built = compile("int main() {}\n", folder);
    EXPECT_TRUE(built.tried);
    ASSERT_TRUE(built.program) << built.diagnostics;
    EXPECT_TRUE(built.program->is_absolute());
    EXPECT_EQ(built.diagnostics, "");
    EXPECT_GT(built.wall, 0ms);
}

TEST(Build, AcceptsGlmInEverySpelling) {
    const std::string use = "int main() { return glm::to_string(glm::vec3(1)).empty(); }\n";
    const std::string headers = "#include \"glm/glm.hpp\"\n#include <glm/gtx/string_cast.hpp>\n";
    for (const char* first : {"", "#define GLM_ENABLE_EXPERIMENTAL\n"}) {
        const Folder folder;
        const Build built = compile(first + headers + use, folder);
        EXPECT_TRUE(built.program) << first << built.diagnostics;
        EXPECT_EQ(built.diagnostics, "") << first;
    }
}

TEST(Build, KeepsWarningsAndTheProgram) {
    const Folder folder;
    const Build built =
        compile("#include <cstdio>\n#define GLM_ENABLE_EXPERIMENTAL 1\nint main() { int unused; }\n", folder);
    EXPECT_TRUE(built.program);
    EXPECT_THAT(built.diagnostics, HasSubstr("ray_cast.cpp:3:18: warning: unused variable 'unused'"));
    EXPECT_THAT(built.diagnostics, HasSubstr("\"GLM_ENABLE_EXPERIMENTAL\" redefined"));
}

TEST(Build, WarnsAboutAVectorThatWasNeverSet) {
    const Folder folder;
    const Build built =
        compile("#include <glm/glm.hpp>\n#include <iostream>\nint main() { glm::vec3 n; std::cout << n.x; }\n", folder);
    EXPECT_TRUE(built.program);
    EXPECT_THAT(built.diagnostics, HasSubstr("uninitialized"));
}

TEST(Build, GivesTheErrorsWithoutColoursAndWithoutTheScratchFolder) {
    const Folder folder;
    const Build built = compile("int main() { return undeclared; }\n", folder);
    EXPECT_TRUE(built.tried);
    EXPECT_FALSE(built.program);
    EXPECT_FALSE(built.reached_limit);
    EXPECT_THAT(built.diagnostics, HasSubstr("ray_cast.cpp:1:21: error: 'undeclared' was not declared"));
    EXPECT_THAT(built.diagnostics, Not(HasSubstr("\x1b[")));
    EXPECT_THAT(built.diagnostics, Not(HasSubstr(folder.path().string())));
}

TEST(Build, SkipsASubmissionWithAProblem) {
    const Folder folder;
    Submission submission = with_source("int main() {}");
    submission.problem = "unreadable";
    const Build built = folder.build(submission);
    EXPECT_FALSE(built.tried);
    EXPECT_FALSE(built.program);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

/// What the HarnessError says that a build throws.
std::string blame(const std::string& source, const harness::BuildSettings& settings) {
    return message_of<harness::HarnessError>([&] { Folder().build(with_source(source), settings); }, "(built)");
}

TEST(Build, ReportsThatTheCompilerRanOutOfTime) {
    std::string endless =
        "template <int K> constexpr int f() {\n int s = K;\n for (int i = 0; i < 5000; ++i)\n"
        " for (int j = 0; j < 1000; ++j) s ^= j;\n return s;\n}\nint main() {}\n";
    for (int i = 0; i < 60; ++i) endless += "static_assert(f<" + std::to_string(i) + ">() >= 0);\n";
    auto settings = default_settings();
    settings.limits.cpu = 1s;
    const Build built = Folder().build(with_source(endless), settings);
    EXPECT_TRUE(built.reached_limit);
    EXPECT_FALSE(built.program);
    // In some sandboxes g++ first prints that its subprocess was killed.
    EXPECT_THAT(built.diagnostics, EndsWith("raygrade: the compiler was stopped at the limit compile.cpu_seconds=1\n"));
}

TEST(Build, BlamesTheMachineIfAKnownProgramDoesNotCompileEither) {
    auto settings = default_settings();
    settings.limits.cpu = 100ms;
    EXPECT_THAT(blame("#include <bits/stdc++.h>\nint main() {}\n", settings), HasSubstr("compile.cpu_seconds=0.1"));
    settings.limits.cpu = 20s;
    settings.limits.wall = 50ms;
    EXPECT_THAT(blame("#include <bits/stdc++.h>\nint main() {}\n", settings), HasSubstr("compile.wall_seconds=0.05"));
    EXPECT_EQ(blame("int main() { return x; }\n", default_settings()), "(built)") << "that is the source's fault";
}

/// Builds a right source with a compiler that fails so often with these words, and then is g++. Outside of sandboxes,
/// where it can count.
Build build_after_failures(int times, const std::string& words,
                           const std::optional<std::filesystem::path>& header = {}) {
    const TemporaryFolder installation;
    auto settings = default_settings();
    settings.compiler = installation.write(
        "bin/g++", "#!/bin/sh\numask 0\ncd \"${0%/bin/*}\"\necho x >> tries\n[ $(wc -l < tries) -gt " +
                       std::to_string(times) + " ] || { echo '" + words +
                       "' >&2; exit 1; }\ncd - > /dev/null\nexec /usr/bin/g++ \"$@\"\n");
    for (const auto& path : {installation.path(), installation.path() / "bin", settings.compiler})
        std::filesystem::permissions(path, static_cast<std::filesystem::perms>(0777));
    const harness::Sandbox sandbox(harness::Tier::unsafe);
    const harness::Scratch scratch(sandbox.workspace());
    return harness::build(with_source("int main() {}\n"), settings, sandbox, scratch, header);
}

TEST(Build, RetriesAFailureAndReportsTheSecondIfAKnownProgramCompiles) {
    for (const char* words : {"cc1plus: out of space: No space left on device", "ray_cast.cpp:1:5: error: no x", ""}) {
        EXPECT_TRUE(build_after_failures(1, words).program) << words;
        EXPECT_FALSE(build_after_failures(2, words).program) << words;
        EXPECT_THROW(build_after_failures(9, words), harness::HarnessError) << words;
    }
}

TEST(Build, CountsAFailureWithAHeaderAsTheFirstOfTwo) {
    const std::filesystem::path header = "/usr/include/stdio.h";
    const std::string words = "ray_cast.cpp:1:5: error: no x";
    EXPECT_TRUE(build_after_failures(1, words, header).program);
    EXPECT_FALSE(build_after_failures(2, words, header).program) << "the third compile is that of the known program";
}

TEST(Build, ReportsAnErrorThatOccursWithAndWithoutTheHeader) {
    // Behind the header, this compiler adds an option. Without a known program that compiles, only both ways together
    // can tell that the source is wrong.
    const TemporaryFolder installation;
    auto settings = default_settings();
    settings.compiler = installation.write(
        "bin/g++", "#!/bin/sh\ngrep -q wrong ray_cast.cpp || exit 1\nexec /usr/bin/g++ -Wno-invalid-pch \"$@\"\n");
    for (const auto& path : {installation.path(), installation.path() / "bin", settings.compiler})
        std::filesystem::permissions(path, static_cast<std::filesystem::perms>(0777));
    const auto built = [&](const std::string& source, const std::optional<std::filesystem::path>& header) {
        const harness::Sandbox sandbox(harness::Tier::unsafe);
        const harness::Scratch scratch(sandbox.workspace());
        return harness::build(with_source(source), settings, sandbox, scratch, header).diagnostics;
    };
    const std::string source = "int main() { return wrong; }\n";
    EXPECT_THAT(built(source, "/usr/include/stdio.h"), HasSubstr("ray_cast.cpp:1:21: error: 'wrong' was not declared"));
    EXPECT_THROW(built(source, {}), harness::HarnessError);
    EXPECT_THROW(built("int wrong();\nint main() { return wrong(); }\n", "/usr/include/stdio.h"), harness::HarnessError)
        << "what the linker does not find may be the machine's fault";
}

TEST(Build, ReportsThatTheCompilersFileBecameTooLarge) {
    const Folder folder;
    const Build built = compile("char big[200000000] = {1};\nint main() { return big[1]; }\n", folder);
    EXPECT_TRUE(built.reached_limit) << built.diagnostics;
    EXPECT_FALSE(built.program);
    EXPECT_THAT(built.diagnostics, EndsWith("\nraygrade: the compiler crashed, as it does beyond the limits "
                                            "compile.stack_mib=64 and compile.file_mib=64\n"));
}

TEST(Build, BoundsTheMessages) {
    const Folder folder;
    std::string source = "int main() {\n";
    for (int i = 0; i < 800; ++i) source += "undeclared" + std::to_string(i) + ";\n";
    const Build built = compile(source + "}\n", folder);
    EXPECT_FALSE(built.program);
    EXPECT_FALSE(built.reached_limit);
    EXPECT_EQ(built.diagnostics.size(), 64U * 1024);
}

TEST(Build, HidesTheHarnessesEnvironmentFromTheCompiler) {
    const TemporaryFolder hidden;
    hidden.write("hidden/trap.h", "#error trapped\n");
    setenv("CPLUS_INCLUDE_PATH", (hidden.path() / "hidden").c_str(), 1);
    const Folder scratch;
    const Build built = compile("#if __has_include(<trap.h>)\n#error found\n#endif\nint main() {}\n", scratch);
    unsetenv("CPLUS_INCLUDE_PATH");
    EXPECT_TRUE(built.program) << built.diagnostics;
}

TEST(Build, GivesTheCompilerHugePages) {
    const TemporaryFolder installation;
    auto settings = default_settings();
    settings.compiler = installation.write("bin/g++", "#!/bin/sh\necho \"preloaded: $LD_PRELOAD\" >&2; exit 1\n");
    for (const auto& path : {installation.path(), installation.path() / "bin", settings.compiler})
        std::filesystem::permissions(path, static_cast<std::filesystem::perms>(0755));
    // The dynamic linker would print a message if it did not find the library.
    EXPECT_THAT(blame("", settings), AllOf(HasSubstr("The compiler said: preloaded: "), EndsWith("/huge_pages.so")));
}

TEST(Build, BlamesTheMachineWhenTheScratchFolderIsGone) {
    const Folder folder;
    std::filesystem::remove(folder.path());
    EXPECT_THROW(compile("int main() {}", folder), harness::HarnessError);
}

TEST(Build, FindsACompilerOutsideTheSystemFolders) {
    const TemporaryFolder installation;
    auto settings = default_settings();
    settings.compiler = installation.write("opt/bin/g++", "#!/bin/sh\ncat \"${0%/bin/*}/lib/words\" >&2; exit 1\n");
    installation.write("opt/lib/words", "from beside it");
    installation.write("opt/secret", "not for compilers");
    for (const char* name : {"", "opt", "opt/bin", "opt/lib"}) {
        std::filesystem::permissions(installation.path() / name, static_cast<std::filesystem::perms>(0755));
    }
    std::filesystem::permissions(settings.compiler, static_cast<std::filesystem::perms>(0755));
    EXPECT_THAT(blame("", settings), EndsWith("from beside it"));
    installation.write("opt/bin/g++", "#!/bin/sh\nls -A \"${0%/bin/*}\" >&2; exit 1\n");
    // "bin" and "lib", or that the folder may not be read.
    EXPECT_THAT(blame("", settings), AllOf(HasSubstr("The compiler said: "), Not(HasSubstr("secret"))));
}

/// A header of these lines in a folder that every account may read.
class Header {
  public:
    Header(const std::string& lines, const std::string& flags) {
        folder_.write("made/block.h", lines);
        for (const auto& path : {folder_.path(), folder_.path() / "made"})
            std::filesystem::permissions(path, static_cast<std::filesystem::perms>(0755));
        const std::string command = "g++ " + flags + " -x c++-header " + file().string();
        if (system(command.c_str()) != 0) throw std::runtime_error(command);
    }
    std::filesystem::path file() const { return folder_.path() / "made/block.h"; }

  private:
    TemporaryFolder folder_;
};

std::string default_flags() {
    std::string text;
    for (const auto& flag : default_settings().flags) text += flag + ' ';
    return text;
}

Build compile_with(const std::string& source, const std::filesystem::path& header) {
    const Folder folder;
    return folder.build(with_source(source), default_settings(), header);
}

TEST(BuildWithAHeader, FallsBackToAPlainBuildIfTheHeaderDoesNotFit) {
    const std::string source = "#include <cstdio>\nint main() {}\n";
    const Header other_flags("#include <cstdio>\n", "-std=c++20 -O3");
    const Header cut_off("#include <cstdio>\n", default_flags());
    std::filesystem::resize_file(cut_off.file().string() + ".gch", 100000);
    for (const Header* header : {&other_flags, &cut_off}) {
        const Build built = compile_with(source, header->file());
        EXPECT_TRUE(built.compiled);
        EXPECT_FALSE(built.by_header);
        EXPECT_EQ(built.diagnostics, "");
    }
}

TEST(Build, SaysHowToGetACompiler) {
    const Folder folder;
    const std::string path = getenv("PATH");
    setenv("PATH", "/nonexistent", 1);
    const auto settings = default_settings();
    const auto message =
        message_of<harness::HarnessError>([&] { folder.build(with_source("int main() {}"), settings); }, "(built)");
    setenv("PATH", path.c_str(), 1);
    EXPECT_THAT(message, HasSubstr("apt install g++"));
}

}  // namespace
