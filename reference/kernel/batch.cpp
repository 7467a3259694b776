#include "reference/kernel/batch.h"

#include <cstdint>

#include "reference/kernel/sphere.h"
#include "reference/kernel/triangle.h"

// The clone for the machine's vector length is chosen when the program starts. No clone may fuse a * b + c (the build
// says -ffp-contract=off), so that all give the same bits.
#if defined(__x86_64__) && __has_attribute(target_clones) && !defined(__SANITIZE_ADDRESS__)
#define EVERY_VECTOR_LENGTH __attribute__((target_clones("avx2", "default")))
#else
#define EVERY_VECTOR_LENGTH
#endif

namespace reference::kernel {
namespace {

constexpr std::size_t block_size = 128;

/// What the filter says about a block of rays: 1 or 0. The words are as long as a double, so that comparisons stay in
/// vector registers.
struct Block {
    std::array<std::int64_t, block_size> known;
    std::array<std::int64_t, block_size> hit;
};

enum class With { decision, t };

template <With with>
KERNEL_INLINE bool is_known(const SphereFilter& filter) {
    return filter.is_known(with == With::t ? SphereFilter::margin_for_t : 1);
}
template <With with>
KERNEL_INLINE bool is_known(const TriangleFilter& filter) {
    return with == With::t ? filter.is_known_with_t() : filter.is_known();
}
KERNEL_INLINE double t_of(const SphereFilter& filter) {
    return filter.root();
}
KERNEL_INLINE double t_of(const TriangleFilter& filter) {
    return filter.t();
}

/// Also writes t for each ray of the block.
template <With with, class Filter, class T, class Object>
KERNEL_INLINE void filter_block(const Rays<T>& rays, std::size_t from, std::size_t size, const Object& object,
                                Block& __restrict block, double* __restrict t) {
    const T* const ox = rays.origin[0].data() + from;
    const T* const oy = rays.origin[1].data() + from;
    const T* const oz = rays.origin[2].data() + from;
    const T* const dx = rays.direction[0].data() + from;
    const T* const dy = rays.direction[1].data() + from;
    const T* const dz = rays.direction[2].data() + from;
    for (std::size_t i = 0; i < size; ++i) {
        const Filter filter(Ray<T>{Vec3<T>(ox[i], oy[i], oz[i]), Vec3<T>(dx[i], dy[i], dz[i])}, object);
        block.known[i] = is_known<with>(filter) ? 1 : 0;
        block.hit[i] = filter.is_hit() ? 1 : 0;
        if constexpr (with == With::t) t[i] = filter.is_hit() ? t_of(filter) : 0;
    }
}

template <class T>
void settle(const Ray<T>& ray, const auto& object, auto& result) {
    result = decide(ray, object);
}
template <class T>
void settle(const Ray<T>& ray, const auto& object, auto& result, double& t) {
    const auto hit = intersect_to_float(ray, object);
    result = hit.result;
    t = hit.t;
}

template <With with, class Filter, class T, class Object, class Result>
KERNEL_INLINE void by_blocks(const Rays<T>& rays, const Object& object, Result* results, double* t) {
    for (std::size_t from = 0; from < rays.size(); from += block_size) {
        const std::size_t size = std::min(block_size, rays.size() - from);
        Block block;
        filter_block<with, Filter>(rays, from, size, object, block, with == With::t ? t + from : nullptr);
        std::int64_t all_known = 1;
        for (std::size_t i = 0; i < size; ++i) all_known &= block.known[i];
        for (std::size_t i = 0; i < size; ++i) results[from + i] = block.hit[i] != 0 ? Result::hit : Result::miss;
        if (all_known != 0) continue;
        for (std::size_t i = 0; i < size; ++i) {
            if (block.known[i] != 0) continue;
            if constexpr (with == With::t) {
                settle(rays[from + i], object, results[from + i], t[from + i]);
            } else {
                settle(rays[from + i], object, results[from + i]);
            }
        }
    }
}

}  // namespace

EVERY_VECTOR_LENGTH void decide(const Rays<float>& rays, const Sphere<float>& sphere, std::span<SphereResult> results) {
    by_blocks<With::decision, SphereFilter>(rays, sphere, results.data(), nullptr);
}
EVERY_VECTOR_LENGTH void decide(const Rays<double>& rays, const Sphere<double>& sphere,
                                std::span<SphereResult> results) {
    by_blocks<With::decision, SphereFilter>(rays, sphere, results.data(), nullptr);
}
EVERY_VECTOR_LENGTH void decide(const Rays<float>& rays, const Triangle<float>& triangle,
                                std::span<TriangleResult> results) {
    by_blocks<With::decision, TriangleFilter>(rays, PreparedTriangle(triangle), results.data(), nullptr);
}
EVERY_VECTOR_LENGTH void decide(const Rays<double>& rays, const Triangle<double>& triangle,
                                std::span<TriangleResult> results) {
    by_blocks<With::decision, TriangleFilter>(rays, PreparedTriangle(triangle), results.data(), nullptr);
}

EVERY_VECTOR_LENGTH void intersect_to_float(const Rays<float>& rays, const Sphere<float>& sphere,
                                            std::span<SphereResult> results, std::span<double> t) {
    by_blocks<With::t, SphereFilter>(rays, sphere, results.data(), t.data());
}
EVERY_VECTOR_LENGTH void intersect_to_float(const Rays<double>& rays, const Sphere<double>& sphere,
                                            std::span<SphereResult> results, std::span<double> t) {
    by_blocks<With::t, SphereFilter>(rays, sphere, results.data(), t.data());
}
EVERY_VECTOR_LENGTH void intersect_to_float(const Rays<float>& rays, const Triangle<float>& triangle,
                                            std::span<TriangleResult> results, std::span<double> t) {
    by_blocks<With::t, TriangleFilter>(rays, PreparedTriangle(triangle), results.data(), t.data());
}
EVERY_VECTOR_LENGTH void intersect_to_float(const Rays<double>& rays, const Triangle<double>& triangle,
                                            std::span<TriangleResult> results, std::span<double> t) {
    by_blocks<With::t, TriangleFilter>(rays, PreparedTriangle(triangle), results.data(), t.data());
}

}  // namespace reference::kernel
