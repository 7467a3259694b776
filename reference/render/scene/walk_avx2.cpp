// The walk in AVX2 and FMA. This file alone is compiled for them. So it calls nothing that another file compiles too:
// the linker would keep either of the two.
#ifdef __AVX2__
#include <immintrin.h>

#include "reference/render/scene/walk_body.h"

namespace reference::render {
namespace {

using Floats [[gnu::vector_size(32)]] = float;
using Doubles [[gnu::vector_size(32)]] = double;

KERNEL_INLINE Floats eight(float x) {
    return _mm256_set1_ps(x);
}
KERNEL_INLINE Doubles four(double x) {
    return _mm256_set1_pd(x);
}
KERNEL_INLINE Doubles absolute(Doubles x) {
    return _mm256_andnot_pd(four(-0.0), x);
}
KERNEL_INLINE unsigned bits_of(__m256d mask) {
    return static_cast<unsigned>(_mm256_movemask_pd(mask));
}

class Avx2Boxes {
  public:
    KERNEL_INLINE explicit Avx2Boxes(const TreeRay& ray) {
        for (int i = 0; i < 3; ++i) {
            inverse_[i] = eight(ray.inverse[i]);
            near_shift_[i] = eight(ray.near_shift[i]);
            far_shift_[i] = eight(ray.far_shift[i]);
            enter_[i] = 32 * ray.enter[i];
            leave_[i] = 32 * (ray.enter[i] ^ 1U);
        }
    }

    KERNEL_INLINE unsigned meets(const Node& node, float until, float* near) const {
        const Floats from = _mm256_max_ps(_mm256_max_ps(tau(node, enter_[0], inverse_[0], near_shift_[0]),
                                                        tau(node, enter_[1], inverse_[1], near_shift_[1])),
                                          _mm256_max_ps(tau(node, enter_[2], inverse_[2], near_shift_[2]), eight(0)));
        const Floats to = _mm256_min_ps(_mm256_min_ps(tau(node, leave_[0], inverse_[0], far_shift_[0]),
                                                      tau(node, leave_[1], inverse_[1], far_shift_[1])),
                                        _mm256_min_ps(tau(node, leave_[2], inverse_[2], far_shift_[2]), eight(until)));
        _mm256_store_ps(near, from);
        return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(from, to, _CMP_LE_OQ)));
    }

  private:
    /// side/d - o/d, of the sides at the offset. Fused, it is rounded once less than tree_ray.h allows for.
    KERNEL_INLINE static Floats tau(const Node& node, std::size_t offset, Floats inverse, Floats shift) {
        const auto* const sides = reinterpret_cast<const float*>(reinterpret_cast<const char*>(&node) + offset);
        return _mm256_fmsub_ps(_mm256_load_ps(sides), inverse, shift);
    }

    Floats inverse_[3];
    Floats near_shift_[3];
    Floats far_shift_[3];
    std::size_t enter_[3];
    std::size_t leave_[3];
};

struct Vectors3 {
    Doubles x;
    Doubles y;
    Doubles z;

    KERNEL_INLINE friend Vectors3 operator-(const Vectors3& p, const Vectors3& q) {
        return {p.x - q.x, p.y - q.y, p.z - q.z};
    }
    KERNEL_INLINE friend Vectors3 cross(const Vectors3& p, const Vectors3& q) {
        return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
    }
    KERNEL_INLINE friend Doubles dot(const Vectors3& p, const Vectors3& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }
    KERNEL_INLINE friend Doubles norm(const Vectors3& p) { return absolute(p.x) + absolute(p.y) + absolute(p.z); }
};

/// The filter of kernel/triangle.h for four triangles, operation by operation.
class Avx2Triangles {
  public:
    KERNEL_INLINE Avx2Triangles(const kernel::Ray<double>& ray, double uncertainty)
        : origin_{four(ray.origin.x), four(ray.origin.y), four(ray.origin.z)},
          d_{four(ray.direction.x), four(ray.direction.y), four(ray.direction.z)},
          d_size_(norm(d_)),
          uncertainty_(four(uncertainty)) {}

    KERNEL_INLINE HitLanes hits(const Leaf& leaf, double until, Lanes& t) const {
        const Vectors3 A = corner(leaf, 0);
        const Vectors3 p = corner(leaf, 1) - A;
        const Vectors3 q = corner(leaf, 2) - A;
        const Vectors3 normal = cross(p, q);
        const Doubles e = norm(p) + norm(q) + four(0x1p-300);
        const Vectors3 s = origin_ - A;
        const Vectors3 side = cross(s, d_);
        const Doubles minus_det = dot(d_, normal);
        const Doubles turned = _mm256_and_pd(minus_det, four(-0.0));
        const Doubles det = absolute(minus_det);
        const Doubles T = _mm256_xor_pd(_mm256_xor_pd(dot(s, normal), turned), four(-0.0));
        const Doubles minus_u = _mm256_xor_pd(dot(side, q), turned);
        const Doubles v = _mm256_xor_pd(dot(side, p), turned);
        const Doubles u = _mm256_xor_pd(minus_u, four(-0.0));
        const Doubles inside = _mm256_min_pd(det + minus_u - v, _mm256_min_pd(v, u));
        const Doubles d_norm = d_size_ + four(0x1p-300);
        const Doubles n_small = e + norm(s);
        const Doubles is_small = _mm256_cmp_pd(n_small + d_norm, four(0x1p300), _CMP_LT_OQ);
        const Doubles n = _mm256_blendv_pd(four(HUGE_VAL), n_small, is_small);
        const Doubles unit = four(0x1p-49) * e * n;
        const Doubles by = uncertainty_ * e * four(1 + 0x1p-40);
        const Doubles error = unit * d_norm + by * d_size_;
        const Doubles t_error = unit * e + by * e;

        const Doubles has_det = _mm256_cmp_pd(det, error, _CMP_GT_OQ);
        const Doubles beside = _mm256_cmp_pd(inside, _mm256_xor_pd(error, four(-0.0)), _CMP_LT_OQ);
        const Doubles behind = _mm256_cmp_pd(T, _mm256_xor_pd(t_error, four(-0.0)), _CMP_LT_OQ);
        const unsigned missed = bits_of(_mm256_and_pd(has_det, _mm256_or_pd(beside, behind)));
        unsigned rest = ~missed & ((1U << leaf.count) - 1);
        if (rest == 0) return {0, 0};
        const Doubles within = _mm256_cmp_pd(inside, error, _CMP_GT_OQ);
        const Doubles ahead = _mm256_cmp_pd(T, four(0x1p28) * t_error, _CMP_GT_OQ);
        const unsigned hit = rest & bits_of(_mm256_and_pd(has_det, _mm256_and_pd(within, ahead)));
        const Doubles quotient = T / det;
        _mm256_store_pd(t.data(), quotient);
        return {hit & bits_of(_mm256_cmp_pd(quotient, four(until), _CMP_LE_OQ)), rest & ~hit};
    }

  private:
    KERNEL_INLINE static Vectors3 corner(const Leaf& leaf, std::size_t i) {
        const double* const numbers = reinterpret_cast<const double*>(&leaf) + 12 * i;
        return {_mm256_load_pd(numbers), _mm256_load_pd(numbers + 4), _mm256_load_pd(numbers + 8)};
    }

    Vectors3 origin_;
    Vectors3 d_;
    Doubles d_size_;
    Doubles uncertainty_;
};

struct Avx2 {
    using Boxes = Avx2Boxes;
    using Triangles = Avx2Triangles;
};

}  // namespace

bool walk_avx2(const Tree& tree, const kernel::Ray<double>& ray, double uncertainty, double until, Visitor& visitor) {
    return walk_with<Avx2>(tree, ray, uncertainty, until, visitor);
}

}  // namespace reference::render
#endif
