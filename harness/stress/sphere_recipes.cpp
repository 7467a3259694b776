#include <cmath>

#include "harness/source/scene/sphere_parts.h"
#include "harness/stress/recipe.h"

namespace harness::stress {
namespace {

/// How far inside the sphere the ray passes: 1 at its center, 0 at its rim, below 0 outside. V has length 1, so that d
/// = 4 (R^2 - distance^2).
double share(const Answers& answers, const Scene& scene) {
    const double radius = scene.spheres.front().radius;
    return answers.sphere->quadratic.d / (4 * radius * radius);
}

bool is_ahead(const Answers& answers) {
    return answers.sphere->quadratic.b < 0 && answers.sphere->quadratic.c > 0;
}

/// With whole numbers of some thousands, some draws come within a millionth of the rim if enough are made.
Scene draw_at_rim(const Stage& stage, Draw& draw) {
    Scene scene = stage.scene;
    reference::Sphere<double>& sphere = scene.spheres.front();
    sphere.radius = draw.whole(4000, 9000);
    sphere.center = rounded(stage.ray.P_WCS + 3 * sphere.radius * stage.ray.V + sphere.radius * across(stage, draw));
    return scene;
}

double grazed(const Answers& answers, const Scene& scene) {
    const double within = share(answers, scene);
    return within > 0 && is_ahead(answers) ? 1 / within : not_wanted;
}

double just_missed(const Answers& answers, const Scene& scene) {
    const double within = share(answers, scene);
    return within < 0 && is_ahead(answers) ? -1 / within : not_wanted;
}

Scene draw_far(const Stage& stage, Draw& draw) {
    constexpr double far = 100'000;
    Scene scene = stage.scene;
    scene.spheres.front() = {rounded(stage.ray.P_WCS + far * stage.ray.V + 0.2 * across(stage, draw)), 1};
    return scene;
}

double surely_hit(const Answers& answers, const Scene& scene) {
    const double within = share(answers, scene);
    return within > 0.2 && is_ahead(answers) ? within : not_wanted;
}

Scene draw_ground(const Stage& stage, Draw& draw) {
    constexpr double radius = 1'000'000, height = 5;
    const double tilt = draw.between(0.2, 0.5);
    const Point down = std::cos(tilt) * stage.ray.V + std::sin(tilt) * across(stage, draw);
    Scene scene = stage.scene;
    scene.spheres.front() = {rounded(stage.ray.P_WCS + (radius + height) * down), radius};
    return scene;
}

Scene draw_around(const Stage& stage, Draw& draw) {
    Scene scene = stage.scene;
    scene.spheres.front() = {rounded(stage.ray.P_WCS - 3.0 * stage.ray.V + 3.0 * across(stage, draw)), 7};
    return scene;
}

double is_inside(const Answers& answers, const Scene& /*scene*/) {
    return answers.sphere->quadratic.c < -5 ? 1 : not_wanted;
}

Scene draw_behind(const Stage& stage, Draw& draw) {
    Scene scene = stage.scene;
    scene.spheres.front() = {rounded(stage.ray.P_WCS - 9.0 * stage.ray.V + across(stage, draw)), 4};
    return scene;
}

double is_behind(const Answers& answers, const Scene& scene) {
    return share(answers, scene) > 0.2 && answers.sphere->quadratic.b > 0 && answers.sphere->quadratic.c > 0
               ? 1
               : not_wanted;
}

}  // namespace

void put_sphere_away(Scene& scene, const Stage& stage) {
    put_sphere_behind(scene, stage, stage.ray);
}

void put_sphere_behind(Scene& scene, const Stage& stage, const reference::CameraAnswers<double>& ray) {
    if (scene.spheres.empty() || !stage.located.contains(source::part::sphere::center)) return;
    reference::Sphere<double>& sphere = scene.spheres.front();
    sphere.center = rounded(ray.P_WCS - (2 * sphere.radius + 5) * ray.V);
}

void put_in_view(reference::Sphere<double>& sphere, const PartSet& located, const View& view) {
    if (located.contains(source::part::sphere::center)) sphere.center = rounded(view.middle + Point(1, 0, 0));
    if (located.contains(source::part::sphere::radius)) sphere.radius = 5;
}

template <>
std::vector<HardRecipe> recipes<reference::Subject::sphere>() {
    const std::vector<ScenePart> sphere = {source::part::sphere::center, source::part::sphere::radius};
    return {
        {"sphere, grazed", "b² and 4ac are nearly the same, and their difference decides", sphere, 3000, false,
         draw_at_rim, grazed},
        {"sphere, just missed", "the discriminant is below 0 by little", sphere, 3000, false, draw_at_rim, just_missed},
        {"small sphere, far away", "b² is ten thousand million times d", sphere, 50, false, draw_far, surely_hit},
        {"huge sphere, near its surface", "c is the small difference of huge squares", sphere, 50, false, draw_ground,
         surely_hit},
        {"ray starts inside the sphere", "the smaller root lies behind the start", sphere, 50, false, draw_around,
         is_inside},
        {"sphere behind the ray", "both roots lie behind the start", sphere, 50, false, draw_behind, is_behind},
    };
}

}  // namespace harness::stress
