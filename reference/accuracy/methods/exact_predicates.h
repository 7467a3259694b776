// Predicates for ray and triangle that never err, as libraries of exact geometry have them.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "reference/accuracy/rays/hit.h"
#include "reference/kernel/triangle.h"
#include "reference/numbers/interval.h"

namespace reference::accuracy {

/// Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates" (1997): a number as a
/// sum of doubles that do not overlap, the smallest first, without zeros. Exact while nothing over- or underflows.
class Expansion {
  public:
    /// Adds x; the paper's GROW-EXPANSION, with zeros left out.
    void add(double x) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < size_; ++i) {
            const Sum sum = two_sum(x, parts_[i]);
            x = sum.high;
            if (sum.low != 0) parts_[kept++] = sum.low;
        }
        if (x != 0) parts_[kept++] = x;
        size_ = kept;
    }
    /// Adds the product of three numbers.
    void add_product(double x, double y, double z) {
        const Sum xy = two_product(x, y);
        for (const double part : {xy.low, xy.high}) {
            const Sum product = two_product(part, z);
            add(product.low);
            add(product.high);
        }
    }
    /// The largest part, which has the sign of the whole.
    double most() const { return size_ == 0 ? 0 : parts_[size_ - 1]; }

    struct Sum {
        double high;
        double low;
    };
    static Sum two_sum(double a, double b) {
        const double sum = a + b;
        const double b_part = sum - a;
        return {sum, (a - (sum - b_part)) + (b - b_part)};
    }
    static Sum two_product(double a, double b) {
        const double product = a * b;
        return {product, std::fma(a, b, -product)};
    }

  private:
    /// A determinant of three differences has 6 * 8 products of four parts each.
    std::array<double, 192> parts_{};
    std::size_t size_ = 0;
};

/// The rounded difference and its error.
struct Difference {
    Vec3<double> rounded;
    Vec3<double> error;

    Difference(const Vec3<double>& p, const Vec3<double>& q) : rounded(p - q) {
        for (int i = 0; i < 3; ++i) error[i] = Expansion::two_sum(p[i], -q[i]).low;
    }
    explicit Difference(const Vec3<double>& exact) : rounded(exact), error(0, 0, 0) {}
    bool is_exact() const { return error.x == 0 && error.y == 0 && error.z == 0; }
};

/// A number with the sign of x . (y × z); the paper's ORIENT3D of points whose differences these are. First in doubles,
/// with the paper's bound; then exactly with the rounded differences, with the paper's second bound; then exactly.
inline double orient3d(const Difference& x, const Difference& y, const Difference& z) {
    constexpr double u = 0x1p-53;
    const Vec3<double>& p = x.rounded;
    const Vec3<double>& q = y.rounded;
    const Vec3<double>& r = z.rounded;
    const auto size = [](double a, double b) { return std::abs(a) + std::abs(b); };
    const double det = p.x * (q.y * r.z - q.z * r.y) + p.y * (q.z * r.x - q.x * r.z) + p.z * (q.x * r.y - q.y * r.x);
    const double permanent = std::abs(p.x) * size(q.y * r.z, q.z * r.y) + std::abs(p.y) * size(q.z * r.x, q.x * r.z) +
                             std::abs(p.z) * size(q.x * r.y, q.y * r.x);
    if (std::abs(det) > (7 + 56 * u) * u * permanent) return det;
    const auto add_all = [](Expansion& sum, const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c) {
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3;
            const int k = (i + 2) % 3;
            sum.add_product(a[i], b[j], c[k]);
            sum.add_product(-a[i], b[k], c[j]);
        }
    };
    Expansion sum;
    add_all(sum, p, q, r);
    if (x.is_exact() && y.is_exact() && z.is_exact()) return sum.most();
    if (std::abs(sum.most()) > (3 + 28 * u) * u * permanent) return sum.most();
    add_all(sum, p, q, z.error);
    add_all(sum, p, y.error, r);
    add_all(sum, p, y.error, z.error);
    add_all(sum, x.error, q, r);
    add_all(sum, x.error, q, z.error);
    add_all(sum, x.error, y.error, r);
    add_all(sum, x.error, y.error, z.error);
    return sum.most();
}

/// The ray passes all three edges on one side, and the plane lies ahead. Where the determinants are all 0 the ray lies
/// in the plane.
inline bool hit_by_orient3d(const Ray<double>& ray, const Triangle<double>& triangle) {
    const Difference d(ray.direction);
    const Difference a(triangle.A, ray.origin);
    const Difference b(triangle.B, ray.origin);
    const Difference c(triangle.C, ray.origin);
    const double u = orient3d(d, b, c);
    const double v = orient3d(d, c, a);
    if ((u < 0 && v > 0) || (u > 0 && v < 0)) return false;
    const double w = orient3d(d, a, b);
    const double least = std::min(std::min(u, v), w);
    const double most = std::max(std::max(u, v), w);
    if ((least < 0 && most > 0) || (least == 0 && most == 0)) return false;
    const double plane = orient3d(a, b, c);
    return least < 0 ? plane <= 0 : plane >= 0;
}

/// A filtered predicate: intervals of double first, and whole numbers where they leave a sign open. Brönnimann,
/// Burnikel and Pion, "Interval arithmetic yields efficient dynamic filters for computational geometry" (2001).
inline bool interval_filtered(const Ray<double>& ray, const Triangle<double>& triangle) {
    using I = Interval<double>;
    const auto exact = [](const Vec3<double>& p) { return Vec3<I>(I(p.x), I(p.y), I(p.z)); };
    const Vec3<I> d = exact(ray.direction);
    const Vec3<I> A = exact(triangle.A);
    const Vec3<I> p = exact(triangle.B) - A;
    const Vec3<I> q = exact(triangle.C) - A;
    const Vec3<I> s = exact(ray.origin) - A;
    const Vec3<I> normal = cross(p, q);
    const Vec3<I> moment = cross(s, d);
    const I minus_det = dot(d, normal);
    const auto exactly = [&] { return kernel::decide_exactly(ray, triangle) == kernel::TriangleResult::hit; };
    const auto det_sign = sign_of(minus_det);
    if (!(det_sign < 0 || det_sign > 0)) return exactly();
    const auto turned_by_det = [&](const I& x) { return det_sign < 0 ? -x : x; };
    const I minus_u = turned_by_det(dot(moment, q));
    const I v = turned_by_det(dot(moment, p));
    const I w = turned_by_det(minus_det) + minus_u - v;
    const I minus_t = turned_by_det(dot(s, normal));
    if (minus_u.lo() > 0 || v.hi() < 0 || w.hi() < 0 || minus_t.lo() > 0) return false;
    if (minus_u.hi() < 0 && v.lo() > 0 && w.lo() > 0 && minus_t.hi() < 0) return true;
    return exactly();
}

}  // namespace reference::accuracy
