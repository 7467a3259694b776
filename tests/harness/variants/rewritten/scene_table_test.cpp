#include "harness/variants/rewritten/scene_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "harness/build/include_block.h"
#include "harness/run/execute.h"
#include "harness/run/limits.h"
#include "harness/run/runner.h"
#include "harness/run/timeline.h"
#include "reference/toml/assignment.h"
#include "tests/given/strongest_tier.h"

namespace harness::variants {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const source::DecimalScene& own_scene() {
    static const source::DecimalScene a6 = reference::load_assignment("a6-2021", RAYGRADE_ASSIGNMENTS).scene;
    return a6;
}

reference::Decimal decimal(const char* number) {
    return reference::Decimal::parse(number).value();
}

/// The eye at (3, -2, 5.1), which float and double hold differently, and the sphere's radius 3.
source::DecimalScene moved() {
    source::DecimalScene scene = own_scene();
    scene.camera.eye = {decimal("3"), decimal("-2"), decimal("5.1")};
    scene.spheres.front().radius = decimal("3");
    return scene;
}

/// What the copy of `source` prints on its own scene and on the moved one; empty if there is no copy or it does not
/// compile.
std::vector<std::string> printed_by_copy(const std::string& source) {
    const source::SceneLiterals found = source::find_scene(source, own_scene());
    const auto copy = with_table(source, found);
    if (!copy) return {};
    const StageLimits limits = read_limits({}, {});
    const Runner runner = make_runner(std::make_unique<const Sandbox>(strongest_tier()),
                                      default_build_settings(limits.compile), limits.run);
    Submission submission;
    submission.source = *copy;
    for (const source::DecimalScene& scene : {own_scene(), moved()})
        submission.inputs.push_back(table_of(found, scene).value_or("no table"));
    Timeline timeline;
    std::vector<std::string> printed;
    for (const Execution& each : execute(submission, runner, timeline).runs) {
        if (each.build.compiled) printed.push_back(each.run.output);
    }
    return printed;
}

TEST(SceneTable, GivesEachNumberItsTypeItsPlaceAndItsValueBeforeAnythingRuns) {
    const std::string source = R"(#include <cstdio>
#include <glm/glm.hpp>  // the vectors
void say(int x) { printf("int %d\n", x); }
void say(float x) { printf("float %.9g\n", x); }
void say(double x) { printf("double %.17g\n", x); }
#define RADIUS 2
namespace f { auto R = 2.0f; }
namespace d { auto R = 2.0; }
const double eye[] = {0.0, 0.0, 4.0};
const glm::vec3 eye2 = glm::vec3(0, 0.0f, 4.0f);
struct Early { Early() { printf("early %g\n", eye[2]); } } early;
int main() {
    say(RADIUS), say(RADIUS / 2), say(f::R), say(d::R);
    say(eye[2]), say(eye2.x), say(eye2.z);
    printf("line %d\n", __LINE__);
}
)";
    EXPECT_THAT(printed_by_copy(source),
                ElementsAre("early 4\nint 2\nint 1\nfloat 2\ndouble 2\ndouble 4\nfloat 0\nfloat 4\nline 15\n",
                            "early 5.1\nint 3\nint 1\nfloat 3\ndouble 3\ndouble 5.0999999999999996\n"
                            "float 3\nfloat 5.0999999\nline 15\n"))
        << with_table(source, source::find_scene(source, own_scene())).value_or("");
}

TEST(SceneTable, LeavesTheDirectivesThatAHeaderReplacesAndEveryLine) {
    const std::string source =
        "#include <cmath> // roots\n#define GLM_ENABLE_EXPERIMENTAL\n#include <glm/glm.hpp> /* and\nvectors */\n"
        "glm::vec3 eye(0.0f, 0.0f, 4.0f);\nint main() {}\n";
    const auto copy = with_table(source, source::find_scene(source, own_scene()));
    ASSERT_TRUE(copy);
    const auto texts = [](const std::string& text) {
        std::vector<std::string> all;
        for (const Directive& directive : include_block(text)) all.push_back(directive.text);
        return all;
    };
    EXPECT_EQ(texts(*copy), texts(source));
    EXPECT_THAT(*copy, HasSubstr("\n#line 3\n /* and\nvectors */\n"));
    EXPECT_THAT(*copy, HasSubstr("glm::vec3 eye((+::raygrade_scene[0].as_float), "));
}

TEST(SceneTable, IsNotMadeWithoutNumbersOfOrdinaryTypesThatFitIt) {
    const auto copy = [](const std::string& source) {
        return with_table(source, source::find_scene(source, own_scene()));
    };
    EXPECT_FALSE(copy("int main() {}"));
    EXPECT_FALSE(copy("long double R = 2.0L; int main() {}"));
    EXPECT_TRUE(copy("double R = 2.0; int main() {}"));
    std::string many = "int main() {\n";
    for (int i = 0; i < 257; ++i) many += "double R = 2.0;\n";
    EXPECT_FALSE(copy(many + "}")) << "a table of 4,096 bytes has 256 numbers";
}

TEST(SceneTable, HasNoFractionsForWholeNumbers) {
    const std::string source = "int R = 2;";
    const source::SceneLiterals found = source::find_scene(source, own_scene());
    EXPECT_TRUE(table_of(found, moved()));
    source::DecimalScene halved = own_scene();
    halved.spheres.front().radius = decimal("2.5");
    EXPECT_FALSE(table_of(found, halved));
}

TEST(SceneTable, HasNoNumbersThatDoNotFitTheirType) {
    source::DecimalScene huge = own_scene();
    huge.spheres.front().radius = decimal("1e40");
    const auto table = [&](const std::string& source) {
        return table_of(source::find_scene(source, own_scene()), huge);
    };
    EXPECT_FALSE(table("float R = 2.0f;")) << "a compiler makes it infinite";
    EXPECT_TRUE(table("double R = 2.0;"));
}

}  // namespace
}  // namespace harness::variants
