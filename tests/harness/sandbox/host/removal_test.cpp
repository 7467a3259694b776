#include "harness/sandbox/host/removal.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "harness/machine/file_descriptor.h"
#include "tests/given/as_nobody.h"
#include "tests/given/temporary_folder.h"

namespace {

using harness::remove_folder;
using std::filesystem::perms;

TEST(RemoveFolder, RemovesFoldersWithoutPermissions) {
    const AsNobody somebody_else;
    const TemporaryFolder folder;
    const auto path = folder.make_folder("top");
    std::filesystem::create_directories(path / "a/b/c");
    std::ofstream(path / "a/b/c/file") << "x";
    for (const char* inner : {"a/b/c", "a/b", "a", "."}) std::filesystem::permissions(path / inner, perms::none);
    remove_folder(path);
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(RemoveFolder, RemovesAChainOfFoldersLongerThanAnyPath) {
    const TemporaryFolder folder;
    const auto path = folder.make_folder("top");
    harness::FileDescriptor at(open(path.c_str(), O_RDONLY | O_DIRECTORY));
    const std::string name(200, 'd');
    for (int i = 0; i < 200; ++i) {
        ASSERT_EQ(mkdirat(at.get(), name.c_str(), 0700), 0);
        at = harness::FileDescriptor(openat(at.get(), name.c_str(), O_RDONLY | O_DIRECTORY));
    }
    remove_folder(path);
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(RemoveFolder, RemovesFoldersWithReservedNames) {
    const TemporaryFolder folder;
    const auto path = folder.make_folder("top");
    std::filesystem::create_directories(path / "moved-0/moved-0/moved-1");
    std::filesystem::create_directories(path / "a/b");
    std::ofstream(path / "moved-1") << "x";
    remove_folder(path);
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(RemoveFolder, RemovesALinkAndNotItsTarget) {
    const TemporaryFolder folder;
    const auto other = folder.make_folder("other");
    std::ofstream(other / "keep") << "x";
    std::filesystem::permissions(other, perms::owner_read | perms::owner_exec);
    const auto path = folder.make_folder("top");
    std::filesystem::create_directory_symlink(other, path / "link");
    std::filesystem::create_directories(path / "inner");
    std::filesystem::create_directory_symlink(other, path / "inner/link");
    remove_folder(path);
    EXPECT_FALSE(std::filesystem::exists(path));
    EXPECT_TRUE(std::filesystem::exists(other / "keep"));
    EXPECT_EQ(std::filesystem::status(other).permissions(), perms::owner_read | perms::owner_exec);
}

}  // namespace
