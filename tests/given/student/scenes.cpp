#include "tests/given/student/scenes.h"

#include <map>
#include <stdexcept>
#include <string>

namespace student {
namespace {

constexpr std::string_view camera_off_axis = R"(
[camera]
eye = [3, 2, 5]
lookat = [0.5, 0.25, -1]
vup = [0.2, 1, 0.1]
[window]
clip_left = -1.5
clip_right = 2.5
clip_bottom = -1
clip_top = 1.25
clip_near = 2
width = 320
height = 200
pixel = [211, 77]
)";

constexpr std::string_view camera_large = R"(
[camera]
eye = [10300, 9200, 10500]
lookat = [10050, 9025, 9900]
vup = [0.2, 1, 0.1]
[window]
clip_left = -150
clip_right = 250
clip_bottom = -100
clip_top = 125
clip_near = 200
width = 320
height = 200
pixel = [211, 77]
)";

constexpr std::string_view camera_small = R"(
[camera]
eye = [0.003, 0.002, 0.005]
lookat = [0.0005, 0.00025, -0.001]
vup = [0.2, 1, 0.1]
[window]
clip_left = -0.0015
clip_right = 0.0025
clip_bottom = -0.001
clip_top = 0.00125
clip_near = 0.002
width = 320
height = 200
pixel = [211, 77]
)";

constexpr std::string_view camera_downward = R"(
[camera]
eye = [3, 2, 5]
lookat = [-0.5, -0.25, -1]
vup = [0.2, 1, 0.1]
[window]
clip_left = -1.5
clip_right = 2.5
clip_bottom = -1
clip_top = 1.25
clip_near = 2
width = 320
height = 200
pixel = [140, 90]
)";

constexpr std::string_view camera_upward = R"(
[camera]
eye = [3, -2, 5]
lookat = [-0.5, 0.25, -1]
vup = [0.2, 1, 0.1]
[window]
clip_left = -1.5
clip_right = 2.5
clip_bottom = -1
clip_top = 1.25
clip_near = 2
width = 320
height = 200
pixel = [140, 90]
)";

/// Looks along the axis of a cylinder, to whose tube the ray is parallel.
constexpr std::string_view camera_from_above = R"(
[camera]
eye = [1, 8, 2]
lookat = [1, 0, 2]
vup = [0, 0, -1]
[window]
clip_left = -2
clip_right = 2
clip_bottom = -1
clip_top = 1
clip_near = 2
width = 301
height = 201
pixel = [150, 100]
)";

/// The questions of 2024, which ask for the tube's a, b, c and d besides.
constexpr std::string_view questions_of_2024 = R"(
[[question]]
title = "the ray"
items = ["P_VCS", "X_vcs", "Y_vcs", "Z_vcs", "M_VCS_to_WCS", "P_WCS", "V"]
points = 30
[[question]]
title = "ray and sphere"
items = ["sphere.a", "sphere.b", "sphere.c", "sphere.d", "sphere.t", "sphere.hit", "sphere.normal"]
points = 20
[[question]]
title = "ray and triangle"
items = ["triangle.matrix", "triangle.rhs", "triangle.t", "triangle.u", "triangle.v", "triangle.hit", "triangle.normal"]
points = 20
[[question]]
title = "ray and cylinder"
items = ["cylinder.a", "cylinder.b", "cylinder.c", "cylinder.d", "cylinder.t", "cylinder.hit", "cylinder.normal"]
points = 20
[[question]]
title = "first hit"
items = ["first_hit"]
points = 10
)";

std::string sphere(std::string_view center, std::string_view radius) {
    return "[[sphere]]\ncenter = " + std::string(center) + "\nradius = " + std::string(radius) + "\n";
}

std::string triangle(std::string_view vertices) {
    return "[[triangle]]\nvertices = " + std::string(vertices) + "\n";
}

std::string cylinder(std::string_view center, std::string_view radius, std::string_view height) {
    return "[[cylinder]]\ncenter = " + std::string(center) + "\nradius = " + std::string(radius) +
           "\nheight = " + std::string(height) + "\n";
}

constexpr std::string_view sphere_near = "[3.9, -0.6, 0]";
constexpr std::string_view triangle_far = "[[2, -4, -4], [8, -2, -5], [3, 3, -5.5]]";
constexpr std::string_view triangle_near = "[[2, -1.5, 1], [6, 0, 1.5], [3, 3, 0.5]]";

const std::map<std::string_view, std::string>& scenes() {
    const std::string off_axis(camera_off_axis);
    static const std::map<std::string_view, std::string> table = {
        {"off axis", off_axis + sphere(sphere_near, "1.25") + triangle(triangle_far)},
        {"triangle first", off_axis + sphere("[4.25, -1.5, -4]", "2") + triangle(triangle_near)},
        {"sphere missed", off_axis + sphere("[-3, 2, -4]", "2") + triangle(triangle_near)},
        {"triangle missed",
         off_axis + sphere(sphere_near, "1.25") + triangle("[[-2, 1, 1], [1, 2, 1.5], [-1, 4, 0.5]]")},
        {"both missed", off_axis + sphere("[-3, 2, -4]", "2") + triangle("[[-2, 1, 1], [1, 2, 1.5], [-1, 4, 0.5]]")},
        {"grazing", off_axis + sphere("[5.47229, -0.58136, -1.54782]", "1.5") + triangle(triangle_near)},
        {"inside", off_axis + sphere("[3, 1, 2]", "2.5") + triangle(triangle_far)},
        {"behind", off_axis + sphere("[3, 3, 7]", "2") + triangle("[[2, 1, 6], [6, 2, 6.5], [3, 5, 5.5]]")},
        {"large", std::string(camera_large) + sphere("[10390, 8940, 10000]", "125") +
                      triangle("[[10200, 8600, 9600], [10800, 8800, 9500], [10300, 9300, 9450]]")},
        {"small", std::string(camera_small) + sphere("[0.0039, -0.0006, 0]", "0.00125") +
                      triangle("[[0.002, -0.004, -0.004], [0.008, -0.002, -0.005], [0.003, 0.003, -0.0055]]")},
        // The following scenes are decided in the ninth digit, which float does not have.
        {"barely hit",
         off_axis + sphere("[5.47230208, -0.581360514, -1.547818876]", "1.50000001") + triangle(triangle_near)},
        {"barely missed",
         off_axis + sphere("[5.47230208, -0.581360514, -1.547818876]", "1.49999999") + triangle(triangle_near)},
        {"barely inside",
         off_axis + sphere(sphere_near, "1.25") +
             triangle(
                 "[[4.988051041, 1.418639486, -1.264611201], [7, -3, -2], [2.988051041, -2.581360514, -2.264611201]]")},
        {"barely outside",
         off_axis + sphere("[4.25, -1.5, -4]", "2") +
             triangle(
                 "[[4.988051081, 1.418639486, -1.264611201], [7, -3, -2], [2.988051081, -2.581360514, -2.264611201]]")},
        {"almost a tie", off_axis + sphere(sphere_near, "1.25") +
                             triangle("[[4.622966677, -1.627549067, 0.934909329], [1.622966677, -0.627549067, "
                                      "1.034909329], [4.622966677, 3.372450933, 0.234909329]]")},
        // This scene lies on the axes, where float is exact: the sphere's nearest point lies in the triangle.
        {"tie", camera_on_the_axis(8) + sphere("[0, 0, 0]", "2") + triangle("[[-4, -4, 2], [4, -4, 2], [0, 8, 2]]")},
    };
    return table;
}

const std::map<std::string_view, std::string>& cylinder_scenes() {
    const std::string questions(questions_of_2024);
    const std::string beyond =
        sphere("[0.3, 0.2, -1.5]", "0.9") + triangle("[[-3, -3, -3], [4, -2, -3.5], [0, 4, -2.5]]");
    const std::string downward = std::string(camera_downward) + questions,
                      upward = std::string(camera_upward) + questions;
    static const std::map<std::string_view, std::string> table = {
        {"tube and bottom", downward + beyond + cylinder("[1.1, 0.5, 0.3]", "1.3", "0.9")},
        {"through the tube", downward + sphere("[2, 1, 2.5]", "0.3") +
                                 triangle("[[-3, -3, -3], [4, -2, -3.5], [0, 4, -2.5]]") +
                                 cylinder("[1.1, -0.3, 0.3]", "0.8", "7")},
        {"top and tube", downward + beyond + cylinder("[1.2, -1, 0.6]", "1.3", "3")},
        {"top and bottom", downward + sphere("[0.3, 0.2, -1.5]", "0.9") +
                               triangle("[[0, -1, 2], [4, 0, 2.4], [1, 3, 2.2]]") +
                               cylinder("[1.2, 0.35, 0.6]", "2.3", "0.3")},
        {"bottom and tube", upward + beyond + cylinder("[1.2, 1, 0.6]", "1.3", "3")},
        {"bottom and top", upward + beyond + cylinder("[1.2, -0.35, 0.6]", "2.3", "0.3")},
        {"in the cylinder", downward + beyond + cylinder("[2, 1, 2.8]", "1.1", "2")},
        {"in it, below the top", downward + beyond + cylinder("[1.9, 0.6, 2.2]", "1.6", "1.8")},
        {"in it, above the bottom", downward + beyond + cylinder("[1.4, 1.3, 2]", "2.7", "1.6")},
        {"cylinder behind", downward + beyond + cylinder("[2.8, 2, 4.8]", "0.7", "1")},
        {"cylinder missed", downward + beyond + cylinder("[-1.5, 0.5, 1]", "0.8", "2")},
        {"below the rim", downward + beyond + cylinder("[1.1, -0.85, 0.3]", "0.9", "3")},
        {"passed above", downward + beyond + cylinder("[1.1, -2, 0.3]", "0.9", "3")},
        {"large cylinder", std::string(camera_large) + questions + sphere("[10390, 8940, 10000]", "125") +
                               triangle("[[10200, 8600, 9600], [10800, 8800, 9500], [10300, 9300, 9450]]") +
                               cylinder("[10370, 9040, 10100]", "90", "170")},
        {"small cylinder", std::string(camera_small) + questions + sphere("[0.0039, -0.0006, 0]", "0.00125") +
                               triangle("[[0.002, -0.004, -0.004], [0.008, -0.002, -0.005], [0.003, 0.003, -0.0055]]") +
                               cylinder("[0.0037, 0.0004, 0.001]", "0.0009", "0.0017")},
        {"along the axis", std::string(camera_from_above) + questions + sphere("[1.5, -4, 2.5]", "2") +
                               triangle("[[-4, 1, -4], [6, 1, -4], [1, 1, 9]]") +
                               cylinder("[1.5, 2, 2.25]", "1.5", "3")},
        // The following scenes are decided in the eighth digit: the ray passes a rim, or touches the tube.
        {"near rim, tube", downward + beyond + cylinder("[1.1, -0.245022857383, 0.3]", "1.3", "2")},
        {"near rim, cap", downward + beyond + cylinder("[1.1, -0.245022897383, 0.3]", "1.3", "2")},
        {"far rim, hit", downward + beyond + cylinder("[1.1, -1.103009399012, 0.3]", "1.3", "2")},
        {"far rim, missed", downward + beyond + cylinder("[1.1, -1.103009439012, 0.3]", "1.3", "2")},
        {"near bottom rim, hit", downward + beyond + cylinder("[1.1, 1.754977102617, 0.3]", "1.3", "2")},
        {"near bottom rim, missed", downward + beyond + cylinder("[1.1, 1.754977142617, 0.3]", "1.3", "2")},
        {"tube touched", downward + beyond + cylinder("[0.2, 0.2, 0.3]", "0.782325201", "5")},
        {"tube barely missed", downward + beyond + cylinder("[0.2, 0.2, 0.3]", "0.782325181", "5")},
    };
    return table;
}

}  // namespace

std::string camera_on_the_axis(int eye_z, std::string_view pixels) {
    return "[camera]\neye = [0, 0, " + std::to_string(eye_z) +
           "]\nlookat = [0, 0, 0]\nvup = [0, 1, 0]\n"
           "[window]\nclip_left = -2\nclip_right = 2\nclip_bottom = -1\nclip_top = 1\nclip_near = 2\n" +
           std::string(pixels);
}

Marking marking_of(std::string_view toml, std::string_view name) {
    static std::map<std::string, Marking> known;  // a key takes a tenth of a second
    const auto found = known.find(std::string(toml));
    if (found != known.end()) return found->second;
    Marking marking{reference::parse_assignment(toml, std::string(name) + ".toml"), {}};
    marking.key = reference::make_key(marking.assignment, reference::Precision::certified);
    return known.emplace(toml, marking).first->second;
}

namespace {

Marking marking_of_assignment(const std::string& name) {
    return marking_of(reference::read_assignment_file(name, RAYGRADE_ASSIGNMENTS).toml, name);
}

}  // namespace

Marking handout_scene() {
    return marking_of_assignment("a6-2021");
}

Marking edge_scene() {
    return marking_of_assignment("a6-edge");
}

Marking off_axis_scene() {
    return scene_named("off axis");
}

Marking scene_named(std::string_view name) {
    if (name == "handout") return handout_scene();
    if (name == "edge") return edge_scene();
    if (name == "handout of 2024") return marking_of_assignment("a6-2024");
    const auto with_cylinder = cylinder_scenes().find(name);
    return marking_of(with_cylinder == cylinder_scenes().end() ? scenes().at(name) : with_cylinder->second, name);
}

const std::vector<std::string_view>& scene_names() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all{"handout", "edge"};
        for (const auto& [name, toml] : scenes()) all.push_back(name);
        return all;
    }();
    return names;
}

const std::vector<std::string_view>& cylinder_scene_names() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all{"handout of 2024"};
        for (const auto& [name, toml] : cylinder_scenes()) all.push_back(name);
        return all;
    }();
    return names;
}

const std::vector<std::string_view>& scenes_to_err_on(reference::Subject subject) {
    using reference::Subject;
    static const std::vector<std::string_view> off_axis{"off axis", "inside", "triangle first"};
    switch (subject) {
        case Subject::camera:
        case Subject::sphere:
        case Subject::triangle:
        case Subject::first_hit: break;
        case Subject::cylinder: return cylinder_scene_names();
    }
    return off_axis;
}

bool rounding_decides(std::string_view name) {
    const auto contains = [&](std::string_view word) { return name.find(word) != std::string_view::npos; };
    return contains("rim") || contains("touched") || contains("barely");
}

}  // namespace student
