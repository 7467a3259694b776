#include "reference/accuracy/rays/truth.h"

#include <cmath>

#include "reference/accuracy/rays/distributions.h"

namespace reference::accuracy::truth {
namespace {

Point minus(const Point& p, const Point& q) {
    return {p.x - q.x, p.y - q.y, p.z - q.z};
}

bool is_zero(const Point& p) {
    return p.x == 0 && p.y == 0 && p.z == 0;
}

}  // namespace

Point exact(const Vec3<double>& p) {
    return {Rational(p.x), Rational(p.y), Rational(p.z)};
}

Rational dot(const Point& p, const Point& q) {
    return p.x * q.x + p.y * q.y + p.z * q.z;
}

Real real(const Rational& x) {
    return Real(numerator(x)) / Real(denominator(x));
}

Real SphereTruth::t() const {
    const Real root = sqrt(real(Rational(h * h - a * c)));
    return (smaller ? Real(-real(h) - root) : Real(-real(h) + root)) / real(a);
}

SphereTruth sphere(const Ray<double>& ray, const Sphere<double>& sphere) {
    const Point d = exact(ray.direction);
    const Point f = minus(exact(ray.origin), exact(sphere.center));
    const Rational R(sphere.radius);
    SphereTruth truth{SphereResult::miss, dot(d, d), dot(d, f), dot(f, f) - R * R};
    const Rational D = truth.h * truth.h - truth.a * truth.c;
    if (D < 0) return truth;
    // The smaller root counts if -h - √D >= 0, else the larger if -h + √D >= 0. Both are decided by squares.
    truth.smaller = truth.h <= 0 && truth.h * truth.h >= D;
    const bool larger = truth.h <= 0 || D >= truth.h * truth.h;
    if (truth.smaller || larger) truth.result = D == 0 ? SphereResult::tangent : SphereResult::hit;
    return truth;
}

TriangleTruth triangle(const Ray<double>& ray, const Triangle<double>& triangle) {
    const Point A = exact(triangle.A);
    const Point p = minus(exact(triangle.B), A);
    const Point q = minus(exact(triangle.C), A);
    const Point d = exact(ray.direction);
    const Point start = minus(exact(ray.origin), A);
    const Point normal{p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
    if (is_zero(normal)) return {TriangleResult::degenerate, 0, 0, 0};
    const Rational approach = dot(normal, d);
    const Rational height = dot(normal, start);
    if (approach == 0) return {height == 0 ? TriangleResult::coplanar : TriangleResult::miss, 0, 0, 0};
    const Rational t = -height / approach;
    const Point in_plane{start.x + t * d.x, start.y + t * d.y, start.z + t * d.z};
    const Rational pp = dot(p, p);
    const Rational pq = dot(p, q);
    const Rational qq = dot(q, q);
    const Rational gram = pp * qq - pq * pq;
    const Rational u = (qq * dot(in_plane, p) - pq * dot(in_plane, q)) / gram;
    const Rational v = (pp * dot(in_plane, q) - pq * dot(in_plane, p)) / gram;
    const bool hit = t >= 0 && u >= 0 && v >= 0 && u + v <= 1;
    return {hit ? TriangleResult::hit : TriangleResult::miss, t, u, v};
}

int sign(const Surd& number) {
    const auto& [x, y, d] = number;
    const int of_root = d == 0 ? 0 : y.sign();
    if (x.sign() * of_root >= 0) return x == 0 ? of_root : x.sign();
    return Rational(y * y * d).compare(Rational(x * x)) * of_root;
}

ExactCylinder exact(const Cylinder<double>& cylinder) {
    return {exact(cylinder.center), Rational(cylinder.radius), Rational(cylinder.height)};
}

std::optional<CylinderTruth> cylinder(const Point& S, const Point& V, const ExactCylinder& cylinder,
                                      Boundary boundary) {
    using kernel::CylinderPart;
    const Rational &R = cylinder.radius, half = cylinder.height / 2;
    const Point from = minus(S, cylinder.center);
    const Rational a = V.x * V.x + V.z * V.z;
    const Rational b = 2 * (from.x * V.x + from.z * V.z);
    const Rational d = b * b - 4 * a * (from.x * from.x + from.z * from.z - R * R);
    std::optional<CylinderTruth> first;
    const auto meet = [&](const Surd& t, CylinderPart part, bool is_at_rim) {
        const int ahead = sign(t);
        if (ahead < 0 || (ahead == 0 && boundary == Boundary::positive)) return;
        // The roots have the same d; a cap's t has none.
        if (!first || sign({t.x - first->t.x, t.y - first->t.y, d}) < 0)
            first = {t, part, part == CylinderPart::tube && d == 0, is_at_rim};
    };
    for (const int side : {-1, 1}) {
        if (V.y != 0) {
            const Rational t = (side * half - from.y) / V.y;
            const Rational x = from.x + t * V.x, z = from.z + t * V.z;
            if (x * x + z * z < R * R) meet({t}, side > 0 ? CylinderPart::top : CylinderPart::bottom, false);
        }
        if (a != 0 && d >= 0) {
            const Surd t{-b / (2 * a), side / (2 * a), d};
            const Rational y = from.y + t.x * V.y;
            const int under = sign({y + half, t.y * V.y, d}), over = sign({y - half, t.y * V.y, d});
            if (under >= 0 && over <= 0) meet(t, CylinderPart::tube, V.y != 0 && (under == 0 || over == 0));
        }
    }
    return first;
}

std::optional<CylinderTruth> cylinder(const Ray<double>& ray, const Cylinder<double>& cylinder, Boundary boundary) {
    return truth::cylinder(exact(ray.origin), exact(ray.direction), exact(cylinder), boundary);
}

int order(const SphereTruth& sphere, const Rational& t) {
    const Rational middle = -sphere.h / sphere.a;
    const Rational D = sphere.h * sphere.h - sphere.a * sphere.c;
    // The root is middle ∓ √D / a; compare √D / a with its distance from t by squares.
    const Rational distance = sphere.smaller ? Rational(middle - t) : Rational(t - middle);
    if (distance < 0) return sphere.smaller ? -1 : 1;
    const int root_is_farther = Rational(D / (sphere.a * sphere.a)).compare(Rational(distance * distance));
    return sphere.smaller ? -root_is_farther : root_is_farther;
}

}  // namespace reference::accuracy::truth

namespace reference::accuracy {
namespace {

Answer at(Outcome outcome, const truth::Real& t) {
    const auto high = t.convert_to<double>();
    return {outcome, high, truth::Real(t - high).convert_to<double>()};
}

bool is_hit(const truth::SphereTruth& sphere) {
    return sphere.result == kernel::SphereResult::hit || sphere.result == kernel::SphereResult::tangent;
}

}  // namespace

Answer true_answer(const SphereCase& c) {
    const truth::SphereTruth sphere = truth::sphere(c.ray, c.sphere);
    return is_hit(sphere) ? at(Outcome::hit, sphere.t()) : Answer{};
}

Answer true_answer(const TriangleCase& c) {
    const truth::TriangleTruth triangle = truth::triangle(c.ray, c.triangle);
    return triangle.result == kernel::TriangleResult::hit ? at(Outcome::hit, truth::real(triangle.t)) : Answer{};
}

Answer true_answer(const CylinderCase& c) {
    const auto hit = truth::cylinder(c.ray, c.cylinder);
    return hit ? at(Outcome::hit, hit->t.value()) : Answer{};
}

Answer true_answer(const OrderCase& c) {
    const truth::SphereTruth sphere = truth::sphere(c.ray, c.sphere);
    const truth::TriangleTruth triangle = truth::triangle(c.ray, c.triangle);
    const bool in_triangle = triangle.result == kernel::TriangleResult::hit;
    if (!is_hit(sphere) && !in_triangle) return {};
    if (!in_triangle) return at(Outcome::sphere_first, sphere.t());
    if (!is_hit(sphere)) return at(Outcome::triangle_first, truth::real(triangle.t));
    const int order = truth::order(sphere, triangle.t);
    if (order < 0) return at(Outcome::sphere_first, sphere.t());
    return at(order == 0 ? Outcome::tie : Outcome::triangle_first, truth::real(triangle.t));
}

}  // namespace reference::accuracy
