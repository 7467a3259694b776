#include "reference/kernel/self_test.h"

#include <cmath>
#include <limits>

#include "reference/kernel/cylinder.h"
#include "reference/kernel/sphere.h"
#include "reference/kernel/triangle.h"
#include "reference/numbers/splitmix.h"

namespace reference::kernel {
namespace {

/// x, hidden from the compiler.
double unknown(double x) {
    volatile double kept = x;
    return kept;
}

bool rounds_to_nearest() {
    const double one = unknown(1), little = unknown(0x1p-60);
    return one + little == 1 && one - little == 1 && -one - little == -1;
}

bool keeps_subnormals() {
    const double smallest = unknown(std::numeric_limits<double>::min());
    const double half = smallest / unknown(2);
    return half > 0 && half + half == smallest &&
           unknown(std::numeric_limits<double>::denorm_min()) * unknown(0x1p60) > 0;
}

/// Knuth's two-sum finds the rounding error of a sum, unless terms are reordered.
bool keeps_the_order_of_sums() {
    const double a = unknown(1), b = unknown(0x1p-60);
    const double total = a + b;
    const double of_b = total - a;
    return (a - (total - of_b)) + (b - of_b) == 0x1p-60;
}

/// Each quotient is the double nearest to the true one: its remainder is at most half a unit.
bool divides_exactly() {
    const double divisor = unknown(49);
    bool all = true;
    for (int i = 1; i <= 50; ++i) {
        const double quotient = i / divisor;
        const double half = std::ldexp(0.5, std::ilogb(quotient) - 52);
        all = all && std::abs(std::fma(-quotient, divisor, i)) <= half * divisor;
    }
    return all;
}

/// From -size to size.
int whole(std::uint64_t& state, int size) {
    return static_cast<int>(next_random_bits(state) % static_cast<std::uint64_t>(2 * size + 1)) - size;
}

/// Whole coordinates, so that sums and differences of points are exact.
Vec3<double> point(std::uint64_t& state, int size) {
    const int x = whole(state, size), y = whole(state, size), z = whole(state, size);
    return {x, y, z};
}

}  // namespace

NarrowCase narrow_case(std::uint64_t seed) {
    std::uint64_t state = seed;
    const double unit = std::ldexp(1.0, whole(state, 40));
    const int steps = 1 + std::abs(whole(state, 1000));
    const Vec3<double> start = point(state, 100000), A = point(state, 100000), edge = point(state, 30000);
    // A point of the edge from A to B, or one step off it: the ray passes through it at t = 1.
    const int share = 1 + std::abs(whole(state, 6));
    const Vec3<double> beside = point(state, steps % 3 == 0 ? 1 : 0);
    const Vec3<double> direction = A + scaled(edge, static_cast<double>(share)) + beside - start;
    // The ray is nearest to the sphere's center at t = 1, at a distance that equals its radius up to a double's last
    // place.
    const Vec3<double> across(direction.y, -direction.x, 0);
    const double radius = length(across) * (1 + whole(state, 1) * std::numeric_limits<double>::epsilon());
    const Vec3<double> third = point(state, 100000);
    // Seen from above, the ray is nearest to the axis at t = 1, likewise; a cap is at the ray's height there, or a step
    // off.
    const Vec3<double> aside(direction.z, 0, -direction.x);
    const double thickness = length(aside) * (1 + whole(state, 1) * std::numeric_limits<double>::epsilon());
    const double height = 2 + 2 * std::abs(whole(state, 1000));
    Vec3<double> center = start + direction + aside;
    center.y += (steps % 2 == 0 ? 0.5 : -0.5) * height + whole(state, 1);
    return {{scaled(start, unit), scaled(direction, unit)},
            {scaled(start + direction + across, unit), (radius > 0 ? radius : 1) * unit},
            {scaled(A, unit), scaled(A + scaled(edge, 7.0), unit), scaled(third, unit)},
            {scaled(center, unit), (thickness > 0 ? thickness : 1) * unit, height * unit}};
}

std::uint64_t hash_of_decisions(std::uint64_t cases) {
    std::uint64_t hash = no_decision;
    for (std::uint64_t seed = 0; seed < cases; ++seed) {
        const auto [ray, sphere, triangle, cylinder] = narrow_case(seed);
        hash = hashed(hash, static_cast<int>(decide(ray, sphere)));
        hash = hashed(hash, static_cast<int>(decide(ray, triangle)));
        const CylinderHit hit = intersect(ray, cylinder);
        hash = hashed(hashed(hash, static_cast<int>(hit.result)), static_cast<int>(hit.part));
    }
    return hash;
}

std::string arithmetic_trouble() {
    if (!rounds_to_nearest()) return "Doubles are not rounded to nearest: another rounding mode is set.";
    if (!keeps_subnormals()) {
        return "The smallest doubles become zero: something that was compiled with -ffast-math is linked or loaded.";
    }
    if (!keeps_the_order_of_sums() || !divides_exactly())
        return "Sums or quotients are not computed as written: compile raygrade without -ffast-math and its parts.";
    if (hash_of_decisions(self_test_cases) != self_test_hash)
        return "Known decisions come out wrong: this program is damaged, or was compiled with flags it can't bear.";
    return "";
}

}  // namespace reference::kernel
