// The sample class on two other scenes, by the real raygrade. A submission with "unmoved" in its expected.json prints
// some of its answers instead of computing them: those, at the least, must be found not to move. No other is flagged.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "tests/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AnyOf;
using testing::HasSubstr;
using testing::IsSupersetOf;

struct Sample {
    std::string name;
};

std::string test_name(const Sample& sample) {
    std::string name;
    for (const char c : sample.name) {
        const auto byte = static_cast<unsigned char>(c);
        if ((byte & 0xC0U) != 0x80U) name += byte < 0x80U && std::isalnum(byte) != 0 ? c : '_';
    }
    return name;
}

void PrintTo(const Sample& sample, std::ostream* out) {
    *out << test_name(sample);
}

std::vector<Sample> sample_class() {
    std::vector<Sample> samples;
    for (const auto& entry : fs::directory_iterator(project_folder() / "submissions")) {
        if (fs::exists(entry.path() / "expected.json") || fs::exists(entry.path() / "label.json"))
            samples.push_back({entry.path().filename()});
    }
    std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) { return a.name < b.name; });
    return samples;
}

json graded_with_variants(const fs::path& source, const std::string& variants,
                          const std::string& assignment = "a6-2021") {
    const TemporaryFolder folder;
    const Result result = raygrade({"grade", source.string(), "--assignment", assignment, "--variants", variants,
                                    "--out", (folder / "out").string()});
    EXPECT_EQ(result.status, 0) << result.both();
    return read_json(folder / "out/grades.json").at("submissions").at(0);
}

std::set<std::string> names(const json& items) {
    std::set<std::string> result;
    for (const json& item : items)
        result.insert(std::to_string(item.at("question").get<int>()) + "." + item.at("item").get<std::string>());
    return result;
}

bool is_hard_coded(const json& submission) {
    const json& flags = submission.at("flags");
    return std::any_of(flags.begin(), flags.end(), [](const json& flag) { return flag.at("kind") == "hard_coded"; });
}

class SampleOnOtherScenes : public testing::TestWithParam<Sample> {};

TEST_P(SampleOnOtherScenes, IsFlaggedIfItPrintsInsteadOfComputing) {
    const fs::path expected_file = sample(GetParam().name) / "expected.json";
    const json expected = fs::exists(expected_file) ? read_json(expected_file) : json::object();
    const json submission = graded_with_variants(sample(GetParam().name), "2");
    EXPECT_EQ(is_hard_coded(submission), expected.contains("unmoved")) << submission.at("flags").dump(2);
    const json& variants = submission.at("variants");
    if (!expected.contains("unmoved")) {
        const std::string verdict = variants.is_null() ? "not_found" : variants.at("verdict");
        EXPECT_THAT(verdict, AnyOf("computes", "breaks", "not_found"));
        return;
    }
    const auto unmoved = expected.at("unmoved").get<std::set<std::string>>();
    EXPECT_THAT(names(variants.at("unmoved")), IsSupersetOf(unmoved));
    EXPECT_EQ(variants.at("verdict"), unmoved.empty() ? "not_found" : "does_not_move");
}

INSTANTIATE_TEST_SUITE_P(Submissions, SampleOnOtherScenes, testing::ValuesIn(sample_class()),
                         [](const auto& name) { return test_name(name.param); });

TEST(OtherScenes, TellWhatMovesFromWhatDoesNot) {
    const json submission = graded_with_variants(sample("ines"), "2");
    // Of the 22 items 14 are computed, a is 1 in every scene, and that the triangle's t is printed as 0 says nothing.
    EXPECT_EQ(names(submission.at("variants").at("unmoved")),
              (std::set<std::string>{"6.t", "6.hit", "7.normal", "8.u", "8.v", "8.hit"}));
    EXPECT_EQ(submission.at("points"), 100) << "a flag costs nothing";
}

TEST(OtherScenes, TakeNoneAgainForNoSign) {
    // Both look away from the scene, so they print "none" everywhere; in this class that is right.
    const fs::path miss = project_folder() / "tests/labelled/miss";
    for (const char* who : {"m06", "m07"}) {
        const json submission = graded_with_variants(miss / who, "2", (miss / "assignment.toml").string());
        EXPECT_FALSE(is_hard_coded(submission)) << submission.at("flags").dump(2);
        EXPECT_NE(submission.at("variants").at("verdict"), "not_found");
    }
}

TEST(OtherScenes, FindTheModelSolutionComputing) {
    const json submission = graded_with_variants(project_folder() / "reference/ray_cast.cpp", "4");
    EXPECT_EQ(submission.at("variants").at("verdict"), "computes") << submission.at("variants").dump(2);
    EXPECT_EQ(submission.at("variants").at("runs").size(), 4U);
    EXPECT_EQ(submission.at("variants").at("not_found"), json::array());
}

TEST(OtherScenes, AreCompiledOnce) {
    const TemporaryFolder folder;
    const std::vector<std::string> arguments = {
        "grade", sample("ada").string(),   "--assignment", "a6-2021", "--variants", "2", "--apply",
        "--out", (folder / "out").string()};
    const auto with_one_cache = [&] { return setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1) == 0; };
    EXPECT_THAT(raygrade(arguments, with_one_cache).voice, HasSubstr("0 of 2 from earlier runs"));
    EXPECT_THAT(raygrade(arguments, with_one_cache).voice, HasSubstr("2 of 2 from earlier runs"));
}

TEST(OtherScenes, AreToldInACheckWithoutTheRightValues) {
    const Result result =
        raygrade({"check", (sample("ines") / "ray_cast.cpp").string(), "--assignment", "a6-2021", "--variants", "2"});
    EXPECT_EQ(result.status, 0);
    EXPECT_THAT(result.output, HasSubstr("do not change when the scene in the source does"));
    EXPECT_THAT(result.output, HasSubstr("100 of 100 points"));
}

TEST(OtherScenes, AreNotTriedUnasked) {
    const TemporaryFolder folder;
    raygrade({"grade", sample("ada").string(), "--assignment", "a6-2021", "--out", (folder / "out").string()});
    EXPECT_TRUE(read_json(folder / "out/grades.json").at("submissions").at(0).at("variants").is_null());
}

}  // namespace
}  // namespace scenario
