// Nothing is compiled twice: the results cached by earlier runs, and their use.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/scenario/scenario.h"

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using scenario::raygrade;
using scenario::read;
using scenario::Result;
using scenario::TemporaryFolder;
using scenario::write;
using testing::HasSubstr;
using testing::Not;

const std::string program = "#include <cstdio>\nint main() { std::puts(\"Question 1:\\nP_VCS = (0, 0, -2)\"); }\n// ";

/// A class of distinct programs, and a cache.
struct Class {
    TemporaryFolder folder;
    fs::path cache = folder / "cache";

    explicit Class(int size) {
        for (int i = 0; i < size; ++i)
            write(folder / "class" / ("s" + std::to_string(100 + i)) / "ray_cast.cpp", program + std::to_string(i));
    }
    Result grade(const std::string& out, std::vector<std::string> more = {}) const {
        std::vector<std::string> arguments{"grade", (folder / "class").string(), "--out", (folder / out).string(),
                                           "--verbose"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return with_cache(arguments);
    }
    Result check() const { return with_cache({"check", (folder / "class/s100/ray_cast.cpp").string()}); }
    Result with_cache(const std::vector<std::string>& arguments) const {
        return raygrade(arguments, scenario::with_cache(cache));
    }
    std::string report(const std::string& out, const std::string& name) const { return read(folder / out / name); }
    fs::path database() const { return cache / "raygrade" / "results.sqlite"; }
};

TEST(Cache, SavesARegradeEveryCompilationAndChangesNoByte) {
    const Class some(3);
    ASSERT_EQ(some.grade("one").status, 0);
    const Result again = some.grade("two");
    EXPECT_EQ(again.status, 0);
    EXPECT_THAT(again.voice, HasSubstr("compiling 0.0 s, running 0.0 s"));
    EXPECT_THAT(again.voice, HasSubstr("3 of 3 reused from earlier runs"));
    for (const char* name : {"grades.json", "grades.csv", "feedback/s101.md"})
        EXPECT_EQ(some.report("one", name), some.report("two", name)) << name;
}

TEST(Cache, IsReportedOnceAndSkippedIfItCannotBeWritten) {
    Class some(3);
    some.cache = "/proc";
    const Result result = some.grade("one");
    EXPECT_EQ(result.status, 0);
    const std::string note = "Could not keep results";
    const std::size_t first = result.voice.find(note);
    ASSERT_NE(first, std::string::npos) << result.voice;
    EXPECT_EQ(result.voice.find(note, first + 1), std::string::npos) << "once";
    EXPECT_THAT(some.report("one", "grades.csv"), HasSubstr("\"s102\",graded"));
}

std::size_t kept_in(const fs::path& database) {
    try {
        SQLite::Database opened(database.string(), SQLite::OPEN_READONLY, 1000);
        return static_cast<std::size_t>(opened.execAndGet("SELECT COUNT(*) FROM results").getInt());
    } catch (const SQLite::Exception&) {
        return 0;  // the database does not exist yet
    }
}

/// Starts raygrade and kills it with SIGKILL as soon as it has kept `enough` results.
void grade_and_kill(const Class& some, std::size_t enough) {
    const std::string folder = (some.folder / "class").string();
    const std::string out = (some.folder / "killed").string();
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        scenario::with_cache(some.cache)();
        if (freopen("/dev/null", "w", stdout) == nullptr || freopen("/dev/null", "w", stderr) == nullptr) _exit(1);
        execl(RAYGRADE_BINARY, RAYGRADE_BINARY, "grade", folder.c_str(), "--out", out.c_str(), "--apply", nullptr);
        _exit(1);
    }
    const auto deadline = std::chrono::steady_clock::now() + 100s;
    while (kept_in(some.database()) < enough && std::chrono::steady_clock::now() < deadline)
        std::this_thread::sleep_for(5ms);
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
}

TEST(Resume, GradesEachSubmissionOnceHoweverOftenTheRunIsKilled) {
    constexpr std::size_t size = 30;
    const Class some(size);
    std::size_t kept = 0;
    for (const std::size_t enough : {std::size_t{1}, std::size_t{5}, std::size_t{12}, std::size_t{20}}) {
        grade_and_kill(some, enough);
        const std::size_t now = kept_in(some.database());
        EXPECT_GE(now, enough) << "what one run has kept, the next one has";
        kept = now;
    }
    ASSERT_LT(kept, size) << "killed before the end";
    const Result last = some.grade("resumed");
    EXPECT_EQ(last.status, 0);
    EXPECT_THAT(last.voice,
                HasSubstr(std::to_string(kept) + " of " + std::to_string(size) + " reused from earlier runs"));
    EXPECT_THAT(last.voice, Not(HasSubstr("deleted and started again")));
    EXPECT_EQ(kept_in(some.database()), size);
    ASSERT_EQ(some.grade("anew", {"--fresh"}).status, 0);
    EXPECT_EQ(some.report("resumed", "grades.csv"), some.report("anew", "grades.csv"));
}

nlohmann::json graded(const Class& some, const std::string& out, const std::string& id) {
    return scenario::submission_in(nlohmann::json::parse(some.report(out, "grades.json")), id);
}

TEST(Repeat, FlagsAnswersThatDifferAndTakesOffNoPoints) {
    const Class some(2);
    write(some.folder / "class/s101/ray_cast.cpp",
          "#include <cstdio>\n#include <ctime>\nint main() {\n    timespec now;\n    clock_gettime(CLOCK_REALTIME, "
          "&now);\n"
          "    std::printf(\"Question 1:\\nP_VCS = (0, 0, -2)\\nQuestion 5:\\nV = (0, 0, -%ld.5)\\n\", "
          "now.tv_nsec);\n}\n");
    ASSERT_EQ(some.grade("once").status, 0);
    EXPECT_EQ(graded(some, "once", "s101")["flags"].size(), 0U);
    const Result often = some.grade("often", {"--repeat", "3"});
    ASSERT_EQ(often.status, 0);
    EXPECT_EQ(graded(some, "often", "s100")["flags"].size(), 0U);
    const auto flagged = graded(some, "often", "s101");
    ASSERT_EQ(flagged["flags"].size(), 1U);
    EXPECT_EQ(flagged["flags"][0]["kind"], "nondeterministic");
    EXPECT_THAT(flagged["flags"][0]["evidence"].get<std::string>(), HasSubstr("Question 5, V: run 1 printed"));
    EXPECT_EQ(flagged["points"], graded(some, "once", "s101")["points"]);
    EXPECT_THAT(some.report("often", "feedback/s101.md"), HasSubstr("answers differ from run to run"));
    const Result again = some.grade("again", {"--repeat", "3"});
    EXPECT_THAT(again.voice, HasSubstr("2 of 2 reused from earlier runs"));
    EXPECT_EQ(some.report("again", "grades.json"), some.report("often", "grades.json"));
}

/// The same slow header in enough programs that it is precompiled.
TEST(PrecompiledHeaders, ChangeOnlyTheTime) {
    const Class some(0);
    for (int i = 0; i < 6; ++i) {
        write(some.folder / "class" / ("s" + std::to_string(i)) / "ray_cast.cpp",
              "#include <cmath>\n#include <iostream>\n"
              "int main() { std::cout << \"Question 1:\\nP_VCS = (0, 0, \" << -std::sqrt(4.0) << \")\\n\"; }\n// " +
                  std::to_string(i));
    }
    const Result first = some.grade("first", {"--jobs", "1"});
    EXPECT_THAT(first.voice, HasSubstr("6 compiled with a precompiled header"));
    fs::remove(some.database());
    EXPECT_THAT(some.grade("second", {"--fresh", "--jobs", "1"}).voice,
                HasSubstr("6 compiled with a precompiled header"));
    EXPECT_EQ(some.report("first", "grades.csv"), some.report("second", "grades.csv"));
    const Class alone(0);
    write(alone.folder / "class/s0/ray_cast.cpp", read(some.folder / "class/s0/ray_cast.cpp"));
    EXPECT_THAT(alone.grade("plain").voice, HasSubstr("0 compiled with a precompiled header"));
    EXPECT_EQ(alone.report("plain", "feedback/s0.md"), some.report("first", "feedback/s0.md"));
}

}  // namespace
