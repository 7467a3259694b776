#include "harness/intake/archive.h"

#include <gmock/gmock.h>

#include <fstream>

#include "tests/given/message_of.h"
#include "tests/given/packed.h"
#include "tests/given/temporary_folder.h"

namespace {

using harness::ArchiveError;
using harness::ArchiveFile;
using harness::ArchiveLimits;
using harness::Links;
using harness::read_archive;
using testing::AllOf;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using Type = PackedEntry::Type;

std::uint64_t everything(std::string_view /*path*/) {
    return 1000;
}

auto file(const std::string& path, const std::string& bytes) {
    return AllOf(Field(&ArchiveFile::path, path), Field(&ArchiveFile::bytes, bytes));
}

class Archive : public testing::TestWithParam<const char*> {
  protected:
    std::filesystem::path archive(const std::vector<PackedEntry>& entries, const std::string& password = {}) const {
        return pack(folder_.path() / (std::string("class") + GetParam()), entries, password);
    }
    std::string why_not_read(const std::filesystem::path& archive, const ArchiveLimits& limits = {}) const {
        return message_of<ArchiveError>([&] { read_archive(archive, Links::follow, everything, limits); },
                                        "no ArchiveError");
    }
    std::string why_not(const std::vector<PackedEntry>& entries, const ArchiveLimits& limits = {}) const {
        return why_not_read(archive(entries), limits);
    }

    TemporaryFolder folder_;
};

TEST_P(Archive, GivesItsFilesInOrderWithTheirBytes) {
    const auto zoe_alone = [](std::string_view path) { return path.starts_with("zoe") ? 3 : 0; };
    EXPECT_THAT(read_archive(archive({{"zoe", "", Type::folder}, {"zoe/a.cpp", "abc"}, {"adam.cpp", "xyz"}}),
                             Links::follow, zoe_alone),
                ElementsAre(file("zoe/a.cpp", "abc"), file("adam.cpp", "")));
}

TEST_P(Archive, KeepsNoBytesOfAFileThatIsTooLarge) {
    const auto files =
        read_archive(archive({{"a.cpp", "abc"}, {"b.cpp", "abcd"}}), Links::follow, [](auto) { return 3; });
    ASSERT_EQ(files.size(), 2U);
    EXPECT_FALSE(files[0].too_large);
    EXPECT_TRUE(files[1].too_large);
    EXPECT_EQ(files[1].bytes, "");
}

TEST_P(Archive, ReadsNamesInAnyScript) {
    EXPECT_THAT(read_archive(archive({{"Łukasz/ray_cast.cpp", "l"}, {"李/光.cpp", "q"}}), Links::follow, everything),
                ElementsAre(file("Łukasz/ray_cast.cpp", "l"), file("李/光.cpp", "q")));
}

TEST_P(Archive, LeavesOutFilesThatNobodySubmitted) {
    EXPECT_THAT(
        read_archive(archive({{"__MACOSX/._a.cpp", "m"}, {".DS_Store", "d"}, {"x/.git/a.cpp", "g"}, {"./a.cpp", "a"}}),
                     Links::follow, everything),
        ElementsAre(file("a.cpp", "a")));
}

TEST_P(Archive, RefusesAndNamesPathsThatLeadOutside) {
    EXPECT_THAT(why_not({{"a.cpp", ""}, {"../../evil.cpp", "e"}}), HasSubstr("\"../../evil.cpp\""));
    EXPECT_THAT(why_not({{"a/../../evil.cpp", "e"}}), HasSubstr("leads out"));
    EXPECT_THAT(why_not({{"..\\evil.cpp", "e"}}), HasSubstr("leads out"));
    EXPECT_THAT(why_not({{"/etc/passwd", "e"}}), AllOf(HasSubstr("\"/etc/passwd\""), HasSubstr("absolute")));
    EXPECT_THAT(why_not({{"C:\\evil.cpp", "e"}}), HasSubstr("absolute"));
}

TEST_P(Archive, RefusesAndNamesEntriesThatAreNotFiles) {
    EXPECT_THAT(why_not({{"link.cpp", "/etc/passwd", Type::link}}),
                AllOf(HasSubstr("\"link.cpp\""), HasSubstr("is a link")));
}

TEST_P(Archive, RefusesTooManyEntries) {
    std::vector<PackedEntry> entries;
    for (int i = 0; i < 20'500; ++i) entries.push_back({std::to_string(i), ""});
    EXPECT_THAT(why_not(entries), AllOf(HasSubstr("more than 20000 entries"), HasSubstr("\"20000\"")));
}

TEST_P(Archive, RefusesABombByItsStatedSizesAndByItsBytes) {
    const std::vector<PackedEntry> entries = {{"a.cpp", std::string(900, 'a')}, {"bomb.cpp", std::string(900, 'b')}};
    EXPECT_THAT(why_not(entries, {.unpacked_bytes = 1000}), HasSubstr("\"bomb.cpp\""));
    EXPECT_THAT(why_not(entries, {.kept_bytes = 1000}), HasSubstr("\"bomb.cpp\""));
    EXPECT_EQ(why_not(entries, {.unpacked_bytes = 1800, .kept_bytes = 1800}), "no ArchiveError");
}

TEST_P(Archive, SaysWhereABrokenArchiveBreaks) {
    const auto path = archive({{"a.cpp", std::string(500, 'a')}, {"b.cpp", std::string(500, 'b')}});
    std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
    EXPECT_THAT(why_not_read(path), AllOf(HasSubstr(path.filename().string()), HasSubstr("cannot be")));
    std::ofstream(path) << "no archive at all";
    EXPECT_THAT(why_not_read(path), HasSubstr("cannot be"));
}

INSTANTIATE_TEST_SUITE_P(, Archive, testing::Values(".zip", ".tgz"),
                         [](const auto& tested) { return std::string(tested.param).substr(1); });

class Zip : public Archive {};
TEST_P(Zip, RefusesAnEncryptedZip) {
    EXPECT_THAT(why_not_read(archive({{"secret.cpp", "s"}}, "hunter2")),
                AllOf(HasSubstr("\"secret.cpp\""), HasSubstr("password")));
}
INSTANTIATE_TEST_SUITE_P(, Zip, testing::Values(".zip"));

class Tar : public Archive {};
TEST_P(Tar, RefusesHardLinksAndPipes) {
    EXPECT_THAT(why_not({{"a.cpp", "a"}, {"hard.cpp", "a.cpp", Type::hard_link}}),
                AllOf(HasSubstr("\"hard.cpp\""), HasSubstr("is a link")));
    EXPECT_THAT(why_not({{"pipe.cpp", "", Type::pipe}}), AllOf(HasSubstr("\"pipe.cpp\""), HasSubstr("is not a file")));
}
INSTANTIATE_TEST_SUITE_P(, Tar, testing::Values(".tgz"));

TEST(ArchiveOfBytes, ReadsLikeAFile) {
    EXPECT_THAT(read_archive(packed({{"a.cpp", "a"}}), "inner.zip", everything), ElementsAre(file("a.cpp", "a")));
}

TEST(IsArchiveName, KnowsTheEndings) {
    for (const char* name : {"class.zip", "class.ZIP", "a.tar", "a.tar.gz", "a.tgz"})
        EXPECT_TRUE(harness::is_archive_name(name));
    for (const char* name : {"zip", "a.rar", "a.gz", "zip.cpp"}) EXPECT_FALSE(harness::is_archive_name(name));
}

}  // namespace
