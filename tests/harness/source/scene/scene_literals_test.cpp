#include "harness/source/scene/scene_literals.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "harness/source/scene/scene_part.h"
#include "tests/given/bytes_of.h"
#include "tests/harness/source/scene/handouts.h"

namespace harness::source {
namespace {

namespace fs = std::filesystem;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

/// A scene whose numbers all differ from the assignment's and from each other.
DecimalScene with_other_numbers() {
    const auto decimal = [](int x) { return reference::Decimal::parse(std::to_string(x)).value(); };
    const auto vector = [&](int x, int y, int z) {
        return reference::Vec3<reference::Decimal>(decimal(x), decimal(y), decimal(z));
    };
    DecimalScene scene = scene_of_2021();
    scene.camera = {vector(11, 12, 13), vector(-14, 15, 16), vector(17, 18, 19)};
    scene.spheres.front() = {vector(21, -22, 23), decimal(24)};
    scene.triangles.front() = {vector(31, 32, 33), vector(34, 35, 36), vector(37, 38, 39)};
    scene.pixel = {41, 42};
    return scene;
}

std::set<std::string> located_in_2021(const std::string& source) {
    return located(source, scene_of_2021());
}

std::string rewritten_of_2021(const std::string& source) {
    return rewritten(source, scene_of_2021(), with_other_numbers());
}

TEST(FindScene, ReadsTheEyeInEverySpelling) {
    EXPECT_EQ(rewritten_of_2021("vec3 eye(0, 0, 4);"), "vec3 eye(11, 12, 13);");
    EXPECT_EQ(rewritten_of_2021("glm::vec3 eye = glm::vec3(0.0f, 0.f, 4.0F);"),
              "glm::vec3 eye = glm::vec3(11.0f, 12.0f, 13.0f);");
    EXPECT_EQ(rewritten_of_2021("auto e = dvec3{0.0, 0.0, 4.0};"), "auto e = dvec3{11.0, 12.0, 13.0};");
    EXPECT_EQ(rewritten_of_2021("float eye[3] = {0, 0, 4};"), "float eye[3] = {11, 12, 13};");
    EXPECT_EQ(rewritten_of_2021("std::array<double, 3> p{{0, +0, 8 / 2}};"), "std::array<double, 3> p{{11, 12, 13}};");
    EXPECT_EQ(rewritten_of_2021("cam.eye.x = 0; cam.eye.y = 0; cam.eye.z = 4e0;"),
              "cam.eye.x = 11; cam.eye.y = 12; cam.eye.z = 13.0;");
    EXPECT_EQ(rewritten_of_2021("e[0] = 0; e[1] = 0; e[2] = 4;"), "e[0] = 11; e[1] = 12; e[2] = 13;");
    EXPECT_EQ(rewritten_of_2021("const int eyeX = 0, eyeY = 0, eyeZ = 0x4;"),
              "const int eyeX = 11, eyeY = 12, eyeZ = 13;");
    EXPECT_EQ(rewritten_of_2021("#define EYE vec3(0, 0, 4)\n"), "#define EYE vec3(11, 12, 13)\n");
    EXPECT_EQ(rewritten_of_2021("#define EYE 0, 0, 4 // m\n"), "#define EYE 11, 12, 13 // m\n");
    EXPECT_EQ(rewritten_of_2021("Camera c{.eye = {0, 0, 4}, .w = 2};"), "Camera c{.eye = {11, 12, 13}, .w = 2};");
    EXPECT_EQ(rewritten_of_2021("vec4 p(0, 0, 4, 1);"), "vec4 p(11, 12, 13, 1);");
}

TEST(FindScene, ReadsConstantsAsTheCompilerDoes) {
    EXPECT_EQ(rewritten_of_2021("int px = 0226, py = 0144;"), "int px = 41, py = 42;");
    EXPECT_EQ(rewritten_of_2021("int px = 1'50, py = 0b110'0100;"), "int px = 41, py = 42;");
    EXPECT_EQ(rewritten_of_2021("vec3 eye(0, 0, 9 / 2);"), "vec3 eye(11, 12, 13);");
    EXPECT_EQ(rewritten_of_2021("vec3 eye(0, 0, 9 / 2.0);"), "vec3 eye(0, 0, 9 / 2.0);") << "that is 4.5";
    EXPECT_EQ(rewritten_of_2021("vec3 eye(2 - 2, 0, 6 - 1 * 2);"), "vec3 eye(11, 12, 13);");
}

TEST(FindScene, BracketsANegativeNumberInAMacro) {
    const std::string unknown = "#define N_X 0\n#define N_Y 0\n#define N_Z 0\n";
    EXPECT_EQ(rewritten_of_2021(unknown), unknown);
    EXPECT_EQ(rewritten_of_2021("#define LOOKAT_X 0\n#define LOOKAT_Y 0\n#define LOOKAT_Z 0\n"),
              "#define LOOKAT_X (-14)\n#define LOOKAT_Y 15\n#define LOOKAT_Z 16\n");
}

TEST(FindScene, ReadsSphereAndTriangle) {
    EXPECT_EQ(rewritten_of_2021("add(new Sphere(vec3(1, 1, 0), 2)); float R = 2.f;"),
              "add(new Sphere(vec3(21, -22, 23), 24)); float R = 24.0f;");
    EXPECT_EQ(rewritten_of_2021("Sphere s(1, 1, 0, 2);"), "Sphere s(21, -22, 23, 24);");
    EXPECT_EQ(rewritten_of_2021("vec3 A(0, -2, 2), B(2), C(-2, 2, 2);"),
              "vec3 A(31, 32, 33), B(34, 35, 36), C(37, 38, 39);");
    EXPECT_EQ(rewritten_of_2021("vec3 A(0, -2, 2), B(2), C(-2, 2, 2); f(2);"),
              "vec3 A(31, 32, 33), B(34, 35, 36), C(37, 38, 39); f(2);");
    EXPECT_EQ(rewritten_of_2021("vec3 t[] = {vec3(0, -2, 2), vec3(2.f), vec3(-2, 2, 2)};"),
              "vec3 t[] = {vec3(31, 32, 33), vec3(34.0f, 35.0f, 36.0f), vec3(37, 38, 39)};");
    EXPECT_EQ(rewritten_of_2021("float tri[] = {0, -2, 2, 2, 2, 2, -2, 2, 2};"),
              "float tri[] = {31, 32, 33, 34, 35, 36, 37, 38, 39};");
}

TEST(FindScene, AcceptsCommonValuesOnlyByNameOrPlace) {
    EXPECT_THAT(located_in_2021("vec3 lookat(0, 0, 0), vup(0, 1, 0);"), UnorderedElementsAre("lookat", "vup"));
    EXPECT_THAT(located_in_2021("m = lookAt(eye, vec3(0, 0, 0), vec3(0, 1, 0));"),
                UnorderedElementsAre("lookat", "vup"));
    EXPECT_THAT(located_in_2021("Camera c({0, 0, 4}, {0, 0, 0}, {0, 1, 0});"),
                UnorderedElementsAre("eye", "lookat", "vup"));
    EXPECT_THAT(located_in_2021("vec3 sum(0, 0, 0); vec3 axis(0, 1, 0);"), IsEmpty());
    EXPECT_THAT(located_in_2021("x = dot(vec3(0, 1, 0), n);"), IsEmpty());
}

TEST(FindScene, ConcludesNothingFromADoubtfulPlace) {
    EXPECT_THAT(located_in_2021("vec3 vup(0, 1, 0); x = cross(vec3(0, 1, 0), z);"), IsEmpty());
    EXPECT_THAT(located_in_2021("vec3 A(0, -2, 2), B(2, 2, 2);"), IsEmpty());
    EXPECT_THAT(located_in_2021("float R = 2; double radius = 3;"), IsEmpty());
    EXPECT_THAT(located_in_2021("#ifdef OTHER\nvec3 eye(0, 0, 4);\n#endif"), IsEmpty());
    EXPECT_THAT(located_in_2021("#ifdef OTHER\nvec3 eye(0, 0, 4);\n#else\nvec3 eye(0, 0, 4);\n#endif"), IsEmpty());
    EXPECT_THAT(located_in_2021("p = vec2(150, 100); q = 100;"), IsEmpty());
    EXPECT_THAT(located_in_2021("p = vec2(150, 100); q = 150;"), IsEmpty());
    EXPECT_THAT(located_in_2021("eyeX = 0; eyeY = 0; eyeZ = 4; eyeX = 9;"), IsEmpty());
    EXPECT_THAT(located_in_2021("vec3 vup(0, 1, 0); return f(0, 1, 0);"), IsEmpty());
    EXPECT_THAT(located_in_2021("vec3 vup(0, 1, 0); use(0, 1, 0, 7);"), UnorderedElementsAre("vup"))
        << "that is no vector";
}

TEST(FindScene, ReadsOnlyCompiledCode) {
    const std::string source =
        "// vec3 eye(0, 0, 4);\nputs(\"vec3 eye(0, 0, 4)\");\n#if 0\nvec3 eye(0, 0, 4);\n#endif\n"
        "auto s = R\"(eye(0, 0, 4))\";\n#include <eye(0,0,4)>\n#pragma eye(0, 0, 4)\n";
    EXPECT_THAT(located_in_2021(source), IsEmpty());
    EXPECT_THAT(located_in_2021("#if 1\nvec3 eye(0, 0, 4);\n#endif"), UnorderedElementsAre("eye"));
    EXPECT_THAT(located_in_2021("#define MINE\n#ifdef MINE\nvec3 eye(0, 0, 4);\n#endif"), UnorderedElementsAre("eye"));
}

TEST(FindScene, NeverChangesFormulas) {
    const std::string formulas =
        "float d = b * b - 4 * a * c; float t = (-b - sqrt(d)) / (2 * a); float x = -2 + 4 * (px + 0.5f) / W;\n"
        "float l = -2, r = 2, bottom = -1, top = 1, near = 2; int W = 301, H = 201; mat4 M(1.0f); f(2, 2); g(4);\n"
        "float clipR = 2; for (int i = 0; i < 4; i++) for (int j = 0; j < 2; j++) m[i][j] = 0; setw(2); vec3 hit(0);\n";
    EXPECT_THAT(located_in_2021(formulas), IsEmpty());
    EXPECT_THAT(located_in_2021("vec3 TB = row(2), TA = row(1);"), IsEmpty());
    EXPECT_THAT(located_in_2021("const double L = -2, R = 2, B = -1, T = 1, N = 2;"), IsEmpty()) << "the window";
    EXPECT_THAT(located_in_2021("const double R = 2;"), UnorderedElementsAre("radius"));
    EXPECT_EQ(rewritten_of_2021(formulas + "vec3 eye(0, 0, 4);"), formulas + "vec3 eye(11, 12, 13);");
}

TEST(FindScene, KeepsTheHalfOfThePixel) {
    EXPECT_EQ(rewritten_of_2021("x = -2 + 4 * 150.5f / 301; y = -1 + 2 * 100.5 / 201;"),
              "x = -2 + 4 * 41.5f / 301; y = -1 + 2 * 42.5 / 201;");
    EXPECT_EQ(rewritten_of_2021("int px = 150, py = 100;"), "int px = 41, py = 42;");
}

TEST(FindScene, IgnoresThePixelsNumbersInOtherPlaces) {
    DecimalScene scene = scene_of_2021();
    scene.pixel = {4, 2};
    EXPECT_FALSE(find_scene("f(4, 2); g(4); h(2);", scene).located.contains(part::pixel));
}

TEST(WithScene, WritesNoFractionForAnIntegerOfTheSource) {
    DecimalScene scene = scene_of_2021();
    scene.camera.eye.x = reference::Decimal::parse("1.5").value();
    const auto rewrite = [&](const std::string& source) {
        return with_scene(source, find_scene(source, scene_of_2021()), scene);
    };
    EXPECT_EQ(rewrite("int eye[] = {0, 0, 4};"), std::nullopt);
    EXPECT_EQ(rewrite("float eye[] = {0.f, 0, 4};"), "float eye[] = {1.5f, 0, 4};");
}

TEST(WithScene, ReturnsTheSourceForTheAssignmentsOwnScene) {
    const std::string source = "vec3 eye(0.0f, 0.0f, 4.0f); int p[] = {150, 100}; Sphere s{{1, 1, 0}, 2};";
    EXPECT_EQ(with_scene(source, find_scene(source, scene_of_2021()), scene_of_2021()), source);
}

/// Whether the submission compiles, according to its label.json or expected.json. Hostile submissions have neither.
bool compiles(const fs::path& folder) {
    for (const char* name : {"label.json", "expected.json"}) {
        if (fs::exists(folder / name))
            return nlohmann::json::parse(bytes_of(folder / name)).at("outcome") != "compile_error";
    }
    return false;
}

TEST(FindScene, FindsTheSceneOfNineTenthsOfTheSampleClass) {
    std::size_t all = 0, found = 0;
    std::string without;
    for (const auto& entry : fs::directory_iterator(fs::path(RAYGRADE_PROJECT) / "submissions")) {
        if (!compiles(entry.path())) continue;
        ++all;
        const SceneLiterals scene = find_scene(bytes_of(entry.path() / "ray_cast.cpp"), scene_of_2021());
        bool whole = true;
        for (const ScenePart part :
             {part::eye, part::sphere::center, part::triangle::A, part::triangle::B, part::triangle::C})
            whole = whole && scene.located.contains(part);
        found += whole ? 1 : 0;
        if (!whole) without += " " + entry.path().filename().string();
    }
    std::cout << "eye, center, A, B and C found in " << found << " of " << all << " submissions; not in:" << without
              << "\n";
    EXPECT_GE(all, 50U);
    EXPECT_GE(static_cast<double>(found), 0.9 * static_cast<double>(all));
}

}  // namespace
}  // namespace harness::source
