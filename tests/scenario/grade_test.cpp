// The real raygrade grades the sample classes and the model solution. Each submissions/<who>/expected.json holds a
// marker's marks, found by reading the source and its output:
//   outcome  as in grades.json
//   points   a number, or [least, most] if more than one verdict is fair
//   diagnosis  the names of the mistakes by "question.item", if any; see diagnosis_test.cpp
//   items    the verdicts of the items that are not right, by "question.item"; an array if several are fair
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Those of submissions/2024 are graded by that year's assignment.
bool is_of_2024(const std::string& name) {
    return name.starts_with("2024/");
}

/// The items of one submission in grades.json, by "question.item".
std::map<std::string, json> graded_items(const json& submission) {
    std::map<std::string, json> items;
    for (const json& question : submission.at("questions")) {
        const std::string number = std::to_string(question.at("number").get<int>());
        for (const json& item : question.at("items")) {
            items[number + "." + item.at("name").get<std::string>()] = item;
        }
    }
    return items;
}

std::set<std::string> fair_verdicts(const json& expected, const std::string& item) {
    const json verdicts = expected.at("items").value(item, json("right"));
    if (verdicts.is_array()) return verdicts.get<std::set<std::string>>();
    return {verdicts.get<std::string>()};
}

/// Grades one path alone and returns what grades.json says of it.
json grade_alone(const fs::path& path, const std::string& assignment = "a6-2021") {
    const TemporaryFolder folder;
    const Result result =
        raygrade({"grade", path.string(), "--assignment", assignment, "--out", (folder / "out").string()});
    EXPECT_EQ(result.status, 0) << result.both();
    const json grades = read_json(folder / "out/grades.json");
    EXPECT_EQ(grades.at("schema"), "raygrade/grades/1");
    EXPECT_EQ(grades.at("submissions").size(), 1U);
    return grades.at("submissions").at(0);
}

std::vector<std::string> marked_samples() {
    std::vector<std::string> samples;
    for (const char* year : {"", "2024/"}) {
        for (const auto& entry : fs::directory_iterator(project_folder() / "submissions" / year)) {
            if (fs::exists(entry.path() / "expected.json")) samples.push_back(year + entry.path().filename().string());
        }
    }
    std::sort(samples.begin(), samples.end());
    return samples;
}

/// Grades the samples of a year in one run; what grades.json says, by id.
std::map<std::string, json> grade_together(const std::vector<std::string>& samples, const std::string& assignment) {
    const TemporaryFolder folder;
    std::vector<std::string> words{"grade", "--assignment", assignment, "--out", (folder / "out").string()};
    for (const std::string& who : samples) words.push_back(sample(who).string());
    const Result result = raygrade(words);
    EXPECT_EQ(result.status, 0) << result.both();
    const json grades = read_json(folder / "out/grades.json");
    EXPECT_EQ(grades.at("schema"), "raygrade/grades/1");
    std::map<std::string, json> graded;
    for (const json& submission : grades.at("submissions")) graded[submission.at("id")] = submission;
    return graded;
}

void expect_a_markers_marks(const std::string& who, const json& submission) {
    const json expected = read_json(sample(who) / "expected.json");
    EXPECT_EQ(submission.at("outcome"), expected.at("outcome"));

    const std::map<std::string, json> graded = graded_items(submission);
    EXPECT_EQ(graded.size(), is_of_2024(who) ? 25U : 22U);
    for (const auto& [name, ignored] : expected.at("items").items()) EXPECT_TRUE(graded.contains(name)) << name;
    for (const auto& [name, item] : graded) {
        EXPECT_THAT(fair_verdicts(expected, name), testing::Contains(item.at("verdict").get<std::string>()))
            << name << ": " << item.dump(2) << "\nThe mistake is: " << expected.at("mistake");
    }
    const json diagnoses = expected.value("diagnosis", json::object());
    for (const auto& [name, diagnosis] : diagnoses.items()) {
        if (!is_of_2024(who)) continue;  // diagnosis_test.cpp has the others
        // One that does not explain the answer on other scenes is not named, but never another.
        const json& named = graded.at(name).at("diagnosis");
        EXPECT_TRUE(named.is_null() || named == diagnosis) << name << ": " << named;
    }

    const json& points = expected.at("points");
    const double least = points.is_array() ? points.at(0) : points;
    const double most = points.is_array() ? points.at(1) : points;
    constexpr double rounding = 0.006;  // expected.json has two decimals
    EXPECT_GE(submission.at("points").get<double>(), least - rounding);
    EXPECT_LE(submission.at("points").get<double>(), most + rounding);
    EXPECT_EQ(submission.at("max_points").get<double>(), 100);
}

class SampleClass : public testing::TestWithParam<const char*> {};

TEST_P(SampleClass, GetsTheMarksThatAMarkerGives) {
    const std::string year = GetParam();
    std::vector<std::string> samples = marked_samples();
    std::erase_if(samples, [&](const std::string& who) { return is_of_2024(who) != (year == "2024"); });
    const std::map<std::string, json> graded = grade_together(samples, "a6-" + year);
    EXPECT_EQ(graded.size(), samples.size());
    for (const std::string& who : samples) {
        SCOPED_TRACE(who);
        const std::string id = fs::path(who).filename().string();
        ASSERT_TRUE(graded.contains(id));
        expect_a_markers_marks(who, graded.at(id));
    }
}

INSTANTIATE_TEST_SUITE_P(Years, SampleClass, testing::Values("2021", "2024"),
                         [](const auto& year) { return std::string(year.param); });

TEST(ModelSolution, GetsFullMarksWithoutAWarning) {
    const json submission = grade_alone(project_folder() / "reference/ray_cast.cpp");
    EXPECT_EQ(submission.at("outcome"), "graded");
    EXPECT_EQ(submission.at("build").at("diagnostics"), "");
    for (const auto& [name, item] : graded_items(submission)) EXPECT_EQ(item.at("verdict"), "right") << name;
    EXPECT_EQ(submission.at("points").get<double>(), 100);
}

}  // namespace
}  // namespace scenario
