// A class that is one archive.
#include <gmock/gmock.h>

#include "tests/given/packed.h"
#include "tests/given/temporary_folder.h"
#include "tests/harness/intake/taken.h"

namespace {

using testing::ElementsAre;

TEST(PackedClass, GivesTheSameAsAFolder) {
    const TemporaryFolder folder;
    const auto wrapped =
        take(pack(folder.path() / "wrapped.tgz", {{"class/zoe/ray_cast.cpp", "z"}, {"class/adam/a.cc", "a"}}));
    EXPECT_THAT(ids(wrapped), ElementsAre("adam", "zoe"));
    EXPECT_EQ(wrapped.at("zoe").file, folder.path() / "wrapped.tgz/class/zoe/ray_cast.cpp");
    const auto exported = take(pack(folder.path() / "export.zip", {{"assignment_5_export/submission_7/a.cpp", "a"}}));
    EXPECT_THAT(ids(exported), ElementsAre("submission_7"));
    EXPECT_THAT(ids(take(pack(folder.path() / "flat.zip", {{"bob.cpp", "b"}, {"alice.cpp", "a"}}))),
                ElementsAre("alice", "bob"));
    EXPECT_THAT(ids(take(pack(folder.path() / "one.zip", {{"ray_cast.cpp", "r"}, {"ray.h", "h"}}))),
                ElementsAre("one.zip"));
}

TEST(PackedClass, OfGradescopeIgnoresMetadataThatStudentsSubmit) {
    const TemporaryFolder folder;
    const std::string largest(std::size_t{64} << 20U, '#');
    // Each file lies next to a folder with a name as in an export.
    std::vector<PackedEntry> entries = {{"export/submission_901/ray_cast.cpp", "a"}};
    for (int i = 0; i < 8; ++i) {
        entries.push_back({"export/submission_901/" + std::to_string(i) + "/submission_metadata.yml", largest});
        entries.push_back({"export/submission_901/" + std::to_string(i) + "/submission_1/a.txt", ""});
    }
    entries.push_back({"export/submission_metadata.yml", "submission_901:\n  :submitters:\n  - :name: Jane Doe\n"});
    EXPECT_THAT(ids(take(pack(folder.path() / "export.zip", entries))), ElementsAre("Jane Doe"));
}

TEST(PackedClass, HasTheLaterOfTwoEntriesOfTheSameNameAsUnpackingLeavesIt) {
    const TemporaryFolder folder;
    const auto taken =
        take(pack(folder.path() / "class.zip", {{"bob.cpp", "first"}, {"bob.cpp", "second"}, {"eve.cpp", "e"}}));
    EXPECT_EQ(taken.size(), 2U);
    EXPECT_EQ(taken.at("bob").source, "second");
}

}  // namespace
