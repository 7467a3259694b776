#include "harness/report/sketch/assignment_sketch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reference/stages/scene_answers.h"
#include "reference/stages/scene_numbers.h"

namespace harness::report::picture {
namespace {

using reference::AnswerKey;
using reference::Numbers;

namespace item = reference::item;
using reference::ItemId;
using reference::Subject;

const Numbers* numbers_of(const AnswerKey& key, const ItemId& id) {
    const reference::KeyItem* asked = reference::asked_item(key, id);
    return asked == nullptr ? nullptr : std::get_if<Numbers>(&asked->answers.front().value);
}

std::optional<Point> point_of(const AnswerKey& key, const ItemId& id) {
    const Numbers* numbers = numbers_of(key, id);
    if (numbers == nullptr || numbers->size() != 3) return std::nullopt;
    const Point point((*numbers)[0], (*numbers)[1], (*numbers)[2]);
    return is_finite(point) ? std::optional(point) : std::nullopt;
}

double number_of(const AnswerKey& key, const ItemId& id) {
    const Numbers* numbers = numbers_of(key, id);
    return numbers != nullptr && numbers->size() == 1 ? numbers->front() : std::nan("");
}

/// The index of the thing that differs least, the first of several; 0 if none can be told.
template <class T, class Difference>
std::size_t nearest(const std::vector<T>& things, Difference difference) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < things.size(); ++i) {
        if (difference(things[i]) < difference(things[best])) best = i;
    }
    return best;
}

// The index of the object of a kind that the questions are about. P_WCS and V are known.
std::size_t asked_index(const std::vector<reference::Sphere<double>>& spheres, const AnswerKey& key,
                        const RightValues& right) {
    const std::optional<Point> P_s = right.of(Subject::sphere).hit;
    const double b = number_of(key, item::sphere::b);
    const double c = number_of(key, item::sphere::c);
    if ((std::isnan(b) || std::isnan(c)) && P_s) {
        return nearest(spheres,
                       [&](const auto& sphere) { return std::abs(distance(*P_s, sphere.center) - sphere.radius); });
    }
    return nearest(spheres, [&](const auto& sphere) {
        const auto quadratic = reference::sphere_quadratic(*right.P_WCS, *right.V, sphere);
        return std::hypot(quadratic.b - b, quadratic.c - c);
    });
}

std::size_t asked_index(const std::vector<reference::Triangle<double>>& triangles, const AnswerKey& key,
                        const RightValues& right) {
    const Numbers* matrix = numbers_of(key, item::triangle::matrix);
    const auto rhs = point_of(key, item::triangle::rhs);
    if (matrix == nullptr || matrix->size() != 9 || !rhs) return 0;
    return nearest(triangles, [&](const auto& triangle) {
        const auto system = reference::triangle_system(*right.P_WCS, *right.V, triangle);
        double sum = distance(system.rhs, *rhs);
        for (int i = 1; i < 3; ++i) {
            const auto at = static_cast<std::size_t>(3 * i);
            sum += distance(system.matrix[i], Point((*matrix)[at], (*matrix)[at + 1], (*matrix)[at + 2]));
        }
        return sum;
    });
}

std::size_t asked_index(const std::vector<reference::Cylinder<double>>& cylinders, const AnswerKey& /*key*/,
                        const RightValues& right) {
    const std::optional<Point> P_c = right.of(Subject::cylinder).hit;
    if (!P_c) return 0;
    return nearest(cylinders, [&](const auto& cylinder) {
        const Point from_center = *P_c - cylinder.center;
        const double beyond_tube = std::hypot(from_center.x, from_center.z) - cylinder.radius;
        const double beyond_cap = std::abs(from_center.y) - cylinder.height / 2;
        return std::abs(std::max(beyond_tube, beyond_cap));
    });
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

std::string hit_note(std::string_view object, std::string_view point, double t) {
    if (std::isnan(t)) return fmt::format("{}: the ray hits the {}.", point, object);
    return fmt::format("{}: the ray hits the {}, t = {:.4g}.", point, object, t);
}

// Where the ray meets the object that the questions are about.
void draw_hit(const reference::Sphere<double>& /*sphere*/, const RightValues& right, const AnswerKey& key,
              Sketch& sketch) {
    const auto [P_s, normal, index] = right.of(Subject::sphere);
    const std::string decision = key.decisions.of(Subject::sphere);
    if (P_s) sketch.dots.push_back({*P_s, "P_s", Ink::sphere, Mark::dot});
    if (P_s && normal) sketch.arrows.push_back({*P_s, *normal, "N at P_s", Ink::sphere, Stroke::plain});
    if (decision == "hit") sketch.notes.push_back(hit_note("sphere", "P_s", number_of(key, item::sphere::t)));
    if (decision == "miss") sketch.notes.emplace_back("The ray misses the sphere.");
    if (decision == "tangent") sketch.notes.emplace_back("P_s: the ray touches the sphere in this one point, d = 0.");
    if (decision == "boundary") sketch.notes.emplace_back("The ray starts on the sphere, c = 0.");
}

/// Whether the hit point lies behind the ray's start.
bool is_behind_start(const std::optional<Point>& hit, const RightValues& right) {
    return hit && right.P_WCS && right.V && reference::dot(*hit - *right.P_WCS, *right.V) < 0;
}

void draw_hit(const reference::Triangle<double>& triangle, const RightValues& right, const AnswerKey& key,
              Sketch& sketch) {
    const auto [hit, normal, index] = right.of(Subject::triangle);
    const std::string decision = key.decisions.of(Subject::triangle);
    const bool met = decision == "hit" || decision == "boundary";
    // If t = 0 does not count as a hit, the key has no hit point, although the ray starts there.
    const std::optional<Point> P_t = decision == "boundary" ? right.P_WCS : hit;
    if (P_t) sketch.dots.push_back({*P_t, "P_t", Ink::triangle, met ? Mark::dot : Mark::ring});
    if (normal) {
        const bool at_hit = met && P_t;
        const Point at = at_hit ? *P_t : middle_of(triangle);
        sketch.arrows.push_back({at, *normal, at_hit ? "N at P_t" : "N of ABC", Ink::triangle, Stroke::plain});
    }
    if (decision == "hit") sketch.notes.push_back(hit_note("triangle", "P_t", number_of(key, item::triangle::t)));
    if (decision == "boundary") sketch.notes.emplace_back("P_t: the ray starts on the triangle, t = 0.");
    if (decision == "coplanar") sketch.notes.emplace_back("The ray lies in the triangle's plane.");
    if (decision == "miss") {
        const double t = number_of(key, item::triangle::t);
        const bool behind = std::isnan(t) ? is_behind_start(hit, right) : t < 0;
        sketch.notes.emplace_back(!P_t     ? "The ray misses the triangle: it runs beside its plane."
                                  : behind ? "The ray misses the triangle: P_t is behind its start, t < 0."
                                           : "The ray misses the triangle: P_t is in its plane, but outside of it.");
    }
}

/// "top cap", "bottom cap" or "tube", by the normal; empty if it is not known.
std::string_view part_of_cylinder(const std::optional<Point>& normal) {
    if (!normal) return "";
    if (normal->y == 0) return "tube";
    return normal->y > 0 ? "top cap" : "bottom cap";
}

void draw_hit(const reference::Cylinder<double>& /*cylinder*/, const RightValues& right, const AnswerKey& key,
              Sketch& sketch) {
    const auto [P_c, normal, index] = right.of(Subject::cylinder);
    const std::string decision = key.decisions.of(Subject::cylinder);
    if (P_c) sketch.dots.push_back({*P_c, "P_c", Ink::cylinder, Mark::dot});
    if (P_c && normal) sketch.arrows.push_back({*P_c, *normal, "N at P_c", Ink::cylinder, Stroke::plain});
    if (decision == "hit") {
        const std::string_view part = part_of_cylinder(normal);
        const std::string object = part.empty() ? "cylinder" : fmt::format("cylinder's {}", part);
        sketch.notes.push_back(hit_note(object, "P_c", number_of(key, item::cylinder::t)));
    }
    if (decision == "miss") sketch.notes.emplace_back("The ray misses the cylinder.");
    if (decision == "tangent")
        sketch.notes.emplace_back("P_c: the ray touches the cylinder's tube in this one point, d = 0.");
    if (decision == "boundary") sketch.notes.emplace_back("The ray starts on the cylinder, t = 0.");
}

void tell_first(const AnswerKey& key, Sketch& sketch) {
    const auto& decisions = key.decisions;
    const std::size_t objects = decisions.objects.size();
    if (objects < 2) return;
    if (std::find(decisions.policy.begin(), decisions.policy.end(), "boundary") != decisions.policy.end()) {
        sketch.notes.push_back(fmt::format("Which of the {} is hit first depends on whether t = 0 counts as a hit.",
                                           objects == 2 ? "two" : "three"));
    } else if (decisions.first == "tie") {
        sketch.notes.emplace_back(objects == 2 ? "The ray hits both at the same t."
                                               : "The ray hits two of the three first, at the same t.");
    } else if (decisions.first != "none" && decisions.first != "unsure") {
        sketch.notes.push_back(fmt::format("The ray hits the {} first.", decisions.first));
    }
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

RightValues right_values(const AnswerKey& key, const DoubleScene& scene) {
    RightValues right;
    right.P_VCS = point_of(key, item::P_VCS);
    right.X_vcs = point_of(key, item::X_vcs);
    right.Y_vcs = point_of(key, item::Y_vcs);
    right.Z_vcs = point_of(key, item::Z_vcs);
    right.P_WCS = point_of(key, item::P_WCS);
    right.V = point_of(key, item::V);
    for (const Subject kind : reference::objects)
        right.objects[kind] = {point_of(key, {kind, "hit"}), point_of(key, {kind, "normal"})};
    if (!right.P_WCS || !right.V) return right;
    reference::for_each_kind(
        [&](Subject kind, const auto& objects) { right.objects[kind].index = asked_index(objects, key, right); },
        scene);
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

Point middle_of(const reference::Sphere<double>& sphere) {
    return sphere.center;
}
Point middle_of(const reference::Triangle<double>& triangle) {
    return triangle.A / 3.0 + triangle.B / 3.0 + triangle.C / 3.0;
}
Point middle_of(const reference::Cylinder<double>& cylinder) {
    return cylinder.center;
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
