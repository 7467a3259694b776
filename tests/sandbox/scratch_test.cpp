#include "harness/sandbox/scratch.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <stdlib.h>
#include <sys/stat.h>

#include <fstream>
#include <optional>

#include "harness/failure.h"
#include "harness/sandbox/file_descriptor.h"
#include "tests/as_nobody.h"

namespace {

using harness::Scratch;
using std::filesystem::perms;

TEST(Scratch, IsAnEmptyFolderOfItsOwnThatIsGoneAtTheEnd) {
    std::optional<Scratch> one{std::in_place};
    const Scratch two;
    EXPECT_NE(one->path(), two.path());
    EXPECT_TRUE(one->path().is_absolute());
    EXPECT_TRUE(std::filesystem::is_empty(one->path()));
    EXPECT_EQ(std::filesystem::status(one->path()).permissions(), perms::owner_all);
    const auto path = one->path();
    one.reset();
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(Scratch, RemovesFoldersWithoutPermissions) {
    const AsNobody somebody_else;
    std::optional<Scratch> scratch{std::in_place};
    const auto path = scratch->path();
    std::filesystem::create_directories(path / "a/b/c");
    std::ofstream(path / "a/b/c/file") << "x";
    for (const char* folder : {"a/b/c", "a/b", "a", "."}) std::filesystem::permissions(path / folder, perms::none);
    scratch.reset();
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(Scratch, RemovesAChainOfFoldersLongerThanAnyPath) {
    std::optional<Scratch> scratch{std::in_place};
    const auto path = scratch->path();
    harness::FileDescriptor at(open(path.c_str(), O_RDONLY | O_DIRECTORY));
    const std::string name(200, 'd');
    for (int i = 0; i < 200; ++i) {
        ASSERT_EQ(mkdirat(at.get(), name.c_str(), 0700), 0);
        at = harness::FileDescriptor(openat(at.get(), name.c_str(), O_RDONLY | O_DIRECTORY));
    }
    scratch.reset();
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(Scratch, RemovesFoldersCalledLikeItsOwn) {
    std::optional<Scratch> scratch{std::in_place};
    const auto path = scratch->path();
    std::filesystem::create_directories(path / "moved-0/moved-0/moved-1");
    std::filesystem::create_directories(path / "a/b");
    std::ofstream(path / "moved-1") << "x";
    scratch.reset();
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(Scratch, RemovesALinkAndNotWhatItPointsAt) {
    const Scratch other;
    std::ofstream(other.path() / "keep") << "x";
    std::filesystem::permissions(other.path(), perms::owner_read | perms::owner_exec);
    {
        const Scratch scratch;
        std::filesystem::create_directory_symlink(other.path(), scratch.path() / "link");
        std::filesystem::create_directories(scratch.path() / "inner");
        std::filesystem::create_directory_symlink(other.path(), scratch.path() / "inner/link");
    }
    EXPECT_TRUE(std::filesystem::exists(other.path() / "keep"));
    EXPECT_EQ(std::filesystem::status(other.path()).permissions(), perms::owner_read | perms::owner_exec);
}

TEST(Scratch, SaysWhereItCouldNotBeMadeAndTheWayOut) {
    setenv("TMPDIR", "/no/such/folder", 1);
    std::string message;
    try {
        const Scratch scratch;
    } catch (const harness::HarnessError& error) {
        message = error.what();
    }
    unsetenv("TMPDIR");
    EXPECT_EQ(
        message,
        "Could not make a scratch folder below \"/no/such/folder\": No such file or directory. Make room there, or "
        "set TMPDIR to a folder that can be written to.");
}

}  // namespace
