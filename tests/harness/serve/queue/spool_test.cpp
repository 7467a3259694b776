// What a spool keeps and for how long, and the folder it is in.
#include "harness/serve/queue/spool.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "harness/machine/errors.h"
#include "tests/given/as_nobody.h"
#include "tests/given/message_of.h"
#include "tests/given/temporary_folder.h"

namespace harness::serve {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;
using testing::ThrowsMessage;
using namespace std::chrono_literals;

class SpoolTest : public testing::Test {
  protected:
    TemporaryFolder own;
    fs::path folder = own.path();
};

std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
}

TEST_F(SpoolTest, TheOldestResultsAreRemovedBeyondTheBounds) {
    SpoolBounds bounds;
    bounds.results = 3;
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
}

TEST_F(SpoolTest, AResultIsRemovedAfterItsTime) {
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

TEST_F(SpoolTest, AFolderIsUsedByOneProcessAtATime) {
    const KeptPrograms kept_programs(folder);
    EXPECT_THAT([&] { const KeptPrograms second(folder); }, ThrowsMessage<HarnessError>(HasSubstr("--state")));
}

TEST_F(SpoolTest, AForeignFolderIsRefusedAndLeftUnchanged) {
    fs::permissions(folder, static_cast<fs::perms>(0755));
    std::ofstream(folder / "mine.txt") << "mine";
    EXPECT_THAT([&] { const KeptPrograms kept_programs(folder); },
                ThrowsMessage<UsageError>(AllOf(HasSubstr("is not empty and has no queue"), HasSubstr("--state"))));
    EXPECT_EQ(fs::status(folder).permissions(), static_cast<fs::perms>(0755));
    EXPECT_THAT(names_in(folder), ElementsAre("mine.txt"));
    EXPECT_THROW(const KeptPrograms kept_programs(folder / "mine.txt"), UsageError);
}

TEST_F(SpoolTest, AnExistingFolderKeepsItsModeAndItsFilesArePrivate) {
    fs::permissions(folder, static_cast<fs::perms>(0755));
    KeptPrograms kept_programs(folder);
    kept_programs.add("a", "source");
    EXPECT_EQ(fs::status(folder).permissions(), static_cast<fs::perms>(0755));
    EXPECT_THAT(names_in(folder), ElementsAre("lock", "spool.sqlite", "spool.sqlite-shm", "spool.sqlite-wal"));
    for (const auto& entry : fs::directory_iterator(folder))
        EXPECT_EQ(entry.status().permissions(), fs::perms::owner_read | fs::perms::owner_write) << entry.path();
}

TEST_F(SpoolTest, AFolderOfAnUnfinishedStartIsAccepted) {
    const fs::path begun = folder / "begun";
    fs::create_directory(begun);
    std::ofstream(begun / "lock").flush();
    EXPECT_NO_THROW(const KeptPrograms kept_programs(begun));
    std::ofstream(folder / "lock") << "of another program";
    EXPECT_THROW(const KeptPrograms kept_programs(folder), UsageError);
}

TEST_F(SpoolTest, ADamagedSpoolOrOneOfAnotherVersionIsRefusedAndLeftUnchanged) {
    const std::string damaged = "this is no database, and it is long enough for SQLite to see that";
    std::ofstream(folder / "spool.sqlite") << damaged;
    EXPECT_THAT([&] { const KeptPrograms kept_programs(folder); },
                ThrowsMessage<HarnessError>(AllOf(HasSubstr("spool.sqlite"), HasSubstr("delete the file"))));
    EXPECT_EQ(fs::file_size(folder / "spool.sqlite"), damaged.size());
    fs::remove(folder / "spool.sqlite");
    {
        SQLite::Database database((folder / "spool.sqlite").string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
        database.exec("CREATE TABLE submissions (key); PRAGMA user_version = 99");
    }
    EXPECT_THAT([&] { const KeptPrograms kept_programs(folder); },
                ThrowsMessage<HarnessError>(HasSubstr("has version 99")));
}

TEST_F(SpoolTest, AnUnwritableFolderIsReportedWithTheWayOut) {
    fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
    const AsNobody nobody;
    EXPECT_THROW(const KeptPrograms kept_programs(folder / "below"), HarnessError);
}

TEST_F(SpoolTest, OnlyItsOwnerReadsTheSpool) {
    const KeptPrograms kept_programs(folder / "new");
    EXPECT_EQ(fs::status(folder / "new").permissions(), fs::perms::owner_all);
}

}  // namespace
}  // namespace harness::serve
