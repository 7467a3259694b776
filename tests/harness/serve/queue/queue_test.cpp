// The queue and its spool: the order of grading, and that no program that was handed in is ever lost.
#include "harness/serve/queue/queue.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <thread>

#include "harness/machine/errors.h"
#include "harness/serve/queue/result_address.h"
#include "tests/given/as_nobody.h"

namespace harness::serve {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;
using namespace std::chrono_literals;

class QueueTest : public testing::Test {
  protected:
    QueueTest() {
        std::string name = (fs::temp_directory_path() / "raygrade-test.XXXXXX").string();
        folder = mkdtemp(name.data());
    }
    ~QueueTest() override { fs::remove_all(folder); }

    static std::string hand_in(Queue& queue, const std::string& source) {
        return std::get<std::string>(queue.accept(source));
    }
    fs::path folder;
};

std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
}

std::size_t position(const Queue& queue, const std::string& address) {
    const Standing standing = queue.standing(address);
    const auto* waiting = std::get_if<Waiting>(&standing);
    return waiting == nullptr ? 0 : waiting->position;
}

TEST(ResultAddress, HasItsFormAndIsNeverRepeated) {
    std::set<std::string> seen;
    for (int i = 0; i < 1000; ++i) {
        const std::string address = new_result_address();
        EXPECT_TRUE(is_result_address(address)) << address;
        EXPECT_TRUE(seen.insert(address).second);
    }
    // An address has 128 random bits, so each bit must take both values.
    for (std::size_t digit = 0; digit < 32; ++digit) {
        std::set<char> values;
        for (const std::string& address : seen) values.insert(address[digit]);
        EXPECT_EQ(values.size(), 16U) << digit;
    }
}

TEST(ResultAddress, RejectsOtherForms) {
    const std::string good(32, 'a');
    EXPECT_TRUE(is_result_address(good));
    for (const std::string& wrong : {std::string(), good + "a", good.substr(1), std::string(32, 'A'),
                                     std::string(31, 'a') + "/", std::string(31, 'a') + '\0', "../" + good.substr(3)}) {
        EXPECT_FALSE(is_result_address(wrong)) << wrong;
    }
}

TEST_F(QueueTest, ProgramsAreGradedInOrderAndKnowTheirPlace) {
    KeptPrograms kept_programs(folder);
    Queue queue(kept_programs, 10);
    const std::string a = hand_in(queue, "a"), b = hand_in(queue, "b"), c = hand_in(queue, "c");
    EXPECT_EQ(position(queue, a), 1U);
    EXPECT_EQ(position(queue, c), 3U);
    EXPECT_EQ(std::get<Waiting>(queue.standing(b)).length, 3U);
    const Task first = queue.next().value();
    EXPECT_EQ(first.source, "a");
    EXPECT_TRUE(std::holds_alternative<BeingGraded>(queue.standing(a)));
    EXPECT_EQ(position(queue, b), 1U);
    queue.finish(first, {"page of a", 12.5, 100});
    const auto done = std::get<Done>(queue.standing(a));
    EXPECT_EQ(done.points, 12.5);
    EXPECT_EQ(done.max_points, 100);
    EXPECT_EQ(queue.page(a), "page of a");
    EXPECT_EQ(queue.page(b), std::nullopt);
    EXPECT_EQ(queue.next().value().source, "b");
}

TEST_F(QueueTest, AResultIsOnlyAtItsOwnAddress) {
    KeptPrograms kept_programs(folder);
    Queue queue(kept_programs, 10);
    const std::string a = hand_in(queue, "a");
    const Task task = queue.next().value();
    queue.finish(task, {"page", 1, 1});
    EXPECT_TRUE(std::holds_alternative<Unknown>(queue.standing(new_result_address())));
    // The spool's own key is no address either.
    EXPECT_TRUE(std::holds_alternative<Unknown>(queue.standing(task.key)));
    EXPECT_EQ(queue.page(task.key), std::nullopt);
    std::ifstream file(folder / "spool.sqlite-wal", std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    ASSERT_THAT(bytes, HasSubstr(task.key));
    EXPECT_THAT(bytes, testing::Not(HasSubstr(a)));
}

TEST_F(QueueTest, AFullQueueRefusesProgramsUntilThereIsRoom) {
    KeptPrograms kept_programs(folder);
    Queue queue(kept_programs, 2);
    hand_in(queue, "a");
    hand_in(queue, "b");
    EXPECT_EQ(std::get<Refusal>(queue.accept("c")), Refusal::full);
    queue.next();
    EXPECT_TRUE(std::holds_alternative<std::string>(queue.accept("c")));
}

TEST_F(QueueTest, WaitingProgramsSurviveAKillInOrder) {
    std::vector<std::string> addresses;
    {
        KeptPrograms kept_programs(folder);
        Queue queue(kept_programs, 10);
        for (const char* source : {"a", "b", "c"}) addresses.push_back(hand_in(queue, source));
        queue.next();  // a is being graded
    }
    KeptPrograms kept_programs(folder);
    Queue queue(kept_programs, 10);
    EXPECT_EQ(position(queue, addresses[0]), 1U);
    EXPECT_EQ(position(queue, addresses[2]), 3U);
    for (const char* source : {"a", "b", "c"}) EXPECT_EQ(queue.next().value().source, source);
}

TEST_F(QueueTest, ResultsSurviveARestart) {
    std::string address;
    {
        KeptPrograms kept_programs(folder);
        Queue queue(kept_programs, 10);
        address = hand_in(queue, "a");
        queue.finish(queue.next().value(), {"page", std::nullopt, 0});
    }
    KeptPrograms kept_programs(folder);
    const Queue queue(kept_programs, 10);
    EXPECT_EQ(std::get<Done>(queue.standing(address)).points, std::nullopt);
    EXPECT_EQ(queue.page(address), "page");
}

TEST_F(QueueTest, WhatWasAtWorkInACrashComesFirst) {
    {
        KeptPrograms kept_programs(folder);
        Queue queue(kept_programs, 10);
        EXPECT_EQ(queue.suspects(), 0U);
        for (const char* source : {"a", "b", "c"}) hand_in(queue, source);
        queue.finish(queue.next().value(), {"page", 1.0, 1});
        queue.next();  // b is being graded
    }
    {
        KeptPrograms kept_programs(folder);
        Queue queue(kept_programs, 10);
        EXPECT_EQ(queue.suspects(), 1U);
        hand_in(queue, "d");
        EXPECT_EQ(queue.next().value().source, "b");
        EXPECT_EQ(queue.next().value().source, "c");
    }
    KeptPrograms kept_programs(folder);
    Queue queue(kept_programs, 10);
    EXPECT_EQ(queue.suspects(), 2U);
    for (const char* source : {"b", "c", "d"}) EXPECT_EQ(queue.next().value().source, source);
}

TEST_F(QueueTest, AProgramIsNotTriedForEver) {
    SpoolBounds bounds;
    bounds.attempts = 3;
    {
        KeptPrograms kept_programs(folder, bounds);
        Queue queue(kept_programs, 10);
        hand_in(queue, "deadly");
    }
    for (int i = 0; i < 3; ++i) {
        KeptPrograms kept_programs(folder, bounds);
        Queue queue(kept_programs, 10);
        ASSERT_EQ(queue.next().value().source, "deadly") << i;
    }
    KeptPrograms kept_programs(folder, bounds);
    EXPECT_THAT(kept_programs.waiting(), IsEmpty());
    EXPECT_EQ(kept_programs.given_up().size(), 1U);
}

TEST_F(QueueTest, AStopDuringGradingDoesNotCountAsAnAttempt) {
    std::string address;
    {
        KeptPrograms kept_programs(folder);
        Queue queue(kept_programs, 10);
        address = hand_in(queue, "slow");
    }
    for (int i = 0; i < 5; ++i) {
        KeptPrograms kept_programs(folder);
        Queue queue(kept_programs, 10);
        ASSERT_EQ(queue.next().value().source, "slow") << i;
        EXPECT_EQ(queue.leave(), 1U);
        EXPECT_EQ(queue.next(), std::nullopt);
    }
}

TEST_F(QueueTest, GradersOfAClosedQueueFinishWaitingProgramsAndStop) {
    KeptPrograms kept_programs(folder);
    Queue queue(kept_programs, 10);
    for (const char* source : {"a", "b"}) hand_in(queue, source);
    queue.close();
    EXPECT_EQ(std::get<Refusal>(queue.accept("late")), Refusal::closed);
    std::vector<std::string> graded;
    while (const auto task = queue.next()) {
        EXPECT_FALSE(queue.is_idle());
        graded.push_back(task->source);
        queue.finish(*task, {"page", 1, 1});
    }
    EXPECT_THAT(graded, ElementsAre("a", "b"));
    EXPECT_TRUE(queue.is_idle());
}

TEST_F(QueueTest, AGraderWaitsForAProgramOrForTheEnd) {
    KeptPrograms kept_programs(folder);
    Queue queue(kept_programs, 10);
    std::vector<std::string> graded;
    std::thread grader([&] {
        while (const auto task = queue.next()) {
            graded.push_back(task->source);
            queue.finish(*task, {"page", 1, 1});
        }
    });
    const std::string address = hand_in(queue, "a");
    while (!std::holds_alternative<Done>(queue.standing(address))) std::this_thread::sleep_for(1ms);
    queue.close();
    grader.join();
    EXPECT_THAT(graded, ElementsAre("a"));
}

TEST_F(QueueTest, NoSourceIsKeptAfterItsResult) {
    KeptPrograms kept_programs(folder);
    Queue queue(kept_programs, 10);
    queue.accept("int secret;" + std::string(500, ' '), "of mine.cpp");
    queue.finish(queue.next().value(), {"page", 1, 1});
    SQLite::Database database((folder / "spool.sqlite").string(), SQLite::OPEN_READONLY);
    EXPECT_EQ(database.execAndGet("SELECT count(*) FROM submissions").getInt(), 1);
    EXPECT_EQ(
        database.execAndGet("SELECT count(*) FROM submissions WHERE source IS NOT NULL OR file IS NOT NULL").getInt(),
        0);
    kept_programs.trim();
    for (const auto& entry : fs::directory_iterator(folder)) {
        std::ifstream file(entry.path(), std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(file), {}};
        EXPECT_EQ(bytes.find("int secret;"), std::string::npos) << entry.path();
        EXPECT_EQ(bytes.find("of mine.cpp"), std::string::npos) << entry.path();
    }
}

TEST_F(QueueTest, TheOldestResultsAreRemovedBeyondTheBounds) {
    SpoolBounds bounds;
    bounds.results = 3;
    bounds.bytes = 100;
    KeptPrograms kept_programs(folder, bounds);
    for (int i = 0; i < 5; ++i) {
        kept_programs.add(std::to_string(i), "source");
        kept_programs.finish(std::to_string(i), {"page", 1, 1});
    }
    kept_programs.add("waiting", "source");
    kept_programs.trim();
    EXPECT_FALSE(kept_programs.result("1"));
    EXPECT_TRUE(kept_programs.result("2"));
    EXPECT_THAT(kept_programs.waiting(), ElementsAre("waiting"));
    kept_programs.finish("waiting", {std::string(97, 'x'), 1, 1});
    kept_programs.trim();
    EXPECT_TRUE(kept_programs.result("waiting"));
    EXPECT_FALSE(kept_programs.result("4"));
}

TEST_F(QueueTest, AResultIsRemovedAfterItsTime) {
    SpoolBounds bounds;
    bounds.age = 0s;
    KeptPrograms kept_programs(folder, bounds);
    kept_programs.add("a", "source");
    kept_programs.finish("a", {"page", 1, 1});
    EXPECT_FALSE(kept_programs.result("a"));
    EXPECT_FALSE(kept_programs.points("a"));
    kept_programs.trim();
    SQLite::Database database((folder / "spool.sqlite").string(), SQLite::OPEN_READONLY);
    EXPECT_EQ(database.execAndGet("SELECT count(*) FROM submissions").getInt(), 0);
}

TEST_F(QueueTest, AFolderIsUsedByOneProcessAtATime) {
    const KeptPrograms kept_programs(folder);
    try {
        const KeptPrograms second(folder);
        FAIL() << "two at a time";
    } catch (const HarnessError& error) {
        EXPECT_THAT(error.what(), HasSubstr("--state"));
    }
}

TEST_F(QueueTest, AForeignFolderIsRefusedAndLeftUnchanged) {
    fs::permissions(folder, static_cast<fs::perms>(0755));
    std::ofstream(folder / "mine.txt") << "mine";
    try {
        const KeptPrograms kept_programs(folder);
        FAIL() << "a folder of somebody else's";
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), AllOf(HasSubstr("is not empty and holds no queue"), HasSubstr("--state")));
    }
    EXPECT_EQ(fs::status(folder).permissions(), static_cast<fs::perms>(0755));
    EXPECT_THAT(names_in(folder), ElementsAre("mine.txt"));
    EXPECT_THROW(const KeptPrograms kept_programs(folder / "mine.txt"), UsageError);
}

TEST_F(QueueTest, AnExistingFolderKeepsItsModeAndItsFilesArePrivate) {
    fs::permissions(folder, static_cast<fs::perms>(0755));
    KeptPrograms kept_programs(folder);
    kept_programs.add("a", "source");
    EXPECT_EQ(fs::status(folder).permissions(), static_cast<fs::perms>(0755));
    EXPECT_THAT(names_in(folder), ElementsAre("lock", "spool.sqlite", "spool.sqlite-shm", "spool.sqlite-wal"));
    for (const auto& entry : fs::directory_iterator(folder))
        EXPECT_EQ(entry.status().permissions(), fs::perms::owner_read | fs::perms::owner_write) << entry.path();
}

TEST_F(QueueTest, AFolderOfAnUnfinishedOrSetAsideStartIsAccepted) {
    const fs::path begun = folder / "begun", aside = folder / "aside";
    for (const fs::path& each : {begun, aside}) fs::create_directory(each);
    std::ofstream(begun / "lock").flush();
    std::ofstream(aside / "spool.sqlite.set-aside") << "damaged";
    EXPECT_NO_THROW(const KeptPrograms kept_programs(begun));
    EXPECT_NO_THROW(const KeptPrograms kept_programs(aside));
    std::ofstream(folder / "lock") << "of another program";
    EXPECT_THROW(const KeptPrograms kept_programs(folder), UsageError);
}

TEST_F(QueueTest, ProgramsWaitingForADifferentAssignmentAreRefused) {
    {
        KeptPrograms kept_programs(folder);
        kept_programs.take_for("a6", "pixel = 1");
        kept_programs.add("done", "source");
        kept_programs.finish("done", {"page of a6", 1, 1});
        kept_programs.add("waiting", "source");
    }
    const auto why_not = [&](const char* assignment, const char* toml) -> std::string {
        KeptPrograms kept_programs(folder);
        try {
            kept_programs.take_for(assignment, toml);
        } catch (const UsageError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_THAT(why_not("a7", "pixel = 2"),
                AllOf(StartsWith('"' + folder.string() + "\": 1 program waits there for the assignment a6."),
                      HasSubstr("--state")));
    EXPECT_THAT(why_not("a6", "pixel = 2"), HasSubstr("for the assignment a6, whose file has changed since."));
    EXPECT_EQ(why_not("a6", "pixel = 1"), "");
    KeptPrograms(folder).finish("waiting", {"page", 1, 1});
    EXPECT_EQ(why_not("a7", "pixel = 2"), "") << "nothing waits any more";
    EXPECT_EQ(KeptPrograms(folder).result("done")->page, "page of a6");
    KeptPrograms(folder).add("new", "source");
    EXPECT_THAT(why_not("a6", "pixel = 1"), HasSubstr("for the assignment a7."));
}

TEST_F(QueueTest, ASpoolOfTheFirstVersionKeepsItsContents) {
    {
        SQLite::Database database((folder / "spool.sqlite").string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
        database.exec(
            "CREATE TABLE submissions (number INTEGER PRIMARY KEY AUTOINCREMENT, key TEXT NOT NULL UNIQUE, attempts "
            "INTEGER NOT NULL DEFAULT 0, source BLOB, page BLOB, points REAL, max_points REAL, finished INTEGER);"
            "INSERT INTO submissions (key, source) VALUES ('a', 'source');"
            "PRAGMA user_version = 1");
    }
    KeptPrograms kept_programs(folder);
    EXPECT_EQ(kept_programs.problem(), "");
    kept_programs.take_for("a6", "pixel = 1");
    EXPECT_THAT(kept_programs.waiting(), ElementsAre("a"));
    const Program program = kept_programs.begin("a");
    EXPECT_EQ(program.source, "source");
    EXPECT_EQ(program.file, "");
}

TEST_F(QueueTest, ASpoolOfALaterVersionIsSetAside) {
    {
        SQLite::Database database((folder / "spool.sqlite").string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
        database.exec("CREATE TABLE submissions (key); PRAGMA user_version = 99");
    }
    const KeptPrograms kept_programs(folder);
    EXPECT_THAT(kept_programs.problem(), HasSubstr("is of version 99"));
}

TEST_F(QueueTest, ADamagedSpoolIsSetAsideAndReported) {
    std::ofstream(folder / "spool.sqlite") << "this is no database, and it is long enough for SQLite to see that";
    KeptPrograms kept_programs(folder);
    EXPECT_THAT(kept_programs.problem(), HasSubstr("set-aside"));
    EXPECT_TRUE(fs::exists(folder / "spool.sqlite.set-aside"));
    kept_programs.add("a", "source");
    EXPECT_THAT(kept_programs.waiting(), ElementsAre("a"));
}

TEST_F(QueueTest, AnUnwritableFolderIsReportedWithTheWayOut) {
    fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
    const AsNobody nobody;
    EXPECT_THROW(const KeptPrograms kept_programs(folder / "below"), HarnessError);
}

TEST_F(QueueTest, OnlyItsOwnerReadsTheSpool) {
    const KeptPrograms kept_programs(folder / "new");
    EXPECT_EQ(fs::status(folder / "new").permissions(), fs::perms::owner_all);
}

TEST_F(QueueTest, AFailingDiskRefusesProgramsAndReportsLostResults) {
    KeptPrograms kept_programs(folder);
    Queue queue(kept_programs, 10);
    const std::string address = hand_in(queue, "a");
    const Task task = queue.next().value();
    {
        // A different process locks the database for longer than the queue waits.
        SQLite::Database other((folder / "spool.sqlite").string(), SQLite::OPEN_READWRITE);
        other.exec("BEGIN EXCLUSIVE");
        EXPECT_EQ(std::get<Refusal>(queue.accept("b")), Refusal::no_room_on_disk);
        queue.finish(task, {"page", 1, 1});
        EXPECT_TRUE(std::holds_alternative<Lost>(queue.standing(address)));
    }
    EXPECT_THAT(kept_programs.waiting(), ElementsAre(task.key));
}

}  // namespace
}  // namespace harness::serve
