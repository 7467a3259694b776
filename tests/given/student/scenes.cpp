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

std::string sphere(std::string_view center, std::string_view radius) {
    return "[[sphere]]\ncenter = " + std::string(center) + "\nradius = " + std::string(radius) + "\n";
}

std::string triangle(std::string_view vertices) {
    return "[[triangle]]\nvertices = " + std::string(vertices) + "\n";
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
    return marking_of(scenes().at(name), name);
}

const std::vector<std::string_view>& scene_names() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all{"handout", "edge"};
        for (const auto& [name, toml] : scenes()) all.push_back(name);
        return all;
    }();
    return names;
}

}  // namespace student
