#include "harness/folder_writer.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/xattr.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <thread>

#include "harness/failure.h"
#include "tests/temporary_folder.h"

namespace harness {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::Pair;

class FolderWriting : public testing::Test {
  protected:
    std::map<std::string, std::string> files() const {
        std::map<std::string, std::string> files;
        for (const auto& entry : fs::directory_iterator(out)) {
            if (!entry.is_regular_file()) continue;
            std::ifstream stream(entry.path(), std::ios::binary);
            files[entry.path().filename().string()] = {std::istreambuf_iterator<char>(stream), {}};
        }
        return files;
    }
    struct stat look(const std::string& name) const {
        struct stat info {};
        EXPECT_EQ(lstat((out / name).c_str(), &info), 0) << name;
        return info;
    }
    /// Writes each of these files, one after the other, with the text behind its name.
    void write(const std::vector<std::pair<std::string, std::string>>& texts) const {
        FolderWriter writer(out);
        for (const auto& [name, text] : texts) writer.write(name, text);
    }

    TemporaryFolder folder;
    const fs::path out = folder.make_folder("out");
};

TEST_F(FolderWriting, LeavesWhatWasWrittenAndNothingElse) {
    write({{"a.md", "first"}, {"b.md", ""}});
    EXPECT_THAT(files(), ElementsAre(Pair("a.md", "first"), Pair("b.md", "")));
    write({{"b.md", std::string(100'000, 'b')}, {"a.md", "a"}, {"c.md", "c"}, {"b.md", "b"}});
    EXPECT_THAT(files(), ElementsAre(Pair("a.md", "a"), Pair("b.md", "b"), Pair("c.md", "c")));
}

TEST_F(FolderWriting, MakesNoFileWhereOneIsThere) {
    const fs::path one = folder.write("one", ""), other = folder.write("other", "");
    if (renameat2(AT_FDCWD, one.c_str(), AT_FDCWD, other.c_str(), RENAME_EXCHANGE) != 0)
        GTEST_SKIP() << "this file system does not let two files change places";
    write({{"a.md", "a"}, {"b.md", "b"}, {"c.md", "c"}});
    const auto a = look("a.md").st_ino, b = look("b.md").st_ino;
    write({{"a.md", "A"}, {"b.md", "B"}, {"c.md", "C"}});
    EXPECT_EQ(look("b.md").st_ino, a) << "the old file of a is the new one of b";
    EXPECT_EQ(look("c.md").st_ino, b);
}

TEST_F(FolderWriting, RemovesTheOthersWithTheSameEndings) {
    write({{"a.md", "a"}, {"b.md", "b"}, {"b.txt", "mine"}});
    FolderWriter writer(out);
    writer.write("a.md", "A");
    writer.remove_others({".md", ".html"});
    EXPECT_EQ(files().count("b.md"), 0U);
    EXPECT_EQ(files().at("a.md"), "A");
    EXPECT_EQ(files().at("b.txt"), "mine");
}

TEST_F(FolderWriting, IsSharedByThreads) {
    std::map<std::string, std::string> texts;
    for (int round = 1; round <= 2; ++round) {
        {
            FolderWriter writer(out);
            std::vector<std::jthread> threads;
            for (int thread = 0; thread < 3; ++thread) {
                threads.emplace_back([&, thread] {
                    for (int i = 0; i < 100; ++i) {
                        // Longer and shorter than what others have left.
                        const std::string text(static_cast<std::size_t>((i * 37 + thread * 11) % 500 * round), 'x');
                        writer.write(std::to_string(thread) + '-' + std::to_string(i), text);
                    }
                });
            }
        }
        texts.clear();
        for (int thread = 0; thread < 3; ++thread) {
            for (int i = 0; i < 100; ++i) {
                texts[std::to_string(thread) + '-' + std::to_string(i)] =
                    std::string(static_cast<std::size_t>((i * 37 + thread * 11) % 500 * round), 'x');
            }
        }
        EXPECT_EQ(files(), texts);
    }
}

TEST_F(FolderWriting, RemovesWhatAWriterThatWasKilledLeft) {
    for (const char* name : {".new", ".new-2", ".new-31", ".newer", ".new-x", "new-2"})
        folder.write(std::string("out/") + name, "");
    folder.write("out/.new-4/mine", "");
    FolderWriter writer(out);
    writer.write("a.md", "a");
    writer.write(".new-x.md", "of one whose name begins so");
    writer.write(".new-5", "and of one who is called so");
    writer.remove_others({".md"});
    EXPECT_THAT(files(), ElementsAre(Pair(".new-5", "and of one who is called so"), Pair(".new-x", ""),
                                     Pair(".new-x.md", "of one whose name begins so"), Pair(".newer", ""),
                                     Pair("a.md", "a"), Pair("new-2", "")));
    EXPECT_TRUE(fs::exists(out / ".new-4/mine"));
}

TEST_F(FolderWriting, LeavesTheCopyThatALinkMadeAlone) {
    write({{"a.md", "a"}, {"b.md", "b"}});
    fs::create_hard_link(out / "a.md", folder.path() / "copy.md");
    write({{"a.md", "A"}, {"b.md", "B"}});
    std::ifstream copy(folder.path() / "copy.md");
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(copy), {}), "a");
    EXPECT_THAT(files(), ElementsAre(Pair("a.md", "A"), Pair("b.md", "B")));
}

TEST_F(FolderWriting, LeavesAFileToWhoIsReadingIt) {
    write({{"a.md", "a"}, {"b.md", "b"}});
    std::ifstream reader(out / "a.md");
    write({{"a.md", "A"}, {"b.md", "B"}});
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(reader), {}), "a");
    EXPECT_THAT(files(), ElementsAre(Pair("a.md", "A"), Pair("b.md", "B")));
}

TEST_F(FolderWriting, GivesNoFileTheAttributesOfAnother) {
    write({{"a.md", "a"}, {"b.md", "b"}});
    const auto has_attribute = [&](const char* name) {
        return getxattr((out / name).c_str(), "user.of", nullptr, 0) >= 0;
    };
    if (setxattr((out / "a.md").c_str(), "user.of", "a", 1, 0) != 0) GTEST_SKIP() << "no attributes here";
    ASSERT_TRUE(has_attribute("a.md"));
    write({{"a.md", "A"}, {"b.md", "B"}});
    EXPECT_FALSE(has_attribute("a.md"));
    EXPECT_FALSE(has_attribute("b.md"));
}

TEST_F(FolderWriting, GivesNoFileTheRightsOfAnother) {
    write({{"a.md", "a"}, {"b.md", "b"}});
    const auto usual = look("b.md").st_mode;
    fs::permissions(out / "a.md", fs::perms::owner_all);
    ASSERT_NE(look("a.md").st_mode, usual);
    write({{"a.md", "A"}, {"b.md", "B"}});
    EXPECT_EQ(look("a.md").st_mode, usual);
    EXPECT_EQ(look("b.md").st_mode, usual);
}

TEST_F(FolderWriting, ReplacesALinkAndNotWhatItLeadsTo) {
    const fs::path target = folder.write("target.md", "target");
    for (const char* link : {"a.md", "b.md", ".new"}) fs::create_symlink(target, out / link);
    write({{"a.md", "A"}, {"b.md", "B"}});
    std::ifstream kept(target);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(kept), {}), "target");
    EXPECT_TRUE(S_ISREG(look("a.md").st_mode));
    EXPECT_THAT(files(), ElementsAre(Pair("a.md", "A"), Pair("b.md", "B")));
}

TEST_F(FolderWriting, TellsWhatCannotBeWritten) {
    EXPECT_THROW(FolderWriter(folder.path() / "nowhere").write("a.md", "a"), HarnessError);
    write({{"b.md", "b"}});
    fs::create_directory(out / "a.md");
    folder.write("out/a.md/inside", "");
    EXPECT_THROW(write({{"b.md", "B"}, {"a.md", "A"}}), HarnessError);
    EXPECT_TRUE(fs::exists(out / "a.md/inside"));
    EXPECT_EQ(files().at("b.md"), "B");
    EXPECT_EQ(files().count(".new"), 0U);
}

}  // namespace
}  // namespace harness
