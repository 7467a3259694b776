#include "harness/machine/bounded_file.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <cerrno>

#include "tests/given/temporary_folder.h"

namespace harness {
namespace {

TEST(BoundedFile, ReadsNoMoreThanItsLimit) {
    const TemporaryFolder folder;
    const auto file = folder.write("a.csv", "12345");
    const BoundedFile exact = read_bounded(file, 5, Links::follow);
    EXPECT_EQ(exact.bytes, "12345");
    EXPECT_TRUE(exact.is_whole());
    const BoundedFile more = read_bounded(file, 4, Links::follow);
    EXPECT_EQ(more.bytes, "1234");
    EXPECT_TRUE(more.has_more);
    EXPECT_FALSE(more.is_whole());
    EXPECT_EQ(why_not_whole(more, 4), "it is larger than 4 bytes");
    EXPECT_EQ(why_not_whole(more, 2 << 20), "it is larger than 2 MiB");
    EXPECT_TRUE(read_bounded(folder.write("empty", ""), 4, Links::follow).is_whole());
}

TEST(BoundedFile, ReadsAFileOfUnknownSizeToItsEnd) {
    // A file that the kernel generates while it is read has the size 0.
    const BoundedFile status = read_bounded("/proc/self/status", 1 << 20, Links::follow);
    EXPECT_TRUE(status.is_whole());
    EXPECT_THAT(status.bytes, testing::HasSubstr("Name:"));
    EXPECT_TRUE(read_bounded("/proc/self/status", 10, Links::follow).has_more);
}

TEST(BoundedFile, RefusesPipesFoldersAndUnwantedLinks) {
    const TemporaryFolder folder;
    const auto pipe = folder.path() / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_TRUE(read_bounded(pipe, 4, Links::follow).is_special) << "and does not wait for a writer";
    EXPECT_TRUE(read_bounded(folder.path(), 4, Links::follow).is_special);
    EXPECT_EQ(why_not_whole(read_bounded("/dev/zero", 4, Links::follow), 4), "it is a folder, pipe or device");
    const auto file = folder.write("a.csv", "123");
    std::filesystem::create_symlink(file, folder.path() / "link");
    EXPECT_EQ(read_bounded(folder.path() / "link", 4, Links::follow).bytes, "123");
    EXPECT_EQ(read_bounded(folder.path() / "link", 4, Links::refuse).error, ELOOP);
    const BoundedFile missing = read_bounded(folder.path() / "missing", 4, Links::follow);
    EXPECT_EQ(missing.error, ENOENT);
    EXPECT_EQ(why_not_whole(missing, 4), "No such file or directory");
}

}  // namespace
}  // namespace harness
