#include "harness/report/picture/scene_sketch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "harness/report/picture/svg.h"
#include "reference/stages/scene_answers.h"

namespace harness::report::picture {
namespace {

namespace item = reference::item;
using reference::AnswerKey;
using reference::ItemId;
using reference::Numbers;
using reference::Subject;

/// The key's numbers for an item; null without any.
const Numbers* numbers_of(const AnswerKey& key, const ItemId& id) {
    const reference::KeyItem* asked = reference::asked_item(key, id);
    return asked == nullptr ? nullptr : std::get_if<Numbers>(&asked->answers.front().value);
}

/// Empty without three finite numbers.
std::optional<Point> point_of(const AnswerKey& key, const ItemId& id) {
    const Numbers* numbers = numbers_of(key, id);
    if (numbers == nullptr || numbers->size() != 3) return std::nullopt;
    const Point point((*numbers)[0], (*numbers)[1], (*numbers)[2]);
    return is_finite(point) ? std::optional(point) : std::nullopt;
}

/// The key's t for an object; empty if it has none.
std::optional<double> t_of(const AnswerKey& key, Subject kind) {
    const Numbers* numbers = numbers_of(key, {kind, "t"});
    return numbers != nullptr && numbers->size() == 1 ? std::optional(numbers->front()) : std::nullopt;
}

void draw_object(const reference::Sphere<double>& sphere, bool named, Sketch& sketch) {
    sketch.balls.push_back({sphere.center, sphere.radius});
    if (named) sketch.dots.push_back({sphere.center, "C", Ink::sphere, Mark::ring});
}

void draw_object(const reference::Triangle<double>& triangle, bool named, Sketch& sketch) {
    sketch.polygons.push_back({{triangle.A, triangle.B, triangle.C}, Ink::triangle, Stroke::plain});
    if (!named) return;
    sketch.dots.push_back({triangle.A, "A", Ink::triangle, Mark::dot});
    sketch.dots.push_back({triangle.B, "B", Ink::triangle, Mark::dot});
    sketch.dots.push_back({triangle.C, "C", Ink::triangle, Mark::dot});
}

void draw_object(const reference::Cylinder<double>& cylinder, bool named, Sketch& sketch) {
    sketch.tubes.push_back({cylinder.center, cylinder.radius, cylinder.height});
    if (named) sketch.dots.push_back({cylinder.center, "center", Ink::cylinder, Mark::ring});
}

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

/// The part of the cylinder that is hit, found by the normal.
std::string_view part_of_cylinder(const std::optional<Point>& normal) {
    if (!normal) return "cylinder";
    if (normal->y == 0) return "cylinder's tube";
    return normal->y > 0 ? "cylinder's top cap" : "cylinder's bottom cap";
}

std::string miss_note(Subject kind, const RightValues& right, const std::optional<double>& t) {
    const std::string missed = fmt::format("The ray misses the {}", to_string(kind));
    if (kind != Subject::triangle) return missed + ".";
    const std::optional<Point>& P_t = right.objects.at(kind).hit;
    if (!P_t) return missed + ": it is parallel to its plane.";
    const bool is_behind = t ? *t < 0 : right.P_WCS && right.V && reference::dot(*P_t - *right.P_WCS, *right.V) < 0;
    return missed +
           (is_behind ? ": P_t is behind its start, t < 0." : ": P_t is in its plane, but outside the triangle.");
}

/// Whether and where the ray meets the object that the questions are about.
std::string hit_note(Subject kind, std::string_view point, const RightValues& right, const AnswerKey& key) {
    const std::string decision = key.decisions.of(kind);
    const std::optional<double> t = t_of(key, kind);
    const std::string_view object =
        kind == Subject::cylinder ? part_of_cylinder(right.objects.at(kind).normal) : to_string(kind);
    if (decision == "hit")
        return fmt::format("{}: the ray hits the {}{}.", point, object, t ? fmt::format(", t = {:.4g}", *t) : "");
    if (decision == "miss") return miss_note(kind, right, t);
    if (decision == "tangent")
        return fmt::format("{}: the ray touches the {} in this one point, d = 0.", point, object);
    if (decision == "boundary" && kind == Subject::triangle) return "P_t: the ray starts on the triangle, t = 0.";
    if (decision == "boundary")
        return fmt::format("The ray starts on the {}, {} = 0.", to_string(kind), kind == Subject::sphere ? "c" : "t");
    return decision == "coplanar" ? "The ray lies in the triangle's plane." : "";
}

/// Hit point and normal of the object that the questions are about.
void draw_hit(Subject kind, const auto& objects, const RightValues& right, const AnswerKey& key, Sketch& sketch) {
    const auto& [hit, normal, index] = right.objects.at(kind);
    const std::string point = fmt::format("P_{}", to_string(kind).front());
    const Ink ink = ink_of(kind);
    // If t = 0 does not count as a hit, the key has no hit point, although the ray starts there.
    const bool starts_on_triangle = kind == Subject::triangle && key.decisions.of(kind) == "boundary";
    const std::optional<Point> at = starts_on_triangle ? right.P_WCS : hit;
    // A triangle's key has the point in its plane and the normal even if the ray misses the triangle.
    const bool is_met = at && key.decisions.of(kind) != "miss";
    if (at) sketch.dots.push_back({*at, point, ink, is_met ? Mark::dot : Mark::ring});
    if (normal && is_met) sketch.arrows.push_back({*at, *normal, "N at " + point, ink, Stroke::plain});
    if (normal && !is_met && kind == Subject::triangle)
        sketch.arrows.push_back({middle_of(objects[index]), *normal, "N of ABC", ink, Stroke::plain});
    if (const std::string note = hit_note(kind, point, right, key); !note.empty()) sketch.notes.push_back(note);
}

void tell_first(const AnswerKey& key, Sketch& sketch) {
    const auto& decisions = key.decisions;
    if (decisions.objects.size() < 2) return;
    if (std::ranges::find(decisions.policy, "boundary") != decisions.policy.end()) {
        sketch.notes.emplace_back("Which object is hit first depends on whether t = 0 counts as a hit.");
    } else if (decisions.first == "tie") {
        sketch.notes.emplace_back("The ray hits two objects first, at the same t.");
    } else if (decisions.first != "none" && decisions.first != "unsure") {
        sketch.notes.push_back(fmt::format("The ray hits the {} first.", decisions.first));
    }
}

}  // namespace

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
    const auto answers =
        reference::answer_scene(reference::in_double(assignment.scene), rubric.pixel_conventions.front(), boundary);
    for (const Subject kind : reference::objects)
        right.objects[kind] = {point_of(key, {kind, "hit"}), point_of(key, {kind, "normal"}),
                               reference::asked_index(kind, answers)};
    return right;
}

std::vector<Point> points_of(const RightValues& right, const AnswerKey& key, const DoubleScene& scene) {
    std::vector<Point> points;
    if (right.P_WCS) points.push_back(*right.P_WCS);
    for (const auto& [kind, met] : right.objects) {
        if (met.hit && key.decisions.of(kind) != "miss") points.push_back(*met.hit);
    }
    if (right.X_vcs && right.Y_vcs && right.Z_vcs) {
        for (const Point& corner : window_corners(scene, *right.X_vcs, *right.Y_vcs, *right.Z_vcs))
            points.push_back(corner);
    }
    return points;
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

void draw_given(const DoubleScene& scene, const std::optional<RightValues>& right, Sketch& sketch) {
    const auto& camera = scene.camera;
    sketch.dots.push_back({camera.eye, "eye", Ink::camera, Mark::dot});
    sketch.dots.push_back({camera.lookat, "lookat", Ink::camera, Mark::ring});
    sketch.lines.push_back({camera.eye, camera.lookat, Ink::camera, Stroke::thin});
    sketch.arrows.push_back({camera.eye, reference::normalized(camera.vup), "vup", Ink::camera, Stroke::thin});
    reference::for_each_kind(
        [&](Subject kind, const auto& objects) {
            constexpr std::size_t most = 6, most_named = 2;
            const std::size_t count = std::min(objects.size(), most);
            const std::size_t asked = right ? right->objects.at(kind).index : 0;
            for (std::size_t i = 0; i < count; ++i)
                draw_object(objects[i + 1 == count ? std::max(i, asked) : i], objects.size() <= most_named, sketch);
            if (count < objects.size())
                sketch.notes.push_back(
                    fmt::format("Only {} of {} {}s are drawn.", count, objects.size(), to_string(kind)));
        },
        scene);
}

void draw_right(const RightValues& right, const AnswerKey& key, const DoubleScene& scene, const Frame& frame,
                Sketch& sketch) {
    draw_ray(right, scene, frame, sketch);
    reference::for_each_kind(
        [&](Subject kind, const auto& objects) {
            if (!objects.empty()) draw_hit(kind, objects, right, key, sketch);
        },
        scene);
    tell_first(key, sketch);
    draw_window(right, scene, sketch);
    if (right.P_VCS) sketch.pixels.push_back({*right.P_VCS, "P_VCS", Ink::ray, Mark::dot});
    for (const Dot& dot : sketch.dots) {
        if (!frame.holds(dot.at)) sketch.notes.push_back(fmt::format("{} is outside the picture.", dot.name));
    }
}

}  // namespace harness::report::picture
