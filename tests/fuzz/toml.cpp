#include <algorithm>
#include <string>
#include <vector>

#include "reference/toml/assignment.h"
#include "reference/toml/assignment_error.h"
#include "reference/toml/scene_toml.h"
#include "tests/fuzz/properties.h"

namespace {

using reference::Assignment;
using reference::AssignmentError;

constexpr std::string_view file = "scene.toml";

/// Whether the message names the file and then, between colons, a line of it.
bool names_a_line(std::string_view message, std::size_t lines) {
    if (!message.starts_with(file)) return false;
    for (std::size_t at = message.find(':'); at != std::string_view::npos; at = message.find(':', at + 1)) {
        std::size_t line = 0;
        std::size_t end = at + 1;
        for (; end < message.size() && message[end] >= '0' && message[end] <= '9' && line <= lines; ++end)
            line = 10 * line + static_cast<std::size_t>(message[end] - '0');
        if (end > at + 1 && end < message.size() && message[end] == ':') return line >= 1 && line <= lines;
    }
    return false;
}

using Scene = reference::Scene<reference::Decimal>;

/// All numbers of the scene in its order, as written.
std::vector<std::string> numbers_of(const Scene& scene) {
    std::vector<std::string> numbers;
    const auto add = [&](const reference::Vec3<reference::Decimal>& p) {
        for (const reference::Decimal& number : {p.x, p.y, p.z}) numbers.push_back(number.text());
    };
    add(scene.camera.eye), add(scene.camera.lookat), add(scene.camera.vup);
    const auto& window = scene.window;
    for (const reference::Decimal& number :
         {window.clip_left, window.clip_right, window.clip_bottom, window.clip_top, window.clip_near})
        numbers.push_back(number.text());
    for (const int number : {window.width, window.height, scene.pixel.x, scene.pixel.y})
        numbers.push_back(std::to_string(number));
    numbers.push_back(std::to_string(scene.spheres.size()) + " spheres");
    for (const auto& sphere : scene.spheres) add(sphere.center), numbers.push_back(sphere.radius.text());
    for (const auto& triangle : scene.triangles) add(triangle.A), add(triangle.B), add(triangle.C);
    return numbers;
}

/// Whether the scene is read as itself from what is printed of it.
std::string check_printed(const Scene& scene) {
    const std::string printed = scene_toml(scene);
    try {
        if (numbers_of(reference::parse_assignment(printed, file).scene) != numbers_of(scene))
            return "a scene is read otherwise than it was printed: " + printed;
        if (numbers_of(reference::check_scene(scene, file)) != numbers_of(scene))
            return "a check changes a scene: " + printed;
    } catch (const AssignmentError& error) {
        return std::string("a scene is refused as it was printed: ") + error.what();
    }
    return {};
}

std::string check_rubric(const reference::Rubric& rubric) {
    const auto is_share = [](double share) { return share >= 0 && share <= 1; };
    if (!is_share(rubric.follow_through) || !is_share(rubric.wrong_scene_credit) ||
        !is_share(rubric.follow_through_cap) ||
        !std::ranges::all_of(rubric.late, is_share, &reference::LateStep::share)) {
        return "a share beyond 0 to 1";
    }
    if (rubric.min_decimals < 0 || rubric.min_decimals > 9) return "decimals beyond 0 to 9";
    if (!(rubric.variant_points >= 0)) return "points below 0 for other scenes";
    for (const auto& [question, points] : rubric.points) {
        if (!(points >= 0) || question < 1 || question > 10) return "points below 0, or for a question beyond 1 to 10";
    }
    if (rubric.pixel_conventions.empty()) return "no place of a ray in its pixel";
    if (rubric.tolerance && !(*rubric.tolerance >= 0)) return "a tolerance below 0";
    return {};
}

}  // namespace

std::string check_toml(std::string_view toml) {
    const auto lines = static_cast<std::size_t>(std::count(toml.begin(), toml.end(), '\n')) + 1;
    Assignment assignment;
    try {
        assignment = reference::parse_assignment(toml, file);
    } catch (const AssignmentError& error) {
        return names_a_line(error.what(), lines) ? ""
                                                 : std::string("a message without a line of the file: ") + error.what();
    }
    if (std::string broken = check_rubric(assignment.rubric); !broken.empty()) return broken;
    if (std::string broken = check_printed(assignment.scene); !broken.empty()) return broken;
    for (const reference::Variant& variant : assignment.variants) {
        if (std::string broken = check_printed(variant.scene); !broken.empty()) return broken;
        if (numbers_of(variant.scene) == numbers_of(assignment.scene)) return "a variant that changes nothing";
    }
    return {};
}
