#include <cmath>

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
void draw_at_rim(Stage& stage, Draw& draw) {
    const double radius = draw.whole(4000, 9000);
    stage.scene.spheres.front() = {rounded(stage.ahead(3 * radius) + radius * stage.across(draw)), radius};
}

double surely_hit(const Answers& answers, const Scene& scene) {
    const double within = share(answers, scene);
    return within > 0.2 && is_ahead(answers) ? within : not_wanted;
}

}  // namespace

void put_sphere_behind(Stage& stage) {
    if (stage.scene.spheres.empty() || !stage.located->contains(source::part::sphere::center)) return;
    reference::Sphere<double>& sphere = stage.scene.spheres.front();
    sphere.center = rounded(stage.ahead(-(2 * sphere.radius + 5)));
}

void put_in_view(reference::Sphere<double>& sphere, const Stage& stage) {
    if (stage.located->contains(source::part::sphere::center))
        sphere.center = rounded(stage.ahead(30) + Point(1, 0, 0));
    if (stage.located->contains(source::part::sphere::radius)) sphere.radius = 5;
}

template <>
std::vector<HardRecipe> recipes<reference::Subject::sphere>() {
    return {
        {"sphere, grazed", "b² and 4ac are nearly the same, and their difference decides", 3000, false, draw_at_rim,
         [](const Answers& answers, const Scene& scene) { return nearness(share(answers, scene), is_ahead(answers)); }},
        {"sphere, just missed", "the discriminant is slightly below 0", 3000, false, draw_at_rim,
         [](const Answers& answers, const Scene& scene) {
             return nearness(-share(answers, scene), is_ahead(answers));
         }},
        {"small sphere, far away", "b² is ten billion times d", 50, false,
         [](Stage& stage, Draw& draw) {
             stage.scene.spheres.front() = {rounded(stage.ahead(100'000) + 0.2 * stage.across(draw)), 1};
         },
         surely_hit},
        {"huge sphere, near its surface", "c is the small difference of huge squares", 50, false,
         [](Stage& stage, Draw& draw) {
             constexpr double radius = 1'000'000, height = 5;
             const double tilt = draw.between(0.2, 0.5);
             const Point down = std::cos(tilt) * stage.ray.V + std::sin(tilt) * stage.across(draw);
             stage.scene.spheres.front() = {rounded(stage.ray.P_WCS + (radius + height) * down), radius};
         },
         surely_hit},
        {"ray starts inside the sphere", "the smaller root is behind the start", 50, false,
         [](Stage& stage, Draw& draw) {
             stage.scene.spheres.front() = {rounded(stage.ahead(-3) + 3.0 * stage.across(draw)), 7};
         },
         [](const Answers& answers, const Scene& /*scene*/) {
             return answers.sphere->quadratic.c < -5 ? 1 : not_wanted;
         }},
        {"sphere behind the ray", "both roots are behind the start", 50, false,
         [](Stage& stage, Draw& draw) {
             stage.scene.spheres.front() = {rounded(stage.ahead(-9) + stage.across(draw)), 4};
         },
         [](const Answers& answers, const Scene& scene) {
             const auto& quadratic = answers.sphere->quadratic;
             return share(answers, scene) > 0.2 && quadratic.b > 0 && quadratic.c > 0 ? 1 : not_wanted;
         }},
    };
}

}  // namespace harness::stress
