#include "reference/allowance.h"

#include "reference/formulations.h"
#include "reference/interval.h"

namespace reference {
namespace {

/// Keyed as ItemValues; without verdicts and values that do not exist.
template <class T>
using Bounds = std::map<ItemId, std::vector<Interval<T>>>;

/// x rounded as a program reads it: the nearest T, or either neighbour of the number written.
template <class T>
Interval<T> rounded(const Rational& x) {
    const Enclosure doubles = enclose(x);
    const auto lo = static_cast<T>(doubles.lo);
    const auto hi = static_cast<T>(doubles.hi);
    return doubles.lo == doubles.hi && static_cast<double>(lo) == doubles.lo ? Interval<T>(lo)
                                                                             : Interval<T>::widened(lo, hi);
}

template <class T>
bool is_bounded(const std::vector<Interval<T>>& numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](const Interval<T>& x) { return x.is_bounded(); });
}

/// The hull of those formulations that are bounded here: one that may divide by zero on this scene is not held correct
/// on it while another is. The whole line in every component when none is bounded.
template <class T, class Value>
std::vector<Interval<T>> hull_of(const std::vector<Value>& formulations) {
    std::vector<Interval<T>> result;
    for (const Value& formulation : formulations) {
        const std::vector<Interval<T>> numbers = components(formulation);
        if (!is_bounded(numbers)) continue;
        if (result.empty()) result = numbers;
        for (std::size_t i = 0; i < numbers.size(); ++i) result[i] = hull(result[i], numbers[i]);
    }
    if (result.empty()) result.assign(components(formulations.front()).size(), Interval<T>::whole());
    return result;
}

template <class T>
Interval<T> scalar_hull(const std::vector<Interval<T>>& formulations) {
    return hull_of<T>(formulations).front();
}

template <class T>
Vec3<Interval<T>> vector_hull(const std::vector<Vec3<Interval<T>>>& formulations) {
    const std::vector<Interval<T>> hulls = hull_of<T>(formulations);
    return {hulls[0], hulls[1], hulls[2]};
}

template <class T>
Vec3<Interval<T>> P_VCS_hull(const Window<Interval<T>>& window, const Pixel& pixel, PixelConvention convention) {
    const int halves = convention == PixelConvention::centre ? 1 : 0;
    const auto coordinate = [&](const Interval<T>& from, const Interval<T>& to, int index, int count) {
        const bool one_point = convention == PixelConvention::grid && count == 1;
        if (one_point) return scalar_hull<T>(window_coordinates(from, to, 0, 1, 1));
        const int steps = convention == PixelConvention::grid ? count - 1 : count;
        return scalar_hull<T>(window_coordinates(from, to, index, steps, halves));
    };
    return {coordinate(window.clip_left, window.clip_right, pixel.x, window.width),
            coordinate(window.clip_bottom, window.clip_top, pixel.y, window.height), -window.clip_near};
}

template <class T>
CameraAnswers<Interval<T>> camera_hull(const Scene<Interval<T>>& scene, PixelConvention convention) {
    using S = Interval<T>;
    const Vec3<S>& eye = scene.camera.eye;
    CameraAnswers<S> hulls;
    hulls.P_VCS = P_VCS_hull<T>(scene.window, scene.pixel, convention);
    std::vector<Vec3<S>> X;
    std::vector<Vec3<S>> Y;
    std::vector<Vec3<S>> Z;
    for (const Basis<S>& basis : bases(scene.camera)) {
        X.push_back(basis.X_vcs);
        Y.push_back(basis.Y_vcs);
        Z.push_back(basis.Z_vcs);
    }
    hulls.basis = {vector_hull<T>(X), vector_hull<T>(Y), vector_hull<T>(Z)};
    const std::vector<Mat4<S>> matrices = inverse_views(hulls.basis, eye);
    const std::vector<S> M = hull_of<T>(matrices);
    const Vec3<S>& p = hulls.P_VCS;
    const Vec3<S> step =
        scaled(hulls.basis.X_vcs, p.x) + scaled(hulls.basis.Y_vcs, p.y) + scaled(hulls.basis.Z_vcs, p.z);
    std::vector<Vec3<S>> points{eye + step};
    for (const Mat4<S>& matrix : matrices) points.push_back(pixel_to_wcs(matrix, p));
    for (int i = 0; i < 16; ++i) hulls.M_VCS_to_WCS[i / 4][i % 4] = M[static_cast<std::size_t>(i)];
    hulls.P_WCS = vector_hull<T>(points);
    std::vector<Vec3<S>> directions = unit_vectors(step);
    for (const Vec3<S>& V : unit_vectors(Vec3<S>(hulls.P_WCS - eye))) directions.push_back(V);
    hulls.V = vector_hull<T>(directions);
    return hulls;
}

template <class T>
void add_sphere(Bounds<T>& bounds, const CameraAnswers<Interval<T>>& ray, const Sphere<Interval<T>>& sphere,
                RootChoice choice) {
    using S = Interval<T>;
    const Quadratic<S> quadratic = sphere_quadratic(ray.P_WCS, ray.V, sphere);
    const S half_b = dot(ray.V, Vec3<S>(ray.P_WCS - sphere.center));
    bounds[{6, "a"}] = {quadratic.a};
    bounds[{6, "b"}] = {quadratic.b};
    bounds[{6, "c"}] = {quadratic.c};
    bounds[{6, "d"}] = {scalar_hull<T>({quadratic.d, S(4) * (half_b * half_b - quadratic.a * quadratic.c)})};
    if (choice != RootChoice::smaller && choice != RootChoice::larger) return;
    const S t = scalar_hull<T>(sphere_roots(quadratic, choice));
    const Vec3<S> hit = point_on_ray(ray.P_WCS, ray.V, t);
    std::vector<Vec3<S>> normals = unit_vectors(Vec3<S>(hit - sphere.center));
    normals.push_back(scaled(Vec3<S>(hit - sphere.center), S(S(1) / sphere.radius)));
    bounds[{6, "t"}] = {t};
    bounds[{6, "hit"}] = components(hit);
    bounds[{7, "normal"}] = hull_of<T>(normals);
}

template <class T>
void add_triangle(Bounds<T>& bounds, const CameraAnswers<Interval<T>>& ray, const Triangle<Interval<T>>& triangle,
                  bool has_solution) {
    using S = Interval<T>;
    const LinearSystem<S> system = triangle_system(ray.P_WCS, ray.V, triangle);
    const Vec3<S> normal = vector_hull<T>(unit_vectors(cross(system.matrix[1], system.matrix[2])));
    bounds[{8, "matrix"}] = components(system.matrix);
    bounds[{8, "rhs"}] = components(system.rhs);
    bounds[{9, "normal"}] = components(normal);
    if (!has_solution) return;
    const Vec3<S> solution = vector_hull<T>(triangle_solutions(system));
    const S t = scalar_hull<T>({solution.x, plane_distance(system, normal)});
    const Vec3<S> in_triangle =
        triangle.A + scaled(system.matrix[1], solution.y) + scaled(system.matrix[2], solution.z);
    bounds[{8, "t"}] = {t};
    bounds[{8, "u"}] = {solution.y};
    bounds[{8, "v"}] = {solution.z};
    bounds[{8, "hit"}] = hull_of<T>(std::vector<Vec3<S>>{point_on_ray(ray.P_WCS, ray.V, t), in_triangle});
}

template <class T>
Bounds<T> bounds_in(const Scene<Rational>& exact, PixelConvention convention, const Branches& branches) {
    const Scene<Interval<T>> scene = convert_scene<Interval<T>>(exact, [](const Rational& x) { return rounded<T>(x); });
    const CameraAnswers<Interval<T>> ray = camera_hull(scene, convention);
    Bounds<T> bounds{{{1, "P_VCS"}, components(ray.P_VCS)},
                     {{2, "X_vcs"}, components(ray.basis.X_vcs)},
                     {{2, "Y_vcs"}, components(ray.basis.Y_vcs)},
                     {{2, "Z_vcs"}, components(ray.basis.Z_vcs)},
                     {{3, "M_VCS_to_WCS"}, components(ray.M_VCS_to_WCS)},
                     {{4, "P_WCS"}, components(ray.P_WCS)},
                     {{5, "V"}, components(ray.V)}};
    if (!scene.spheres.empty()) add_sphere(bounds, ray, scene.spheres.at(branches.sphere_index), branches.root);
    if (!scene.triangles.empty()) {
        add_triangle(bounds, ray, scene.triangles.at(branches.triangle_index), branches.triangle_has_solution);
    }
    return bounds;
}

template <class T>
ItemBounds as_doubles(const std::vector<Interval<T>>& numbers, Arithmetic arithmetic) {
    ItemBounds result{{}, {}, arithmetic};
    for (const Interval<T>& x : numbers) {
        result.lo.push_back(static_cast<double>(x.lo()));
        result.hi.push_back(static_cast<double>(x.hi()));
    }
    return result;
}

}  // namespace

std::string_view to_string(Arithmetic arithmetic) {
    switch (arithmetic) {
        case Arithmetic::float_:
            return "float";
        case Arithmetic::double_:
            return "double";
        case Arithmetic::none:
            return "none";
    }
    return "";
}

std::map<ItemId, ItemBounds> bounds_of_correct_programs(const Scene<Rational>& scene, PixelConvention convention,
                                                        const Branches& branches) {
    const Bounds<float> floats = bounds_in<float>(scene, convention, branches);
    const Bounds<double> doubles = bounds_in<double>(scene, convention, branches);
    std::map<ItemId, ItemBounds> result;
    for (const auto& [id, numbers] : floats) {
        const std::vector<Interval<double>>& finer = doubles.at(id);
        if (is_bounded(numbers)) {
            result[id] = as_doubles(numbers, Arithmetic::float_);
        } else if (is_bounded(finer)) {
            result[id] = as_doubles(finer, Arithmetic::double_);
        } else {
            result[id] = as_doubles(finer, Arithmetic::none);
        }
    }
    return result;
}

}  // namespace reference
