// The real raygrade grades the frozen corpus as one class. See its README: neither programs, labels nor the reader are
// adapted to each other.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int least_agreement = 524;  ///< of 24 x 22 items
/// On the handout's scene t is 0, so that nothing tells the sign of the matrix' column.
const std::set<std::string> known_gifts = {"f06 8.matrix"};

std::set<std::string> fair_by_label(const json& label, const std::string& item) {
    std::set<std::string> fair = {label.at("not_right").value(item, "right")};
    for (const json& verdict : label.at("ambiguous").value(item, json::array())) fair.insert(verdict);
    return fair;
}

TEST(FrozenCorpus, IsGradedAsItIsLabeled) {
    const fs::path corpus = project_folder() / "tests/given/frozen";
    const TemporaryFolder folder;
    for (const auto& entry : fs::directory_iterator(corpus)) {
        if (entry.is_directory())
            write(folder / "class" / entry.path().filename() / "ray_cast.cpp", read(entry.path() / "ray_cast.cpp"));
    }
    const Result result =
        raygrade({"grade", (folder / "class").string(), "--assignment", "a6-2021", "--out", (folder / "out").string()});
    ASSERT_EQ(result.status, 0) << result.both();
    int items = 0, agree = 0;
    std::string differ, gifts;
    const json grades = read_json(folder / "out/grades.json");
    for (const json& submission : grades.at("submissions")) {
        const std::string who = submission.at("id");
        const json label = read_json(corpus / who / "label.json");
        for (const json& question : submission.at("questions")) {
            for (const json& item : question.at("items")) {
                const std::string name = question.at("number").dump() + "." + item.at("name").get<std::string>();
                const std::string verdict = item.at("verdict");
                const std::set<std::string> fair = fair_by_label(label, name);
                ++items;
                if (fair.contains(verdict)) {
                    ++agree;
                    continue;
                }
                const std::string told = who + " " + name;
                differ += told + ": " + verdict + ", not " + label.at("not_right").value(name, "right") + "\n";
                const bool is_doubtful = !item.at("reading").is_null() && item.at("reading").contains("doubt");
                if (verdict == "right" && !is_doubtful && !known_gifts.contains(told)) gifts += told + "\n";
            }
        }
    }
    std::printf("%d of %d items agree with the labels\n%s", agree, items, differ.c_str());
    EXPECT_EQ(items, 24 * 22);
    EXPECT_GE(agree, least_agreement) << differ;
    EXPECT_EQ(gifts, "") << "right for raygrade, not for the label, and without a doubt";
}

}  // namespace
}  // namespace scenario
