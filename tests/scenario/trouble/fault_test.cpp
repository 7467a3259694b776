// Failures around a submission: raygrade is killed, the disk is full, the sandbox is gone. Nothing
// may be left behind, no failure may change a mark, and the other submissions must still be graded.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <thread>

#include "tests/given/cases.h"
#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using nlohmann::json;
using testing::HasSubstr;

/// Resists every attempt to end it for some seconds.
constexpr std::string_view clinging =
    "#include <signal.h>\n#include <unistd.h>\n"
    "int main() {\n"
    "    for (int s = 1; s < 32; ++s) signal(s, SIG_IGN);\n"
    "    for (int i = 0; i < 3; ++i) if (fork() == 0) setsid();\n"
    "    for (int i = 0; i < 20; ++i) usleep(500000);\n"
    "}\n";
constexpr std::string_view spinning =
    "#include <ctime>\nint main() { const auto end = time(nullptr) + 10; while (time(nullptr) < end) {} }\n";

/// Makes this process inherit every process that its descendants leave behind, so that none can hide.
void adopt_orphans() {
    ASSERT_EQ(prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0), 0);
}

/// Reaps until no descendant is left. Returns false if some are left after `time`.
bool all_gone_within(std::chrono::milliseconds time) {
    const auto end = std::chrono::steady_clock::now() + time;
    for (;;) {
        const pid_t pid = waitpid(-1, nullptr, WNOHANG);
        if (pid < 0) return true;
        if (pid > 0) continue;
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(2ms);
    }
}

std::ptrdiff_t entries(const fs::path& folder) {
    const fs::directory_iterator all(folder);
    return std::distance(begin(all), end(all));
}

class Fault : public testing::Test {
  protected:
    Fault() {
        fs::create_directory(temporary());
        // If root runs the tests, the programs' accounts need access to this folder.
        fs::permissions(folder.path(), static_cast<fs::perms>(0755));
    }

    fs::path students() const { return folder / "class"; }
    fs::path out() const { return folder / "out"; }
    /// The $TMPDIR of raygrade.
    fs::path temporary() const { return folder / "tmp"; }
    void add(const std::string& id, std::string_view source) const { write(students() / id / "ray_cast.cpp", source); }
    std::vector<std::string> command(std::vector<std::string> more = {}) const {
        std::vector<std::string> words = {"grade", students().string(), "--out", out().string(), "--apply"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    Preparation in_temporary(Preparation more = {}) const {
        return [this, more] { return setenv("TMPDIR", temporary().c_str(), 1) == 0 && (!more || more()); };
    }
    /// Starts raygrade without waiting for it.
    pid_t start(const std::vector<std::string>& arguments) const {
        const pid_t child = fork();
        if (child == 0) {
            if (!in_temporary()()) _exit(99);
            become_raygrade(arguments, {}, "/dev/null", "/dev/null");
        }
        return child;
    }
    json graded(const std::string& id) const { return submission_in(read_json(out() / "grades.json"), id); }

    Preparation with_own_cache(Preparation more = {}) const {
        return in_temporary(both(with_cache(folder / "cache"), more));
    }
    /// Grades where the machine lacks something. Then raygrade says why it does not begin, or "honest" has its points
    /// or is not graded.
    void grade_fairly(const Preparation& lacking) const {
        fs::remove_all(out());
        const Result result = raygrade(command({"-j", "2"}), with_own_cache(lacking));
        if (!fs::exists(out() / "grades.json")) {
            EXPECT_NE(result.voice, "");
            return;
        }
        const json one = graded("honest");
        EXPECT_TRUE(one.at("points") == 10.0 || one.at("outcome") == "not_graded") << one.dump(2) << result.both();
    }
    void expect_that_nothing_is_kept() const {
        ASSERT_EQ(raygrade(command(), with_own_cache()).status, 0);
        EXPECT_EQ(graded("honest").at("points"), 10.0);
    }

    TemporaryFolder folder;
};

class Killed : public Fault, public testing::WithParamInterface<unsigned> {};

/// Kills raygrade at 10 random moments within 1.5 s, and nightly at 100: while it starts, tries the sandbox, compiles,
/// runs or cleans up. The seed is the parameter.
TEST_P(Killed, LeavesNoProcessAndTheNextRunRemovesItsFolder) {
    adopt_orphans();
    add("clinging", clinging);
    add("honest", small_program);
    add("spinning", spinning);
    const std::vector<std::string> words = command({"-j", "2", "--limit", "run.cpu_seconds=0.3"});
    std::mt19937 random(GetParam());
    std::uniform_int_distribution<int> moments(0, 1500);
    const int kills = is_nightly() ? 100 : 10;
    for (int i = 0; i < kills; ++i) {
        const auto moment = std::chrono::milliseconds(moments(random));
        const pid_t raygrade = start(words);
        ASSERT_GT(raygrade, 0);
        std::this_thread::sleep_for(moment);
        kill(raygrade, SIGKILL);
        ASSERT_TRUE(all_gone_within(5s)) << "killed after " << moment.count() << " ms, seed " << GetParam();
        ASSERT_LE(entries(temporary()), 1) << "what an earlier run left is still there";
    }
    EXPECT_EQ(raygrade_from_scratch({"check", (students() / "honest/ray_cast.cpp").string()}, in_temporary()).status,
              0);
    EXPECT_EQ(entries(temporary()), 0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Killed, testing::Values(1));

/// Finds a running process called `name` and sets `parent` to its parent's id. Returns false if none appears in time.
bool find_running(const std::string& name, pid_t& parent) {
    const auto end = std::chrono::steady_clock::now() + 20s;
    while (std::chrono::steady_clock::now() < end) {
        for (const auto& entry : fs::directory_iterator("/proc")) {
            std::ifstream file(entry.path() / "stat");
            std::string pid, comm, state;
            if (file >> pid >> comm >> state >> parent && comm == "(" + name + ")") return true;
        }
        std::this_thread::sleep_for(5ms);
    }
    return false;
}

TEST_F(Fault, ADeadSupervisorLeavesItsSubmissionNotGraded) {
    adopt_orphans();
    add("honest", small_program);
    // A unique name, so that this test finds only its own process.
    const std::string name = "waits-" + std::to_string(getpid());
    add("waits", "#include <sys/prctl.h>\n#include <unistd.h>\nint main() { prctl(PR_SET_NAME, \"" + name +
                     "\"); sleep(8); }\n");
    const pid_t raygrade = start(command({"-j", "1"}));
    pid_t supervisor = 0;
    ASSERT_TRUE(find_running(name, supervisor));
    kill(supervisor, SIGKILL);
    int status = 0;
    ASSERT_EQ(waitpid(raygrade, &status, 0), raygrade);
    EXPECT_EQ(WEXITSTATUS(status), some_not_graded);
    EXPECT_TRUE(all_gone_within(5s));
    EXPECT_EQ(graded("waits").at("outcome"), "not_graded");
    EXPECT_TRUE(graded("waits").at("points").is_null());
    EXPECT_THAT(graded("waits").at("explanation").get<std::string>(), HasSubstr("supervisor"));
    EXPECT_EQ(graded("honest").at("points").get<double>(), 10);
}

TEST_F(Fault, ADiskThatFillsUpLeavesASubmissionNotGraded) {
    add("fills", "char big[30000000] = {1};\nint main() { return big[1]; }\n");
    add("honest", small_program);
    const Result result =
        raygrade_from_scratch(command({"-j", "1"}), in_temporary([this] { return mount_disk(temporary(), "16m"); }));
    EXPECT_EQ(result.status, some_not_graded) << result.both();
    EXPECT_THAT(result.both(), HasSubstr("TMPDIR"));
    EXPECT_EQ(graded("fills").at("outcome"), "not_graded");
    EXPECT_EQ(graded("honest").at("points").get<double>(), 10) << result.both();
}

TEST_F(Fault, ADiskWithFewInodesCausesNoCompileError) {
    add("honest", small_program);
    for (const int files : {8, 12, 16})
        grade_fairly([&] { return mount_disk(temporary(), "64m,nr_inodes=" + std::to_string(files)); });
    expect_that_nothing_is_kept();
}

TEST_F(Fault, EveryCommandSaysThatMemoryIsLow) {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "a sanitised raygrade needs terabytes of addresses";
#endif
    add("honest", small_program);
    const std::string source = (students() / "honest/ray_cast.cpp").string();
    const std::vector<std::vector<std::string>> commands = {
        {"check", source},
        {"stress", source},
        command({"-j", "2"}),
        {"reference"},
        {"doctor"},
        {"explain", "-o", "-"},
        {"accuracy", "--quick", "--rays", "256", "--out", (folder / "accuracy").string()}};
    for (const auto& words : commands) {
        const Result result = raygrade(words, with_own_cache([&] {
                                           const rlimit addresses{72'000 << 10U, 72'000 << 10U};
                                           return setrlimit(RLIMIT_AS, &addresses) == 0;
                                       }));
        EXPECT_NE(result.both(), "") << words.front();
        EXPECT_LE(result.status, 2) << words.front() << '\n' << result.both();
    }
}

TEST_F(Fault, LowMemoryCausesNoCompileError) {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "a sanitised raygrade needs terabytes of addresses";
#endif
    add("honest", "#include <iostream>\n" + std::string(small_program));
    constexpr rlim_t megabyte = 1'000'000;
    for (const rlim_t megabytes : {70, 100, 130}) {
        grade_fairly([&] {
            const rlimit addresses{megabytes * megabyte, megabytes * megabyte};
            return setrlimit(RLIMIT_AS, &addresses) == 0;
        });
    }
    expect_that_nothing_is_kept();
}

TEST_F(Fault, AFullDiskIsReportedBeforeTheFirstSubmission) {
    add("honest", small_program);
    const Result result =
        raygrade_from_scratch(command(), in_temporary([this] { return mount_tiny_disk(temporary()); }));
    EXPECT_EQ(result.status, some_not_graded) << result.both();
    EXPECT_THAT(result.voice, HasSubstr("TMPDIR"));
    EXPECT_FALSE(fs::exists(out() / "grades.json"));
}

/// A PATH whose bwrap or g++ removes itself after `uses` uses.
fs::path path_with_vanishing(const fs::path& folder, const std::string& name, int uses) {
    const fs::path bin = folder / "bin";
    write(bin / "uses", std::to_string(uses));
    write(bin / name, "#!/bin/bash\nleft=$(<" + (bin / "uses").string() + "); echo $((left - 1)) >" +
                          (bin / "uses").string() + "\n((left > 1)) || rm -f \"$0\"\nexec /usr/bin/" + name +
                          " \"$@\"\n");
    for (const auto& path : {folder, bin, bin / name, bin / "uses"})
        fs::permissions(path, static_cast<fs::perms>(0777));
    return bin;
}

TEST_F(Fault, ABwrapRemovedDuringTheRunLeavesTheRestNotGraded) {
    if (!holds_bwrap()) GTEST_SKIP() << "bwrap does not hold on this machine";
    // Three different programs: what is the same would be compiled and run once.
    for (const char* id : {"a", "b", "c"})
        add(id, std::string(small_program) + "const char* author = \"" + id + "\";\n");
    // The first use is the canary, the next are some of the six compilations and runs.
    const fs::path bin = path_with_vanishing(folder / "vanishing", "bwrap", 4);
    const Result result = raygrade_from_scratch(
        command({"-j", "1"}),
        in_temporary([&] { return setenv("PATH", (bin.string() + ":/usr/bin:/bin").c_str(), 1) == 0; }));
    EXPECT_EQ(result.status, some_not_graded) << result.both();
    int not_graded = 0;
    for (const char* id : {"a", "b", "c"}) {
        const json one = graded(id);
        if (one.at("outcome") == "graded") {
            EXPECT_EQ(one.at("points").get<double>(), 10) << id;
            continue;
        }
        ++not_graded;
        EXPECT_EQ(one.at("outcome"), "not_graded") << id;
        EXPECT_TRUE(one.at("points").is_null()) << id;
        EXPECT_THAT(one.at("explanation").get<std::string>(), HasSubstr("bwrap")) << id;
    }
    EXPECT_GE(not_graded, 1);
}

TEST_F(Fault, OutputBeforeACrashCountsWithAnyLineEnd) {
    const auto crashing = [](const std::string& before, const std::string& print) {
        return "#include <cstdio>\n#include <cstdlib>\n#include <iostream>\nint main() {\n    " + before + "\n    " +
               print + "\n    abort();\n}\n";
    };
    const std::string stream = "std::cout << \"Question 5:\" << '\\n' << \"V: vec3(0, 0, -1)\" << '\\n';";
    const std::map<std::string, std::string> sources = {
        {"endl", crashing("", "std::cout << \"Question 5:\" << std::endl << \"V: vec3(0, 0, -1)\" << std::endl;")},
        {"newline", crashing("", stream)},
        {"unsynchronised", crashing("std::ios::sync_with_stdio(false);", stream)},
        {"printf", crashing("", "std::printf(\"Question 5:\\nV: vec3(0, 0, -1)\\n\");")},
        {"wide", crashing("", "std::wcout << L\"Question 5:\\nV: vec3(0, 0, -1)\\n\";")},
    };
    for (const auto& [name, source] : sources) add(name, source);
    ASSERT_EQ(raygrade_from_scratch(command()).status, 0);
    for (const auto& [name, source] : sources) {
        EXPECT_EQ(graded(name).at("outcome"), "crashed") << name;
        EXPECT_EQ(graded(name).at("points").get<double>(), 10) << name;
    }
}

}  // namespace
}  // namespace scenario
