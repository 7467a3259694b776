#include <algorithm>
#include <cmath>

#include "harness/stress/recipe.h"

namespace harness::stress {
namespace {

/// The distance of the hit from the triangle's nearest edge, as a barycentric coordinate; nan if the system has no
/// solution or the hit is behind the ray's start.
double margin(const Answers& answers) {
    const reference::TriangleAnswers<double>& triangle = *answers.triangle;
    if (!triangle.t || *triangle.t < 0.5) return NAN;
    return std::min({*triangle.u, *triangle.v, 1 - *triangle.u - *triangle.v});
}

double well_inside(const Answers& answers, const Scene& /*scene*/) {
    return margin(answers) > 0.05 ? 1 : not_wanted;
}

/// `p` and `q` are perpendicular to the ray and to each other.
struct Frame {
    Point p, q;
};
Frame frame(const Stage& stage, Draw& draw) {
    const Point p = stage.across(draw);
    return {p, reference::cross(stage.ray.V, p)};
}

void put_triangle(Stage& stage, const Point& A, const Point& B, const Point& C) {
    put_sphere_behind(stage);
    stage.scene.triangles.front() = {A, B, C};
}

void draw_edge(Stage& stage, Draw& draw) {
    const auto [p, q] = frame(stage, draw);
    const auto at = [&](double along, double beside, double above) {
        return rounded(stage.ahead(along) + beside * p + above * q);
    };
    const double above_C = draw.between(500, 900), beside_C = draw.between(-90, 90), along_C = draw.between(60, 90);
    const double beside_B = draw.between(300, 900), along_B = draw.between(60, 90);
    const double beside_A = draw.between(300, 900), along_A = draw.between(60, 90);
    put_triangle(stage, at(along_A, beside_A, 0), at(along_B, -beside_B, 0), at(along_C, beside_C, above_C));
}

}  // namespace

void put_in_view(reference::Triangle<double>& triangle, const Stage& stage) {
    if (!stage.located->contains(source::part::triangle::A)) return;
    const Point& V = stage.ray.V;
    const Point p = reference::normalized(reference::cross(V, Point(3, -1, 2)));
    const Point q = reference::cross(V, p);
    const Point behind = stage.ahead(30) + 9.0 * V;
    triangle = {rounded(behind + 20.0 * p), rounded(behind - 10.0 * p + 17.0 * q),
                rounded(behind - 10.0 * p - 17.0 * q)};
}

template <>
std::vector<HardRecipe> recipes<reference::Subject::triangle>() {
    return {
        {"triangle, just inside an edge", "a barycentric coordinate is slightly above 0", 3000, false, draw_edge,
         [](const Answers& answers, const Scene& /*scene*/) { return nearness(margin(answers)); }},
        {"triangle, just outside an edge", "a barycentric coordinate is slightly below 0", 3000, false, draw_edge,
         [](const Answers& answers, const Scene& /*scene*/) { return nearness(-margin(answers)); }},
        {"triangle, through a vertex", "u and v are exactly 0, which counts as a hit", 1, true,
         [](Stage& stage, Draw& draw) {
             // The edges that start at the vertex lie on both sides of the ray, so the ray meets the vertex.
             const auto [p, q] = frame(stage, draw);
             const Point A = stage.on_ray(5);
             put_triangle(stage, A, A + rounded(7.0 * p + 5.0 * q + 2.0 * stage.ray.V),
                          A + rounded(-7.0 * p + 6.0 * q - stage.ray.V));
         }},
        {"triangle, nearly parallel to the ray", "the determinant is much smaller than its terms", 100, false,
         [](Stage& stage, Draw& draw) {
             const auto [p, q] = frame(stage, draw);
             const Point begin = stage.ahead(10) - 4.0 * p;
             put_triangle(stage, rounded(begin - 30.0 * q), rounded(begin + 30.0 * q),
                          rounded(stage.ahead(30'000) + 8.0 * p));
         },
         well_inside},
        {"triangle, parallel to the ray", "the determinant is exactly 0, so there is no t, u or v", 1, true,
         [](Stage& stage, Draw& draw) {
             // One edge runs along the ray, so that det is exactly 0.
             const auto [p, q] = frame(stage, draw);
             const Point A = stage.on_ray(3) + rounded(2.0 * p + 2.0 * q);
             put_triangle(stage, A, A + (stage.on_ray(7) - stage.on_ray(3)), A + rounded(9.0 * p - 4.0 * q));
         }},
        {"triangle, a sliver", "two edges point nearly the same way", 300, false,
         [](Stage& stage, Draw& draw) {
             const auto [p, q] = frame(stage, draw);
             const Point middle = stage.ahead(40);
             put_triangle(stage, rounded(middle - 20'000.0 * p - 2.0 * q), rounded(middle + 20'000.0 * p - 2.0 * q),
                          rounded(middle + 3.0 * q + 5.0 * stage.ray.V));
         },
         well_inside},
        {"ray starts on the triangle", "t is exactly 0", 1, true,
         [](Stage& stage, Draw& draw) {
             // The ray's start is the middle of the triangle: the corners add up to three times the start.
             const auto [p, q] = frame(stage, draw);
             const Point a = rounded(7.0 * p + 3.0 * stage.ray.V), b = rounded(-4.0 * p + 6.0 * q + 2.0 * stage.ray.V);
             const Point& S = stage.ray.P_WCS;
             put_triangle(stage, S + a, S + b, S - a - b);
         }},
    };
}

}  // namespace harness::stress
