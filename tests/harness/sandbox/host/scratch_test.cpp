#include "harness/sandbox/host/scratch.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <optional>

namespace {

using harness::Scratch;
using harness::Workspace;

TEST(Scratch, IsANewEmptyFolderThatIsRemovedAtTheEnd) {
    const Workspace workspace;
    std::optional<Scratch> one{std::in_place, workspace};
    const Scratch two(workspace);
    EXPECT_NE(one->path(), two.path());
    EXPECT_EQ(one->path().parent_path(), workspace.path());
    EXPECT_TRUE(std::filesystem::is_empty(one->path()));
    struct stat info {};
    ASSERT_EQ(stat(one->path().c_str(), &info), 0);
    EXPECT_EQ(info.st_mode & 0777U, one->account() ? 0770U : 0700U);
    const auto path = one->path();
    one.reset();
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(Scratch, BelongsToItsOwnAccountWhenRootGrades) {
    const Workspace workspace;
    const Scratch one(workspace), two(workspace);
    struct stat info {};
    ASSERT_EQ(stat(one.path().c_str(), &info), 0);
    if (geteuid() != 0) {
        EXPECT_FALSE(one.account());
        EXPECT_EQ(info.st_uid, geteuid());
        return;
    }
    ASSERT_TRUE(one.account());
    EXPECT_EQ(info.st_uid, one.account()->uid);
    EXPECT_EQ(info.st_gid, getegid()) << "the harness keeps its way in";
    EXPECT_NE(one.account()->uid, 0U);
    EXPECT_NE(one.account()->uid, two.account()->uid);
}

TEST(Scratch, SaysWhatToDoWhenTheWorkspaceIsGone) {
    const Workspace workspace;
    std::filesystem::remove(workspace.path());
    EXPECT_ANY_THROW(Scratch{workspace});
}

}  // namespace
