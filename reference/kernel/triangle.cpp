#include "reference/kernel/triangle.h"

#include "reference/stages/triangle.h"

namespace reference::kernel {
namespace {

CramerSolution<Dyadic> exact_solution(const Ray<double>& ray, const Triangle<double>& triangle) {
    return solve_by_cramer(
        triangle_system(over<Dyadic>(ray.origin), over<Dyadic>(ray.direction), over<Dyadic>(triangle)));
}

bool has_area(const Triangle<Dyadic>& triangle) {
    const Vec3<Dyadic> normal = cross(Vec3<Dyadic>(triangle.B - triangle.A), Vec3<Dyadic>(triangle.C - triangle.A));
    return sign_of(normal.x) != 0 || sign_of(normal.y) != 0 || sign_of(normal.z) != 0;
}

}  // namespace

TriangleResult decide_exactly(const Ray<double>& ray, const Triangle<double>& triangle) {
    if (!is_valid(ray) || !is_finite(triangle.A) || !is_finite(triangle.B) || !is_finite(triangle.C)) {
        return TriangleResult::invalid;
    }
    const CramerSolution<Dyadic> solution = exact_solution(ray, triangle);
    if (sign_of(solution.det) == 0 && !has_area(over<Dyadic>(triangle))) return TriangleResult::degenerate;
    switch (classify(solution)) {
        case reference::TriangleHit::hit:
        case reference::TriangleHit::boundary: return TriangleResult::hit;
        case reference::TriangleHit::coplanar: return TriangleResult::coplanar;
        case reference::TriangleHit::miss:
        case reference::TriangleHit::parallel:
        case reference::TriangleHit::unsure: break;
    }
    return TriangleResult::miss;
}

HitParameter<Dyadic> exact_t(const Ray<double>& ray, const Triangle<double>& triangle) {
    return fraction_of(exact_solution(ray, triangle));
}

TriangleHit intersect(const Ray<double>& ray, const Triangle<double>& triangle) {
    const TriangleResult result = decide(ray, triangle);
    if (!is_hit(result)) return {result, 0, 0, 0};
    const CramerSolution<Dyadic> exact = exact_solution(ray, triangle);
    const auto over_det = [&](const Dyadic& numerator) {
        return nearest(reference::Fraction<Dyadic>{numerator, exact.det});
    };
    return {result, over_det(exact.t_numerator), over_det(exact.u_numerator), over_det(exact.v_numerator)};
}

}  // namespace reference::kernel
