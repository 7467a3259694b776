#include <algorithm>
#include <cmath>

#include "harness/source/scene/cylinder_parts.h"
#include "harness/stress/recipe.h"
#include "harness/variants/random/cylinder_meeting.h"

namespace harness::stress {
namespace {
using variants::cylinder_meeting;
using variants::CylinderMeeting;

namespace cylinder {

CylinderMeeting meeting_of(const Answers& answers, const Scene& scene) {
    return cylinder_meeting(answers.camera, scene.cylinders.front());
}

/// A unit vector perpendicular to the ray and to the axis; the x axis for a ray along the axis.
Point beside(const Point& V) {
    const double level = std::hypot(V.x, V.z);
    return level > 0 ? Point(V.z / level, 0, -V.x / level) : Point(1, 0, 0);
}

/// A cylinder of some ten thousand in size, as whole numbers then come close to a tube or a rim if enough are drawn.
/// `met` is where the ray meets the tube if it passes `offset` radii beside the axis; `height` is 1 at the top cap.
Scene with_large_cylinder(const Stage& stage, const Point& met, double offset, double height, Draw& draw) {
    const Point& V = stage.ray.V;
    Scene scene = stage.scene;
    reference::Cylinder<double>& cylinder = scene.cylinders.front();
    cylinder.radius = draw.whole(4000, 60'000);
    cylinder.height = 2 * draw.whole(4000, 60'000);
    const double level = std::max(std::hypot(V.x, V.z), 1e-3);
    const double within = std::sqrt(std::max(0.0, 1 - offset * offset));
    const Point towards_axis(V.x / level, 0, V.z / level);
    // A ray along an axis of the world comes near only by whole numbers, and not at all without these.
    const double nearer = draw.between(-2, 2), higher = draw.between(-2, 2);
    cylinder.center =
        rounded(met + cylinder.radius * within * towards_axis + (cylinder.radius * offset + nearer) * beside(V) -
                Point(0, height * cylinder.height / 2 + higher, 0));
    return scene;
}

Scene draw_at_tube(const Stage& stage, Draw& draw) {
    const Point met = stage.ray.P_WCS + draw.between(9'000, 20'000) * stage.ray.V;
    return with_large_cylinder(stage, met, 1, draw.between(-0.5, 0.5), draw);
}

bool is_between_caps(const CylinderMeeting& meeting) {
    constexpr double well = 0.8;
    return std::abs(meeting.height_at_enters) < well;
}

double grazed(const Answers& answers, const Scene& scene) {
    const CylinderMeeting meeting = meeting_of(answers, scene);
    return meeting.share > 0 && meeting.enters > 1 && is_between_caps(meeting) ? 1 / meeting.share : not_wanted;
}

double just_missed(const Answers& answers, const Scene& scene) {
    const CylinderMeeting meeting = meeting_of(answers, scene);
    const bool ahead = answers.cylinder->equations.tube.b < 0;
    return meeting.share < 0 && ahead ? -1 / meeting.share : not_wanted;
}

Scene draw_at_rim(const Stage& stage, Draw& draw) {
    const Point met = stage.ray.P_WCS + draw.between(9'000, 20'000) * stage.ray.V;
    const double side = stage.ray.V.y > 0 ? -1 : 1;  // the cap that faces the ray
    return with_large_cylinder(stage, met, draw.between(-0.6, 0.6), side, draw);
}

double just_within_rim(const Answers& answers, const Scene& scene) {
    const CylinderMeeting meeting = meeting_of(answers, scene);
    const double inside = 1 - std::abs(meeting.height_at_enters);
    return meeting.share > 0.2 && meeting.enters > 1 && inside > 0 ? 1 / inside : not_wanted;
}

double just_beyond_rim(const Answers& answers, const Scene& scene) {
    const CylinderMeeting meeting = meeting_of(answers, scene);
    const double beyond = std::abs(meeting.height_at_enters) - 1;
    return meeting.share > 0.2 && meeting.enters > 1 && beyond > 0 ? 1 / beyond : not_wanted;
}

double always(const Answers& /*answers*/, const Scene& /*scene*/) {
    return 1;
}

/// Along the axis that the ray runs along most, so that a cylinder can be put before the ray exactly.
Point level_step(const Point& V) {
    if (std::abs(V.x) >= std::abs(V.z)) return {V.x < 0 ? -1 : 1, 0, 0};
    return {0, 0, V.z < 0 ? -1 : 1};
}

/// A point of the ray is exactly on the rim of the cap that faces it.
Scene draw_through_rim(const Stage& stage, Draw& /*draw*/) {
    constexpr double radius = 5, half = 4;
    const double side = stage.ray.V.y > 0 ? -1 : 1;
    Scene scene = stage.scene;
    put_sphere_away(scene, stage);
    const Point center = stage.on_ray(4) + radius * level_step(stage.ray.V) - Point(0, side * half, 0);
    scene.cylinders.front() = {center, radius, 2 * half};
    return scene;
}

Scene draw_at_start(const Stage& stage, Draw& /*draw*/) {
    constexpr double radius = 5, height = 8;
    Scene scene = stage.scene;
    scene.cylinders.front() = {stage.ray.P_WCS + radius * level_step(stage.ray.V), radius, height};
    return scene;
}

double enters_at_start(const Answers& answers, const Scene& /*scene*/) {
    return answers.cylinder->equations.tube.b < -1 ? 1 : not_wanted;
}

Scene draw_near_tube(const Stage& stage, Draw& draw) {
    return with_large_cylinder(stage, stage.ray.P_WCS + draw.between(0, 2) * stage.ray.V, draw.between(-0.4, 0.4),
                               draw.between(-0.5, 0.5), draw);
}

double starts_near(const Answers& answers, const Scene& scene) {
    const CylinderMeeting meeting = meeting_of(answers, scene);
    constexpr double least = 0.02;
    const bool met = meeting.share > 0.2 && meeting.enters > least && is_between_caps(meeting);
    return met ? 1 / meeting.enters : not_wanted;
}

Scene draw_far(const Stage& stage, Draw& draw) {
    constexpr double far = 100'000;
    Scene scene = stage.scene;
    scene.cylinders.front() = {rounded(stage.ray.P_WCS + far * stage.ray.V + 0.2 * across(stage, draw)), 2, 4};
    return scene;
}

double surely_hit(const Answers& answers, const Scene& scene) {
    const CylinderMeeting meeting = meeting_of(answers, scene);
    constexpr double well = 0.3;
    const bool tube = meeting.share > well && is_between_caps(meeting);
    return answers.cylinder->t && (tube || meeting.cap_share > well) ? 1 : not_wanted;
}

/// A number that is small in one half of the draws, and may be large in the other: a pixel off the image's center needs
/// the camera turned.
double small_or_any(double most, Draw& draw) {
    return std::round(draw.whole(0, 1) == 0 ? draw.between(-3, 3) : draw.between(-most, most));
}

/// The ray falls upon a wide cap at an angle of some ten-thousandths.
Scene draw_along_caps(const Stage& stage, Draw& draw) {
    Scene scene = stage.scene;
    scene.camera.eye = scene.camera.lookat + Point(2000, small_or_any(3000, draw), 3000);
    const auto ray = reference::answer_camera(scene, stage.convention);
    reference::Cylinder<double>& cylinder = scene.cylinders.front();
    cylinder.radius = 4000;
    cylinder.height = 8;
    const double side = ray.V.y < 0 ? 1 : -1;
    const double above = draw.between(0.2, 1.5);
    const Point met = ray.P_WCS + above / std::max(std::abs(ray.V.y), 1e-6) * ray.V;
    cylinder.center = rounded(Point(met.x, ray.P_WCS.y - side * (above + cylinder.height / 2), met.z));
    put_sphere_behind(scene, stage, ray);
    return scene;
}

double falls_on_cap(const Answers& answers, const Scene& scene) {
    const CylinderMeeting meeting = meeting_of(answers, scene);
    constexpr double small = 0.02, well = 0.2;
    const bool met = meeting.cap_t > 1 && meeting.cap_share > well;
    return met && meeting.steepness > 0 && meeting.steepness < small ? 1 / meeting.steepness : not_wanted;
}

/// The ray runs into a high, narrow tube at an angle of some ten-thousandths.
Scene draw_along_axis(const Stage& stage, Draw& draw) {
    Scene scene = stage.scene;
    constexpr double high = 5000;
    scene.camera.eye = scene.camera.lookat + Point(small_or_any(high, draw), high, small_or_any(high, draw));
    scene.camera.vup = {1, 0, 0};
    const auto ray = reference::answer_camera(scene, stage.convention);
    reference::Cylinder<double>& cylinder = scene.cylinders.front();
    cylinder.radius = draw.whole(2, 9);
    cylinder.height = 20'000;
    const double level = std::max(std::hypot(ray.V.x, ray.V.z), 1e-6);
    const double gap = draw.between(1, 3);
    const Point met = ray.P_WCS + gap / level * ray.V;
    const Point towards_axis(ray.V.x / level, 0, ray.V.z / level);
    cylinder.center = rounded(met + cylinder.radius * towards_axis);
    put_sphere_behind(scene, stage, ray);
    return scene;
}

double runs_into_tube(const Answers& answers, const Scene& scene) {
    const CylinderMeeting meeting = meeting_of(answers, scene);
    constexpr double small = 0.02;
    const double a = answers.cylinder->equations.tube.a;
    const bool met = meeting.share > 0.2 && meeting.enters > 1 && is_between_caps(meeting);
    return met && a > 0 && a < small ? 1 / a : not_wanted;
}

}  // namespace cylinder
}  // namespace

void put_in_view(reference::Cylinder<double>& cylinder, const PartSet& located, const View& view) {
    if (located.contains(source::part::cylinder::center)) cylinder.center = rounded(view.middle + 20.0 * view.ray.V);
    if (located.contains(source::part::cylinder::radius)) cylinder.radius = 4;
    if (located.contains(source::part::cylinder::height)) cylinder.height = 10;
}

template <>
std::vector<HardRecipe> recipes<reference::Subject::cylinder>() {
    const std::vector<ScenePart> parts = {source::part::cylinder::center, source::part::cylinder::radius,
                                          source::part::cylinder::height};
    std::vector<ScenePart> with_eye = parts;
    with_eye.push_back(source::part::eye);
    std::vector<ScenePart> with_vup = with_eye;
    with_vup.push_back(source::part::vup);
    return {
        {"cylinder, grazed", "b² and 4ac are nearly the same, and their difference decides", parts, 3000, false,
         cylinder::draw_at_tube, cylinder::grazed},
        {"cylinder, just missed", "the discriminant is below 0 by little", parts, 3000, false, cylinder::draw_at_tube,
         cylinder::just_missed},
        {"cylinder, just within the rim", "the hit on the tube is within the height by little", parts, 3000, false,
         cylinder::draw_at_rim, cylinder::just_within_rim},
        {"cylinder, just beyond the rim", "the root on the tube is beyond a cap by little", parts, 3000, false,
         cylinder::draw_at_rim, cylinder::just_beyond_rim},
        {"cylinder, through the rim", "the hit is on the tube and in the plane of a cap exactly", parts, 1, true,
         cylinder::draw_through_rim, cylinder::always},
        {"cylinder's cap, nearly parallel to the ray", "V.y is nearly 0, and yet the ray meets the cap", with_eye, 3000,
         false, cylinder::draw_along_caps, cylinder::falls_on_cap},
        {"cylinder's axis, nearly parallel to the ray", "a, b and c are small, and t is their quotient", with_vup, 3000,
         false, cylinder::draw_along_axis, cylinder::runs_into_tube},
        {"ray starts close to the cylinder", "c is the small difference of large squares", parts, 300, false,
         cylinder::draw_near_tube, cylinder::starts_near},
        {"ray starts on the cylinder", "t is 0 exactly", parts, 1, true, cylinder::draw_at_start,
         cylinder::enters_at_start},
        {"small cylinder, far away", "b² is a thousand million times d", parts, 50, false, cylinder::draw_far,
         cylinder::surely_hit},
    };
}

}  // namespace harness::stress
