// embree_bench [ROUNDS]: one triangle and one sphere, many float rays, one at a time: the certified kernel beside
// Embree's own intersection of a scene of one primitive, which includes its walk to it. Both give t.
#include <cstdlib>

#include "reference/accuracy/methods/block_methods.h"
#include "reference/kernel/sphere.h"
#include "reference/kernel/triangle.h"
#include "tests/bench/contest.h"
#include "tests/bench/embree.h"

using namespace reference;

namespace {

constexpr std::uint64_t ray_count = 8192;

template <template <class> class Problem>
std::vector<kernel::Ray<float>> floats_of(const accuracy::BlockRays<Problem>& rays) {
    std::vector<kernel::Ray<float>> floats;
    for (const auto& problem : rays.problems) floats.push_back(as_floats(problem).ray);
    return floats;
}

std::size_t certified(const std::vector<kernel::Ray<float>>& rays, const auto& object, auto hit) {
    std::size_t count = 0;
    for (const auto& ray : rays) {
        const auto found = kernel::intersect_to_float(ray, object);
        accuracy::keep(found);
        count += found.result == hit ? 1 : 0;
    }
    return count;
}

}  // namespace

int main(int argc, char** argv) {
    const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 51;
    const auto at_triangle = accuracy::rays_at_a_triangle(1, ray_count);
    const auto at_sphere = accuracy::rays_at_a_sphere(1, ray_count);
    const Triangle<float> triangle = as_floats(at_triangle.problems.front()).triangle;
    const Sphere<float> sphere = as_floats(at_sphere.problems.front()).sphere;
    const kernel::PreparedTriangle<float> prepared(triangle);
    const auto triangle_rays = floats_of(at_triangle);
    const auto sphere_rays = floats_of(at_sphere);
    const std::vector<Embree::Point> corners{triangle.A, triangle.B, triangle.C};
    const Embree fast(corners, {{0, 1, 2}}, RTC_SCENE_FLAG_NONE);
    const Embree robust(corners, {{0, 1, 2}}, RTC_SCENE_FLAG_ROBUST);
    const Embree fast_sphere(sphere, RTC_SCENE_FLAG_NONE);
    const Embree robust_sphere(sphere, RTC_SCENE_FLAG_ROBUST);
    std::vector<Contestant> triangles{
        {"certified with t", [&] { return certified(triangle_rays, prepared, kernel::TriangleResult::hit); }},
        {"Embree, fast", [&] { return fast.hits(triangle_rays); }},
        {"Embree, robust", [&] { return robust.hits(triangle_rays); }}};
    std::vector<Contestant> spheres{
        {"certified with t", [&] { return certified(sphere_rays, sphere, kernel::SphereResult::hit); }},
        {"Embree, fast", [&] { return fast_sphere.hits(sphere_rays); }},
        {"Embree, robust", [&] { return robust_sphere.hits(sphere_rays); }}};
    contest(triangles, rounds);
    contest(spheres, rounds);
    print_contest("one triangle", triangles, ray_count);
    print_contest("one sphere", spheres, ray_count);
}
