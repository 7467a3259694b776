#include "harness/variants/rewritten/early_read.h"

#include <gtest/gtest.h>

#include <string>

#include "reference/toml/assignment.h"

namespace harness::variants {
namespace {

/// A source with the declarations above the scene of 2021, whose point looked at is (0, 0, 0).
std::string source_with(const std::string& above, const std::string& scene) {
    return "#include <glm/glm.hpp>\n" + above + "\n" + scene +
           "\nint main() { auto m = glm::lookAt(eye, lookat, vup); return m[0][0] > 0; }\n";
}

const std::string globals =
    "const glm::vec3 eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0); const glm::vec3 C(1, 1, 0); const float R = 2;";

bool is_early(const std::string& source) {
    static const source::DecimalScene a6 = reference::load_assignment("a6-2021", RAYGRADE_ASSIGNMENTS).scene;
    const source::SceneLiterals found = source::find_scene(source, a6);
    EXPECT_FALSE(found.literals.empty()) << source;
    return may_be_read_early(source, found);
}

TEST(EarlyRead, IsPossibleIfSomethingIsDeclaredBeforeItsDefinition) {
    for (const char* above :
         {"glm::vec3 direction();", "extern const float x;", "struct Settings { static const float x; };",
          "struct Box { Box(); float size; }; Box box;", "float f(float) noexcept;", "struct Ray; Ray ray(Ray);"})
        EXPECT_TRUE(is_early(source_with(above, globals))) << above;
}

TEST(EarlyRead, IsImpossibleIfEverythingIsDefinedAtOnce) {
    for (const char* above :
         {"", "glm::vec3 ray(float t) { return glm::vec3(t); }", "using namespace std;",
          "struct Ray { glm::vec3 S; glm::vec3 at(float t) const { return S * t; } };",
          "const float near_plane = f(x); const glm::vec3 up(0.5f, near_plane, 0);", "extern \"C\" { }"})
        EXPECT_FALSE(is_early(source_with(above, globals))) << above;
}

TEST(EarlyRead, IsLookedForInLinearTime) {
    for (const char* part : {"f(1) ", "f(", "a b(x, ", "struct A ", "{ g(1) ", "] ) ("}) {
        std::string above;
        while (above.size() < 300'000) above += part;
        is_early(source_with("", globals) + above);
    }
    std::string nested;
    for (int i = 0; i < 50'000; ++i) nested += "f([1,";
    for (int i = 0; i < 50'000; ++i) nested += "])";
    is_early(source_with("", globals) + nested);
}

TEST(EarlyRead, IgnoresTheVariablesOfAFunction) {
    const std::string source = "#include <glm/glm.hpp>\nglm::vec3 direction();\nint main() {" + globals +
                               "auto m = glm::lookAt(eye, lookat, vup); return m[0][0] > 0; }\n";
    EXPECT_FALSE(is_early(source));
}

}  // namespace
}  // namespace harness::variants
