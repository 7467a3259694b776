#include "harness/machine/fresh_file.h"

#include <gmock/gmock.h>

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

TEST(WriteFile, ReplacesAnExistingFile) {
    const TemporaryFolder folder;
    const fs::path file = folder.write("grades.csv", "earlier");
    write_file(file, "later");
    EXPECT_EQ(bytes_of(file), "later");
    EXPECT_FALSE(fs::exists(folder.path() / "grades.csv.new"));
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
    EXPECT_FALSE(fs::exists(folder.path() / "grades.csv.new"));
}

TEST(WriteFile, ReplacesALinkAndNotItsTarget) {
    const TemporaryFolder folder;
    const fs::path target = folder.write("theirs", "theirs");
    for (const char* link : {"grades.csv", "grades.csv.new"}) fs::create_symlink(target, folder.path() / link);
    write_file(folder.path() / "grades.csv", "ours");
    EXPECT_EQ(bytes_of(target), "theirs");
    EXPECT_EQ(bytes_of(folder.path() / "grades.csv"), "ours");
    EXPECT_FALSE(fs::is_symlink(folder.path() / "grades.csv"));
}

TEST(WriteFile, ReportsANameTakenByAFolderAndLeavesNothingBehind) {
    const TemporaryFolder folder;
    const fs::path file = folder.make_folder("grades.csv");
    folder.write("grades.csv/mine.txt", "mine");
    EXPECT_THAT(failure_of_writing(file), AllOf(HasSubstr(file.string()), HasSubstr("can't be written")));
    EXPECT_TRUE(fs::exists(file / "mine.txt"));
    EXPECT_FALSE(fs::exists(folder.path() / "grades.csv.new"));
}

TEST(WriteFile, ReportsAMissingFolder) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "nowhere" / "grades.csv";
    EXPECT_THAT(failure_of_writing(file), AllOf(HasSubstr(file.string()), HasSubstr("No such file")));
}

}  // namespace
}  // namespace harness
