#include "harness/machine/fresh_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/file.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "harness/machine/errors.h"
#include "tests/given/bytes_of.h"
#include "tests/given/message_of.h"
#include "tests/given/temporary_folder.h"

namespace harness {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

std::string failure_of_writing(const fs::path& file) {
    return message_of<HarnessError>([&] { write_file(file, "text"); }, "(nothing thrown)");
}

TEST(FolderLock, WaitsForProcessesThatAKilledRaygradeLeft) {
    const TemporaryFolder folder;
    const int other = open(folder.path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    ASSERT_EQ(flock(other, LOCK_EX), 0);
    const std::jthread left_behind([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        close(other);
    });
    EXPECT_NO_THROW(FolderLock(folder.path()));
}

TEST(WriteFile, ReplacesAnExistingFile) {
    const TemporaryFolder folder;
    const fs::path file = folder.write("grades.csv", "earlier");
    write_file(file, "later");
    EXPECT_EQ(bytes_of(file), "later");
    EXPECT_FALSE(fs::exists(folder.path() / "grades.csv.raygrade-new"));
}

TEST(WriteFile, KeepsTheOldFileUntilTheNewOneIsComplete) {
    const TemporaryFolder folder;
    const fs::path file = folder.write("grades.csv", "earlier");
    write_file(file, [&](std::ostream& stream) {
        stream << "later" << std::flush;
        EXPECT_EQ(bytes_of(file), "earlier");
    });
    EXPECT_EQ(bytes_of(file), "later");
    EXPECT_THROW(write_file(file, [](std::ostream&) { throw std::runtime_error("no more"); }), std::runtime_error);
    EXPECT_EQ(bytes_of(file), "later");
    EXPECT_FALSE(fs::exists(folder.path() / "grades.csv.raygrade-new"));
}

TEST(WriteFile, ReplacesALinkAndNotItsTarget) {
    const TemporaryFolder folder;
    const fs::path target = folder.write("theirs", "theirs");
    for (const char* link : {"grades.csv", "grades.csv.raygrade-new"}) fs::create_symlink(target, folder.path() / link);
    write_file(folder.path() / "grades.csv", "ours");
    EXPECT_EQ(bytes_of(target), "theirs");
    EXPECT_EQ(bytes_of(folder.path() / "grades.csv"), "ours");
    EXPECT_FALSE(fs::is_symlink(folder.path() / "grades.csv"));
}

std::string why_no_place(const fs::path& file, Earlier earlier = Earlier::replaced) {
    return message_of<UsageError>([&] { require_can_write({file, "--note", "note of ours", "# note"}, earlier); }, "");
}

TEST(RequirePlace, AcceptsAFreePlaceAndAnEarlierFileOfItsKind) {
    const TemporaryFolder folder;
    EXPECT_EQ(why_no_place(folder.path() / "new.md"), "");
    const fs::path earlier = folder.write("earlier.md", "<!-- mine -->\n# note\n");
    EXPECT_EQ(why_no_place(earlier), "");
    EXPECT_THAT(why_no_place(earlier, Earlier::kept), HasSubstr("earlier.md exists; replace it with --force"));
}

TEST(RequirePlace, RefusesAnotherFileALinkAndAMissingFolder) {
    const TemporaryFolder folder;
    const fs::path earlier = folder.write("earlier.md", "# note\n");
    fs::create_symlink(earlier, folder.path() / "link.md");
    for (const fs::path& other : {folder.write("ray_cast.cpp", "int main() {}\n"), folder.write("empty", ""),
                                  folder.write("late", std::string(1000, ' ') + "# note"), folder.path() / "link.md",
                                  folder.make_folder("folder")}) {
        EXPECT_THAT(why_no_place(other), HasSubstr("exists and is not a note of ours; name another file with --note"))
            << other;
    }
    EXPECT_THAT(why_no_place(folder.path() / "nowhere/new.md"), HasSubstr("cannot be written: No such file"));
}

TEST(RemoveEarlier, ReportsAFailureAndIgnoresAMissingFile) {
    const TemporaryFolder folder;
    const auto failure = [&](const fs::path& file) {
        return message_of<UsageError>([&] { remove_earlier({file, "--note", "note of ours", "# note"}); }, "");
    };
    const fs::path earlier = folder.write("earlier.md", "# note\n");
    EXPECT_EQ(failure(earlier), "");
    EXPECT_FALSE(fs::exists(earlier));
    EXPECT_EQ(failure(earlier), "");
    folder.write("full/mine.txt", "mine");
    EXPECT_THAT(failure(folder.path() / "full"), HasSubstr("name another file with --note"));
}

TEST(WriteFile, ReportsANameTakenByAFolderAndLeavesNothingBehind) {
    const TemporaryFolder folder;
    const fs::path file = folder.make_folder("grades.csv");
    folder.write("grades.csv/mine.txt", "mine");
    EXPECT_THAT(failure_of_writing(file), AllOf(HasSubstr(file.string()), HasSubstr("cannot write ")));
    EXPECT_TRUE(fs::exists(file / "mine.txt"));
    EXPECT_FALSE(fs::exists(folder.path() / "grades.csv.raygrade-new"));
}

TEST(WriteFile, ReportsAMissingFolder) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "nowhere" / "grades.csv";
    EXPECT_THAT(failure_of_writing(file), AllOf(HasSubstr(file.string()), HasSubstr("No such file")));
}

}  // namespace
}  // namespace harness
