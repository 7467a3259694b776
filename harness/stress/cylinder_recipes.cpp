#include <algorithm>
#include <cmath>

#include "harness/stress/recipe.h"
#include "harness/variants/random/cylinder_meeting.h"

namespace harness::stress {
namespace {
using variants::CylinderMeeting;

CylinderMeeting meeting_of(const Answers& answers, const Scene& scene) {
    return variants::cylinder_meeting(answers.camera, scene.cylinders.front());
}

/// A unit vector perpendicular to the ray and to the axis; the x axis if the ray is along the axis.
Point beside(const Point& V) {
    const double level = std::hypot(V.x, V.z);
    return level > 0 ? Point(V.z / level, 0, -V.x / level) : Point(1, 0, 0);
}

/// A cylinder of a size around ten thousand: with many draws, whole numbers then come close to a tube or a rim. `met`
/// is the point where the ray meets the tube if it passes `offset` radii beside the axis; `height` is 1 at the top cap.
void put_large_cylinder(Stage& stage, const Point& met, double offset, double height, Draw& draw) {
    const Point& V = stage.ray.V;
    reference::Cylinder<double>& cylinder = stage.scene.cylinders.front();
    cylinder.radius = draw.whole(4000, 60'000);
    cylinder.height = 2 * draw.whole(4000, 60'000);
    const double level = std::max(std::hypot(V.x, V.z), 1e-3);
    const double within = std::sqrt(std::max(0.0, 1 - offset * offset));
    const Point towards_axis(V.x / level, 0, V.z / level);
    // A ray along an axis of the world is off by whole numbers, so it would never come close without these offsets.
    const double nearer = draw.between(-2, 2), higher = draw.between(-2, 2);
    cylinder.center =
        rounded(met + cylinder.radius * within * towards_axis + (cylinder.radius * offset + nearer) * beside(V) -
                Point(0, height * cylinder.height / 2 + higher, 0));
}

void draw_at_tube(Stage& stage, Draw& draw) {
    const Point met = stage.ahead(draw.between(9'000, 20'000));
    put_large_cylinder(stage, met, 1, draw.between(-0.5, 0.5), draw);
}

/// 1 if the cap that faces the ray is the top one, -1 if it is the bottom one.
double facing_cap(const Stage& stage) {
    return stage.ray.V.y > 0 ? -1 : 1;
}

void draw_at_cap_rim(Stage& stage, Draw& draw) {
    const Point met = stage.ahead(draw.between(9'000, 20'000));
    put_large_cylinder(stage, met, draw.between(-0.6, 0.6), facing_cap(stage), draw);
}

bool is_between_caps(const CylinderMeeting& meeting) {
    constexpr double well = 0.8;
    return std::abs(meeting.height_at_enters) < well;
}

bool is_well_ahead(const CylinderMeeting& meeting) {
    return meeting.share > 0.2 && meeting.enters > 1;
}

/// A step along the axis that is nearest to the ray, so that a cylinder can be put exactly before the ray.
Point level_step(const Point& V) {
    if (std::abs(V.x) >= std::abs(V.z)) return {V.x < 0 ? -1 : 1, 0, 0};
    return {0, 0, V.z < 0 ? -1 : 1};
}

/// A number that is small in half of the draws, and may be large in the others: for a pixel off the image's center, the
/// camera must be turned.
double small_or_any(double most, Draw& draw) {
    return std::round(draw.whole(0, 1) == 0 ? draw.between(-3, 3) : draw.between(-most, most));
}

/// The ray hits a wide cap at an angle of some ten-thousandths.
void draw_along_caps(Stage& stage, Draw& draw) {
    constexpr double height = 8;
    stage.scene.camera.eye = stage.scene.camera.lookat + Point(2000, small_or_any(3000, draw), 3000);
    stage.follow_camera();
    const double side = stage.ray.V.y < 0 ? 1 : -1;
    const double above = draw.between(0.2, 1.5);
    const Point met = stage.ahead(above / std::max(std::abs(stage.ray.V.y), 1e-6));
    const Point center = rounded(Point(met.x, stage.ray.P_WCS.y - side * (above + height / 2), met.z));
    stage.scene.cylinders.front() = {center, 4000, height};
    put_sphere_behind(stage);
}

/// The ray enters a high, narrow tube at an angle of some ten-thousandths.
void draw_along_axis(Stage& stage, Draw& draw) {
    constexpr double high = 5000;
    reference::Camera<double>& camera = stage.scene.camera;
    const double z = small_or_any(high, draw), x = small_or_any(high, draw);
    camera.eye = camera.lookat + Point(x, high, z);
    camera.vup = {1, 0, 0};
    stage.follow_camera();
    const Point& V = stage.ray.V;
    const double radius = draw.whole(2, 9);
    const double level = std::max(std::hypot(V.x, V.z), 1e-6);
    const Point met = stage.ahead(draw.between(1, 3) / level);
    const Point towards_axis(V.x / level, 0, V.z / level);
    stage.scene.cylinders.front() = {rounded(met + radius * towards_axis), radius, 20'000};
    put_sphere_behind(stage);
}

}  // namespace

void put_in_view(reference::Cylinder<double>& cylinder, const Stage& stage) {
    if (stage.located->contains(source::part::cylinder::center))
        cylinder.center = rounded(stage.ahead(30) + 20.0 * stage.ray.V);
    if (stage.located->contains(source::part::cylinder::radius)) cylinder.radius = 4;
    if (stage.located->contains(source::part::cylinder::height)) cylinder.height = 10;
}

template <>
std::vector<HardRecipe> recipes<reference::Subject::cylinder>() {
    const std::vector<ScenePart> eye{source::part::eye}, eye_and_vup{source::part::eye, source::part::vup};
    return {
        {"cylinder, grazed", "b² and 4ac are nearly the same, and their difference decides", 3000, false, draw_at_tube,
         [](const Answers& answers, const Scene& scene) {
             const CylinderMeeting meeting = meeting_of(answers, scene);
             return nearness(meeting.share, meeting.enters > 1 && is_between_caps(meeting));
         }},
        {"cylinder, just missed", "the discriminant is slightly below 0", 3000, false, draw_at_tube,
         [](const Answers& answers, const Scene& scene) {
             return nearness(-meeting_of(answers, scene).share, answers.cylinder->equations.tube.b < 0);
         }},
        {"cylinder, just within the rim", "the hit on the tube is only just within the height", 3000, false,
         draw_at_cap_rim,
         [](const Answers& answers, const Scene& scene) {
             const CylinderMeeting meeting = meeting_of(answers, scene);
             return nearness(1 - std::abs(meeting.height_at_enters), is_well_ahead(meeting));
         }},
        {"cylinder, just beyond the rim", "the root on the tube is only just beyond a cap", 3000, false,
         draw_at_cap_rim,
         [](const Answers& answers, const Scene& scene) {
             const CylinderMeeting meeting = meeting_of(answers, scene);
             return nearness(std::abs(meeting.height_at_enters) - 1, is_well_ahead(meeting));
         }},
        {"cylinder, through the rim", "the hit is exactly on the tube and in the plane of a cap", 1, true,
         [](Stage& stage, Draw& /*draw*/) {
             constexpr double radius = 5, half = 4;
             put_sphere_behind(stage);
             const Point on_axis = stage.on_ray(4) + radius * level_step(stage.ray.V);
             stage.scene.cylinders.front() = {on_axis - Point(0, facing_cap(stage) * half, 0), radius, 2 * half};
         }},
        {"cylinder's cap, nearly parallel to the ray", "V.y is nearly 0, but the ray meets the cap", 3000, false,
         draw_along_caps,
         [](const Answers& answers, const Scene& scene) {
             const CylinderMeeting meeting = meeting_of(answers, scene);
             const bool met = meeting.cap_t > 1 && meeting.cap_share > 0.2;
             return nearness(meeting.steepness, met && meeting.steepness < 0.02);
         },
         eye},
        {"cylinder's axis, nearly parallel to the ray", "a, b and c are small, and t is their quotient", 3000, false,
         draw_along_axis,
         [](const Answers& answers, const Scene& scene) {
             const CylinderMeeting meeting = meeting_of(answers, scene);
             const double a = answers.cylinder->equations.tube.a;
             return nearness(a, is_well_ahead(meeting) && is_between_caps(meeting) && a < 0.02);
         },
         eye_and_vup},
        {"ray starts close to the cylinder", "c is the small difference of large squares", 300, false,
         [](Stage& stage, Draw& draw) {
             const double height = draw.between(-0.5, 0.5), offset = draw.between(-0.4, 0.4);
             put_large_cylinder(stage, stage.ahead(draw.between(0, 2)), offset, height, draw);
         },
         [](const Answers& answers, const Scene& scene) {
             const CylinderMeeting meeting = meeting_of(answers, scene);
             const bool met = meeting.share > 0.2 && meeting.enters > 0.02 && is_between_caps(meeting);
             return nearness(meeting.enters, met);
         }},
        {"ray starts on the cylinder", "t is exactly 0", 1, true,
         [](Stage& stage, Draw& /*draw*/) {
             constexpr double radius = 5, height = 8;
             stage.scene.cylinders.front() = {stage.ray.P_WCS + radius * level_step(stage.ray.V), radius, height};
         },
         [](const Answers& answers, const Scene& /*scene*/) {
             return answers.cylinder->equations.tube.b < -1 ? 1 : not_wanted;
         }},
        {"small cylinder, far away", "b² is a billion times d", 50, false,
         [](Stage& stage, Draw& draw) {
             stage.scene.cylinders.front() = {rounded(stage.ahead(100'000) + 0.2 * stage.across(draw)), 2, 4};
         },
         [](const Answers& answers, const Scene& scene) {
             const CylinderMeeting meeting = meeting_of(answers, scene);
             constexpr double well = 0.3;
             const bool tube = meeting.share > well && is_between_caps(meeting);
             return answers.cylinder->t && (tube || meeting.cap_share > well) ? 1 : not_wanted;
         }},
    };
}

}  // namespace harness::stress
