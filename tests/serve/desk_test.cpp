// The desk and its spool: the order of the queue, and that nothing handed in is ever lost.
#include "harness/serve/desk.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <thread>

#include "harness/failure.h"
#include "harness/find_submissions.h"
#include "harness/serve/result_address.h"
#include "tests/as_nobody.h"

namespace harness::serve {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;
using namespace std::chrono_literals;

class DeskTest : public testing::Test {
  protected:
    DeskTest() {
        std::string name = (fs::temp_directory_path() / "raygrade-test.XXXXXX").string();
        folder = mkdtemp(name.data());
    }
    ~DeskTest() override { fs::remove_all(folder); }

    static std::string hand_in(Desk& desk, const std::string& source) {
        return std::get<std::string>(desk.accept(source));
    }
    fs::path folder;
};

std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
}

std::size_t position(const Desk& desk, const std::string& address) {
    const Standing standing = desk.standing(address);
    const auto* waiting = std::get_if<Waiting>(&standing);
    return waiting == nullptr ? 0 : waiting->position;
}

TEST(ResultAddress, HasItsShapeAndNeverComesTwice) {
    std::set<std::string> seen;
    for (int i = 0; i < 1000; ++i) {
        const std::string address = new_result_address();
        EXPECT_TRUE(is_result_address(address)) << address;
        EXPECT_TRUE(seen.insert(address).second);
    }
    // Every bit takes both values: 128 of them are random.
    for (std::size_t digit = 0; digit < 32; ++digit) {
        std::set<char> values;
        for (const std::string& address : seen) values.insert(address[digit]);
        EXPECT_EQ(values.size(), 16U) << digit;
    }
}

TEST(ResultAddress, IsNothingElse) {
    const std::string good(32, 'a');
    EXPECT_TRUE(is_result_address(good));
    for (const std::string& wrong : {std::string(), good + "a", good.substr(1), std::string(32, 'A'),
                                     std::string(31, 'a') + "/", std::string(31, 'a') + '\0', "../" + good.substr(3)}) {
        EXPECT_FALSE(is_result_address(wrong)) << wrong;
    }
}

TEST_F(DeskTest, ProgramsAreGradedInTheirOrderAndEachIsToldItsPlace) {
    Spool spool(folder);
    Desk desk(spool, 10);
    const std::string a = hand_in(desk, "a"), b = hand_in(desk, "b"), c = hand_in(desk, "c");
    EXPECT_EQ(position(desk, a), 1U);
    EXPECT_EQ(position(desk, c), 3U);
    EXPECT_EQ(std::get<Waiting>(desk.standing(b)).length, 3U);
    const Task first = desk.next().value();
    EXPECT_EQ(first.source, "a");
    EXPECT_TRUE(std::holds_alternative<BeingGraded>(desk.standing(a)));
    EXPECT_EQ(position(desk, b), 1U);
    desk.finish(first, {"page of a", 12.5, 100});
    const auto done = std::get<Done>(desk.standing(a));
    EXPECT_EQ(done.points, 12.5);
    EXPECT_EQ(done.max_points, 100);
    EXPECT_EQ(desk.page(a), "page of a");
    EXPECT_EQ(desk.page(b), std::nullopt);
    EXPECT_EQ(desk.next().value().source, "b");
}

TEST_F(DeskTest, NobodyHasAResultAtAnotherAddress) {
    Spool spool(folder);
    Desk desk(spool, 10);
    const std::string a = hand_in(desk, "a");
    const Task task = desk.next().value();
    desk.finish(task, {"page", 1, 1});
    EXPECT_TRUE(std::holds_alternative<Unknown>(desk.standing(new_result_address())));
    // Not even with what the spool calls it by.
    EXPECT_TRUE(std::holds_alternative<Unknown>(desk.standing(task.key)));
    EXPECT_EQ(desk.page(task.key), std::nullopt);
    std::ifstream file(folder / "spool.sqlite-wal", std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    ASSERT_THAT(bytes, HasSubstr(task.key));
    EXPECT_THAT(bytes, testing::Not(HasSubstr(a)));
}

TEST_F(DeskTest, AFullQueueTakesNoMoreUntilThereIsRoom) {
    Spool spool(folder);
    Desk desk(spool, 2);
    hand_in(desk, "a");
    hand_in(desk, "b");
    EXPECT_EQ(std::get<Refusal>(desk.accept("c")), Refusal::full);
    desk.next();
    EXPECT_TRUE(std::holds_alternative<std::string>(desk.accept("c")));
}

TEST_F(DeskTest, WhatWaitsIsThereAfterAKillInItsOrder) {
    std::vector<std::string> addresses;
    {
        Spool spool(folder);
        Desk desk(spool, 10);
        for (const char* source : {"a", "b", "c"}) addresses.push_back(hand_in(desk, source));
        desk.next();  // a is being graded
    }
    Spool spool(folder);
    Desk desk(spool, 10);
    EXPECT_EQ(position(desk, addresses[0]), 1U);
    EXPECT_EQ(position(desk, addresses[2]), 3U);
    for (const char* source : {"a", "b", "c"}) EXPECT_EQ(desk.next().value().source, source);
}

TEST_F(DeskTest, ResultsAreThereAfterARestart) {
    std::string address;
    {
        Spool spool(folder);
        Desk desk(spool, 10);
        address = hand_in(desk, "a");
        desk.finish(desk.next().value(), {"page", std::nullopt, 0});
    }
    Spool spool(folder);
    const Desk desk(spool, 10);
    EXPECT_EQ(std::get<Done>(desk.standing(address)).points, std::nullopt);
    EXPECT_EQ(desk.page(address), "page");
}

TEST_F(DeskTest, WhatBringsRaygradeDownIsNotTriedForEver) {
    {
        Spool spool(folder);
        Desk desk(spool, 10);
        hand_in(desk, "deadly");
    }
    for (int i = 0; i < 3; ++i) {
        Spool spool(folder);
        Desk desk(spool, 10);
        ASSERT_EQ(desk.next().value().source, "deadly") << i;
    }
    Spool spool(folder);
    EXPECT_THAT(spool.waiting(), IsEmpty());
    EXPECT_EQ(spool.given_up().size(), 1U);
}

TEST_F(DeskTest, BeingStoppedWhileGradedIsNoAttempt) {
    std::string address;
    {
        Spool spool(folder);
        Desk desk(spool, 10);
        address = hand_in(desk, "slow");
    }
    for (int i = 0; i < 5; ++i) {
        Spool spool(folder);
        Desk desk(spool, 10);
        ASSERT_EQ(desk.next().value().source, "slow") << i;
        EXPECT_EQ(desk.leave(), 1U);
        EXPECT_EQ(desk.next(), std::nullopt);
    }
}

TEST_F(DeskTest, GradersOfAClosedDeskFinishWhatWaitsAndThenStop) {
    Spool spool(folder);
    Desk desk(spool, 10);
    for (const char* source : {"a", "b"}) hand_in(desk, source);
    desk.close();
    EXPECT_EQ(std::get<Refusal>(desk.accept("late")), Refusal::closed);
    std::vector<std::string> graded;
    while (const auto task = desk.next()) {
        EXPECT_FALSE(desk.is_idle());
        graded.push_back(task->source);
        desk.finish(*task, {"page", 1, 1});
    }
    EXPECT_THAT(graded, ElementsAre("a", "b"));
    EXPECT_TRUE(desk.is_idle());
}

TEST_F(DeskTest, AGraderWaitsForAProgramAndForTheEnd) {
    Spool spool(folder);
    Desk desk(spool, 10);
    std::vector<std::string> graded;
    std::thread grader([&] {
        while (const auto task = desk.next()) {
            graded.push_back(task->source);
            desk.finish(*task, {"page", 1, 1});
        }
    });
    const std::string address = hand_in(desk, "a");
    while (!std::holds_alternative<Done>(desk.standing(address))) std::this_thread::sleep_for(1ms);
    desk.close();
    grader.join();
    EXPECT_THAT(graded, ElementsAre("a"));
}

TEST_F(DeskTest, NoSourceIsKeptBesideItsResult) {
    Spool spool(folder);
    Desk desk(spool, 10);
    desk.accept("int secret;" + std::string(500, ' '), "of mine.cpp");
    desk.finish(desk.next().value(), {"page", 1, 1});
    SQLite::Database database((folder / "spool.sqlite").string(), SQLite::OPEN_READONLY);
    EXPECT_EQ(database.execAndGet("SELECT count(*) FROM submissions").getInt(), 1);
    EXPECT_EQ(
        database.execAndGet("SELECT count(*) FROM submissions WHERE source IS NOT NULL OR file IS NOT NULL").getInt(),
        0);
    spool.trim();
    for (const auto& entry : fs::directory_iterator(folder)) {
        std::ifstream file(entry.path(), std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(file), {}};
        EXPECT_EQ(bytes.find("int secret;"), std::string::npos) << entry.path();
        EXPECT_EQ(bytes.find("of mine.cpp"), std::string::npos) << entry.path();
    }
}

TEST_F(DeskTest, ResultsAreBoundedInNumberAndBytesTheOldestGoFirst) {
    SpoolBounds bounds;
    bounds.results = 3;
    bounds.bytes = 100;
    Spool spool(folder, bounds);
    for (int i = 0; i < 5; ++i) {
        spool.add(std::to_string(i), "source");
        spool.finish(std::to_string(i), {"page", 1, 1});
    }
    spool.add("waiting", "source");
    spool.trim();
    EXPECT_FALSE(spool.result("1"));
    EXPECT_TRUE(spool.result("2"));
    EXPECT_THAT(spool.waiting(), ElementsAre("waiting"));
    spool.finish("waiting", {std::string(97, 'x'), 1, 1});
    spool.trim();
    EXPECT_TRUE(spool.result("waiting"));
    EXPECT_FALSE(spool.result("4"));
}

TEST_F(DeskTest, AResultIsGoneAfterItsTime) {
    SpoolBounds bounds;
    bounds.age = 0s;
    Spool spool(folder, bounds);
    spool.add("a", "source");
    spool.finish("a", {"page", 1, 1});
    EXPECT_FALSE(spool.result("a"));
    EXPECT_FALSE(spool.points("a"));
    spool.trim();
    SQLite::Database database((folder / "spool.sqlite").string(), SQLite::OPEN_READONLY);
    EXPECT_EQ(database.execAndGet("SELECT count(*) FROM submissions").getInt(), 0);
}

TEST_F(DeskTest, AFolderIsUsedByOneAtATime) {
    const Spool spool(folder);
    try {
        const Spool second(folder);
        FAIL() << "two at a time";
    } catch (const HarnessError& error) {
        EXPECT_THAT(error.what(), HasSubstr("--state"));
    }
}

TEST_F(DeskTest, AFolderOfAnythingElseIsRefusedAndLeftAsItIs) {
    fs::permissions(folder, static_cast<fs::perms>(0755));
    std::ofstream(folder / "mine.txt") << "mine";
    try {
        const Spool spool(folder);
        FAIL() << "a folder of somebody else's";
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), AllOf(HasSubstr("is not empty and holds no queue"), HasSubstr("--state")));
    }
    EXPECT_EQ(fs::status(folder).permissions(), static_cast<fs::perms>(0755));
    EXPECT_THAT(names_in(folder), ElementsAre("mine.txt"));
    EXPECT_THROW(const Spool spool(folder / "mine.txt"), UsageError);
}

TEST_F(DeskTest, AFolderThatIsThereKeepsItsModeAndOthersReadNoFileInIt) {
    fs::permissions(folder, static_cast<fs::perms>(0755));
    Spool spool(folder);
    spool.add("a", "source");
    EXPECT_EQ(fs::status(folder).permissions(), static_cast<fs::perms>(0755));
    EXPECT_THAT(names_in(folder), ElementsAre("lock", "spool.sqlite", "spool.sqlite-shm", "spool.sqlite-wal"));
    for (const auto& entry : fs::directory_iterator(folder))
        EXPECT_EQ(entry.status().permissions(), fs::perms::owner_read | fs::perms::owner_write) << entry.path();
}

TEST_F(DeskTest, AFolderThatAStartHasBegunOrSetAsideIsTaken) {
    const fs::path begun = folder / "begun", aside = folder / "aside";
    for (const fs::path& each : {begun, aside}) fs::create_directory(each);
    std::ofstream(begun / "lock").flush();
    std::ofstream(aside / "spool.sqlite.set-aside") << "damaged";
    EXPECT_NO_THROW(const Spool spool(begun));
    EXPECT_NO_THROW(const Spool spool(aside));
    std::ofstream(folder / "lock") << "of another program";
    EXPECT_THROW(const Spool spool(folder), UsageError);
}

TEST_F(DeskTest, WhatWaitsForAnotherAssignmentIsRefused) {
    {
        Spool spool(folder);
        spool.take_for("a6", "pixel = 1");
        spool.add("done", "source");
        spool.finish("done", {"page of a6", 1, 1});
        spool.add("waiting", "source");
    }
    const auto why_not = [&](const char* assignment, const char* toml) -> std::string {
        Spool spool(folder);
        try {
            spool.take_for(assignment, toml);
        } catch (const UsageError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_THAT(why_not("a7", "pixel = 2"),
                AllOf(StartsWith('"' + folder.string() + "\": 1 program waits there for the assignment a6."),
                      HasSubstr("--state")));
    EXPECT_THAT(why_not("a6", "pixel = 2"), HasSubstr("for the assignment a6, whose file was another one then."));
    EXPECT_EQ(why_not("a6", "pixel = 1"), "");
    Spool(folder).finish("waiting", {"page", 1, 1});
    EXPECT_EQ(why_not("a7", "pixel = 2"), "") << "nothing waits any more";
    EXPECT_EQ(Spool(folder).result("done")->page, "page of a6");
    Spool(folder).add("new", "source");
    EXPECT_THAT(why_not("a6", "pixel = 1"), HasSubstr("for the assignment a7."));
}

TEST_F(DeskTest, ASpoolOfTheFirstVersionKeepsWhatItHolds) {
    {
        SQLite::Database database((folder / "spool.sqlite").string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
        database.exec(
            "CREATE TABLE submissions (number INTEGER PRIMARY KEY AUTOINCREMENT, key TEXT NOT NULL UNIQUE, attempts "
            "INTEGER NOT NULL DEFAULT 0, source BLOB, page BLOB, points REAL, max_points REAL, finished INTEGER);"
            "INSERT INTO submissions (key, source) VALUES ('a', 'source');"
            "PRAGMA user_version = 1");
    }
    Spool spool(folder);
    EXPECT_EQ(spool.problem(), "");
    spool.take_for("a6", "pixel = 1");
    EXPECT_THAT(spool.waiting(), ElementsAre("a"));
    const Program program = spool.begin("a");
    EXPECT_EQ(program.source, "source");
    EXPECT_EQ(program.file, "");
}

TEST_F(DeskTest, ASpoolOfALaterVersionIsSetAside) {
    {
        SQLite::Database database((folder / "spool.sqlite").string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
        database.exec("CREATE TABLE submissions (key); PRAGMA user_version = 99");
    }
    const Spool spool(folder);
    EXPECT_THAT(spool.problem(), HasSubstr("is of version 99"));
}

TEST_F(DeskTest, ADamagedSpoolIsSetAsideAndTold) {
    std::ofstream(folder / "spool.sqlite") << "this is no database, and it is long enough for SQLite to see that";
    Spool spool(folder);
    EXPECT_THAT(spool.problem(), HasSubstr("set-aside"));
    EXPECT_TRUE(fs::exists(folder / "spool.sqlite.set-aside"));
    spool.add("a", "source");
    EXPECT_THAT(spool.waiting(), ElementsAre("a"));
}

TEST_F(DeskTest, AFolderThatCantBeWrittenIsToldWithTheWayOut) {
    fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
    const AsNobody nobody;
    EXPECT_THROW(const Spool spool(folder / "below"), HarnessError);
}

TEST_F(DeskTest, OnlyItsOwnerReadsTheSpool) {
    const Spool spool(folder / "new");
    EXPECT_EQ(fs::status(folder / "new").permissions(), fs::perms::owner_all);
}

TEST_F(DeskTest, ADiskThatFailsRefusesProgramsAndLosesNoResultSilently) {
    Spool spool(folder);
    Desk desk(spool, 10);
    const std::string address = hand_in(desk, "a");
    const Task task = desk.next().value();
    {
        // Somebody else has the database for longer than anyone waits.
        SQLite::Database other((folder / "spool.sqlite").string(), SQLite::OPEN_READWRITE);
        other.exec("BEGIN EXCLUSIVE");
        EXPECT_EQ(std::get<Refusal>(desk.accept("b")), Refusal::no_room_on_disk);
        desk.finish(task, {"page", 1, 1});
        EXPECT_TRUE(std::holds_alternative<Lost>(desk.standing(address)));
    }
    EXPECT_THAT(spool.waiting(), ElementsAre(task.key));
}

}  // namespace
}  // namespace harness::serve
