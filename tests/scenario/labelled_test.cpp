// The real raygrade grades the submissions that have a label.json, an independent marker's verdict on every item:
//   outcome                     ok, compile_error, crash or timeout
//   questions.N.items           the verdicts
//   questions.N.ambiguous_items every fair verdict, if several are fair
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::map<std::string, std::string> outcome_of_label = {
    {"ok", "graded"}, {"compile_error", "compile_error"}, {"crash", "crashed"}, {"timeout", "timed_out"}};

std::vector<std::string> labelled_class() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(project_folder() / "submissions")) {
        if (fs::exists(entry.path() / "label.json")) names.push_back(entry.path().filename());
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::vector<std::string> verdicts_of_label(const json& question, const std::string& item) {
    std::vector<std::string> fair = {question.at("items").at(item)};
    const json ambiguous = question.value("ambiguous_items", json::object());
    if (ambiguous.contains(item)) {
        for (const json& verdict : ambiguous.at(item)) fair.push_back(verdict);
    }
    return fair;
}

TEST(LabelledClass, AgreesWithTheMarkerOnEveryItem) {
    const TemporaryFolder folder;
    std::vector<std::string> words{"grade", "--assignment", "a6-2021", "--out", (folder / "out").string()};
    for (const std::string& who : labelled_class()) words.push_back(sample(who).string());
    const Result result = raygrade(words);
    ASSERT_EQ(result.status, 0) << result.both();
    const json grades = read_json(folder / "out/grades.json");
    EXPECT_EQ(grades.at("submissions").size(), 20U);
    for (const json& submission : grades.at("submissions")) {
        const std::string who = submission.at("id");
        SCOPED_TRACE(who);
        const json label = read_json(sample(who) / "label.json");
        EXPECT_EQ(submission.at("outcome"), outcome_of_label.at(label.at("outcome")));
        std::size_t items = 0;
        for (const json& question : submission.at("questions")) {
            const json& labelled = label.at("questions").at(std::to_string(question.at("number").get<int>()));
            for (const json& item : question.at("items")) {
                const std::string name = item.at("name");
                EXPECT_THAT(verdicts_of_label(labelled, name), testing::Contains(item.at("verdict").get<std::string>()))
                    << question.at("number") << "." << name << ": " << item.dump(2) << "\n"
                    << labelled.at("why");
                ++items;
            }
        }
        EXPECT_EQ(items, 22U);
    }
}

}  // namespace
}  // namespace scenario
