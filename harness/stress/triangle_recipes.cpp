#include <algorithm>
#include <cmath>

#include "harness/source/scene/triangle_parts.h"
#include "harness/stress/recipe.h"

namespace harness::stress {
namespace {

/// The distance of the hit from the triangle's nearest edge, as a barycentric coordinate; empty if the system has no
/// solution or the hit lies behind the ray's start.
std::optional<double> margin(const Answers& answers) {
    const reference::TriangleAnswers<double>& triangle = *answers.triangle;
    if (!triangle.t || *triangle.t < 0.5) return {};
    return std::min({*triangle.u, *triangle.v, 1 - *triangle.u - *triangle.v});
}

double well_inside(const Answers& answers, const Scene& /*scene*/) {
    return margin(answers).value_or(not_wanted) > 0.05 ? 1 : not_wanted;
}

double just_inside(const Answers& answers, const Scene& /*scene*/) {
    const double inside = margin(answers).value_or(not_wanted);
    return inside > 0 ? 1 / inside : not_wanted;
}

double just_outside(const Answers& answers, const Scene& /*scene*/) {
    const double inside = margin(answers).value_or(1);
    return inside < 0 ? -1 / inside : not_wanted;
}

double always(const Answers& /*answers*/, const Scene& /*scene*/) {
    return 1;
}

/// `p` and `q` are perpendicular to the ray and to each other.
struct Frame {
    Point p, q;
};
Frame frame(const Stage& stage, Draw& draw) {
    const Point p = across(stage, draw);
    return {p, reference::cross(stage.ray.V, p)};
}

Scene with_triangle(const Stage& stage, const Point& A, const Point& B, const Point& C) {
    Scene scene = stage.scene;
    put_sphere_away(scene, stage);
    scene.triangles.front() = {A, B, C};
    return scene;
}

Scene draw_edge(const Stage& stage, Draw& draw) {
    const auto [p, q] = frame(stage, draw);
    const auto at = [&](double along, double beside, double above) {
        return rounded(stage.ray.P_WCS + along * stage.ray.V + beside * p + above * q);
    };
    return with_triangle(stage, at(draw.between(60, 90), draw.between(300, 900), 0),
                         at(draw.between(60, 90), -draw.between(300, 900), 0),
                         at(draw.between(60, 90), draw.between(-90, 90), draw.between(500, 900)));
}

Scene draw_grazed(const Stage& stage, Draw& draw) {
    const auto [p, q] = frame(stage, draw);
    const Point begin = stage.ray.P_WCS + 10.0 * stage.ray.V - 4.0 * p;
    return with_triangle(stage, rounded(begin - 30.0 * q), rounded(begin + 30.0 * q),
                         rounded(stage.ray.P_WCS + 30'000.0 * stage.ray.V + 8.0 * p));
}

Scene draw_sliver(const Stage& stage, Draw& draw) {
    const auto [p, q] = frame(stage, draw);
    const Point middle = stage.ray.P_WCS + 40.0 * stage.ray.V;
    return with_triangle(stage, rounded(middle - 20'000.0 * p - 2.0 * q), rounded(middle + 20'000.0 * p - 2.0 * q),
                         rounded(middle + 3.0 * q + 5.0 * stage.ray.V));
}

/// The edges that start at the vertex lie on both sides of the ray, so the ray meets the vertex.
Scene draw_vertex(const Stage& stage, Draw& draw) {
    const auto [p, q] = frame(stage, draw);
    const Point A = stage.on_ray(5);
    return with_triangle(stage, A, A + rounded(7.0 * p + 5.0 * q + 2.0 * stage.ray.V),
                         A + rounded(-7.0 * p + 6.0 * q - stage.ray.V));
}

/// One edge runs along the ray, so that det is 0 exactly.
Scene draw_parallel(const Stage& stage, Draw& draw) {
    const auto [p, q] = frame(stage, draw);
    const Point A = stage.on_ray(3) + rounded(2.0 * p + 2.0 * q);
    return with_triangle(stage, A, A + (stage.on_ray(7) - stage.on_ray(3)), A + rounded(9.0 * p - 4.0 * q));
}

/// The ray's start is the middle of the triangle: the corners add up to three times the start.
Scene draw_at_start(const Stage& stage, Draw& draw) {
    const auto [p, q] = frame(stage, draw);
    const Point a = rounded(7.0 * p + 3.0 * stage.ray.V), b = rounded(-4.0 * p + 6.0 * q + 2.0 * stage.ray.V);
    const Point& S = stage.ray.P_WCS;
    return with_triangle(stage, S + a, S + b, S - a - b);
}

}  // namespace

void put_in_view(reference::Triangle<double>& triangle, const PartSet& located, const View& view) {
    if (!located.contains(source::part::triangle::A)) return;
    const Point& V = view.ray.V;
    const Point p = reference::normalized(reference::cross(V, Point(3, -1, 2)));
    const Point q = reference::cross(V, p);
    const Point behind = view.middle + 9.0 * V;
    triangle = {rounded(behind + 20.0 * p), rounded(behind - 10.0 * p + 17.0 * q),
                rounded(behind - 10.0 * p - 17.0 * q)};
}

template <>
std::vector<HardRecipe> recipes<reference::Subject::triangle>() {
    const std::vector<ScenePart> triangle = {source::part::triangle::A, source::part::triangle::B,
                                             source::part::triangle::C};
    return {
        {"triangle, just inside an edge", "a barycentric coordinate is above 0 by little", triangle, 3000, false,
         draw_edge, just_inside},
        {"triangle, just outside an edge", "a barycentric coordinate is below 0 by little", triangle, 3000, false,
         draw_edge, just_outside},
        {"triangle, through a vertex", "u and v are 0 exactly, which counts as a hit", triangle, 1, true, draw_vertex,
         always},
        {"triangle, nearly parallel to the ray", "the determinant is small beside its terms", triangle, 100, false,
         draw_grazed, well_inside},
        {"triangle, parallel to the ray", "the determinant is 0 exactly: there is no t, u, v", triangle, 1, true,
         draw_parallel, always},
        {"triangle, a sliver", "two edges point nearly the same way", triangle, 300, false, draw_sliver, well_inside},
        {"ray starts on the triangle", "t is 0 exactly", triangle, 1, true, draw_at_start, always},
    };
}

}  // namespace harness::stress
