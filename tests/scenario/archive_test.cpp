// A class in an archive: graded as downloaded from a learning management system, or refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/given/packed.h"
#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

TEST(Archive, OfAHostileStudentCostsNobodyElse) {
    const TemporaryFolder folder;
    const fs::path students = folder / "class", out = folder / "out";
    write(students / "ada/ray_cast.cpp", read(project_folder() / "submissions/ada/ray_cast.cpp"));
    std::string deep;
    for (int i = 0; i < 30'000; ++i) deep += "a/";
    fs::create_directories(students / "deep");
    pack(students / "deep/x.zip", {{deep + "ray_cast.cpp", "int main() {}"}});
    fs::create_directories(students / "pipe");
    ASSERT_EQ(mkfifo((students / "pipe/x.tar.gz").c_str(), 0600), 0);
    const Result result = raygrade({"grade", students.string(), "--out", out.string()});
    EXPECT_EQ(result.status, some_not_graded) << result.both();
    const json grades = read_json(out / "grades.json");
    EXPECT_EQ(submission_in(grades, "ada").at("points"), 100);
    EXPECT_EQ(submission_in(grades, "deep").at("outcome"), "not_graded");
    EXPECT_EQ(submission_in(grades, "pipe").at("outcome"), "not_graded");
    EXPECT_THAT(result.both(), HasSubstr("a path longer than 1000 bytes"));
}

TEST(Archive, IsRefusedIfAnEntryLeadsOutside) {
    const TemporaryFolder folder;
    const fs::path out = folder / "out";
    const fs::path zip = pack(folder / "class.zip", {{"a.cpp", ""}, {"../../evil.cpp", "e"}});
    const Result result = raygrade({"grade", zip.string(), "--out", out.string()});
    EXPECT_EQ(result.status, usage) << result.both();
    EXPECT_THAT(result.voice, HasSubstr("../../evil.cpp"));
    EXPECT_FALSE(fs::exists(out));
}

}  // namespace
}  // namespace scenario
