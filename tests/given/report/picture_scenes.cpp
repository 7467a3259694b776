#include "tests/given/report/picture_scenes.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "harness/mark/score/mark_transcript.h"
#include "harness/record/marking.h"
#include "reference/accuracy/rays/random_numbers.h"
#include "tests/given/random_scene.h"

namespace picture_scenes {
namespace {

using reference::accuracy::Random;

constexpr const char* camera_2021 = "[camera]\neye = [0, 0, 4]\nlookat = [0, 0, 0]\nvup = [0, 1, 0]\n";
constexpr const char* window_2021 =
    "[window]\nclip_left = -2\nclip_right = 2\nclip_bottom = -1\nclip_top = 1\nclip_near = 2\nwidth = 301\nheight = "
    "201\npixel = [150, 100]\n";
constexpr const char* sphere_2021 = "[[sphere]]\ncenter = [1, 1, 0]\nradius = 2\n";
constexpr const char* triangle_2021 = "[[triangle]]\nvertices = [[0, -2, 2], [2, 2, 2], [-2, 2, 2]]\n";

std::string sphere(const std::string& center, const std::string& radius) {
    return fmt::format("[[sphere]]\ncenter = [{}]\nradius = {}\n", center, radius);
}

std::string triangle(const std::string& A, const std::string& B, const std::string& C) {
    return fmt::format("[[triangle]]\nvertices = [[{}], [{}], [{}]]\n", A, B, C);
}

std::string cylinder(const std::string& center, const std::string& radius, const std::string& height) {
    return fmt::format("[[cylinder]]\ncenter = [{}]\nradius = {}\nheight = {}\n", center, radius, height);
}

constexpr const char* asks_about_cylinder =
    "[[question]]\nnumber = 1\nitems = [\"P_VCS\", \"X_vcs\", \"Y_vcs\", \"Z_vcs\", \"M_VCS_to_WCS\", \"P_WCS\", "
    "\"V\"]\n"
    "[[question]]\nnumber = 4\nitems = [\"cylinder.t\", \"cylinder.hit\", \"cylinder.normal\"]\n";
constexpr const char* asks_about_all =
    "[[question]]\nnumber = 5\nitems = [\"sphere.hit\", \"sphere.normal\"]\n"
    "[[question]]\nnumber = 6\nitems = [\"triangle.hit\", \"triangle.normal\"]\n"
    "[[question]]\nnumber = 7\nitems = [\"first_hit\"]\n";

std::string with_objects(const std::string& objects) {
    return std::string(camera_2021) + window_2021 + objects;
}

/// The same view of the same objects, with all lengths multiplied by 10 to the power.
std::string scaled(int power) {
    const std::string e = fmt::format("e{}", power);
    const auto p = [&](const char* x, const char* y, const char* z) {
        return fmt::format("{}{}, {}{}, {}{}", x, e, y, e, z, e);
    };
    return fmt::format(
               "[camera]\neye = [{}]\nlookat = [{}]\nvup = [0, 1, 0]\n[window]\nclip_left = -2.0{e}\nclip_right = "
               "2.0{e}\nclip_bottom = -1.0{e}\nclip_top = 1.0{e}\nclip_near = 2.0{e}\nwidth = 301\nheight = 201\npixel "
               "= "
               "[140, 90]\n",
               p("6.0", "3.0", "8.0"), p("0.0", "1.0", "0.0"), fmt::arg("e", e)) +
           sphere(p("1.0", "1.0", "0.0"), "1.5" + e) +
           triangle(p("0.0", "-2.0", "2.0"), p("3.0", "2.0", "1.0"), p("-2.0", "2.0", "2.0"));
}

std::string crowd() {
    std::string objects;
    for (int i = 0; i < 40; ++i) {
        objects += sphere(fmt::format("{}, {}, {}", i % 5 - 2, i / 5 - 2, -i), "0.4");
        objects += triangle(fmt::format("{}, 0, {}", i, -i), fmt::format("{}, 0, {}", i + 1, -i),
                            fmt::format("{}, 1, {}", i, -i));
    }
    return objects;
}

std::string cylinders() {
    std::string objects;
    for (int i = 0; i < 9; ++i) objects += cylinder(fmt::format("{}, 0, {}", i % 3 - 1, -i), "0.4", "1");
    return objects;
}

std::string camera(const char* eye, const char* lookat, const char* vup) {
    return fmt::format("[camera]\neye = [{}]\nlookat = [{}]\nvup = [{}]\n", eye, lookat, vup);
}

harness::Marking with_key(reference::Assignment assignment) {
    reference::AnswerKey key = reference::make_key(assignment, reference::Precision::certified);
    return {std::move(assignment), std::move(key)};
}

}  // namespace

const std::vector<Named>& hard_scenes() {
    static const std::vector<Named> scenes = {
        {"2021", with_objects(std::string(sphere_2021) + triangle_2021)},
        {"nothing", with_objects("")},
        {"no sphere", with_objects(triangle_2021)},
        {"no triangle", with_objects(sphere_2021)},
        {"missed", with_objects(sphere("-9, 1, -2", "1") + triangle("5, -2, -5", "7, 2, -2", "5, 2, -2"))},
        {"tangent", with_objects(sphere("2, 0, 0", "2") + triangle("0, -2, -3", "2, 2, -3", "-2, 2, -3"))},
        {"starts on the sphere", with_objects(sphere("0, 0, 0", "2") + triangle_2021)},
        {"grazes an edge", with_objects(triangle("0, -1, 0", "0, 1, 0", "3, 0, -1"))},
        {"coplanar", with_objects(std::string(sphere_2021) + triangle("0, 0, 1", "0, 2, -2", "0, -1, -2"))},
        {"beside the plane", with_objects(std::string(sphere_2021) + triangle("1, 0, 1", "1, 2, -2", "1, -1, -2"))},
        {"behind the start", with_objects(std::string(sphere_2021) + triangle("0, -2, 3", "2, 2, 3", "-2, 2, 3"))},
        {"eye within", with_objects(sphere("0, 0, 0", "1000000") + triangle_2021)},
        {"eye within a small one", with_objects(sphere("0, 0, 2", "9") + triangle_2021)},
        {"floor", camera("0, 3, 8", "0, 0, 0", "0, 1, 0") + std::string(window_2021) + sphere("0, -1000, 0", "1000") +
                      triangle("-1, 0, 1", "1, 0, 1", "0, 2, 1")},
        {"a wall of a sphere", with_objects(sphere("40, 0, -40", "50") + triangle_2021)},
        {"down", camera("1, 9, 1", "1, 0, 0.5", "0, 0, -1") + std::string(window_2021) + sphere("1, 0, 0", "2") +
                     triangle("0, 3, 0", "3, 3, 1", "0, 3, 3")},
        {"exactly down", camera("0, 9, 0", "0, 0, 0", "0, 0, 1") + std::string(window_2021) + sphere_2021},
        {"z is up", camera("7, -6, 4", "0, 0, 1", "0, 0, 1") + std::string(window_2021) + sphere("0, 0, 1", "2") +
                        triangle("3, -3, 0", "4, -1, 0", "3, -2, 4")},
        {"far", camera("0, 0, 4", "0, 0, -100000", "0, 1, 0") + std::string(window_2021) +
                    sphere("0, 0, -100000", "20000") +
                    triangle("0, -2000, -30000", "2000, 2000, -30000", "-2000, 2000, -30000")},
        {"near the eye",
         with_objects(sphere("0, 0, 3.9", "0.05") + triangle("0, 0, -300", "40, 0, -300", "0, 40, -300"))},
        {"all at one place",
         with_objects(sphere("0, 0, 0", "0.001") + triangle("0, 0, 0", "0.001, 0, 0", "0, 0.001, 0"))},
        {"off the origin", camera("1000000, 1000000, 1000004", "1000000, 1000000, 1000000", "0, 1, 0") +
                               std::string(window_2021) + sphere("1000001, 1000001, 1000000", "2")},
        {"narrow", camera("0, 0, 4", "0, 0, 0", "0, 1, 0") +
                       "[window]\nclip_left = -0.05\nclip_right = 0.05\nclip_bottom = -3\nclip_top = 3\nclip_near = "
                       "2\nwidth = 10\nheight = 600\npixel = [5, 300]\n" +
                       sphere_2021 + triangle_2021},
        {"mirrored", camera("0, 0, 4", "0, 0, 0", "0, 1, 0") +
                         "[window]\nclip_left = 2\nclip_right = -2\nclip_bottom = 1\nclip_top = -1\nclip_near = "
                         "2\nwidth = 1\nheight = 1\npixel = [0, 0]\n" +
                         sphere_2021 + triangle_2021},
        {"a crowd", with_objects(crowd())},
        {"2024", camera("6, 1, 0", "0, 1, 0", "0, 1, 0") + std::string(window_2021) + sphere("1, 0, 1", "2") +
                     triangle("3, -1, -1", "3, -1, 1", "1, 3, 0") + cylinder("2, 0, 0", "1", "4") +
                     asks_about_cylinder + asks_about_all},
        {"on the cap", camera("3, 8, 5", "0, 1, 0", "0, 1, 0") + std::string(window_2021) +
                           cylinder("0, 0, 0", "2", "2") + asks_about_cylinder},
        {"under the cap", camera("0, -9, 1", "0, 0, 0", "0, 0, 1") + std::string(window_2021) +
                              cylinder("0, 0, 0", "2", "1") + asks_about_cylinder},
        {"past the cylinder", with_objects(cylinder("0, 4, -2", "1", "2") + asks_about_cylinder)},
        {"along the tube", with_objects(cylinder("3, 0, -2", "3", "2") + asks_about_cylinder)},
        {"starts on the cylinder", with_objects(cylinder("0, 0, 0", "2", "2") + asks_about_cylinder)},
        {"within a cylinder", with_objects(cylinder("0, 0, 0", "1000", "3000") + sphere_2021 + asks_about_cylinder)},
        {"on a disc", camera("0, 3, 8", "0, 0, 0", "0, 1, 0") + std::string(window_2021) +
                          cylinder("0, -5, 0", "1000", "10") + sphere("0, 1, 0", "1") + asks_about_cylinder},
        {"before a pillar", with_objects(cylinder("1, 0, -3", "0.5", "4000") + triangle_2021 + asks_about_cylinder)},
        {"nine cylinders", with_objects(cylinders() + asks_about_cylinder)},
        {"thousandths", scaled(-3)},
        {"ones", scaled(0)},
        {"millions", scaled(6)},
    };
    return scenes;
}

harness::Marking marking_of(const Named& scene) {
    static std::map<std::string, harness::Marking> made;  // a certified key takes long
    const auto [at, is_new] = made.try_emplace(scene.name + scene.toml);
    if (is_new) at->second = with_key(reference::parse_assignment(scene.toml, scene.name + ".toml"));
    return at->second;
}

harness::Marking marking_of(const std::string& name) {
    for (const Named& scene : hard_scenes()) {
        if (scene.name == name) return marking_of(scene);
    }
    throw std::logic_error("no scene " + name);
}

harness::Marking random_marking(std::uint64_t seed) {
    static std::map<std::uint64_t, harness::Marking> made;
    const auto [at, is_new] = made.try_emplace(seed);
    if (is_new) at->second = with_key(random_assignment(seed));
    return at->second;
}

harness::Graded graded(const std::string& output, const harness::Marking& marking) {
    harness::Graded result;
    result.execution.outcome = harness::Outcome::graded;
    result.score = harness::score(harness::read_transcript(output, 10), marking.key, marking.assignment);
    return result;
}

std::string random_output(std::uint64_t seed, const harness::Marking& marking) {
    Random random(seed);
    std::string output;
    for (const reference::KeyQuestion& question : marking.key.questions) {
        output += fmt::format("Question {}\n", question.number);
        for (const reference::KeyItem& item : question.items) {
            const auto* numbers = std::get_if<reference::Numbers>(&item.answers.front().value);
            if (item.spec.shape != reference::Shape::vector || random.whole(0, 9) == 0) continue;
            std::vector<double> value = numbers != nullptr ? *numbers : reference::Numbers{1, 2, 3};
            const int kind = random.whole(0, 9);
            for (double& x : value) {
                if (kind == 3) x += random.between(-1, 1);
                if (kind == 4) x = -x;
                if (kind == 5) x = random.between(-9, 9);
                if (kind == 6) x *= random.between(0, 4);
                if (kind == 7) x *= 1e12;
                if (kind == 8) x = random.whole(0, 1) == 0 ? HUGE_VAL : std::nan("");
                if (kind == 9) x = 0;
            }
            output += fmt::format("{}: ({:.6g}, {:.6g}, {:.6g})\n", item.spec.label, value[0], value[1], value[2]);
        }
    }
    return output;
}

}  // namespace picture_scenes
