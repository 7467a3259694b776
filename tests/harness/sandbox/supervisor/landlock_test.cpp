#include "harness/sandbox/supervisor/landlock.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>

#include <cerrno>

#include "harness/machine/file_descriptor.h"
#include "tests/given/sandbox/in_a_child.h"
#include "tests/given/temporary_folder.h"

namespace {

using harness::restrict_files;

constexpr int could_not_restrict = 200;

/// Three folders with a file each: one readable, one writable, one forbidden.
class Landlock : public testing::Test {
  protected:
    Landlock() {
        for (const char* name : {"readable", "writable", "secret"}) folder.write(std::string(name) + "/file", "text");
    }
    std::string path(const std::string& name) const { return (folder.path() / name).string(); }
    /// errno of opening the file with these flags under Landlock; 0 on success.
    int open_restricted(const std::string& name, int flags) const {
        return in_a_child([&] {
            if (!restrict_files({path("readable"), "/no/such/folder"}, {path("writable"), "/dev/null"}))
                return could_not_restrict;
            const harness::FileDescriptor file(open(path(name).c_str(), flags, 0600));
            return file ? 0 : errno;
        });
    }

    TemporaryFolder folder;
};

TEST_F(Landlock, AllowsReadingReadableFolders) {
    EXPECT_EQ(open_restricted("readable/file", O_RDONLY), 0);
    EXPECT_EQ(open_restricted("readable", O_RDONLY | O_DIRECTORY), 0);
    EXPECT_EQ(open_restricted("readable/file", O_WRONLY), EACCES);
    EXPECT_EQ(open_restricted("readable/new", O_WRONLY | O_CREAT), EACCES);
}

TEST_F(Landlock, AllowsWritingWritableFolders) {
    EXPECT_EQ(open_restricted("writable/file", O_RDWR | O_TRUNC), 0);
    EXPECT_EQ(open_restricted("writable/new", O_WRONLY | O_CREAT), 0);
}

TEST_F(Landlock, ForbidsEverythingElse) {
    EXPECT_EQ(open_restricted("secret/file", O_RDONLY), EACCES);
    EXPECT_EQ(open_restricted("secret", O_RDONLY | O_DIRECTORY), EACCES);
    EXPECT_EQ(open_restricted("secret/new", O_WRONLY | O_CREAT), EACCES);
    EXPECT_EQ(open_restricted(".", O_RDONLY | O_DIRECTORY), EACCES);
}

TEST_F(Landlock, CannotBeBypassedByALink) {
    std::filesystem::create_symlink(path("secret/file"), path("writable/link"));
    EXPECT_EQ(open_restricted("writable/link", O_RDONLY), EACCES);
    const auto moved = in_a_child([&] {
        if (!restrict_files({path("readable")}, {path("writable")})) return could_not_restrict;
        return link(path("secret/file").c_str(), path("writable/hard").c_str()) == 0 ? 0 : errno;
    });
    EXPECT_NE(moved, 0);
    EXPECT_NE(moved, could_not_restrict);
}

TEST_F(Landlock, ForbidsSignalsToOthersIfTheKernelCan) {
    constexpr int since_signals = 6;
    if (harness::landlock_version() < since_signals) GTEST_SKIP() << "this kernel's Landlock leaves signals alone";
    const pid_t parent = getpid();
    const auto outcome = in_a_child([&] {
        if (!restrict_files({}, {})) return could_not_restrict;
        return kill(parent, 0) == 0 ? 0 : errno;
    });
    EXPECT_EQ(outcome, EPERM);
}

}  // namespace
