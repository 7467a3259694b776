// The gate: a precompiled header and huge pages for the compiler change only the time. Three sample submissions with a
// dozen warnings (nightly: every sample and every labelled program, with them and without) and every eighth probe
// (nightly: each) is compiled with and without the header and run, samples with the usual errors are compiled both
// ways, and the samples (nightly: the probes too) are compiled by g++ alone; messages and output must be byte for byte
// the same, and so must the program where the source has its includes in the header's order, else its functions.
#include <gmock/gmock.h>
#include <stdlib.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <sstream>

#include "harness/build/header_cache.h"
#include "harness/build/header_use.h"
#include "harness/run/limits.h"
#include "harness/run/run.h"
#include "tests/given/bytes_of.h"
#include "tests/given/cases.h"
#include "tests/given/strongest_tier.h"
#include "tests/given/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using harness::Build;
using harness::BuildSettings;

/// One of `by_day`; nightly all of them.
std::vector<fs::path> some_of(std::vector<fs::path> files, std::size_t by_day) {
    std::sort(files.begin(), files.end());
    if (is_nightly()) return files;
    std::vector<fs::path> some;
    for (std::size_t i = 0; i < files.size(); i += by_day) some.push_back(files[i]);
    return some;
}

std::vector<fs::path> samples() {
    std::vector<fs::path> files;
    std::vector<std::string> folders{"submissions"};
    if (is_nightly()) {
        for (const char* labelled : {"edge", "miss", "offaxis"})
            folders.push_back(std::string("tests/given/labelled/") + labelled);
    }
    for (const std::string& folder : folders) {
        for (const auto& entry : fs::directory_iterator(fs::path(RAYGRADE_PROJECT) / folder)) {
            if (fs::exists(entry.path() / "ray_cast.cpp")) files.push_back(entry.path() / "ray_cast.cpp");
        }
    }
    return some_of(std::move(files), 20);
}

std::vector<fs::path> probes() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(fs::path(RAYGRADE_PROJECT) / "tests/given/probes"))
        files.push_back(entry.path());
    return some_of(std::move(files), 8);
}

/// The results of compiling and running a source.
struct Result {
    bool by_header = false;
    bool compiled = false;
    std::string diagnostics, program, output;
};

/// A program's functions, each as its instructions without addresses, sorted: neither the order of functions counts nor
/// where a constant lies.
std::vector<std::string> functions_of(const std::string& program) {
    const TemporaryFolder folder;
    const std::string file = folder.write("program", program).string();
    std::ostringstream command;
    command
        << "objdump -d -j .text --no-show-raw-insn " << file
        << " | sed -E 's/^ *[0-9a-f]+:\\t//; s/^[0-9a-f]+ (<.*>:)$/\\1/; s/# [0-9a-f]+ <[^>]*\\+0x[0-9a-f]+>/# data/; "
           "s/ [0-9a-f]+ <([^>]*)>/ <\\1>/; s/-?0x[0-9a-f]+\\(%rip\\)/(%rip)/' >"
        << file << ".text";
    if (system(command.str().c_str()) != 0) throw std::runtime_error(command.str());
    std::vector<std::string> functions(1);
    std::istringstream text(bytes_of(file + ".text"));
    for (std::string line; std::getline(text, line);) {
        if (line.empty()) {
            functions.emplace_back();
        } else if (line != "nop") {  // between functions
            functions.back() += line + '\n';
        }
    }
    std::erase_if(functions, [](const std::string& function) { return !function.starts_with('<'); });
    if (functions.empty()) throw std::runtime_error("no functions in " + file);
    std::sort(functions.begin(), functions.end());
    return functions;
}

class Precompiled : public testing::TestWithParam<fs::path> {
  protected:
    /// Shared by all tests, so that each header is made only once.
    struct Machine {
        BuildSettings settings = harness::default_build_settings(harness::read_limits({}, {}).compile);
        harness::Limits limits = harness::read_limits({}, {}).run;
        harness::Sandbox sandbox{strongest_tier()};
        harness::HeaderCache cache{{}, settings, "", sandbox};
    };
    static Machine& machine() {
        static Machine machine;
        return machine;
    }

    /// Without a header. Remembered, because two tests want it.
    static const Result& compile_plainly(const std::string& source) {
        static std::map<std::string, Result> known;
        const auto [place, is_new] = known.try_emplace(source);
        if (is_new) place->second = compile(source, {});
        return place->second;
    }

    static Result compile(const std::string& source, const std::optional<fs::path>& header) {
        harness::Submission submission;
        submission.source = source;
        const harness::Scratch scratch(machine().sandbox.workspace());
        const Build build = harness::build(submission, machine().settings, machine().sandbox, scratch, header);
        Result result{build.by_header, build.compiled, build.diagnostics, "", ""};
        if (!build.program) return result;
        result.program = bytes_of(*build.program);
        result.output = harness::run(build, machine().limits, machine().sandbox, scratch).output;
        return result;
    }

    /// By g++ as it stands, outside of any sandbox: the samples are no attacks.
    static Result compile_alone(const std::string& source) {
        const TemporaryFolder folder;
        folder.write("ray_cast.cpp", source);
        std::string command = "cd " + folder.path().string() + " && LANG=C.UTF-8 LC_ALL=C g++";
        for (const auto& words : {machine().settings.flags, machine().settings.linker}) {
            for (const std::string& word : words) command += ' ' + word;
        }
        Result result;
        result.compiled = system((command + " -o ray_cast ray_cast.cpp 2>messages").c_str()) == 0;
        result.diagnostics = bytes_of(folder.path() / "messages");
        if (result.compiled) result.program = bytes_of(folder.path() / "ray_cast");
        return result;
    }

    static std::optional<fs::path> own_header(const std::string& source) {
        const auto lines = harness::header_use(source).lines;
        return lines.empty() ? std::nullopt : machine().cache.get(lines);
    }
};

/// What g++ warns of in students' programs.
const char* const warned = R"(
struct Warned { int second, first; Warned(int x) : first(x), second(x) {} virtual int size() const { return 1; } };
struct Derived : Warned { Derived() : Warned(1) {} int size(); };
inline int Derived::size() { return 2; }
static int never_called(int unused_parameter) { }
template <class T> bool below(T x) { return x < 1u; }
int warned(int n) {
    int unused, never_set;
    unsigned u = 3;
    if (n < u) n = 1;
    if (n = 2) n += never_set;
    switch (n) { case 1: n = 4; case 2: ; }
    for (int i = 0; i < n; ++i);
        n + 1;
    int *p = new int[2]; delete p;
    char c = 300;
    if (n == 1) if (n == 2) n = 3; else n = 4;
    return below(-1) && n & 1 == 0 ? c : n;
}
)";

TEST_P(Precompiled, GivesTheSameProgramMessagesAndOutputAsPlain) {
    const bool is_probe = GetParam().filename() != "ray_cast.cpp";
    std::vector<const char*> endings{is_probe ? "" : warned};
    if (!is_probe && is_nightly()) endings.push_back("");
    for (const std::string more : endings) {
        const std::string source = bytes_of(GetParam()) + more;
        const auto header = own_header(source);
        if (!header) return;  // the source is compiled without a header anyway
        const Result& plain = compile_plainly(source);
        const Result fast = compile(source, header);
        EXPECT_EQ(plain.compiled, fast.compiled);
        EXPECT_EQ(plain.diagnostics, fast.diagnostics);
        EXPECT_TRUE(plain.program == fast.program || functions_of(plain.program) == functions_of(fast.program))
            << "program differs";
        EXPECT_EQ(plain.output, fast.output);
        // Probes also warn of what headers define, so there only a clean one must be compiled with its header; and one
        // gives the headers' words another meaning.
        EXPECT_TRUE(plain.compiled || !fast.by_header);
        EXPECT_TRUE(fast.by_header || !plain.compiled || (is_probe && !plain.diagnostics.empty()) ||
                    GetParam().stem() == "private_public")
            << fast.diagnostics;
        if (is_probe && !is_nightly()) continue;
        const Result alone = compile_alone(source);
        EXPECT_EQ(plain.compiled, alone.compiled);
        EXPECT_EQ(plain.diagnostics, alone.diagnostics);
        EXPECT_TRUE(plain.program == alone.program) << "program differs from g++ alone";
    }
}

/// What students' programs have that do not compile.
const char* const wrong[] = {
    "int wrong() { return zzzzzzzzzz; }\n",
    "int wrong() { glm::vec3 eye; return eyee.x; }\n",
    "int wrong() { int x = 1 return x; }\n",
    "int wrong() { return 1;\n",
    "int wrong() { glm::vec3 v = 1; return v; }\n",
    "int wrong() { return glm::dot(glm::vec3(1), 2); }\n",
    "int wrong() { return glm::dott(glm::vec3(1), glm::vec3(2)); }\n",
    "int wrong() { std::cout << glm::vec3(1); return 0; }\n",
    "int wrong() { const float t = 1; t = 2; return glm::vec3(1) * glm::vec2(1); }\n",
    "int wrong(int a) { int a = 1; return a.x; }\nint wrong(int b) { return b; }\n",
    "glm::vec3 wrong(glm::vec3 v) { return normalize(v, 1); }\n",
    "struct Wrong { glm::vec3 c float r; };\n",
    "int wrong() { return std::strin().size(); }\n",
    "int wrong() { for (int i = 0; i < 3; i++ { } return i; }\n",
    "void wrong() { glm::mat4 m; m = glm::lookAt(glm::vec3(1)); return m; }\n",
    "int wrong() { int unused; return nothing(unused_too); }\n",
};

class NotCompiled : public Precompiled {};

/// Every fourth of them in one of the samples; nightly each in each sample.
TEST_F(NotCompiled, GetsTheMessagesOfAPlainBuild) {
    const std::vector<fs::path> files = samples();
    std::size_t compared = 0;
    for (std::size_t i = 0; i < std::size(wrong); i += is_nightly() ? 1 : 4) {
        for (std::size_t k = 0; k < (is_nightly() ? files.size() : 1); ++k) {
            const std::string source = bytes_of(files[(i + k) % files.size()]) + wrong[i];
            const auto header = own_header(source);
            if (!header) continue;
            const Result plain = compile(source, {}), fast = compile(source, header);
            EXPECT_EQ(plain.compiled, fast.compiled);
            EXPECT_EQ(plain.diagnostics, fast.diagnostics);
            compared += plain.compiled ? 0 : 1;
        }
    }
    EXPECT_GE(compared, is_nightly() ? std::size(wrong) : 3);
}

std::string name_of(const testing::TestParamInfo<fs::path>& info) {
    const fs::path& file = info.param;
    std::string name = file.filename() == "ray_cast.cpp" ? file.parent_path().filename() : file.stem();
    for (char& c : name) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    }
    return name + "_" + std::to_string(info.index);
}

INSTANTIATE_TEST_SUITE_P(Submissions, Precompiled, testing::ValuesIn(samples()), name_of);
INSTANTIATE_TEST_SUITE_P(Probes, Precompiled, testing::ValuesIn(probes()), name_of);

/// A header of GLM that stands first means what it means behind others only if it compiles there.
TEST(HeadersOfGlm, CompileAlone) {
    if (!is_nightly()) GTEST_SKIP() << "nightly: compiles 300 headers";
    const TemporaryFolder folder;
    int count = 0;
    for (const auto& entry : fs::recursive_directory_iterator("/usr/include/glm")) {
        const std::string name = entry.path().string().substr(std::string("/usr/include/").size());
        const std::string directive = "#include <" + name + ">";
        if (entry.path().extension() != ".hpp" || name.starts_with("glm/detail/")) continue;
        if (harness::header_use(directive).lines.empty() || name == "glm/gtc/type_aligned.hpp") continue;
        const std::string file = folder.write("a.cpp", directive + '\n').string();
        const std::string command = "g++ -std=c++17 -DGLM_ENABLE_EXPERIMENTAL= -fsyntax-only " + file;
        EXPECT_EQ(system((command + " 2>" + file + ".messages").c_str()), 0) << name;
        ++count;
    }
    EXPECT_GT(count, 200);
}

}  // namespace
