#include "harness/cache/result_cache.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <thread>
#include <tuple>

#include "tests/given/temporary_folder.h"

namespace {

using namespace std::chrono_literals;
using harness::Ended;
using harness::Execution;
using harness::is_worth_keeping;
using harness::ResultCache;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Execution printed(const std::string& output) {
    Execution execution;
    execution.build.tried = true;
    execution.build.compiled = true;
    execution.run.ended = Ended::exited;
    execution.run.output = output;
    return execution;
}

std::string output_of(ResultCache& cache, const std::string& key) {
    const auto found = cache.find(key);
    return found ? found->run.output : "(nothing)";
}

void alter(const std::filesystem::path& folder, const std::string& sql) {
    SQLite::Database((folder / "results.sqlite").string(), SQLite::OPEN_READWRITE).exec(sql);
}

TEST(ResultCache, ReturnsEveryFieldInTheNextRun) {
    const TemporaryFolder folder;
    Execution kept = printed(std::string("a\0\xff\n", 4));
    kept.build.program = "/gone";
    kept.build.diagnostics = "warning \x80";
    kept.build.reached_limit = true;
    kept.build.wall = 1234ms;
    kept.run.ended = Ended::signalled;
    kept.run.exit_code = 7;
    kept.run.signal = 11;
    kept.run.error = 8;
    kept.run.cpu = 12ms;
    kept.run.wall = 34ms;
    kept.run.peak_memory_bytes = std::uint64_t{5} << 40;
    kept.run.errors = "e";
    kept.run.errors_truncated = true;
    ResultCache(folder.path()).keep("k", kept);
    ResultCache cache(folder.path());
    const auto found = cache.find("k");
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->build.program) << "the program is gone";
    const auto fields = [](const Execution& of) {
        const auto& [build, run] = std::tie(of.build, of.run);
        return std::make_tuple(build.tried, build.compiled, build.reached_limit, build.diagnostics, build.wall,
                               run.ended, run.exit_code, run.signal, run.error, run.cpu, run.wall,
                               run.peak_memory_bytes, run.output, run.errors, run.errors_truncated);
    };
    EXPECT_EQ(fields(*found), fields(kept));
    EXPECT_THAT(cache.problems(), IsEmpty());
}

TEST(ResultCache, ReturnsEveryKindOfEndThatItKeeps) {
    const TemporaryFolder folder;
    ResultCache cache(folder.path());
    for (const Ended ended : {Ended::not_started, Ended::exited, Ended::signalled, Ended::refused, Ended::cpu_limit,
                              Ended::memory_limit, Ended::output_limit}) {
        Execution execution = printed("");
        execution.run.ended = ended;
        cache.keep("k", execution);
        ASSERT_TRUE(cache.find("k"));
        EXPECT_EQ(cache.find("k")->run.ended, ended);
    }
}

TEST(IsWorthKeeping, RejectsResultsThatDependOnTheMachinesLoad) {
    EXPECT_TRUE(is_worth_keeping(printed("a")));
    Execution by_the_clock = printed("a");
    by_the_clock.run.ended = Ended::wall_limit;
    EXPECT_FALSE(is_worth_keeping(by_the_clock));
    by_the_clock.run.ended = harness::Ended::process_limit;
    EXPECT_FALSE(is_worth_keeping(by_the_clock)) << "a bomb prints more or less before it is stopped";
    Execution killed = printed("a");
    killed.run.ended = Ended::signalled;
    killed.run.signal = SIGKILL;
    EXPECT_FALSE(is_worth_keeping(killed));
    killed.run.signal = SIGSEGV;
    EXPECT_TRUE(is_worth_keeping(killed));
    Execution compiler_broke_down = printed("");
    compiler_broke_down.build.depends_on_load = true;
    EXPECT_FALSE(is_worth_keeping(compiler_broke_down));
    EXPECT_FALSE(is_worth_keeping(Execution{})) << "nothing was tried";
    const TemporaryFolder folder;
    ResultCache cache(folder.path());
    cache.keep("k", by_the_clock);
    EXPECT_FALSE(cache.contains("k"));
}

TEST(ResultCache, RemovesTheLeastRecentlyUsedResults) {
    const TemporaryFolder folder;
    const std::string large(10000, 'x');
    {
        ResultCache cache(folder.path());
        for (const char* key : {"a", "b", "c"}) cache.keep(key, printed(large));
    }
    alter(folder.path(), "UPDATE results SET used = used - 900000 WHERE key IN ('a', 'b')");
    {
        ResultCache cache(folder.path(), {.bytes = 25000, .age = 24h * 180});
        EXPECT_EQ(output_of(cache, "a"), large);
    }
    ResultCache cache(folder.path());
    EXPECT_TRUE(cache.contains("a")) << "was used just now";
    EXPECT_FALSE(cache.contains("b"));
    EXPECT_TRUE(cache.contains("c"));
}

TEST(ResultCache, RemovesTooOldResults) {
    const TemporaryFolder folder;
    ResultCache(folder.path()).keep("old", printed("a"));
    alter(folder.path(), "UPDATE results SET used = used - 7201");
    { ResultCache(folder.path(), {.bytes = 1 << 20, .age = 2h}).keep("new", printed("b")); }
    ResultCache cache(folder.path());
    EXPECT_FALSE(cache.contains("old"));
    EXPECT_TRUE(cache.contains("new"));
}

TEST(ResultCache, IgnoresResultsThatTheDiskGarbled) {
    const TemporaryFolder folder;
    ResultCache(folder.path()).keep("k", printed("right"));
    alter(folder.path(), "UPDATE results SET execution = CAST(replace(execution, 'right', 'wrong') AS BLOB)");
    ResultCache cache(folder.path());
    EXPECT_FALSE(cache.find("k"));
    cache.keep("k", printed("right"));
    EXPECT_EQ(output_of(cache, "k"), "right");
}

TEST(ResultCache, ReplacesAFileThatIsNotADatabase) {
    for (const std::string& rubbish : {std::string("not a database, but longer than its header of 100 bytes would "
                                                   "be, so that it is looked at in earnest: xxxxxxxxxxxxxxxxxxxxx"),
                                       "SQLite format 3" + std::string(5000, '\0')}) {
        const TemporaryFolder folder;
        folder.write("results.sqlite", rubbish);
        folder.write("results.sqlite-wal", "rubbish");
        ResultCache cache(folder.path());
        ASSERT_THAT(cache.problems(), ElementsAre(HasSubstr("deleted and started again")));
        cache.keep("k", printed("a"));
        EXPECT_EQ(output_of(cache, "k"), "a");
    }
}

TEST(ResultCache, ShowsNoControlCharactersOfADamagedFile) {
    const TemporaryFolder folder;
    ResultCache(folder.path()).keep("k", printed("a"));
    alter(folder.path(),
          "PRAGMA writable_schema = ON; UPDATE sqlite_schema SET name = char(27) || '[2J', sql = 'CREATE TABLE x(' "
          "WHERE name = 'results'");
    EXPECT_THAT(ResultCache(folder.path()).problems(), ElementsAre(HasSubstr("%1B[2J")));
}

TEST(ResultCache, ReplacesADatabaseOfADifferentVersion) {
    for (const char* change :
         {"PRAGMA user_version = 0", "PRAGMA user_version = 99", "ALTER TABLE results RENAME COLUMN seal TO sealed"}) {
        const TemporaryFolder folder;
        ResultCache(folder.path()).keep("k", printed("a"));
        alter(folder.path(), change);
        ResultCache cache(folder.path());
        EXPECT_THAT(cache.problems(), ElementsAre(HasSubstr("deleted and started again"))) << change;
        EXPECT_FALSE(cache.contains("k")) << change;
        cache.keep("k", printed("b"));
        EXPECT_EQ(output_of(cache, "k"), "b") << change;
        EXPECT_THAT(ResultCache(folder.path()).problems(), IsEmpty()) << change;
    }
}

TEST(ResultCache, ContinuesIfTheDatabaseIsDamagedDuringTheRun) {
    const TemporaryFolder folder;
    {
        ResultCache cache(folder.path());
        for (int i = 0; i < 200; ++i) cache.keep(std::to_string(i), printed(std::string(3000, 'x')));
    }
    {  // garbles every page except the first few, which are read on opening
        std::fstream file(folder.path() / "results.sqlite", std::ios::in | std::ios::out | std::ios::binary);
        file.seekp(5 * 4096);
        for (int i = 0; i < 100 * 4096; ++i) file.put('\x5a');
    }
    ResultCache cache(folder.path());
    for (int i = 0; i < 200; ++i) cache.find(std::to_string(i));
    EXPECT_THAT(cache.problems(), ElementsAre(HasSubstr("deleted and started again")));
    cache.keep("k", printed("a"));
    EXPECT_EQ(output_of(cache, "k"), "a");
}

TEST(ResultCache, WorksWithoutAWritableFolder) {
    const TemporaryFolder folder;
    folder.write("file", "");
    ResultCache cache(folder.path() / "file" / "below");
    cache.keep("k", printed("a"));
    EXPECT_FALSE(cache.contains("k"));
    EXPECT_FALSE(cache.find("k"));
    EXPECT_THAT(cache.problems(), ElementsAre(HasSubstr("set XDG_CACHE_HOME")));
    ResultCache in_proc("/proc/raygrade");
    EXPECT_THAT(in_proc.problems(), ElementsAre(HasSubstr("/proc/raygrade")));
}

TEST(ResultCache, ServesTwoRunsAtOnce) {
    const TemporaryFolder folder;
    constexpr int each = 100;
    const auto fill = [&](const std::string& who) {
        ResultCache cache(folder.path());
        for (int i = 0; i < each; ++i) {
            cache.keep(who + std::to_string(i), printed(who));
            cache.find("a" + std::to_string(i));
        }
        return cache.problems().empty();
    };
    const pid_t child = fork();
    if (child == 0) _exit(fill("a") ? 0 : 1);
    bool good = false;
    std::thread second([&] { good = fill("b"); });
    EXPECT_TRUE(fill("c"));
    second.join();
    EXPECT_TRUE(good);
    int status = -1;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
    ResultCache cache(folder.path());
    for (const std::string who : {"a", "b", "c"}) {
        for (int i = 0; i < each; ++i) EXPECT_EQ(output_of(cache, who + std::to_string(i)), who);
    }
}

TEST(ResultCache, HasEveryResultKeptBeforeARunWasKilled) {
    const TemporaryFolder folder;
    int said[2];
    ASSERT_EQ(pipe(said), 0);
    const pid_t child = fork();
    if (child == 0) {
        ResultCache cache(folder.path());
        for (int i = 0;; ++i) {
            cache.keep(std::to_string(i), printed(std::to_string(i)));
            if (write(said[1], "x", 1) != 1) _exit(1);
        }
    }
    close(said[1]);
    int kept = 0;
    for (char byte = 0; kept < 50 && read(said[0], &byte, 1) == 1;) ++kept;
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    for (char byte = 0; read(said[0], &byte, 1) == 1;) ++kept;
    close(said[0]);
    ASSERT_GE(kept, 50);
    ResultCache cache(folder.path());
    for (int i = 0; i < kept; ++i) EXPECT_EQ(output_of(cache, std::to_string(i)), std::to_string(i));
    EXPECT_THAT(cache.problems(), IsEmpty());
}

TEST(CacheFolder, FollowsTheXdgStandard) {
    const std::string home = getenv("HOME") == nullptr ? "" : getenv("HOME");
    setenv("HOME", "/home/x", 1);
    unsetenv("XDG_CACHE_HOME");
    EXPECT_EQ(harness::cache_folder(), "/home/x/.cache/raygrade");
    setenv("XDG_CACHE_HOME", "/var/cache/x", 1);
    EXPECT_EQ(harness::cache_folder(), "/var/cache/x/raygrade");
    setenv("XDG_CACHE_HOME", "relative", 1);
    EXPECT_EQ(harness::cache_folder(), "/home/x/.cache/raygrade") << "the standard: relative ones are ignored";
    unsetenv("XDG_CACHE_HOME");
    unsetenv("HOME");
    EXPECT_EQ(harness::cache_folder(), std::nullopt);
    setenv("HOME", home.c_str(), 1);
}

}  // namespace
