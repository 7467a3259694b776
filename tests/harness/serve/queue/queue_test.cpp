// The queue and its spool: the order of grading, and that no program that was handed in is ever lost.
#include "harness/serve/queue/queue.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <thread>

#include "harness/serve/queue/result_address.h"
#include "tests/given/temporary_folder.h"

namespace harness::serve {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using namespace std::chrono_literals;

class QueueTest : public testing::Test {
  protected:
    static std::string hand_in(Queue& queue, const std::string& source) {
        return std::get<std::string>(queue.accept(source));
    }
    TemporaryFolder own;
    fs::path folder = own.path();
};

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
    EXPECT_TRUE(std::get<BeingGraded>(queue.standing(b)).last_took) << "as long as a took";
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

TEST_F(QueueTest, ProgramsInterruptedByACrashComeFirst) {
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
    for (const auto& [source, crashes] : {std::pair("b", 2U), {"c", 1U}, {"d", 0U}}) {
        const Task task = queue.next().value();
        EXPECT_EQ(task.source, source);
        EXPECT_EQ(task.crashes, crashes) << source;
    }
}

TEST_F(QueueTest, AStopDuringGradingMakesNoSuspect) {
    std::string address;
    {
        KeptPrograms kept_programs(folder);
        Queue queue(kept_programs, 10);
        address = hand_in(queue, "slow");
    }
    for (int i = 0; i < 2; ++i) {
        KeptPrograms kept_programs(folder);
        Queue queue(kept_programs, 10);
        EXPECT_EQ(queue.suspects(), 0U) << i;
        ASSERT_EQ(queue.next().value().source, "slow") << i;
        EXPECT_EQ(queue.leave(), 1U);
        EXPECT_EQ(queue.next(), std::nullopt);
    }
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
    queue.leave();
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
