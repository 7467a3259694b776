#include "harness/report/picture/object_sketch.h"

#include <fmt/format.h>

#include <cmath>
#include <variant>

namespace harness::report::picture {

using reference::AnswerKey;
using reference::ItemId;
using reference::Numbers;
using reference::Subject;
namespace item = reference::item;

namespace {

/// Whether the hit point lies behind the ray's start.
bool is_behind_start(const std::optional<Point>& hit, const RightValues& right) {
    return hit && right.P_WCS && right.V && reference::dot(*hit - *right.P_WCS, *right.V) < 0;
}

/// "top cap", "bottom cap" or "tube", by the normal; empty if it is not known.
std::string_view part_of_cylinder(const std::optional<Point>& normal) {
    if (!normal) return "";
    if (normal->y == 0) return "tube";
    return normal->y > 0 ? "top cap" : "bottom cap";
}

}  // namespace

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

std::string hit_note(std::string_view object, std::string_view point, double t) {
    if (std::isnan(t)) return fmt::format("{}: the ray hits the {}.", point, object);
    return fmt::format("{}: the ray hits the {}, t = {:.4g}.", point, object, t);
}

void draw_object(const reference::Sphere<double>& sphere, bool named, Sketch& sketch) {
    sketch.balls.push_back({sphere.center, sphere.radius});
    if (named) sketch.dots.push_back({sphere.center, "C", Ink::sphere, Mark::ring});
}

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

Point middle_of(const reference::Sphere<double>& sphere) {
    return sphere.center;
}

Extent extent_of(const reference::Sphere<double>& sphere) {
    return {{sphere.center}, sphere.radius};
}

void draw_object(const reference::Triangle<double>& triangle, bool named, Sketch& sketch) {
    sketch.polygons.push_back({{triangle.A, triangle.B, triangle.C}, Ink::triangle, Stroke::plain});
    if (!named) return;
    sketch.dots.push_back({triangle.A, "A", Ink::triangle, Mark::dot});
    sketch.dots.push_back({triangle.B, "B", Ink::triangle, Mark::dot});
    sketch.dots.push_back({triangle.C, "C", Ink::triangle, Mark::dot});
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

Point middle_of(const reference::Triangle<double>& triangle) {
    return triangle.A / 3.0 + triangle.B / 3.0 + triangle.C / 3.0;
}

Extent extent_of(const reference::Triangle<double>& triangle) {
    return {{triangle.A, triangle.B, triangle.C}};
}

void draw_object(const reference::Cylinder<double>& cylinder, bool named, Sketch& sketch) {
    sketch.tubes.push_back({cylinder.center, cylinder.radius, cylinder.height});
    if (named) sketch.dots.push_back({cylinder.center, "center", Ink::cylinder, Mark::ring});
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

Point middle_of(const reference::Cylinder<double>& cylinder) {
    return cylinder.center;
}

Extent extent_of(const reference::Cylinder<double>& cylinder) {
    const Point half(cylinder.radius, cylinder.height / 2, cylinder.radius);
    return {{cylinder.center - half, cylinder.center + half}};
}

}  // namespace harness::report::picture
