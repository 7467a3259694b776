// What is drawn of a cylinder.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/report/picture/object_sketch.h"
#include "reference/stages/cylinder.h"

namespace harness::report::picture {

using reference::AnswerKey;
using reference::Subject;
namespace item = reference::item;

namespace {

/// "top cap", "bottom cap" or "tube", by the normal; empty if it is not known.
std::string_view part_of_cylinder(const std::optional<Point>& normal) {
    if (!normal) return "";
    if (normal->y == 0) return "tube";
    return normal->y > 0 ? "top cap" : "bottom cap";
}

}  // namespace

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
