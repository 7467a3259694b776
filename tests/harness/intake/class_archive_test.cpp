// What one student has in the archive of a class costs that student alone, also where the system has unpacked it there.
#include <gmock/gmock.h>

#include <map>

#include "harness/intake/intake.h"
#include "harness/machine/errors.h"
#include "tests/given/forged_archives.h"
#include "tests/given/packed.h"
#include "tests/given/temporary_folder.h"

namespace {

using harness::Submission;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;
using testing::ThrowsMessage;
using Type = PackedEntry::Type;

/// A system's download, with the path of a student's file in it.
struct Download {
    std::string name;
    std::function<std::string(int student, const std::string& file)> path;
};

std::string numbered(const std::string& file) {
    static int number = 100;
    return std::to_string(++number) + '_' + file;
}

const Download gradescope = {"Gradescope", [](int student, const std::string& file) {
                                 return "assignment_5_export/submission_90" + std::to_string(student) + "/" + file;
                             }};
const Download moodle = {"Moodle", [](int student, const std::string& file) {
                             const std::string number = std::to_string(student);
                             return "Student " + number + "_1" + number + "_assignsubmission_file/" + file;
                         }};
const Download flat_moodle = {"FlatMoodle", [](int student, const std::string& file) {
                                  const std::string number = std::to_string(student);
                                  return "Student " + number + "_1" + number + "_assignsubmission_file_" + file;
                              }};
const Download canvas = {"Canvas", [](int student, const std::string& file) {
                             const std::string name = student == 1 ? "ada" : student == 2 ? "mallory" : "zoe";
                             return name + "_1" + std::to_string(student) + "_" + numbered(file);
                         }};

class ClassArchive : public testing::TestWithParam<Download> {
  protected:
    static std::string path(int student, const std::string& file) { return GetParam().path(student, file); }

    /// Takes in a class of three, of which the one in the middle has these entries, and expects the others' sources.
    /// Returns that student's submission.
    Submission take_in_with(const std::vector<PackedEntry>& entries, const char* ending = ".zip") const {
        std::vector<PackedEntry> all = {{path(1, "ray_cast.cpp"), "first"}};
        for (const PackedEntry& entry : entries) all.push_back({path(2, entry.path), entry.bytes, entry.type});
        all.push_back({path(3, "ray_cast.cpp"), "third"});
        return taken_from(pack(folder_.path() / ("class" + std::string(ending)), all));
    }

    Submission taken_from(const std::filesystem::path& archive) const {
        const std::vector<Submission> taken = harness::take_in(archive);
        EXPECT_EQ(taken.size(), 3U);
        if (taken.size() != 3) return {};
        EXPECT_EQ(taken[0].source, "first") << taken[0].problem.value_or("");
        EXPECT_EQ(taken[2].source, "third") << taken[2].problem.value_or("");
        EXPECT_EQ(taken[1].source, "");
        EXPECT_TRUE(taken[1].lms.has_value());
        return taken[1];
    }

    static std::string problem(const Submission& submission) { return submission.problem.value_or("none"); }

    TemporaryFolder folder_;
};

std::vector<PackedEntry> many(std::size_t count) {
    std::vector<PackedEntry> entries = {{"ray_cast.cpp", "mine"}};
    while (entries.size() < count) {
        const std::string number = std::to_string(entries.size());
        entries.push_back({"f" + number + ".txt", ""});
    }
    return entries;
}

TEST_P(ClassArchive, KeepsTheOtherStudentsIfOneHasTooManyFiles) {
    for (const char* ending : {".zip", ".tgz"}) {
        EXPECT_THAT(problem(take_in_with(many(20'500), ending)),
                    AllOf(HasSubstr("contains more than 20000 entries, from "), HasSubstr("f20000.txt"),
                          HasSubstr("hand in only the source")));
    }
}

TEST_P(ClassArchive, KeepsTheOtherStudentsIfOneHasTooManyBytes) {
    std::vector<PackedEntry> sources;
    for (int i = 0; i < 40; ++i) sources.push_back({std::to_string(i) + ".cpp", std::string(1 << 20, 'x')});
    EXPECT_THAT(problem(take_in_with(sources)), HasSubstr("contains more than 32 MiB in total, from "));
    forged::Member large{path(2, "large.bin")};
    large.unpacked = std::uint32_t{1500} << 20U;
    const std::string bytes = forged::zip({{path(1, "ray_cast.cpp"), "first", 5, forged::crc32("first")},
                                           large,
                                           {path(3, "ray_cast.cpp"), "third", 5, forged::crc32("third")}});
    folder_.write("large.zip", bytes);
    EXPECT_THAT(problem(taken_from(folder_.path() / "large.zip")),
                HasSubstr("contains more than 1024 MiB in total, from "));
}

/// A download in which students have folders.
class ClassArchiveWithFolders : public ClassArchive {};

TEST_P(ClassArchiveWithFolders, KeepsTheOtherStudentsIfPathsOfOneAreTooDeep) {
    EXPECT_THAT(problem(take_in_with({{"ray_cast.cpp", "mine"}, {forged::repeated("a/", 40) + "b.cpp", "deep"}})),
                AllOf(StartsWith("\""), HasSubstr(" contains \""), HasSubstr("a path of more than 31 folders")));
    EXPECT_THAT(problem(take_in_with({{forged::repeated("a", 2000) + "/b.cpp", "long"}, {"ray_cast.cpp", "mine"}})),
                HasSubstr("a path longer than 1000 bytes"));
    std::vector<PackedEntry> long_names;
    for (int i = 0; i < 3000; ++i) long_names.push_back({std::string(900, 'n') + std::to_string(i), ""});
    EXPECT_THAT(problem(take_in_with(long_names)), HasSubstr("contains paths of more than 2000000 bytes"));
}

TEST_P(ClassArchive, KeepsTheOtherStudentsIfAnEntryOfOneIsRefused) {
    EXPECT_THAT(problem(take_in_with({{"ray_cast.cpp", "mine"}, {"link.cpp", "/etc/passwd", Type::link}})),
                HasSubstr("which is a link"));
}

TEST_P(ClassArchiveWithFolders, KeepsTheOtherStudentsIfAPathOfOneLeadsOutside) {
    EXPECT_THAT(problem(take_in_with({{"ray_cast.cpp", "mine"}, {"..\\..\\evil.cpp", "e"}})),
                HasSubstr("leads outside"));
}

std::string name_of(const testing::TestParamInfo<Download>& tested) {
    return tested.param.name;
}
INSTANTIATE_TEST_SUITE_P(, ClassArchive, testing::Values(gradescope, moodle, flat_moodle, canvas), name_of);
INSTANTIATE_TEST_SUITE_P(, ClassArchiveWithFolders, testing::Values(gradescope, moodle), name_of);

TEST(ClassArchiveLimits, GrowWithTheClass) {
    const TemporaryFolder folder;
    std::vector<PackedEntry> entries;
    for (int student = 0; student < 300; ++student) {
        const std::string of = "submission_" + std::to_string(1000 + student) + "/";
        entries.push_back({of + "ray_cast.cpp", "s"});
        for (int i = 0; i < 100; ++i) entries.push_back({of + "build/" + std::to_string(i) + ".o", ""});
    }
    const std::vector<Submission> taken = harness::take_in(pack(folder.path() / "class.zip", entries));
    ASSERT_EQ(taken.size(), 300U);
    for (const Submission& one : taken) EXPECT_EQ(one.source, "s");
}

TEST(ClassArchiveLimits, NameTheStudentWhoExceedsThem) {
    const TemporaryFolder folder;
    std::vector<PackedEntry> entries = {
        {"export/submission_metadata.yml", "submission_901:\n  :submitters:\n  - :name: Jane Doe\n"},
        {"export/submission_902/ray_cast.cpp", "s"}};
    for (const PackedEntry& entry : many(20'001))
        entries.push_back({"export/submission_901/" + entry.path, entry.bytes});
    const std::vector<Submission> taken = harness::take_in(pack(folder.path() / "class.zip", entries));
    ASSERT_EQ(taken.size(), 2U);
    EXPECT_EQ(taken[0].id, "Jane Doe");
    EXPECT_THAT(taken[0].problem.value_or(""), AllOf(StartsWith("\"submission_901\" contains more than 20000 entries"),
                                                     HasSubstr("Nothing in it was read")));
}

TEST(ClassArchiveLimits, ApplyToAllStudentsTogether) {
    const TemporaryFolder folder;
    std::vector<forged::Member> members;
    for (int student = 0; student < 263; ++student) {
        members.push_back({"submission_" + std::to_string(student) + "/large.bin"});
        members.back().unpacked = std::uint32_t{1000} << 20U;
    }
    const auto archive = folder.write("class.zip", forged::zip(members));
    EXPECT_THAT([&] { harness::take_in(archive); },
                ThrowsMessage<harness::UsageError>(HasSubstr("contains too much: more than 274877906944 bytes")));
}

TEST(ClassArchiveLimits, RefuseTheArchiveForFilesThatBelongToNobody) {
    const TemporaryFolder folder;
    std::vector<PackedEntry> entries = {{"submission_1/ray_cast.cpp", "s"}};
    for (int i = 0; i < 20'001; ++i) entries.push_back({"notes/" + std::to_string(i), ""});
    EXPECT_THROW(harness::take_in(pack(folder.path() / "class.zip", entries)), harness::UsageError);
    EXPECT_THROW(harness::take_in(
                     pack(folder.path() / "out.zip", {{"submission_1/a.cpp", "s"}, {"../x/submission_2/b.cpp", "e"}})),
                 harness::UsageError);
}

TEST(ClassArchiveLimits, DoNotCountTheFilesOfASimilarName) {
    const TemporaryFolder folder;
    // Each name may be that of number 11 or of number 13.
    std::vector<PackedEntry> entries = {{"ada_11_101_ray_cast.cpp", "ada's"}};
    for (int i = 0; i < 20'500; ++i)
        entries.push_back({"mallory_13_103_ada_11_" + std::to_string(2000 + i) + "_ray_cast.cpp", ""});
    entries.push_back({"zoe_12_102_ray_cast.cpp", "zoe's"});
    std::map<std::string, Submission> taken;
    for (const Submission& one : harness::take_in(pack(folder.path() / "class.zip", entries))) taken[one.id] = one;
    EXPECT_EQ(taken["ada"].source, "ada's");
    EXPECT_EQ(taken["zoe"].source, "zoe's");
}

TEST(ClassArchiveLimits, CountNestedFoldersForTheOutermostStudent) {
    const TemporaryFolder folder;
    std::vector<PackedEntry> entries = {{"submission_1/ray_cast.cpp", "one"}};
    for (int i = 0; i < 20'500; ++i)
        entries.push_back({"submission_2/submission_1/submission_" + std::to_string(i) + "/a.txt", ""});
    const std::vector<Submission> taken = harness::take_in(pack(folder.path() / "class.zip", entries));
    ASSERT_EQ(taken.size(), 2U);
    EXPECT_EQ(taken[0].source, "one");
    EXPECT_THAT(taken[1].problem.value_or(""), HasSubstr("more than 20000 entries"));
}

}  // namespace
