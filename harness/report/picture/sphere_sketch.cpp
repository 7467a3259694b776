// What is drawn of a sphere.
#include <cmath>

#include "harness/report/picture/object_sketch.h"
#include "reference/stages/sphere.h"

namespace harness::report::picture {

using reference::AnswerKey;
using reference::Subject;
namespace item = reference::item;

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

}  // namespace harness::report::picture
