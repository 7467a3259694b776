// Sandboxes and limits as an instructor sees them: on the command line, in an assignment and in the reports.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/mount.h>
#include <unistd.h>

#include <cerrno>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class Sandboxed : public testing::Test {
  protected:
    Sandboxed() {
        // If root runs the tests, the programs' accounts need access to this folder to reach without_bwrap's compiler.
        fs::permissions(folder.path(), static_cast<fs::perms>(0755));
        write(students() / "prints/ray_cast.cpp",
              "#include <cstdio>\nint main() { puts(\"Question 5:\\nV: vec3(0.000000, 0.000000, -1.000000)\"); }\n");
    }
    void add_spinning() const {
        write(students() / "spins/ray_cast.cpp",
              "#include <cstdio>\nint main() { puts(\"Question 5:\\nV: vec3(0.000000, 0.000000, -1.000000)\"); "
              "fflush(stdout); for (volatile int i = 0;; i = i + 1) {} }\n");
    }
    fs::path students() const { return folder / "class"; }
    fs::path out() const { return folder / "out"; }
    Result grade(std::vector<std::string> more, const Preparation& prepare = {}) const {
        more.insert(more.begin(), {"grade", "--out", out().string(), "--apply"});
        more.push_back(students().string());
        return raygrade_from_scratch(more, prepare);
    }
    json grades() const { return read_json(out() / "grades.json"); }
    /// A PATH with a compiler and without bwrap.
    Preparation without_bwrap() const {
        return [this] {
            const fs::path bin = folder / "bin";
            fs::create_directories(bin);
            if (!fs::exists(bin / "g++")) fs::create_symlink("/usr/bin/g++", bin / "g++");
            return setenv("PATH", bin.c_str(), 1) == 0;
        };
    }
    /// The assignment of 2021 with these lines added.
    std::string assignment_with(const std::string& lines) const {
        const fs::path file = folder / "limited.toml";
        write(file, read(project_folder() / "reference/assignments/a6-2021.toml") + "\n" + lines);
        return file.string();
    }

    TemporaryFolder folder;
};

TEST_F(Sandboxed, EachTierGradesAndIsNamed) {
    const bool bwrap = holds_bwrap();
    for (const auto& [option, name] : {std::pair{"auto", bwrap ? "bwrap+shim" : "landlock+shim"},
                                       {"bwrap", "bwrap+shim"},
                                       {"landlock", "landlock+shim"}}) {
        if (!bwrap && option == std::string("bwrap")) continue;
        const Result result = grade({"--sandbox", option});
        EXPECT_EQ(result.status, 0) << result.both();
        EXPECT_EQ(grades().at("sandbox"), name);
        EXPECT_TRUE(grades().at("warning").is_null());
        EXPECT_EQ(grades().at("submissions").at(0).at("points").get<double>(), 10);
        EXPECT_THAT(result.output, Not(HasSubstr("unsafe")));
    }
}

TEST_F(Sandboxed, AStrongerTierThatFailsIsReported) {
    const Result result = grade({}, without_bwrap());
    EXPECT_EQ(result.status, 0) << result.both();
    EXPECT_EQ(grades().at("sandbox"), "landlock+shim");
    EXPECT_THAT(
        result.voice,
        HasSubstr("note: programs run in landlock+shim, because bwrap+shim does not work here (bwrap was not found"));
    if (holds_bwrap()) {
        EXPECT_THAT(grade({}).voice, Not(HasSubstr("does not work here")));
    }
}

/// Refuses to make user namespaces, as Docker's filter does.
bool forbid_user_namespaces() {
    const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
    const bool done = filter != nullptr &&
                      seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(clone), 1,
                                       SCMP_A0(SCMP_CMP_MASKED_EQ, CLONE_NEWUSER, CLONE_NEWUSER)) == 0 &&
                      seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(unshare), 0) == 0 &&
                      seccomp_load(filter) == 0;
    seccomp_release(filter);
    return done;
}

/// Covers a file of /proc, as containers do; nobody may then mount a whole /proc.
bool cover_a_part_of_proc() {
    return unshare(CLONE_NEWNS) == 0 && mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
           mount("/dev/null", "/proc/version", nullptr, MS_BIND, nullptr) == 0;
}

TEST_F(Sandboxed, TheDoctorSaysWhatForbidsNamespacesAndThatLandlockWorks) {
    if (!holds_bwrap()) GTEST_SKIP() << "no bwrap here";
    const Result filtered = raygrade_from_scratch({"doctor"}, forbid_user_namespaces);
    EXPECT_EQ(filtered.status, 0) << filtered.both();
    EXPECT_THAT(filtered.output,
                AllOf(HasSubstr("could not create a sandbox for \"./canary\": bwrap: No permissions to create new "
                                "namespace, likely because the kernel does "
                                "not allow non-privileged user namespaces. See <https://deb.li/bubblewrap> or "
                                "<file:///usr/share/doc/bubblewrap/README.Debian.gz>."),
                      HasSubstr("-> A system call filter forbids user namespaces"),
                      HasSubstr("Until then programs run in the other sandbox, which works."),
                      HasSubstr("programs run in: landlock+shim"), Not(HasSubstr("free memory"))));
    if (geteuid() != 0) return;  // only root may mount
    const Result covered = raygrade_from_scratch({"doctor"}, cover_a_part_of_proc);
    EXPECT_THAT(covered.output,
                AllOf(HasSubstr("-> Parts of /proc are hidden here"), HasSubstr("systempaths=unconfined"),
                      HasSubstr("programs run in: landlock+shim"), Not(HasSubstr("free memory"))));
}

TEST_F(Sandboxed, NothingRunsWithoutASandboxUnlessAllowed) {
    const Result refused = grade({"--sandbox", "bwrap"}, without_bwrap());
    EXPECT_EQ(refused.status, some_not_graded);
    EXPECT_THAT(refused.voice,
                AllOf(HasSubstr("apt install bubblewrap"), HasSubstr("--unsafe"), HasSubstr("raygrade doctor")));
    EXPECT_FALSE(fs::exists(out() / "grades.json"));
}

TEST_F(Sandboxed, UnsafeChangesNothingIfASandboxWorks) {
    if (!holds_bwrap()) GTEST_SKIP() << "no sandbox here";
    const Result result = grade({"--unsafe"});
    EXPECT_EQ(result.status, 0) << result.both();
    EXPECT_THAT(result.voice, HasSubstr("--unsafe is not needed here; programs run in the sandbox bwrap+shim"));
    EXPECT_EQ(grades().at("sandbox"), "bwrap+shim");
    EXPECT_THAT(grade({"--apply"}).voice, Not(HasSubstr("--unsafe")));
}

TEST_F(Sandboxed, EveryReportOfMarksMadeWithoutASandboxSaysSo) {
    const Result result = grade({"--sandbox", "bwrap", "--unsafe"}, without_bwrap());
    EXPECT_EQ(result.status, 0) << result.both();
    const std::string warning = "Graded without a sandbox (--unsafe)";
    EXPECT_THAT(result.output, HasSubstr(warning));
    EXPECT_THAT(result.voice, HasSubstr(warning));
    EXPECT_EQ(grades().at("sandbox"), "unsafe");
    EXPECT_THAT(grades().at("warning").get<std::string>(), HasSubstr(warning));
    EXPECT_THAT(read(out() / "feedback/prints.md"), HasSubstr(warning));
    EXPECT_THAT(read(out() / "feedback/prints.html"), HasSubstr(warning));
    EXPECT_THAT(read(out() / "report.html"), HasSubstr(warning));
    EXPECT_THAT(read(out() / "grades.csv"), HasSubstr(",unsafe,"));
    const Result check = raygrade_from_scratch(
        {"check", (students() / "prints/ray_cast.cpp").string(), "--sandbox", "bwrap", "--unsafe"}, without_bwrap());
    EXPECT_THAT(check.output, HasSubstr(warning));
}

TEST_F(Sandboxed, TheCommandLinesLimitOverridesTheAssignments) {
    add_spinning();
    const std::string assignment = assignment_with("[limits.run]\ncpu_seconds = 0.2\n");
    ASSERT_EQ(grade({"--assignment", assignment}).status, 0);
    const json spins = submission_in(grades(), "spins");
    EXPECT_EQ(spins.at("outcome"), "timed_out");
    EXPECT_EQ(spins.at("run").at("limit"), "run.cpu_seconds");
    EXPECT_THAT(spins.at("explanation").get<std::string>(),
                AllOf(HasSubstr("Time limit"), HasSubstr("0.2 s of processor time")));
    EXPECT_EQ(spins.at("points").get<double>(), 10) << "what it printed before counts";
    EXPECT_GE(spins.at("run").at("cpu_seconds").get<double>(), 0.2);
    ASSERT_EQ(grade({"--assignment", assignment, "--limit", "run.cpu_seconds=0.5"}).status, 0);
    EXPECT_GE(submission_in(grades(), "spins").at("run").at("cpu_seconds").get<double>(), 0.5);
}

/// As on a machine that is too busy to give a program the seconds of computing that it is allowed.
TEST_F(Sandboxed, AnEndlessLoopThatTheWallLimitStopsIsNotCalledWaiting) {
    add_spinning();
    write(students() / "waits/ray_cast.cpp", "#include <unistd.h>\nint main() { sleep(60); }\n");
    ASSERT_EQ(grade({"--limit", "run.cpu_seconds=60", "--limit", "run.wall_seconds=3"}).status, 0);
    const json spins = submission_in(grades(), "spins"), waits = submission_in(grades(), "waits");
    EXPECT_EQ(spins.at("run").at("limit"), "run.wall_seconds");
    EXPECT_THAT(spins.at("explanation").get<std::string>(),
                AllOf(HasSubstr("after 3 s of real time, in which it used "), HasSubstr("infinite loop?")));
    EXPECT_THAT(waits.at("explanation").get<std::string>(), HasSubstr("3 s of real time; does it wait for something?"));
}

}  // namespace
}  // namespace scenario
