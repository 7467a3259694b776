#include "tests/given/cylinder_parts.h"

#include <vector>

namespace cylinder_parts {

namespace truth = reference::accuracy::truth;

Real Surd::value() const {
    return truth::real(x) + truth::real(y) * sqrt(truth::real(d));
}

int sign(const Surd& number) {
    const int of_x = number.x.sign();
    const int of_root = number.d == 0 ? 0 : number.y.sign();
    if (of_x == 0 || of_root == of_x) return of_root;
    if (of_root == 0) return of_x;
    const Rational root_square = number.y * number.y * number.d;
    const int root_wins = root_square.compare(Rational(number.x * number.x));
    return root_wins == 0 ? 0 : (root_wins > 0 ? of_root : of_x);
}

/// A thousand digits tell unequal numbers apart. That two are equal is told by x² = (y√d + z√e)², squared once more.
int order(const Surd& one, const Surd& other) {
    const Real difference = one.value() - other.value();
    if (abs(difference) > Real("1e-300") * (abs(one.value()) + Real("1e-300"))) return difference.sign();
    const Rational x = one.x - other.x;
    const Rational y_square = one.y * one.y * one.d;
    const Rational z_square = other.y * other.y * other.d;
    const Rational mixed = x * x - y_square - z_square;
    if (mixed * mixed == 4 * y_square * z_square) return 0;
    return difference.sign();
}

std::optional<Hit> first_hit(const Point& S, const Point& V, const ExactCylinder& cylinder, Boundary boundary) {
    const Point& center = cylinder.center;
    const Rational& R = cylinder.radius;
    const Rational half_height = cylinder.height / 2;
    std::vector<Hit> hits;
    // The caps.
    if (V.y != 0) {
        for (const CylinderPart cap : {CylinderPart::top, CylinderPart::bottom}) {
            const Rational plane = center.y + (cap == CylinderPart::top ? 1 : -1) * half_height;
            const Rational t = (plane - S.y) / V.y;
            const Rational x = S.x + t * V.x - center.x;
            const Rational z = S.z + t * V.z - center.z;
            if (x * x + z * z < R * R) hits.push_back({{t}, cap});
        }
    }
    // The tube.
    const Rational a = V.x * V.x + V.z * V.z;
    const Rational b = 2 * (S.x - center.x) * V.x + 2 * (S.z - center.z) * V.z;
    const Rational c = (S.x - center.x) * (S.x - center.x) + (S.z - center.z) * (S.z - center.z) - R * R;
    const Rational d = b * b - 4 * a * c;
    if (a != 0 && d >= 0) {
        for (const int side : {-1, 1}) {
            const Surd t{-b / (2 * a), side / (2 * a), d};
            const Surd above_bottom{S.y + t.x * V.y - center.y + half_height, t.y * V.y, d};
            const Surd above_top{S.y + t.x * V.y - center.y - half_height, t.y * V.y, d};
            const int over = sign(above_top), under = sign(above_bottom);
            if (under < 0 || over > 0) continue;
            hits.push_back({t, CylinderPart::tube, d == 0, V.y != 0 && (under == 0 || over == 0)});
        }
    }
    std::optional<Hit> first;
    for (const Hit& hit : hits) {
        const int t = sign(hit.t);
        if (t < 0 || (t == 0 && boundary == Boundary::positive)) continue;
        // The roots have the same d; a cap's t has none.
        const auto is_nearer = [&] { return sign({hit.t.x - first->t.x, hit.t.y - first->t.y, d}) < 0; };
        if (!first || is_nearer()) first = hit;
    }
    return first;
}

std::optional<Hit> first_hit(const Point& S, const Point& V, const Cylinder<double>& cylinder, Boundary boundary) {
    return first_hit(S, V, {truth::exact(cylinder.center), Rational(cylinder.radius), Rational(cylinder.height)},
                     boundary);
}

std::optional<Hit> first_hit(const Ray<double>& ray, const Cylinder<double>& cylinder, Boundary boundary) {
    return first_hit(truth::exact(ray.origin), truth::exact(ray.direction), cylinder, boundary);
}

std::optional<Surd> first_t(const Ray<double>& ray, const Sphere<double>& sphere) {
    const truth::SphereTruth truth = truth::sphere(ray, sphere);
    if (truth.result == truth::SphereResult::miss) return std::nullopt;
    return Surd{-truth.h / truth.a, (truth.smaller ? -1 : 1) / truth.a, truth.h * truth.h - truth.a * truth.c};
}
std::optional<Surd> first_t(const Ray<double>& ray, const Triangle<double>& triangle) {
    const truth::TriangleTruth truth = truth::triangle(ray, triangle);
    if (truth.result != truth::TriangleResult::hit) return std::nullopt;
    return Surd{truth.t};
}
std::optional<Surd> first_t(const Ray<double>& ray, const Cylinder<double>& cylinder) {
    const std::optional<Hit> hit = first_hit(ray, cylinder, Boundary::nonnegative);
    return hit ? std::optional(hit->t) : std::nullopt;
}

}  // namespace cylinder_parts
