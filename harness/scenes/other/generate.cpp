#include "harness/scenes/other/generate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "harness/scenes/other/kind.h"
#include "harness/scenes/source/drawing.h"
#include "reference/stages/item_values.h"
#include "reference/toml/scene_toml.h"

namespace harness::scenes {
namespace {

using reference::Assignment;
using reference::Decimal;
using reference::OtherScene;
using reference::Scene;
using reference::Vec3;

bool is_zero(const Vec3<double>& p) {
    return p.x == 0 && p.y == 0 && p.z == 0;
}

/// The role, as far as the ray can play it: a camera that can be turned plays them all.
CylinderRole role_of(Kind kind, const PartSet& located, const Vec3<double>& V) {
    const bool turns = located.contains(ScenePart::eye) || located.contains(ScenePart::lookat);
    return turns ? cylinder_plan(kind).role : possible_role(cylinder_plan(kind).role, V);
}

/// Draws scenes of one kind. Lengths grow with the distance of the kind's objects.
class Painter {
  public:
    Painter(const Assignment& assignment, const PartSet& located, Kind kind)
        : base_(in_double(assignment.scene)),
          convention_(assignment.rubric.pixel_conventions.front()),
          located_(located),
          kind_(kind),
          size_(kind == Kind::grazing ? 8 : 1) {}

    Scene<double> paint(Draw& draw) const {
        Scene<double> scene = base_;
        paint_camera(scene, draw);
        const auto ray = reference::answer_camera(scene, convention_);
        const Vec3<double> side = across(ray.V, draw);
        const double distance = size_ * draw.between(4, 8);
        if (located_.contains(ScenePart::radius))
            scene.spheres.front().radius = size_ * draw.whole(2, 4) + draw.whole(0, 1);
        if (located_.contains(ScenePart::center)) {
            reference::Sphere<double>& sphere = scene.spheres.front();
            sphere.center = rounded(ray.P_WCS + distance * ray.V + sphere.radius * draw_offset(draw) * side);
        }
        if (located_.contains(ScenePart::A)) paint_triangle(scene, ray, draw);
        if (!scene.cylinders.empty()) paint_cylinder(scene.cylinders.front(), ray, draw);
        return scene;
    }

  private:
    void paint_camera(Scene<double>& scene, Draw& draw) const {
        reference::Camera<double>& camera = scene.camera;
        if (located_.contains(ScenePart::lookat)) camera.lookat = draw.vector(2);
        if (located_.contains(ScenePart::vup)) camera.vup = draw.vector(2);
        if (located_.contains(ScenePart::eye)) camera.eye = camera.lookat + rounded(size_ * draw.vector(6));
        const bool moves_pixel = kind_ == Kind::triangle_first || kind_ == Kind::grazing;
        if (moves_pixel && located_.contains(ScenePart::pixel)) {
            const auto within = [&](int count) {
                return std::clamp(draw.whole(count / 4, count - count / 4), 0, count - 1);
            };
            scene.pixel = {within(scene.window.width), within(scene.window.height)};
        }
    }

    /// The distance of the sphere's center from the ray, in radii.
    double draw_offset(Draw& draw) const {
        switch (kind_) {
            case Kind::off_axis:
            case Kind::triangle_first: return draw.between(0, 0.7);
            case Kind::sphere_missed: return draw.between(1.5, 2.5);
            case Kind::grazing: return draw.between(0.95, 1);
        }
        return 0;
    }

    /// Draws the triangle around the ray, so that the ray mostly hits it.
    void paint_triangle(Scene<double>& scene, const reference::CameraAnswers<double>& ray, Draw& draw) const {
        const Vec3<double> p = across(ray.V, draw);
        const Vec3<double> q = reference::cross(ray.V, p);
        const double distance = draw.between(1, kind_ == Kind::triangle_first ? 3 : 6) * size_;
        const auto vertex = [&](double angle) {
            const double spread = size_ * draw.between(3, 6);
            const double tilt = size_ * draw.between(-1, 1);
            return rounded(ray.P_WCS + (distance + tilt) * ray.V + spread * std::cos(angle) * p +
                           spread * std::sin(angle) * q);
        };
        constexpr double third = 2.0943951;  // of a turn
        reference::Triangle<double>& triangle = scene.triangles.front();
        triangle.A = vertex(0);
        triangle.B = vertex(third);
        triangle.C = vertex(2 * third);
    }

    void paint_cylinder(reference::Cylinder<double>& cylinder, const reference::CameraAnswers<double>& ray,
                        Draw& draw) const {
        const CylinderPlan plan = cylinder_plan(kind_);
        const CylinderParts parts{located_.contains(ScenePart::cylinder_center),
                                  located_.contains(ScenePart::cylinder_radius),
                                  located_.contains(ScenePart::cylinder_height)};
        cylinder = draw_cylinder(cylinder, parts, ray, role_of(kind_, located_, ray.V), size_, size_ * plan.least,
                                 size_ * plan.most, draw);
    }

    Scene<double> base_;
    reference::PixelConvention convention_;
    PartSet located_;
    Kind kind_;
    double size_;
};

using Answers = reference::SceneAnswers<double>;

Answers answer(const Scene<double>& scene, const Assignment& assignment) {
    return reference::answer_scene(scene, assignment.rubric.pixel_conventions.front(),
                                   reference::Boundary::nonnegative);
}

/// Whether the camera is far from any undefined case.
bool is_sound(const Scene<double>& scene) {
    const Vec3<double> view = scene.camera.eye - scene.camera.lookat;
    if (reference::dot(view, view) < 4 || is_zero(scene.camera.vup)) return false;
    return reference::length(reference::cross(reference::normalized(scene.camera.vup), reference::normalized(view))) >
           0.3;
}

bool sphere_is_as_wanted(const Answers& answers, double radius, Kind kind) {
    // V has length 1, so that d = 4 (R^2 - distance^2): the share of R^2 says how near the rim the ray is.
    const double share = answers.sphere->quadratic.d / (4 * radius * radius);
    const bool before = answers.sphere->t && *answers.sphere->t > 0.3;
    switch (kind) {
        case Kind::off_axis:
        case Kind::triangle_first: return share > 0.2 && before;
        case Kind::sphere_missed: return share < -0.2;
        case Kind::grazing: return share > 0.005 && share < 0.12 && before;
    }
    return false;
}

bool triangle_is_hit(const Answers& answers) {
    constexpr double margin = 0.05;
    const reference::TriangleAnswers<double>& triangle = *answers.triangle;
    return triangle.t && *triangle.t > 0.2 && *triangle.u > margin && *triangle.v > margin &&
           1 - *triangle.u - *triangle.v > margin;
}

/// Whether the located cylinder plays its kind's role, and the objects are hit in the kind's order with no two at
/// nearly the same t.
bool cylinder_is_as_wanted(const Answers& answers, const Scene<double>& scene, const PartSet& located, Kind kind) {
    if (!plays(role_of(kind, located, answers.camera.V), cylinder_meeting(answers.camera, scene.cylinders.front())))
        return false;
    constexpr double never = std::numeric_limits<double>::infinity();
    const bool has_sphere = located.contains(ScenePart::center) && answers.sphere->t;
    const double sphere = has_sphere ? *answers.sphere->t : never;
    const double triangle = located.contains(ScenePart::A) ? *answers.triangle->t : never;
    const double cylinder = answers.cylinder->t.value_or(never);
    constexpr double apart = 0.3;
    const auto is_before = [](double one, double other) { return one == never || other - one > apart; };
    const auto are_apart = [](double one, double other) { return one == never || !(std::abs(one - other) <= apart); };
    if (!are_apart(cylinder, sphere) || !are_apart(cylinder, triangle)) return false;
    switch (kind) {
        case Kind::off_axis: return is_before(sphere, cylinder) && is_before(sphere, triangle);
        case Kind::triangle_first: return is_before(triangle, cylinder);
        case Kind::sphere_missed: return is_before(cylinder, triangle);
        case Kind::grazing: return true;
    }
    return false;
}

/// Whether the scene has its kind's property, as far as the located parts allow it.
bool has_property(const Answers& answers, const Scene<double>& scene, const PartSet& located, Kind kind) {
    const bool sphere = located.contains(ScenePart::center);
    const bool triangle = located.contains(ScenePart::A);
    if (sphere && !sphere_is_as_wanted(answers, scene.spheres.front().radius, kind)) return false;
    if (triangle && !triangle_is_hit(answers)) return false;
    const bool cylinder = located.contains(ScenePart::cylinder_center);
    if (cylinder && !cylinder_is_as_wanted(answers, scene, located, kind)) return false;
    if (!sphere || !triangle || !answers.sphere->t) return true;
    const double lead = *answers.sphere->t - *answers.triangle->t;
    return kind == Kind::triangle_first ? lead > 0.3 : std::abs(lead) > 0.3;
}

/// Whether two values differ by more than rounding and short decimals explain.
bool differ(const reference::ItemValue<double>& one, const reference::ItemValue<double>& other) {
    const auto* a = std::get_if<std::vector<double>>(&one);
    const auto* b = std::get_if<std::vector<double>>(&other);
    if (a == nullptr || b == nullptr) return one.index() != other.index();
    constexpr double apart = 0.05;
    for (std::size_t i = 0; i < a->size(); ++i) {
        if (std::abs(a->at(i) - b->at(i)) > apart) return true;
    }
    return false;
}

int differences(const Answers& answers, const reference::ItemValues<double>& base) {
    int count = 0;
    for (const auto& [id, value] : reference::values_of(answers, reference::Boundary::nonnegative)) {
        const auto found = base.find(id);
        if (found != base.end() && differ(value, found->second)) ++count;
    }
    return count;
}

/// Empty if no scene of the kind could be drawn.
std::optional<Scene<double>> draw_scene(const Assignment& assignment, const PartSet& located, Kind kind, Draw draw) {
    const Painter painter(assignment, located, kind);
    const auto base =
        reference::values_of(answer(in_double(assignment.scene), assignment), reference::Boundary::nonnegative);
    constexpr int attempts = 400;
    constexpr int property = 1000;  // weighs more than all differences
    // Three items need not differ: a is always 1, because V has length 1; P_VCS only depends on the pixel; and the
    // verdict has few values.
    const int enough = property + static_cast<int>(base.size()) - 3;
    std::optional<Scene<double>> best;
    int most = -1;
    for (int i = 0; i < attempts && most < enough; ++i) {
        Scene<double> scene = painter.paint(draw);
        if (!is_sound(scene)) continue;
        const Answers answers = answer(scene, assignment);
        const bool wanted = has_property(answers, scene, located, kind);
        if (!wanted && most >= property) continue;
        const int worth = differences(answers, base) + (wanted ? property : 0);
        if (worth <= most) continue;
        most = worth;
        best = std::move(scene);
    }
    return most > 0 ? best : std::nullopt;
}

PartSet had_by(const DecimalScene& scene, const PartSet& parts) {
    PartSet had;
    for (const ScenePart part : all_parts) {
        if (parts.contains(part) && has_part(scene, part)) had.insert(part);
    }
    return had;
}

/// The assignment's scene with the located parts taken from `variant`.
DecimalScene restricted(const DecimalScene& scene, const DecimalScene& variant, const PartSet& located) {
    DecimalScene result = scene;
    for (const ScenePart part : all_parts) {
        if (located.contains(part)) copy_part(result, variant, part);
    }
    return result;
}

bool is_another_scene(const DecimalScene& scene, const Assignment& assignment) {
    if (reference::scene_toml(scene) == reference::scene_toml(assignment.scene)) return false;
    try {
        reference::check_scene(scene, "a variant");
        return true;
    } catch (const reference::AssignmentError&) {
        return false;  // e.g. the eye was moved onto a lookat that was not located
    }
}

}  // namespace

std::vector<OtherScene> other_scenes_for(const Assignment& assignment, const PartSet& found, int count,
                                         std::uint64_t seed) {
    const PartSet located = had_by(assignment.scene, found);
    std::vector<OtherScene> variants;
    if (located.empty()) return variants;
    const auto wanted = static_cast<std::size_t>(count);
    for (const OtherScene& variant : assignment.variants) {
        DecimalScene scene = restricted(assignment.scene, variant.scene, located);
        if (variants.size() < wanted && is_another_scene(scene, assignment))
            variants.push_back({variant.name, std::move(scene)});
    }
    for (std::uint64_t drawn = 0; variants.size() < wanted && drawn < 2 * wanted; ++drawn) {
        const Kind kind = all_kinds.at(drawn % all_kinds.size());
        const auto scene = draw_scene(assignment, located, kind, Draw(seed * 1000003 + drawn));
        if (!scene) continue;
        DecimalScene exact = in_decimal(*scene);
        const std::string again = drawn < all_kinds.size() ? "" : fmt::format(" ({})", drawn / all_kinds.size() + 1);
        if (is_another_scene(exact, assignment))
            variants.push_back({std::string(name_of(kind, assignment.scene)) + again, std::move(exact)});
    }
    return variants;
}

}  // namespace harness::scenes
