// cgal_bench [ROUNDS]: the certified kernel's decisions beside CGAL's predicates, filtered (EPICK) and with exact
// constructions (EPECK). One triangle, one sphere, and rays in doubles, all made beforehand.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <cstdlib>

#include "reference/accuracy/methods/block_methods.h"
#include "reference/kernel/sphere.h"
#include "reference/kernel/triangle.h"
#include "tests/bench/contest.h"

using namespace reference;

namespace {

constexpr std::uint64_t ray_count = 8192;

template <class K>
typename K::Point_3 point(const Vec3<double>& p) {
    return {p.x, p.y, p.z};
}

template <class K, template <class> class Problem>
std::vector<typename K::Ray_3> rays_of(const accuracy::BlockRays<Problem>& rays) {
    std::vector<typename K::Ray_3> made;
    for (const auto& problem : rays.problems) {
        const Vec3<double>& d = problem.ray.direction;
        made.emplace_back(point<K>(problem.ray.origin), typename K::Vector_3(d.x, d.y, d.z));
    }
    return made;
}

template <class Rays, class Object>
std::size_t cgal_hits(const Rays& rays, const Object& object) {
    std::size_t count = 0;
    for (const auto& ray : rays) count += CGAL::do_intersect(ray, object) ? 1 : 0;
    return count;
}

template <class Rays>
std::size_t certified_hits(const Rays& rays, const auto& object, auto hit) {
    std::size_t count = 0;
    for (const auto& problem : rays.problems) count += kernel::decide(problem.ray, object) == hit ? 1 : 0;
    return count;
}

}  // namespace

int main(int argc, char** argv) {
    using Filtered = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
    const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 15;
    const auto at_triangle = accuracy::rays_at_a_triangle(1, ray_count);
    const auto at_sphere = accuracy::rays_at_a_sphere(1, ray_count);
    const Triangle<double>& t = at_triangle.problems.front().triangle;
    const Sphere<double>& s = at_sphere.problems.front().sphere;
    const kernel::PreparedTriangle<double> prepared(t);
    const auto filtered_rays = rays_of<Filtered>(at_triangle);
    const auto exact_rays = rays_of<Exact>(at_triangle);
    const Filtered::Triangle_3 filtered(point<Filtered>(t.A), point<Filtered>(t.B), point<Filtered>(t.C));
    const Exact::Triangle_3 exact(point<Exact>(t.A), point<Exact>(t.B), point<Exact>(t.C));
    std::vector<Contestant> triangles{
        {"certified decision", [&] { return certified_hits(at_triangle, prepared, kernel::TriangleResult::hit); }},
        {"CGAL, EPICK", [&] { return cgal_hits(filtered_rays, filtered); }},
        {"CGAL, EPECK", [&] { return cgal_hits(exact_rays, exact); }}};
    contest(triangles, rounds);
    print_contest("one triangle", triangles, ray_count);
    const auto filtered_sphere_rays = rays_of<Filtered>(at_sphere);
    const auto exact_sphere_rays = rays_of<Exact>(at_sphere);
    // The radius is a float, so its square is exact.
    const Filtered::Sphere_3 filtered_sphere(point<Filtered>(s.center), s.radius * s.radius);
    const Exact::Sphere_3 exact_sphere(point<Exact>(s.center), s.radius * s.radius);
    std::vector<Contestant> spheres{
        {"certified decision", [&] { return certified_hits(at_sphere, s, kernel::SphereResult::hit); }},
        {"CGAL, EPICK", [&] { return cgal_hits(filtered_sphere_rays, filtered_sphere); }},
        {"CGAL, EPECK", [&] { return cgal_hits(exact_sphere_rays, exact_sphere); }}};
    contest(spheres, rounds);
    print_contest("one sphere", spheres, ray_count);
}
