#include "harness/report/picture/scene_sketch.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "harness/report/picture/object_sketch.h"
#include "reference/stages/scene_answers.h"
#include "reference/stages/scene_numbers.h"

namespace harness::report::picture {
namespace {

namespace item = reference::item;
using reference::AnswerKey;
using reference::Subject;

void draw_window(const RightValues& right, const DoubleScene& scene, Sketch& sketch) {
    if (!right.X_vcs || !right.Y_vcs || !right.Z_vcs) return;
    const Point& eye = scene.camera.eye;
    for (const auto& [name, axis] :
         {std::pair("X_vcs", *right.X_vcs), std::pair("Y_vcs", *right.Y_vcs), std::pair("Z_vcs", *right.Z_vcs)})
        sketch.arrows.push_back({eye, axis, name, Ink::camera, Stroke::plain});
    const std::vector<Point> corners = window_corners(scene, *right.X_vcs, *right.Y_vcs, *right.Z_vcs);
    for (const Point& corner : corners) sketch.lines.push_back({eye, corner, Ink::camera, Stroke::thin});
    sketch.polygons.push_back({corners, Ink::camera, Stroke::plain});
}

void draw_ray(const RightValues& right, const DoubleScene& scene, const Frame& frame, Sketch& sketch) {
    if (!right.P_WCS || !right.V) return;
    sketch.lines.push_back({scene.camera.eye, *right.P_WCS, Ink::ray, Stroke::thin});
    sketch.lines.push_back(ray_from(*right.P_WCS, *right.V, frame));
    sketch.arrows.push_back({*right.P_WCS, *right.V, "V", Ink::ray, Stroke::plain});
    sketch.dots.push_back({*right.P_WCS, "P_WCS", Ink::ray, Mark::dot});
}

/// "two", "three" and so on; digits from ten on.
std::string spelled(std::size_t count) {
    constexpr std::array words{"no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine"};
    return count < words.size() ? words.at(count) : fmt::format("{}", count);
}

void tell_first(const AnswerKey& key, Sketch& sketch) {
    const auto& decisions = key.decisions;
    const std::size_t objects = decisions.objects.size();
    if (objects < 2) return;
    if (std::find(decisions.policy.begin(), decisions.policy.end(), "boundary") != decisions.policy.end()) {
        sketch.notes.push_back(
            fmt::format("Which of the {} is hit first depends on whether t = 0 counts as a hit.", spelled(objects)));
    } else if (decisions.first == "tie") {
        sketch.notes.push_back(objects == 2
                                   ? "The ray hits both at the same t."
                                   : fmt::format("The ray hits two of the {} first, at the same t.", spelled(objects)));
    } else if (decisions.first != "none" && decisions.first != "unsure") {
        sketch.notes.push_back(fmt::format("The ray hits the {} first.", decisions.first));
    }
}

/// If there are many things of a kind, draws only some, without names; `asked` is always among them.
template <class T>
void draw_objects(const std::vector<T>& things, std::size_t asked, std::string_view what, Sketch& sketch) {
    constexpr std::size_t most = 6;
    constexpr std::size_t most_named = 2;
    const std::size_t count = std::min(things.size(), most);
    for (std::size_t i = 0; i < count; ++i)
        draw_object(things[i + 1 == count ? std::max(i, asked) : i], things.size() <= most_named, sketch);
    if (count < things.size())
        sketch.notes.push_back(fmt::format("Only {} of {} {}s are drawn.", count, things.size(), what));
}

}  // namespace

DoubleScene double_scene(const reference::Assignment& assignment) {
    return reference::in_double(assignment.scene);
}

RightValues right_values(const AnswerKey& key, const reference::Assignment& assignment) {
    RightValues right;
    right.P_VCS = point_of(key, item::P_VCS);
    right.X_vcs = point_of(key, item::X_vcs);
    right.Y_vcs = point_of(key, item::Y_vcs);
    right.Z_vcs = point_of(key, item::Z_vcs);
    right.P_WCS = point_of(key, item::P_WCS);
    right.V = point_of(key, item::V);
    const auto& rubric = assignment.rubric;
    const auto boundary = rubric.boundary == reference::BoundaryPolicy::positive ? reference::Boundary::positive
                                                                                 : reference::Boundary::nonnegative;
    const auto answers = reference::answer_scene(double_scene(assignment), rubric.pixel_conventions.front(), boundary);
    for (const Subject kind : reference::objects)
        right.objects[kind] = {point_of(key, {kind, "hit"}), point_of(key, {kind, "normal"}),
                               reference::asked_index(kind, answers)};
    return right;
}

std::vector<Point> window_corners(const DoubleScene& scene, const Point& X_vcs, const Point& Y_vcs,
                                  const Point& Z_vcs) {
    const auto& window = scene.window;
    const Point middle = scene.camera.eye - Z_vcs * window.clip_near;
    const auto corner = [&](double x, double y) { return middle + X_vcs * x + Y_vcs * y; };
    return {corner(window.clip_left, window.clip_bottom), corner(window.clip_right, window.clip_bottom),
            corner(window.clip_right, window.clip_top), corner(window.clip_left, window.clip_top)};
}

Line ray_from(const Point& start, const Point& V, const Frame& frame) {
    constexpr double across_the_frame = 4;
    return {start, start + V * (across_the_frame * frame.unit), Ink::ray, Stroke::plain};
}

Sketch given_sketch(const DoubleScene& scene, const RightValues& right) {
    Sketch sketch;
    const auto& camera = scene.camera;
    sketch.dots.push_back({camera.eye, "eye", Ink::camera, Mark::dot});
    sketch.dots.push_back({camera.lookat, "lookat", Ink::camera, Mark::ring});
    sketch.lines.push_back({camera.eye, camera.lookat, Ink::camera, Stroke::thin});
    const double length = distance(camera.vup, Point(0, 0, 0));
    sketch.arrows.push_back({camera.eye, camera.vup / length, "vup", Ink::camera, Stroke::thin});
    reference::for_each_kind(
        [&](Subject kind, const auto& objects) {
            draw_objects(objects, right.of(kind).index, to_string(kind), sketch);
        },
        scene);
    return sketch;
}

Sketch right_sketch(const RightValues& right, const AnswerKey& key, const DoubleScene& scene, const Frame& frame) {
    Sketch sketch;
    draw_ray(right, scene, frame, sketch);
    reference::for_each_kind(
        [&](Subject kind, const auto& objects) {
            if (!objects.empty()) draw_hit(objects[right.of(kind).index], right, key, sketch);
        },
        scene);
    tell_first(key, sketch);
    draw_window(right, scene, sketch);
    for (const Dot& dot : sketch.dots) {
        if (!frame.holds(dot.at)) sketch.notes.push_back(fmt::format("{} lies beyond the frame.", dot.name));
    }
    return sketch;
}

}  // namespace harness::report::picture
