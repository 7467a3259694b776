// Bad input: each kind gives a message with the path and the way out, and its documented exit status. The other
// submissions are graded nevertheless.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

/// A class with one good submission, "good", and the submissions that a test adds.
class BadInput : public testing::Test {
  protected:
    BadInput() { write(students() / "good/ray_cast.cpp", small_program); }

    fs::path students() const { return folder / "class"; }
    fs::path out() const { return folder / "out"; }
    Result grade(const Preparation& prepare = {}) const {
        return raygrade_from_scratch({"grade", students().string(), "--assignment", "a6-2021", "--out", out().string()},
                                     prepare);
    }
    json graded(const std::string& id) const { return submission_in(read_json(out() / "grades.json"), id); }

    /// The usual result: `id` is not graded, the message contains `named` and `way_out`, and "good" is graded.
    void expect_not_graded(const Result& result, const std::string& id, const std::string& named,
                           const std::string& way_out) const {
        EXPECT_EQ(result.status, some_not_graded) << result.both();
        EXPECT_THAT(result.both(), HasSubstr(named));
        EXPECT_THAT(result.both(), HasSubstr(way_out));
        ASSERT_FALSE(graded(id).is_null()) << id << " was left out";
        EXPECT_EQ(graded(id).at("outcome"), "not_graded");
        EXPECT_EQ(graded("good").at("outcome"), "graded");
        EXPECT_EQ(graded("good").at("points").get<double>(), 10);
        EXPECT_TRUE(fs::exists(out() / "feedback/good.md"));
    }

    TemporaryFolder folder;
};

TEST_F(BadInput, UnreadableInputIsReported) {
    fs::create_directories(students() / "nothing");
    for (const char* id : {"locked", "closed", "huge", "choice"})
        write(students() / id / "ray_cast.cpp", small_program);
    fs::permissions(students() / "locked/ray_cast.cpp", fs::perms::none);
    fs::permissions(students() / "closed", fs::perms::none);
    fs::resize_file(students() / "huge/ray_cast.cpp", 100'000'000);
    write(students() / "choice/old.cpp", "not C++");
    fs::create_directories(students() / "pipe");
    ASSERT_EQ(mkfifo((students() / "pipe/ray_cast.cpp").c_str(), 0600), 0);
    fs::create_directories(students() / "folder/ray_cast.cpp");
    write(students() / "two/first.cpp", small_program);
    write(students() / "two/second.cpp", small_program);
    fs::create_directories(students() / "link");
    fs::create_symlink(students() / "good/ray_cast.cpp", students() / "link/ray_cast.cpp");
    fs::create_directory_symlink(students() / "good", students() / "linked");
    const Result result = grade(obey_permissions);
    expect_not_graded(result, "nothing", "nothing", "ray_cast.cpp");
    expect_not_graded(result, "locked", "locked: Cannot read \"ray_cast.cpp\"", "chmod");
    expect_not_graded(result, "closed", "closed", "chmod");
    expect_not_graded(result, "huge", "huge: \"ray_cast.cpp\"", "source");
    expect_not_graded(result, "pipe", "pipe: \"ray_cast.cpp\"", "source");
    expect_not_graded(result, "folder", "folder: There is no file", "ray_cast.cpp");
    expect_not_graded(result, "two", "first.cpp", "second.cpp");
    expect_not_graded(result, "link", "link: \"ray_cast.cpp\"", "symbolic link");
    expect_not_graded(result, "linked", "linked", "symbolic link");
    EXPECT_EQ(graded("choice").at("outcome"), "graded") << "ray_cast.cpp of two sources";
    EXPECT_THAT(result.both() + read(out() / "feedback/choice.md"), HasSubstr("old.cpp"));
}

TEST_F(BadInput, AMissingCompilerIsReported) {
    const Result result = grade(forget_path);
    EXPECT_EQ(result.status, some_not_graded) << result.both();
    EXPECT_THAT(result.both(), HasSubstr("g++"));
    EXPECT_THAT(result.both(), HasSubstr("apt install g++"));
    EXPECT_EQ(graded("good").at("outcome"), "not_graded");
}

TEST_F(BadInput, AnUnwritableOutputFolderIsReported) {
    fs::create_directories(folder / "locked");
    fs::permissions(folder / "locked", fs::perms::owner_read | fs::perms::owner_exec);
    const fs::path target = folder / "locked/out";
    const Result result = raygrade({"grade", students().string(), "--out", target.string()}, obey_permissions);
    EXPECT_EQ(result.status, usage) << result.both();
    EXPECT_THAT(result.voice, HasSubstr((folder / "locked").string()));
}

TEST_F(BadInput, ATraceReplacesNoOtherFile) {
    const fs::path source = students() / "good/ray_cast.cpp";
    const std::string before = read(source);
    const Result result = raygrade({"grade", students().string(), "--out", out().string(), "--trace", source.string()});
    EXPECT_EQ(result.status, usage);
    EXPECT_THAT(result.voice, HasSubstr("exists and is not a trace of raygrade; name another file with --trace"));
    EXPECT_EQ(read(source), before);
    const std::vector<std::string> twice = {"grade",        students().string(), "--out",
                                            out().string(), "--trace",           (folder / "trace.json").string()};
    EXPECT_EQ(raygrade(twice).status, 0);
    EXPECT_EQ(raygrade(twice).status, 0) << "a trace replaces a trace";
}

}  // namespace
}  // namespace scenario
