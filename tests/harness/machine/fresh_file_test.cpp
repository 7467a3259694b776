#include "harness/results_folder.h"

#include <gmock/gmock.h>

#include "harness/failure.h"
#include "temporary_folder.h"
#include "tests/bytes_of.h"

namespace harness {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

std::string failure_of_writing(const fs::path& file) {
    try {
        write_file(file, "text");
    } catch (const HarnessError& error) {
        return error.what();
    }
    return "(nothing thrown)";
}

TEST(WriteFile, ReplacesWhatWasThere) {
    const TemporaryFolder folder;
    const fs::path file = folder.write("grades.csv", "earlier");
    write_file(file, "later");
    EXPECT_EQ(bytes_of(file), "later");
    EXPECT_FALSE(fs::exists(folder.path() / "grades.csv.new"));
}

TEST(FreshFile, StaysBesideUntilItIsPutInPlace) {
    const TemporaryFolder folder;
    const fs::path file = folder.write("grades.csv", "earlier");
    {
        FreshFile fresh(file);
        fresh.write([](std::ostream& stream) { stream << "later"; });
        EXPECT_EQ(bytes_of(file), "earlier");
        EXPECT_EQ(bytes_of(folder.path() / "grades.csv.new"), "later");
    }
    EXPECT_EQ(bytes_of(file), "earlier");
    EXPECT_FALSE(fs::exists(folder.path() / "grades.csv.new"));
    folder.write("grades.csv.new", "of somebody else");
    { const FreshFile unused(file); }
    EXPECT_TRUE(fs::exists(folder.path() / "grades.csv.new"));
}

TEST(WriteFile, TellsOfANameThatIsTakenByAFolderAndLeavesNothingBehind) {
    const TemporaryFolder folder;
    const fs::path file = folder.make_folder("grades.csv");
    folder.write("grades.csv/mine.txt", "mine");
    EXPECT_THAT(failure_of_writing(file), AllOf(HasSubstr(file.string()), HasSubstr("can't be written")));
    EXPECT_TRUE(fs::exists(file / "mine.txt"));
    EXPECT_FALSE(fs::exists(folder.path() / "grades.csv.new"));
}

TEST(WriteFile, TellsOfAFolderThatIsMissing) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "nowhere" / "grades.csv";
    EXPECT_THAT(failure_of_writing(file), AllOf(HasSubstr(file.string()), HasSubstr("No such file")));
}

}  // namespace
}  // namespace harness
