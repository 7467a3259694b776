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

/// A class as downloaded from Canvas, with a submission of every kind.
TEST(Archive, OfCanvasIsGradedWithEveryStudent) {
    const TemporaryFolder folder;
    const fs::path out = folder / "out";
    const std::string right = read(project_folder() / "submissions/ada/ray_cast.cpp");
    const fs::path zip = pack(folder / "submissions.zip", {{"doejane_11_101_ray_cast.cpp", right},
                                                           {"roe_LATE_12_102_ray_cast-1.cpp", right},
                                                           {"roe_12_99_ray_cast.cpp", "not even C++"},
                                                           {"poe_13_103_essay.pdf", "%PDF-1.4"}});
    const Result result = raygrade({"grade", zip.string(), "--out", out.string()});
    EXPECT_EQ(result.status, some_not_graded) << result.both();
    const json grades = read_json(out / "grades.json");
    const auto graded = [&](const char* id) { return submission_in(grades, id); };
    EXPECT_EQ(graded("doejane").at("points"), 100);
    EXPECT_EQ(graded("doejane").at("student").at("lms_user_id"), "11");
    EXPECT_EQ(graded("roe").at("points"), 100) << "the newest counts";
    EXPECT_EQ(graded("roe").at("student").at("late"), true);
    EXPECT_EQ(graded("poe").at("outcome"), "not_graded");
    EXPECT_THAT(result.both(), HasSubstr("essay.pdf"));
}

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

/// Gradescope unpacks what students pack.
TEST(Archive, OfGradescopeWithAHostileStudentGradesTheOthers) {
    const TemporaryFolder folder;
    const fs::path out = folder / "out";
    const std::string right = read(project_folder() / "submissions/ada/ray_cast.cpp");
    std::vector<PackedEntry> entries = {{"export/submission_1/ray_cast.cpp", right}};
    for (int i = 0; i < 25'000; ++i) {
        const std::string number = std::to_string(i);
        entries.push_back({"export/submission_2/" + number + ".txt", ""});
    }
    entries.push_back({"export/submission_3/" + std::string(2000, 'x') + "/ray_cast.cpp", right});
    entries.push_back({"export/submission_4/ray_cast.cpp", right});
    const Result result = raygrade({"grade", pack(folder / "class.zip", entries).string(), "--out", out.string()});
    EXPECT_EQ(result.status, some_not_graded) << result.both();
    const json grades = read_json(out / "grades.json");
    EXPECT_EQ(submission_in(grades, "submission_1").at("points"), 100);
    EXPECT_EQ(submission_in(grades, "submission_4").at("points"), 100);
    for (const char* id : {"submission_2", "submission_3"})
        EXPECT_EQ(submission_in(grades, id).at("outcome"), "not_graded") << id;
    EXPECT_THAT(result.both(), HasSubstr("holds more than 20000 entries"));
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
