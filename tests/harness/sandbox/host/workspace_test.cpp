#include "harness/sandbox/host/workspace.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <optional>

#include "harness/machine/errors.h"
#include "harness/sandbox/host/scratch.h"
#include "tests/given/message_of.h"
#include "tests/given/temporary_folder.h"

namespace {

using harness::Workspace;

/// Sets $TMPDIR to a new folder, so that the test sees only its own workspaces.
class OwnRoot {
  public:
    OwnRoot() { setenv("TMPDIR", folder_.path().c_str(), 1); }
    ~OwnRoot() { unsetenv("TMPDIR"); }
    OwnRoot(const OwnRoot&) = delete;
    OwnRoot& operator=(const OwnRoot&) = delete;

    const std::filesystem::path& path() const { return folder_.path(); }
    std::ptrdiff_t entries() const {
        const std::filesystem::directory_iterator all(path());
        return std::distance(begin(all), end(all));
    }

  private:
    TemporaryFolder folder_;
};

TEST(Workspace, IsRemovedAtTheEnd) {
    const OwnRoot root;
    {
        const Workspace workspace;
        EXPECT_EQ(workspace.path().parent_path(), root.path());
        std::ofstream(workspace.path() / "file") << "x";
        EXPECT_EQ(root.entries(), 1);
    }
    EXPECT_EQ(root.entries(), 0);
}

TEST(Workspace, OnlyItsUserMayListIt) {
    const OwnRoot root;
    const Workspace workspace;
    struct stat info {};
    ASSERT_EQ(stat(workspace.path().c_str(), &info), 0);
    EXPECT_EQ(info.st_mode & 0777U, geteuid() == 0 ? 0711U : 0700U);
}

TEST(Workspace, RemovesOnlyWhatAKilledRunLeft) {
    const OwnRoot root;
    std::filesystem::create_directory(root.path() / "raygrade-run-not-a-folder-of-ours-but-unlocked");
    std::filesystem::create_directory(root.path() / "raygrade");
    std::ofstream(root.path() / "raygrade-run-file") << "x";
    const Workspace living;
    const pid_t killed = fork();
    ASSERT_GE(killed, 0);
    if (killed == 0) {
        const Workspace workspace;
        const harness::Scratch scratch(workspace);
        std::ofstream(scratch.path() / "file") << "x";
        raise(SIGKILL);
    }
    waitpid(killed, nullptr, 0);
    // The child's workspace has already removed the unlocked folder.
    EXPECT_EQ(root.entries(), 4);
    const Workspace next;
    EXPECT_TRUE(std::filesystem::exists(living.path()));
    EXPECT_TRUE(std::filesystem::exists(root.path() / "raygrade"));
    EXPECT_TRUE(std::filesystem::exists(root.path() / "raygrade-run-file"));
    EXPECT_EQ(root.entries(), 4);
}

TEST(Workspace, LeavesFoldersOfOtherUsers) {
    if (geteuid() != 0) GTEST_SKIP() << "takes root";
    const OwnRoot root;
    const auto theirs = root.path() / "raygrade-run-theirs";
    std::filesystem::create_directory(theirs);
    ASSERT_EQ(chown(theirs.c_str(), 65534, 65534), 0);
    const Workspace workspace;
    EXPECT_TRUE(std::filesystem::exists(theirs));
}

TEST(Workspace, FollowsNoLink) {
    const OwnRoot root;
    const TemporaryFolder other;
    other.write("keep", "x");
    std::filesystem::create_directory_symlink(other.path(), root.path() / "raygrade-run-link");
    const Workspace workspace;
    EXPECT_TRUE(std::filesystem::exists(other.path() / "keep"));
}

TEST(Workspace, SaysWhereItCouldNotBeCreatedAndWhatToDo) {
    setenv("TMPDIR", "/no/such/folder", 1);
    const std::string message = message_of<harness::HarnessError>([] { const Workspace workspace; }, "made");
    unsetenv("TMPDIR");
    EXPECT_EQ(message,
              "Could not create a scratch folder in \"/no/such/folder\": No such file or directory. Free some space "
              "there, or "
              "set TMPDIR to a folder that you can write to.");
}

}  // namespace
