// Marks the printed outputs in tests/given/labelled and compares the verdicts with an independent marker's labels.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "harness/mark/score/mark_transcript.h"
#include "harness/read/transcript.h"
#include "reference/key/answer_key.h"
#include "tests/given/bytes_of.h"

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path classes = fs::path(RAYGRADE_PROJECT) / "tests/given/labelled";

/// Every submission as "class/id".
std::vector<std::string> labelled() {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(classes)) {
        if (entry.path().filename() != "label.json") continue;
        names.push_back(fs::relative(entry.path().parent_path(), classes).string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

class Labelled : public testing::TestWithParam<std::string> {};

TEST_P(Labelled, AgreesWithTheMarkerOnEveryItemOrHasADoubt) {
    const fs::path folder = classes / GetParam();
    const auto assignment = reference::load_assignment((folder.parent_path() / "assignment.toml").string(), classes);
    const auto key = reference::make_key(assignment, reference::Precision::certified);
    const harness::Score score =
        harness::score(harness::read_transcript(bytes_of(folder / "expected_stdout.txt"), 10), key, assignment);
    const json label = json::parse(bytes_of(folder / "label.json"));
    std::size_t items = 0;
    for (const harness::QuestionScore& question : score.questions) {
        const json& labelled = label.at("questions").at(std::to_string(question.number));
        const json ambiguous = labelled.value("ambiguous_items", json::object());
        for (const harness::ItemScore& item : question.items) {
            const std::string name(item.spec.name);
            std::vector<std::string> fair = {labelled.at("items").at(name)};
            if (ambiguous.contains(name)) {
                for (const json& verdict : ambiguous.at(name)) fair.push_back(verdict);
            }
            if (item.doubt) fair.emplace_back(harness::to_string(item.verdict));  // the experiment asks
            EXPECT_THAT(fair, testing::Contains(std::string(harness::to_string(item.verdict))))
                << question.number << "." << name << " was printed as \"" << item.printed << "\"\n"
                << labelled.at("why");
            ++items;
        }
    }
    EXPECT_EQ(items, 22U);
}

INSTANTIATE_TEST_SUITE_P(Classes, Labelled, testing::ValuesIn(labelled()), [](const auto& name) {
    std::string plain = name.param;
    std::replace(plain.begin(), plain.end(), '/', '_');
    return plain;
});

TEST(LabelledClasses, Contain32Submissions) {
    EXPECT_EQ(labelled().size(), 32U);
}

}  // namespace
