// How many mistakes get their right name: those in the sample class's expected.json ("diagnosis"), and those of the
// labelled class, which its marker described in words.
#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// The mistakes' names by "question.item".
using Diagnosis = std::map<std::string, std::string>;

/// The marker's words from the labels, translated into the harness's names. Wrong verdicts, crashes and compile errors
/// have no name.
const std::map<std::string, Diagnosis> labelled = {
    {"s02", {{"6.t", "operator precedence"}}},                             // operator precedence in the root
    {"s05", {{"5.V", "not normalized"}, {"9.normal", "not normalized"}}},  // forgot to normalise V and the normal
    {"s07", {{"3.M_VCS_to_WCS", "translation missing"}}},                  // forgot translation
    {"s09", {{"2.Z_vcs", "Z points at lookat"}, {"9.normal", "opposite direction"}}},
    {"s11", {{"1.P_VCS", "positive z"}}},  // positive z for clipNear
    {"s14", {{"1.P_VCS", "integer division"}}},
    {"s16", {{"6.c", "radius not squared"}, {"8.t", "wrong unknown"}}},  // wrong Cramer column for t
    {"s18",
     {{"6.b", "ray starts at the eye"},
      {"6.c", "ray starts at the eye"},
      {"10.verdict", "verdict against own values"}}},
    {"s19", {{"6.t", "far root"}}},  // wrong root
    {"s20", {{"3.M_VCS_to_WCS", "matrix transposed"}}},
};

std::map<std::string, Diagnosis> expected_diagnoses() {
    std::map<std::string, Diagnosis> expected = labelled;
    for (const auto& entry : fs::directory_iterator(project_folder() / "submissions")) {
        if (!fs::exists(entry.path() / "expected.json")) continue;
        const json file = read_json(entry.path() / "expected.json");
        if (file.contains("diagnosis")) expected[entry.path().filename()] = file.at("diagnosis").get<Diagnosis>();
    }
    return expected;
}

TEST(Diagnosis, SaysWhatToDoAboutUsualCompileErrors) {
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"#include <glm/glm.hpp>\nint main() { glm::vec3 V(1); double t = 2; V = t * V; }\n",
         "Line 2: GLM has no * for double and glm::vec3. Make the number a float"},
        {"int main() { std::cout << 1; }\n", "std::cout needs #include <iostream>"},
        {"#include <glm/GLM.hpp>\nint main() {}\n", "Line 1: write #include <glm/glm.hpp>; on Linux"},
        {"#include <windows.h>\nint main() {}\n", "Line 1: windows.h is a header of Windows"},
        {"int Main() { return 0; }\n", "Line 1: should Main be main?"},
    };
    const TemporaryFolder folder;
    std::vector<std::string> arguments = {"grade", "--assignment", "a6-2021", "--out", (folder / "out").string()};
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const fs::path one = folder / std::to_string(i);
        write(one / "ray_cast.cpp", cases[i].first);
        arguments.push_back(one.string());
    }
    const Result result = raygrade(arguments);
    ASSERT_EQ(result.status, 0) << result.both();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const std::string page = read(folder / "out" / "feedback" / (std::to_string(i) + ".md"));
        EXPECT_NE(page.find(cases[i].second), std::string::npos) << page;
    }
}

TEST(Diagnosis, NamesTheMistakeThatAlsoExplainsOtherScenes) {
    // On the handout's scene normalize(P_WCS) is -V, and 4 * dot(V, S - C) is 2 * dot(V, eye - C).
    const std::string model = read(project_folder() / "reference" / "ray_cast.cpp");
    const auto edited = [&](const std::string& before, const std::string& after) {
        std::string source = model;
        const std::size_t at = source.find(before);
        EXPECT_NE(at, std::string::npos) << before;
        return source.replace(at, before.size(), after);
    };
    const TemporaryFolder folder;
    write(folder / "class/one/ray_cast.cpp", edited("normalize(P_WCS - camera.eye)", "normalize(P_WCS)"));
    write(folder / "class/two/ray_cast.cpp", edited("2.0f * glm::dot(ray.V", "4.0f * glm::dot(ray.V"));
    const Result result =
        raygrade({"grade", (folder / "class").string(), "--assignment", "a6-2021", "--out", (folder / "out").string()});
    ASSERT_EQ(result.status, 0) << result.both();
    const json grades = read_json(folder / "out/grades.json");
    const auto diagnosis = [&](const char* who, std::size_t question, std::size_t item) {
        return submission_in(grades, who).at("questions").at(question - 1).at("items").at(item).at("diagnosis");
    };
    EXPECT_EQ(diagnosis("one", 5, 0), "eye forgotten");
    EXPECT_TRUE(diagnosis("two", 6, 1).is_null()) << diagnosis("two", 6, 1);
}

TEST(Diagnosis, NamesFourOfFiveSingleMistakesAndNoRightAnswer) {
    const std::map<std::string, Diagnosis> expected = expected_diagnoses();
    const TemporaryFolder folder;
    std::vector<std::string> arguments = {"grade"};
    for (const auto& [who, diagnosis] : expected) arguments.push_back(sample(who).string());
    for (const char* argument : {"--assignment", "a6-2021", "--out"}) arguments.emplace_back(argument);
    arguments.push_back((folder / "out").string());
    const Result result = raygrade(arguments);
    ASSERT_EQ(result.status, 0) << result.both();

    int single = 0, named = 0, all = 0, all_named = 0;
    const json grades = read_json(folder / "out/grades.json");
    for (const json& submission : grades.at("submissions")) {
        const Diagnosis& diagnosis = expected.at(submission.at("id"));
        bool right = true;
        for (const json& question : submission.at("questions")) {
            for (const json& item : question.at("items")) {
                const std::string name =
                    std::to_string(question.at("number").get<int>()) + "." + item.at("name").get<std::string>();
                if (item.at("verdict") == "right" || item.at("verdict") == "follow") {
                    EXPECT_TRUE(item.at("diagnosis").is_null()) << submission.at("id") << " " << name;
                }
                if (!diagnosis.contains(name)) continue;
                const bool is_named = item.at("diagnosis") == diagnosis.at(name);
                if (!is_named)
                    std::cout << submission.at("id") << " " << name << " is not \"" << diagnosis.at(name) << "\" but "
                              << item.at("diagnosis") << "\n";
                ++all;
                all_named += is_named ? 1 : 0;
                right = right && is_named;
            }
        }
        const bool is_single = diagnosis.size() == 1;
        single += is_single ? 1 : 0;
        named += is_single && right ? 1 : 0;
    }
    std::cout << "named: " << named << " of " << single << " submissions with one mistake, " << all_named << " of "
              << all << " mistakes\n";
    EXPECT_GE(single, 15);
    EXPECT_GE(10 * named, 8 * single);
    EXPECT_GE(10 * all_named, 8 * all);
}

}  // namespace
}  // namespace scenario
