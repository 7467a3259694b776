#include "reference/key/allowance.h"

#include <algorithm>

#include "reference/numbers/affine.h"
#include "reference/stages/formulations.h"

namespace reference {
namespace {

using Range = Interval<double>;

bool is_bounded(const std::vector<Range>& ranges) {
    return std::all_of(ranges.begin(), ranges.end(), [](const Range& x) { return x.is_bounded(); });
}

/// Collects, item by item, the hull of the bounded formulations. A formulation that may divide by zero on this scene
/// does not count as correct here, as long as a different formulation is bounded. The hull is the whole line where none
/// is bounded.
class Hulls {
  public:
    template <class Value>
    void add(const ItemId& id, const Value& formulation) {
        std::vector<Range> ranges;
        for (const auto& x : components(formulation)) ranges.push_back(x.range());
        std::vector<Range>& known = hulls_[id];
        if (known.empty() || !is_bounded(known)) {
            known = ranges;
        } else if (is_bounded(ranges)) {
            for (std::size_t i = 0; i < ranges.size(); ++i) known[i] = hull(known[i], ranges[i]);
        }
    }
    const std::map<ItemId, std::vector<Range>>& all() const { return hulls_; }

  private:
    std::map<ItemId, std::vector<Range>> hulls_;
};

/// x as a program reads it: rounded to T.
template <class T>
Affine<T> read_number(const Rational& x, Roundings& roundings) {
    const Enclosure doubles = enclose(x);
    const auto lo = static_cast<T>(doubles.lo);
    const auto hi = static_cast<T>(doubles.hi);
    if (doubles.lo == doubles.hi && static_cast<double>(lo) == doubles.lo) return {Range(doubles.lo), roundings};
    const Interval<T> around = Interval<T>::widened(lo, hi);
    return {Range(static_cast<double>(around.lo()), static_cast<double>(around.hi())), roundings};
}

/// The hull of the bounded ways to compute a number, as a new number.
template <class S>
S any_of(const std::vector<S>& formulations, Roundings& roundings) {
    Hulls hulls;
    for (const S& formulation : formulations) hulls.add({}, formulation);
    return S(hulls.all().begin()->second.front(), roundings);
}

template <class S>
Vec3<S> P_VCS_of(const Window<S>& window, const Pixel& pixel, PixelConvention convention, Roundings& roundings) {
    const auto coordinate = [&](const S& from, const S& to, int index, int count) {
        const bool grid = convention == PixelConvention::grid;
        if (grid && count == 1) return any_of(window_coordinates(from, to, 0, 1, 1), roundings);
        const int halves = convention == PixelConvention::centre ? 1 : 0;
        return any_of(window_coordinates(from, to, index, grid ? count - 1 : count, halves), roundings);
    };
    return {coordinate(window.clip_left, window.clip_right, pixel.x, window.width),
            coordinate(window.clip_bottom, window.clip_top, pixel.y, window.height), -window.clip_near};
}

/// The ways in which a program may answer questions 1 to 5 once it has a basis: one for each way to answer question 4.
template <class S>
std::vector<CameraAnswers<S>> camera_ways(const Vec3<S>& p, const Basis<S>& basis, const Vec3<S>& eye) {
    std::vector<CameraAnswers<S>> ways;
    for (const Mat4<S>& M : inverse_views(basis, eye)) {
        const Vec3<S> P_WCS = pixel_to_wcs(M, p);
        ways.push_back({p, basis, M, P_WCS, unit_vector(Vec3<S>(P_WCS - eye))});
    }
    const Vec3<S> step = scaled(basis.X_vcs, p.x) + scaled(basis.Y_vcs, p.y) + scaled(basis.Z_vcs, p.z);
    ways.push_back({p, basis, vcs_to_wcs(basis, eye), eye + step, unit_vector(step)});
    return ways;
}

template <class S>
void add_camera(Hulls& hulls, const CameraAnswers<S>& ray) {
    const Mat4<S>& M = ray.M_VCS_to_WCS;
    hulls.add(item::P_VCS, ray.P_VCS);
    hulls.add(item::X_vcs, ray.basis.X_vcs);
    hulls.add(item::Y_vcs, ray.basis.Y_vcs);
    hulls.add(item::Z_vcs, ray.basis.Z_vcs);
    // The axes as columns of an inverted view matrix.
    hulls.add(item::X_vcs, Vec3<S>(M[0]));
    hulls.add(item::Y_vcs, Vec3<S>(M[1]));
    hulls.add(item::Z_vcs, Vec3<S>(M[2]));
    hulls.add(item::M_VCS_to_WCS, M);
    hulls.add(item::P_WCS, ray.P_WCS);
    hulls.add(item::V, ray.V);
}

template <class S>
void add_sphere(Hulls& hulls, const CameraAnswers<S>& ray, const Sphere<S>& sphere, RootChoice choice) {
    const Quadratic<S> quadratic = sphere_quadratic(ray.P_WCS, ray.V, sphere);
    const S half_b = dot(ray.V, Vec3<S>(ray.P_WCS - sphere.center));
    hulls.add(item::sphere::a, quadratic.a);
    hulls.add(item::sphere::b, quadratic.b);
    hulls.add(item::sphere::c, quadratic.c);
    hulls.add(item::sphere::d, quadratic.d);
    hulls.add(item::sphere::d, S(4) * (half_b * half_b - quadratic.a * quadratic.c));
    if (choice != RootChoice::smaller && choice != RootChoice::larger) return;
    for (const S& t : sphere_roots(quadratic, choice)) {
        const Vec3<S> hit = point_on_ray(ray.P_WCS, ray.V, t);
        const Vec3<S> outward = hit - sphere.center;
        hulls.add(item::sphere::t, t);
        hulls.add(item::sphere::hit, hit);
        hulls.add(item::sphere::normal, unit_vector(outward));
        hulls.add(item::sphere::normal, scaled(outward, S(S(1) / sphere.radius)));
    }
}

template <class S>
void add_triangle(Hulls& hulls, const CameraAnswers<S>& ray, const Triangle<S>& triangle, bool has_solution) {
    const LinearSystem<S> system = triangle_system(ray.P_WCS, ray.V, triangle);
    const Vec3<S> normal = unit_vector(cross(system.matrix[1], system.matrix[2]));
    hulls.add(item::triangle::matrix, system.matrix);
    hulls.add(item::triangle::rhs, system.rhs);
    hulls.add(item::triangle::normal, normal);
    if (!has_solution) return;
    for (const Vec3<S>& solution : triangle_solutions(system)) {
        hulls.add(item::triangle::t, solution.x);
        hulls.add(item::triangle::u, solution.y);
        hulls.add(item::triangle::v, solution.z);
        hulls.add(item::triangle::hit, point_on_ray(ray.P_WCS, ray.V, solution.x));
        hulls.add(item::triangle::hit,
                  triangle.A + scaled(system.matrix[1], solution.y) + scaled(system.matrix[2], solution.z));
    }
    const S t = plane_distance(system, normal);
    hulls.add(item::triangle::t, t);
    hulls.add(item::triangle::hit, point_on_ray(ray.P_WCS, ray.V, t));
}

template <class T>
Hulls hulls_in(const Scene<Rational>& exact, PixelConvention convention, const Branches& branches) {
    using S = Affine<T>;
    Roundings roundings;
    const Scene<S> scene = convert_scene<S>(exact, [&](const Rational& x) { return read_number<T>(x, roundings); });
    const Vec3<S> p = P_VCS_of(scene.window, scene.pixel, convention, roundings);
    const std::vector<Basis<S>> all_bases = bases(scene.camera);
    const std::size_t before_ways = roundings.count();
    Hulls hulls;
    for (const Basis<S>& basis : all_bases) {
        roundings.restart_at(before_ways);
        const std::vector<CameraAnswers<S>> ways = camera_ways(p, basis, scene.camera.eye);
        const std::size_t before_objects = roundings.count();
        for (const CameraAnswers<S>& ray : ways) {
            roundings.restart_at(before_objects);
            add_camera(hulls, ray);
            if (!scene.spheres.empty()) add_sphere(hulls, ray, scene.spheres.at(branches.sphere_index), branches.root);
            if (scene.triangles.empty()) continue;
            add_triangle(hulls, ray, scene.triangles.at(branches.triangle_index), branches.triangle_has_solution);
        }
    }
    return hulls;
}

ItemBounds as_bounds(const std::vector<Range>& ranges, Arithmetic arithmetic) {
    ItemBounds result{{}, {}, arithmetic};
    for (const Range& range : ranges) {
        result.lo.push_back(range.lo());
        result.hi.push_back(range.hi());
    }
    return result;
}

}  // namespace

std::string_view to_string(Arithmetic arithmetic) {
    switch (arithmetic) {
        case Arithmetic::float_: return "float";
        case Arithmetic::double_: return "double";
        case Arithmetic::none: return "none";
    }
    return "";
}

std::map<ItemId, ItemBounds> bounds_of_correct_programs(const Scene<Rational>& scene, PixelConvention convention,
                                                        const Branches& branches) {
    const Hulls floats = hulls_in<float>(scene, convention, branches);
    std::map<ItemId, ItemBounds> result;
    bool all_bounded = true;
    for (const auto& [id, ranges] : floats.all()) {
        all_bounded = all_bounded && is_bounded(ranges);
        result[id] = as_bounds(ranges, is_bounded(ranges) ? Arithmetic::float_ : Arithmetic::none);
    }
    if (all_bounded) return result;
    const Hulls doubles = hulls_in<double>(scene, convention, branches);
    for (const auto& [id, ranges] : doubles.all()) {
        const bool better = result.at(id).arithmetic == Arithmetic::none && is_bounded(ranges);
        if (better) result[id] = as_bounds(ranges, Arithmetic::double_);
    }
    return result;
}

}  // namespace reference
