#include "harness/intake/intake.h"

#include <gmock/gmock.h>

#include "harness/intake/source_file.h"
#include "harness/machine/errors.h"
#include "tests/given/as_nobody.h"
#include "tests/given/message_of.h"
#include "tests/given/packed.h"
#include "tests/given/temporary_folder.h"
#include "tests/harness/intake/taken.h"

namespace {

using harness::Submission;
using harness::take_in;
using harness::take_in_all;
using harness::take_in_one;
using harness::UsageError;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string problem_of_only(const std::vector<Submission>& submissions) {
    EXPECT_EQ(submissions.size(), 1U);
    return submissions.at(0).problem.value_or("no problem");
}

std::string why_not(const std::filesystem::path& path) {
    return message_of<UsageError>([&] { take_in(path); }, "no UsageError");
}

TEST(TakeIn, TakesAFolderOfStudentFoldersSortedById) {
    const TemporaryFolder folder;
    folder.write("zoe/ray_cast.cpp", "z");
    folder.write("adam/RayCast.CXX", "a");
    folder.write("eve/main.cc", "e");
    folder.write("README.md", "ignored");
    const auto submissions = take_in(folder.path());
    EXPECT_THAT(ids(submissions), ElementsAre("adam", "eve", "zoe"));
    EXPECT_EQ(submissions[2].source, "z");
    EXPECT_EQ(submissions[2].file, folder.path() / "zoe/ray_cast.cpp");
    EXPECT_FALSE(submissions[2].problem);
}

TEST(TakeIn, NamesFilesThatAreNotSubmissions) {
    const TemporaryFolder folder;
    folder.write("zoe/ray_cast.cpp", "z");
    folder.write("notes.txt", "");
    folder.write("helpers.h", "");
    EXPECT_THAT(take_in_all({folder.path()}).left_out, ElementsAre("helpers.h", "notes.txt"));
    const TemporaryFolder other;
    other.write("doejane_1001_5001_ray_cast.cpp", "j");
    other.write("roe_1002_5002_ray_cast.cpp", "r");
    other.write("desktop.ini", "");
    EXPECT_THAT(take_in_all({other.path(), folder.path()}).left_out,
                ElementsAre("desktop.ini", "helpers.h", "notes.txt"));
    EXPECT_THAT(take_in_all({folder.path() / "zoe"}).left_out, IsEmpty())
        << "a student's own files are told with the student";
}

TEST(TakeIn, TakesAnArchiveInAClassAsAStudents) {
    const TemporaryFolder folder;
    folder.write("zoe/ray_cast.cpp", "z");
    std::filesystem::rename(pack(folder.path() / "tmp.zip", {{"ray_cast.cpp", "packed"}}), folder.path() / "yan.zip");
    folder.write("xu.zip", "no zip");
    const auto submissions = take_in(folder.path());
    EXPECT_THAT(ids(submissions), ElementsAre("xu", "yan", "zoe"));
    EXPECT_TRUE(submissions[0].problem);
    EXPECT_EQ(submissions[1].source, "packed");
    const TemporaryFolder flat;
    flat.write("ann.cpp", "a");
    flat.write("ben.zip", "no zip");
    EXPECT_THAT(ids(take_in(flat.path())), ElementsAre("ann", "ben"));
    std::filesystem::remove(flat.path() / "ann.cpp");
    flat.write("ann.zip", "no zip");
    EXPECT_THAT(ids(take_in(flat.path())), ElementsAre("ann", "ben"));
}

TEST(TakeIn, GivesNoTwoFilesTheSameId) {
    const TemporaryFolder folder;
    folder.write("doe.cpp", "first");
    EXPECT_THAT(ids(take_in(folder.path())), ElementsAre("doe"));
    folder.write("doe.cc", "second");
    folder.write("roe.cpp", "r");
    const auto submissions = take_in(folder.path());
    ASSERT_THAT(ids(submissions), ElementsAre("doe.cc", "doe.cpp", "roe"));
    EXPECT_EQ(submissions[1].source, "first");
}

TEST(TakeIn, LeavesOutFoldersForResults) {
    const TemporaryFolder folder;
    folder.write("zoe/ray_cast.cpp", "z");
    folder.write("ended/gradebook.sqlite", "");
    folder.write("ended/feedback/zoe.md", "");
    std::filesystem::create_directories(folder.path() / "interrupted/feedback");
    folder.write("older/grades.json", R"({"schema": "raygrade/grades/1"})");
    folder.write("older/feedback/zoe.md", "");
    EXPECT_THAT(ids(take_in(folder.path())), ElementsAre("zoe"));
}

TEST(TakeIn, KeepsEveryFileThatMayBeAStudents) {
    const TemporaryFolder folder;
    folder.write("ann.cpp", "a");
    folder.write("ben.7z", "7z");
    folder.write("bo.txz", "xz");
    folder.write("cy.cpp.txt", "int");
    folder.write("notes.txt", "");
    const auto taken = take_in_all({folder.path()});
    EXPECT_THAT(ids(taken.submissions), ElementsAre("ann", "ben", "bo", "cy.cpp"));
    EXPECT_THAT(taken.submissions[1].problem.value_or(""), HasSubstr("There is \"ben.7z\", but no C++ source"));
    EXPECT_THAT(taken.left_out, ElementsAre("notes.txt"));
}

TEST(TakeIn, KeepsAStudentWhoseFolderLooksLikeResults) {
    const TemporaryFolder folder;
    folder.write("zoe/ray_cast.cpp", "z");
    folder.write("zoe/grades.json", R"({"schema": "raygrade/grades/1"})");
    folder.write("zoe/feedback/mine.txt", "");
    folder.write("eve/grades.json", "{}");
    folder.write("eve/feedback/mine.txt", "");
    folder.write("tom/notes.txt", "");
    std::filesystem::create_directories(folder.path() / "tom/feedback");
    EXPECT_THAT(ids(take_in(folder.path())), ElementsAre("eve", "tom", "zoe"));
}

TEST(TakeIn, TakesAFolderWithRayCastAsOneSubmission) {
    const TemporaryFolder folder;
    folder.write("s07/ray_cast.cpp", "it");
    folder.write("s07/old.cpp", "not it");
    folder.write("s07/vec.h", "");
    folder.write("s07/notes/todo.txt", "");
    const auto submissions = take_in(folder.path() / "s07");
    ASSERT_THAT(ids(submissions), ElementsAre("s07"));
    EXPECT_EQ(submissions[0].source, "it");
    EXPECT_THAT(submissions[0].notes, ElementsAre("Only \"ray_cast.cpp\" is graded, not \"old.cpp\".",
                                                  "Only \"ray_cast.cpp\" is compiled, without \"vec.h\"."));
}

TEST(TakeIn, TakesSourcesNextToStudentFoldersToo) {
    const TemporaryFolder folder;
    folder.write("ray_cast.cpp", "top");
    folder.write("s01/ray_cast.cpp", "one");
    folder.write("s02/answers.txt", "no source");
    const auto submissions = take_in(folder.path());
    ASSERT_THAT(ids(submissions), ElementsAre("ray_cast", "s01", "s02"));
    EXPECT_THAT(submissions[0].notes, ElementsAre(HasSubstr("is next to the students' folders")));
    EXPECT_THAT(submissions[2].problem.value_or(""), HasSubstr("no C++ source"));
}

TEST(TakeIn, IgnoresFoldersWithoutSourcesInAFlatClass) {
    const TemporaryFolder folder;
    folder.write("alice.cpp", "a");
    folder.write("build/alice.o", "");
    EXPECT_THAT(ids(take_in(folder.path())), ElementsAre("alice"));
}

TEST(TakeIn, FindsAClassNextToASource) {
    const TemporaryFolder folder;
    folder.write("solution.cpp", "");
    folder.write("class/ann/ray_cast.cpp", "a");
    folder.write("class/ben/ray_cast.cpp", "b");
    const auto submissions = take_in(folder.path());
    ASSERT_THAT(ids(submissions), ElementsAre("class", "solution"));
    EXPECT_THAT(submissions[0].problem.value_or(""), HasSubstr("\"ann/ray_cast.cpp\", \"ben/ray_cast.cpp\""));
    EXPECT_THAT(submissions[0].notes, ElementsAre(HasSubstr("If \"class\" is a class, grade it separately")));
    std::filesystem::rename(folder.path() / "solution.cpp", folder.path() / "ray_cast.cpp");
    const auto one = take_in(folder.path());
    ASSERT_EQ(one.size(), 1U);
    EXPECT_THAT(one[0].notes, ElementsAre("Only \"ray_cast.cpp\" is graded, not \"class/ann/ray_cast.cpp\", "
                                          "\"class/ben/ray_cast.cpp\"."));
}

TEST(TakeIn, NamesARayCastFileByItsFolderAndOtherFilesByThemselves) {
    const TemporaryFolder folder;
    EXPECT_THAT(ids(take_in(folder.write("s03/ray_cast.cpp", ""))), ElementsAre("s03"));
    EXPECT_THAT(ids(take_in(folder.write("s03/mine.cpp", ""))), ElementsAre("mine"));
    EXPECT_THAT(ids(take_in(folder.path() / "s03/")), ElementsAre("s03"));
}

TEST(TakeIn, IgnoresHiddenFilesAndFolders) {
    const TemporaryFolder folder;
    folder.write("s01/ray_cast.cpp", "");
    folder.write("s01/.ray_cast.cpp.swp.cpp", "");
    folder.write(".git/x.cpp", "");
    folder.write("__MACOSX/s01/ray_cast.cpp", "");
    const auto submissions = take_in(folder.path());
    ASSERT_THAT(ids(submissions), ElementsAre("s01"));
    EXPECT_THAT(submissions[0].notes, IsEmpty());
}

TEST(TakeIn, HashesTheSource) {
    const TemporaryFolder folder;
    const auto submissions = take_in(folder.write("s01/ray_cast.cpp", "abc"));
    // FIPS 180-2, appendix B.1.
    EXPECT_EQ(submissions[0].source_sha256, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(TakeIn, TakesTheSameNameForAFolderOfAnySystem) {
    const TemporaryFolder folder;
    folder.write("Mu\u0308ller/ray_cast.cpp", "");
    EXPECT_THAT(ids(take_in(folder.path())), ElementsAre("M\u00fcller"));
}

TEST(TakeIn, LeavesOutTheEndOfFileThatDosWrites) {
    const TemporaryFolder folder;
    EXPECT_EQ(take_in(folder.write("s01/ray_cast.cpp", "int x;\r\n\x1a"))[0].source, "int x;\n");
    EXPECT_EQ(take_in(folder.write("s02/ray_cast.cpp", "int x;\r\n"))[0].source, "int x;\r\n");
    EXPECT_EQ(take_in(folder.write("s03/ray_cast.cpp", "\"\x1a\";"))[0].source, "\"\x1a\";");
}

TEST(TakeIn, GradesTheLastOfSeveralDownloads) {
    const TemporaryFolder folder;
    folder.write("bob/ray_cast.cpp", "first");
    folder.write("bob/ray_cast (1).cpp", "second");
    folder.write("bob/ray_cast (10).cpp", "last");
    const auto submissions = take_in(folder.path());
    ASSERT_THAT(ids(submissions), ElementsAre("bob"));
    EXPECT_EQ(submissions[0].source, "last");
    EXPECT_THAT(submissions[0].notes, ElementsAre(HasSubstr("not \"ray_cast.cpp\", \"ray_cast (1).cpp\"")));
}

TEST(TakeIn, TakesASourceAtAnyDepth) {
    const TemporaryFolder folder;
    folder.write("s01/assignment 6/ray_cast.cpp", "one deeper");
    folder.write("s02/a6/hw/main.cpp", "two deeper");
    folder.write("s03/home/jane/Documents/UNH/2026/fall/CS770/assignments/a6/RayCast/src/ray_cast.cpp", "a full path");
    const auto submissions = take_in(folder.path());
    ASSERT_THAT(ids(submissions), ElementsAre("s01", "s02", "s03"));
    EXPECT_EQ(submissions[0].source, "one deeper");
    EXPECT_THAT(submissions[0].notes, IsEmpty());
    EXPECT_EQ(submissions[1].source, "two deeper");
    EXPECT_EQ(submissions[2].source, "a full path");
}

TEST(TakeIn, TakesAClassWithDeeperSourcesFromAnArchiveOfItsFolder) {
    const TemporaryFolder folder;
    const auto submissions = take_in(pack(
        folder.path() / "class.zip", {{"class/s1/hw/ray_cast.cpp", "one"}, {"class/s2/a6/hw/ray_cast.cpp", "two"}}));
    ASSERT_THAT(ids(submissions), ElementsAre("s1", "s2"));
    EXPECT_EQ(submissions[0].source, "one");
    EXPECT_EQ(submissions[1].source, "two");
}

TEST(TakeIn, TakesTheLeastDeepSourceOfAnArchiveOrAFolder) {
    const std::vector<std::vector<PackedEntry>> hand_ins = {
        {{"ray_cast.cpp", "it"}, {"old/ray_cast.cpp", "o"}},
        {{"a/old/ray_cast.cpp", "o"}, {"a/ray_cast.cpp", "it"}, {"a/x64/Debug/ray_cast-3.cpp", "x"}},
        {{"main.cpp", "it"}, {"tests/a.cpp", "a"}, {"tests/b.cpp", "b"}},
        {{"proj/main.cpp", "it"}, {"proj/glm/glm.hpp", ""}, {"proj/glm/detail/glm.cpp", "g"}},
        {{"proj/src/app/main.cpp", "it"}, {"proj/GLM/glm.hpp", ""}, {"proj/GLM/detail/glm.cpp", "g"}},
        {{"proj/src/app/main.cpp", "it"}, {"proj/glm-0.9.9/test/bug.cpp", "g"}},
        {{"src/main.cpp", "it"}, {"CMakeFiles/CMakeCXXCompilerId.cpp", "c"}},
        {{"glm/ray_cast.cpp", "it"}, {"glm/glm.hpp", ""}, {"glm/setup.cpp", "g"}},
        {{"src/ray_cast.cpp", "it"}, {"helpers.cpp", "h"}},
        {{"Ray_Cast.CPP", "it"}, {"old/ray_cast.cpp", "o"}, {"helpers.cpp", "h"}},
        {{"ray_cast.cpp", "an earlier entry of this path"}, {"ray_cast.cpp", "it"}}};
    for (const auto& files : hand_ins) {
        const TemporaryFolder folder;
        folder.make_folder("class");
        pack(folder.path() / "class/zipped.zip", files);
        pack(folder.path() / "class/tarred.tgz", files);
        for (const PackedEntry& file : files) folder.write("class/unpacked/" + file.path, file.bytes);
        const auto submissions = take_in(folder.path() / "class");
        ASSERT_THAT(ids(submissions), ElementsAre("tarred", "unpacked", "zipped"));
        for (const Submission& one : submissions) EXPECT_EQ(one.source, "it") << one.file << *one.problem;
        for (const char* one : {"zipped.zip", "tarred.tgz", "unpacked"})
            EXPECT_EQ(take_in_one(folder.path() / "class" / one).source, "it") << one;
    }
}

TEST(TakeIn, TakesNoSourceIfSeveralAreEquallyDeep) {
    const TemporaryFolder folder;
    const std::vector<PackedEntry> files = {{"a/ray_cast.cpp", "a"}, {"b/ray_cast.cpp", "b"}, {"b/c/ray_cast.cpp", ""}};
    folder.make_folder("class");
    pack(folder.path() / "class/packed.zip", files);
    for (const PackedEntry& file : files) folder.write("class/unpacked/" + file.path, file.bytes);
    for (const Submission& one : take_in(folder.path() / "class")) {
        EXPECT_THAT(one.problem.value_or(""),
                    HasSubstr("to grade: \"a/ray_cast.cpp\", \"b/ray_cast.cpp\". Hand in one"))
            << one.id;
    }
}

TEST(TakeIn, NamesTheFileThatWasSubmittedInsteadOfASource) {
    const TemporaryFolder folder;
    folder.write("class/rar/hw/ray_cast.rar", "Rar!");
    folder.write("class/txt/ray_cast.cpp.txt", "int");
    folder.write("class/c/ray_cast.C", "int");
    folder.write("class/hpp/ray_cast.hpp", "int");
    folder.make_folder("class/nothing");
    folder.write("class/cc/main.cc", "int");
    pack(folder.path() / "class/zip.zip", {{"inner.zip", packed({{"ray_cast.cpp", "i"}})}});
    const auto taken = take(folder.path() / "class");
    const auto said = [](const std::string& name) {
        return AllOf(HasSubstr('"' + name + '"'), HasSubstr("no C++ source"), HasSubstr("ray_cast.cpp."),
                     Not(HasSubstr("Ask")));
    };
    EXPECT_THAT(taken.at("rar").problem.value_or(""), said("hw/ray_cast.rar"));
    EXPECT_THAT(taken.at("hpp").problem.value_or(""), said("ray_cast.hpp"));
    EXPECT_THAT(taken.at("zip").problem.value_or(""), said("inner.zip"));
    EXPECT_THAT(taken.at("txt").problem.value_or(""),
                AllOf(said("ray_cast.cpp.txt"), HasSubstr("Rename \"ray_cast.cpp.t")));
    EXPECT_THAT(taken.at("c").problem.value_or(""), AllOf(said("ray_cast.C"), HasSubstr("Rename \"ray_cast.C\"")));
    EXPECT_THAT(taken.at("nothing").problem.value_or(""), HasSubstr("There is no file."));
}

TEST(TakeInOne, TakesOneStudentsFolderWithAnyContent) {
    const TemporaryFolder folder;
    folder.write("repository/ray_cast.cpp", "it");
    folder.write("repository/tests/test_ray.cpp", "t");
    folder.write("repository/cmake-build-debug/CMakeFiles/CMakeCXXCompilerId.cpp", "c");
    const Submission one = take_in_one(folder.path() / "repository");
    EXPECT_EQ(one.id, "repository");
    EXPECT_EQ(one.source, "it");
    folder.write("two/main.cpp", "m");
    folder.write("two/util.cpp", "u");
    EXPECT_EQ(take_in_one(folder.path() / "two").problem,
              "It is not clear which of these files to grade: \"main.cpp\", \"util.cpp\". Hand in one file named "
              "ray_cast.cpp.");
    EXPECT_THROW(take_in_one(folder.path() / "missing"), UsageError);
    EXPECT_THAT(take_in_one(folder.write("ray_cast.cpp.txt", "int")).problem.value_or(""),
                HasSubstr("Rename \"ray_cast.cpp.txt\" to ray_cast.cpp."));
}

TEST(TakeIn, DoesNotFollowALinkInsideAFolder) {
    const TemporaryFolder folder;
    const auto secret = folder.write(".secret/key.cpp", "the key");
    folder.make_folder("s01");
    std::filesystem::create_symlink(secret, folder.path() / "s01/ray_cast.cpp");
    std::filesystem::create_symlink(secret.parent_path(), folder.path() / "s02");
    const auto submissions = take_in(folder.path());
    ASSERT_THAT(ids(submissions), ElementsAre("s01", "s02"));
    for (const auto& submission : submissions) {
        EXPECT_THAT(submission.problem.value_or(""), HasSubstr("is a symbolic link"));
        EXPECT_EQ(submission.source, "");
    }
}

TEST(TakeIn, FollowsALinkThatWasGiven) {
    const TemporaryFolder folder;
    folder.write("class/s01/ray_cast.cpp", "x");
    std::filesystem::create_symlink(folder.path() / "class", folder.path() / "link");
    EXPECT_THAT(ids(take_in(folder.path() / "link")), ElementsAre("s01"));
}

TEST(TakeIn, TakesASourceOfExactlyTheLimit) {
    const TemporaryFolder folder;
    const auto file = folder.write("s01/ray_cast.cpp", std::string(harness::largest_source_bytes, '/'));
    EXPECT_EQ(take_in(file)[0].source.size(), harness::largest_source_bytes);
    folder.write("s01/ray_cast.cpp", std::string(harness::largest_source_bytes + 1, '/'));
    EXPECT_THAT(problem_of_only(take_in(file)), HasSubstr("is larger"));
}

TEST(TakeIn, KeepsAFolderThatItCannotRead) {
    const TemporaryFolder folder;
    std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
    folder.write("monday/doejane_1001_5001_ray_cast.cpp", "j");
    folder.write("monday/roe_1002_5002_ray_cast.cpp", "r");
    std::filesystem::permissions(folder.make_folder("friday"), std::filesystem::perms::none);
    const AsNobody somebody_else;
    const auto submissions = take_in(folder.path());
    ASSERT_THAT(ids(submissions), ElementsAre("doejane", "friday", "roe"));
    EXPECT_THAT(submissions[1].problem.value_or(""), HasSubstr("its student is unknown"));
}

TEST(TakeIn, KeepsStrangeNamesAndMakesTheIdPrintable) {
    const TemporaryFolder folder;
    for (const char* name : {"O'Neil \"Jo\"", "Zoë 名", "new\nline", "bad\xFF"}) {
        folder.write(std::filesystem::path(name) / "ray_cast.cpp", name);
    }
    const auto submissions = take_in(folder.path());
    EXPECT_THAT(ids(submissions), ElementsAre("O'Neil \"Jo\"", "Zoë 名", "bad%FF", "new%0Aline"));
    EXPECT_EQ(submissions[3].source, "new\nline");
}

TEST(TakeIn, RefusesAPathWithoutSubmissions) {
    const TemporaryFolder folder;
    EXPECT_THAT(why_not(folder.make_folder("empty")), HasSubstr("empty\": There is no file."));
    EXPECT_THAT(why_not(folder.path() / "missing"), HasSubstr("Cannot find "));
    EXPECT_THAT(why_not(folder.write("a.txt", "")), HasSubstr("not a folder, a C++ source"));
    EXPECT_THAT(why_not("/dev/null"), HasSubstr("is not a folder"));
}

TEST(TakeInAll, KeepsTheOrderOfThePathsAndMakesIdsUnique) {
    const TemporaryFolder folder;
    for (const char* file : {"2021/s01/ray_cast.cpp", "2021/s02/ray_cast.cpp", "2020/s01/ray_cast.cpp"}) {
        folder.write(file, file);
    }
    EXPECT_THAT(ids(take_in_all({folder.path() / "2021", folder.path() / "2020"}).submissions),
                ElementsAre("2021-s01", "s02", "2020-s01"));
    EXPECT_THAT(ids(take_in_all({folder.path() / "2021/s01", folder.path() / "2020/s01/ray_cast.cpp"}).submissions),
                ElementsAre("2021-s01", "2020-s01"));
}

TEST(TakeInAll, NumbersAPathThatIsGivenTwice) {
    const TemporaryFolder folder;
    const auto file = folder.write("s01/ray_cast.cpp", "");
    EXPECT_THAT(ids(take_in_all({file, file}).submissions), ElementsAre("s01", "s01-2"));
}

}  // namespace
