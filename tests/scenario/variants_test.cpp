// The real raygrade runs the sample class on two other scenes. A submission with "unmoved" in its expected.json prints
// some of its answers instead of computing them; at least these answers must be found not to move. No other submission
// may be flagged. A submission with "variants" in its expected.json must get that verdict.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "tests/given/cases.h"
#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

json expected_of(const std::string& who) {
    const fs::path file = sample(who) / "expected.json";
    return fs::exists(file) ? read_json(file) : json::object();
}

/// By day every third of those that compute.
std::vector<std::string> samples_on_variants() {
    std::vector<std::string> samples;
    for (const auto& entry : fs::directory_iterator(project_folder() / "submissions")) {
        if (fs::exists(entry.path() / "expected.json") || fs::exists(entry.path() / "label.json"))
            samples.push_back(entry.path().filename());
    }
    std::sort(samples.begin(), samples.end());
    std::size_t others = 0;
    std::erase_if(samples, [&](const std::string& who) {
        return !is_nightly() && !expected_of(who).contains("unmoved") && others++ % 3 != 0;
    });
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

bool is_hard_coded(const json& submission) {
    const json& flags = submission.at("flags");
    return std::any_of(flags.begin(), flags.end(), [](const json& flag) { return flag.at("kind") == "hard_coded"; });
}

/// Grades them on two other scenes in one run.
json graded_together(const std::vector<std::string>& samples) {
    const TemporaryFolder folder;
    std::vector<std::string> words{"grade", "--assignment",           "a6-2021", "--variants", "2",
                                   "--out", (folder / "out").string()};
    for (const std::string& who : samples) words.push_back(sample(who).string());
    const Result result = raygrade(words);
    EXPECT_EQ(result.status, 0) << result.both();
    return read_json(folder / "out/grades.json").at("submissions");
}

TEST(SamplesOnVariants, AreFlaggedIfTheyPrintInsteadOfComputing) {
    const std::vector<std::string> samples = samples_on_variants();
    const json graded = graded_together(samples);
    EXPECT_EQ(graded.size(), samples.size());
    for (const json& submission : graded) {
        const std::string who = submission.at("id");
        SCOPED_TRACE(who);
        const json expected = expected_of(who);
        EXPECT_EQ(is_hard_coded(submission), expected.contains("unmoved")) << submission.at("flags").dump(2);
        const json& variants = submission.at("variants");
        if (expected.contains("unmoved")) {
            const auto unmoved = expected.at("unmoved").get<std::set<std::string>>();
            EXPECT_THAT(item_names(variants.at("unmoved")), IsSupersetOf(unmoved));
            EXPECT_EQ(variants.at("verdict"), unmoved.empty() ? "not_found" : "does_not_move");
        } else if (variants.is_null()) {
            EXPECT_FALSE(expected.contains("variants"));
            EXPECT_THAT(submission.at("outcome"), AnyOf("compile_error", "no_output"));
        } else {
            EXPECT_THAT(variants.at("verdict"), AnyOf("computes", "breaks")) << variants.dump(2);
            EXPECT_EQ(variants.at("verdict"), expected.value("variants", variants.at("verdict")));
        }
    }
}

TEST(Variants, DoNotFlagARepeatedNone) {
    // Both programs look away from the scene and print "none" everywhere, which is right in this class.
    const fs::path miss = project_folder() / "tests/given/labelled/miss";
    for (const char* who : {"m06", "m07"}) {
        const json submission = graded_with_variants(miss / who, "2", (miss / "assignment.toml").string());
        EXPECT_FALSE(is_hard_coded(submission)) << submission.at("flags").dump(2);
        EXPECT_NE(submission.at("variants").at("verdict"), "not_found");
    }
}

/// A program that states the scene and prints the right answer to question 5 on every scene. `more` follows the scene.
std::string program_with(const std::string& more) {
    return "#include <cmath>\n#include <cstdio>\n#include <cstdlib>\n"
           "constexpr float eye[3] = {0, 0, 4}, lookat[3] = {0, 0, 0}, center[3] = {1, 1, 0};\n"
           "constexpr float A[3] = {0, -2, 2}, B[3] = {2, 2, 2}, C[3] = {-2, 2, 2};\n" +
           more +
           "\nint main() {\n"
           "    if (is_bad(eye[0])) abort();\n"
           "    const float x = lookat[0] - eye[0], y = lookat[1] - eye[1], z = lookat[2] - eye[2];\n"
           "    const float l = sqrtf(x * x + y * y + z * z);\n"
           "    printf(\"Question 5:\\nV: vec3(%f, %f, %f)\\n\", x / l, y / l, z / l);\n"
           "}\n";
}

class PointsForVariants : public testing::Test {
  protected:
    PointsForVariants() {
        write(folder / "a.toml", read(project_folder() / "reference/assignments/a6-2021.toml") +
                                     "\nvariant_points = 20\n"
                                     "[[variant]]\nname = \"left\"\ncamera.eye = [-5, 0, 3]\n"
                                     "[[variant]]\nname = \"right\"\ncamera.eye = [3, 0, 5]\n");
    }
    Result run(const std::vector<std::string>& words) const {
        Result result = raygrade(words, with_cache(folder / "cache"));
        EXPECT_EQ(result.status, 0) << result.both();
        return result;
    }
    Result grade(const std::vector<std::string>& more) const {
        std::vector<std::string> words{"grade", (folder / "ada").string(), "--assignment", (folder / "a.toml").string(),
                                       "--out", (folder / "out").string()};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }
    json submission() const { return read_json(folder / "out/grades.json").at("submissions").at(0); }
    /// Grades the program on the scenes "left" and "right".
    json graded(const std::string& source) const {
        write(folder / "ada/ray_cast.cpp", source);
        grade({"--variants", "2"});
        return submission();
    }
    double variants_in_history(int run) const {
        return SQLite::Database((folder / "out/gradebook.sqlite").string(), SQLite::OPEN_READONLY)
            .execAndGet("SELECT json_extract(items, '$.variants') FROM history WHERE run = " + std::to_string(run))
            .getDouble();
    }
    TemporaryFolder folder;
};

/// The share of a program that answers only question 5, on any scene: 10 of 100 points.
constexpr double a_tenth = 0.1;

TEST_F(PointsForVariants, CountASceneThatDoesNotCompileAsTheAssignmentsOwn) {
    const json submission =
        graded(program_with("static_assert(eye[0] != 3, \"not there\");\nbool is_bad(float x) { return x == -5; }"));
    const json& variants = submission.at("variants");
    ASSERT_EQ(variants.at("runs").size(), 1U) << "it crashed there, and so was tried";
    EXPECT_EQ(variants.at("runs").at(0).at("name"), "left");
    EXPECT_EQ(variants.at("runs").at(0).at("share"), 0.0);
    EXPECT_EQ(variants.at("not_tried"), json::array({{{"name", "right"},
                                                      {"changes", "eye = (3, 0, 5)"},
                                                      {"why", "the source does not compile with its numbers"}}}));
    EXPECT_NEAR(submission.at("other_scenes").at("points").get<double>(), 20 * (0 + a_tenth) / 2, 1e-9);
    const json& flag = submission.at("flags").at(0);
    EXPECT_EQ(flag.at("kind"), "variants_not_tried");
    EXPECT_THAT(flag.at("evidence").get<std::string>(),
                HasSubstr("on 1 of 2 other scenes (right): the source does not compile with its numbers."));
}

TEST_F(PointsForVariants, NameTheirScenesInARegradeAndAreKept) {
    const std::string right_on_the_left = program_with("bool is_bad(float x) { return x > 0; }");
    const json before = graded(right_on_the_left);
    EXPECT_NEAR(before.at("other_scenes").at("points").get<double>(), 20 * (a_tenth + 0) / 2, 1e-9);
    EXPECT_EQ(before.at("variants").at("seed"), 1);
    EXPECT_THAT(grade({"--variants", "1", "--variant-seed", "7", "--apply"}).output,
                HasSubstr("other scenes (+1: 1 scene of seed 7, before 2 scenes of seed 1)"));
    EXPECT_NEAR(submission().at("other_scenes").at("points").get<double>(), 20 * a_tenth, 1e-9);
    EXPECT_EQ(submission().at("variants").at("seed"), 7);
    EXPECT_NEAR(variants_in_history(1), 1, 1e-9);
    EXPECT_NEAR(variants_in_history(2), 2, 1e-9);
}

TEST_F(PointsForVariants, AreOverriddenByTheirNameAndSurviveARegrade) {
    graded(program_with("bool is_bad(float x) { return x > 0; }"));
    const Result given = run({"override", "--results", (folder / "out").string(), "ada", "variants", "15", "--why",
                              "right there by hand", "--by", "Prof. X"});
    EXPECT_THAT(given.output, HasSubstr("ada: 11 -> 25 of 120 points in total"));
    EXPECT_EQ(submission().at("other_scenes").at("points"), 15);
    EXPECT_EQ(submission().at("other_scenes").at("automatic_points"), 1);
    EXPECT_THAT(read(folder / "out/report.html"),
                AllOf(HasSubstr("Other scenes: 15 of 20 points."), HasSubstr("right there by hand")));
    EXPECT_THAT(read(folder / "out/feedback/ada.html"),
                HasSubstr("Your instructor gave 15 points for the other scenes: right there by hand"));

    std::string toml = read(folder / "a.toml");
    toml.replace(toml.find("variant_points = 20"), 19, "variant_points = 60");
    write(folder / "a.toml", toml);
    EXPECT_THAT(grade({"--variants", "2", "--apply"}).output, HasSubstr("other scenes (+2)"));
    EXPECT_EQ(submission().at("points"), 25) << "the override stands";
    EXPECT_EQ(submission().at("max_points"), 160);
    EXPECT_EQ(submission().at("automatic_points"), 13);

    toml.replace(toml.find("variant_points = 60"), 19, "");
    write(folder / "a.toml", toml);
    const Result without = grade({"--variants", "2", "--apply"});
    EXPECT_THAT(without.voice, HasSubstr("the override of variants for ada is unused, because there is no such"));
    EXPECT_EQ(submission().at("points"), 10);
    EXPECT_THAT(read(folder / "out/feedback/ada.html"), Not(HasSubstr("Your instructor gave")));
    EXPECT_THAT(read(folder / "out/report.html"), HasSubstr("the rubric no longer has these points"));
}

// The source states no scene, and two printed answers may be there by chance.
TEST(Variants, FlagThreePrintedAnswersButNotTwo) {
    const TemporaryFolder folder;
    const auto printing = [&](const std::string& answers) {
        write(folder / "ada/ray_cast.cpp", "#include <cstdio>\nint main() { puts(\"" + answers + "\"); }\n");
        return graded_with_variants(folder / "ada", "1");
    };
    const std::string two = "Question 6:\\nt: 0.585786\\nhit point: (0.0, 0.0, 1.414214)\\n";
    EXPECT_EQ(printing(two).at("flags"), json::array());
    const json three = printing(two + "Question 7:\\nnormal: (-0.5, -0.5, 0.707107)\\n");
    EXPECT_TRUE(is_hard_coded(three)) << three.dump(2);
}

}  // namespace
}  // namespace scenario
