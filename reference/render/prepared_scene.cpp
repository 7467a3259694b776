#include "reference/render/prepared_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reference/stages/scene_answers.h"
#include "reference/toml/assignment_error.h"

namespace reference::render {
namespace {

constexpr double largest = 1e30;
constexpr std::int64_t most_samples = std::int64_t{1} << 28U;

/// The scene in doubles. Fails for sizes that rendering does not accept.
Scene<double> scene_in_doubles(const Assignment& assignment) {
    const auto convert = [&](const Decimal& number) {
        const double x = number.to_double();
        if (std::abs(x) <= largest && (x == 0 || std::abs(x) >= 1 / largest)) return x;
        throw AssignmentError(fmt::format(
            "{}: {} can't be rendered: numbers must be 0 or between 1e-30 and 1e30 in size; scale the scene",
            assignment.name, number.text()));
    };
    return convert_scene<double>(assignment.scene, convert);
}

/// The positions of the samples along one axis of the window. One sample per pixel is at along_window(); n samples per
/// pixel are evenly spaced within one pixel's width around that point.
std::vector<double> sample_coordinates(double from, double to, int pixels, int samples_per_side,
                                       PixelConvention convention) {
    std::vector<double> result;
    const int n = samples_per_side;
    const bool on_grid = convention == PixelConvention::grid && pixels > 1;
    const bool in_middle =
        convention == PixelConvention::centre || (convention == PixelConvention::grid && pixels == 1);
    const int steps = on_grid ? pixels - 1 : pixels;
    for (int i = 0; i < pixels * n; ++i) {
        // Twice the numerator and denominator, as in along_window().
        const int numerator = 2 * i + 1 - (in_middle ? 0 : n);
        result.push_back(from + (to - from) * static_cast<double>(numerator) / static_cast<double>(2 * n * steps));
    }
    return result;
}

Eye eye_of(const Scene<double>& scene, PixelConvention convention, int samples_per_side) {
    const Window<double>& window = scene.window;
    const Basis<double> basis = view_basis(scene.camera);
    const Mat4<double> M = vcs_to_wcs(basis, scene.camera.eye);
    const auto corner = [&](double x, double y) { return pixel_to_wcs(M, Vec3<double>(x, y, -window.clip_near)); };
    const auto across = [&](int samples) {
        return sample_coordinates(window.clip_left, window.clip_right, window.width, samples, convention);
    };
    const auto up = [&](int samples) {
        return sample_coordinates(window.clip_bottom, window.clip_top, window.height, samples, convention);
    };
    return {basis,
            scene.camera.eye,
            across(1),
            up(1),
            across(samples_per_side),
            up(samples_per_side),
            -window.clip_near,
            {corner(window.clip_left, window.clip_bottom), corner(window.clip_right, window.clip_bottom),
             corner(window.clip_left, window.clip_top), corner(window.clip_right, window.clip_top)}};
}

Vec3<double> unit(const Vec3<double>& p) {
    const double size = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    return normalized(scaled(p, 1 / size));
}

/// The unit normal; empty if the triangle in doubles has no area. Computed exactly if rounding errors would dominate
/// it.
std::optional<Vec3<double>> unit_normal(const kernel::PreparedTriangle& triangle) {
    const double size = triangle.norm(triangle.normal);
    if (size > 0x1p-30 * triangle.edges * triangle.edges) return unit(triangle.normal);
    using kernel::Dyadic;
    const Triangle<Dyadic> exact = kernel::over<Dyadic>(triangle.triangle);
    const Vec3<Dyadic> normal = cross(Vec3<Dyadic>(exact.B - exact.A), Vec3<Dyadic>(exact.C - exact.A));
    const auto rounded = [](const Dyadic& x) { return kernel::nearest(Fraction<Dyadic>{x, Dyadic(1)}); };
    const Vec3<double> n(rounded(normal.x), rounded(normal.y), rounded(normal.z));
    return n == Vec3<double>(0, 0, 0) ? std::nullopt : std::optional(unit(n));
}

/// The surface of the i-th object of a kind: that of its material, or 0 if it has none or is beyond the list's end.
std::uint32_t surface_index(const Appearance& appearance, Subject kind, std::size_t i) {
    const auto materials = appearance.object_materials.find(kind);
    const bool is_listed = materials != appearance.object_materials.end() && i < materials->second.size();
    return is_listed && materials->second[i] ? static_cast<std::uint32_t>(*materials->second[i] + 1) : 0;
}

/// The share that is neither mirrored nor transmitted. The shares are rounded to doubles: a smaller rest counts as
/// nothing.
double own_share_of(const Material& material) {
    const double share = 1 - material.reflectivity - material.transparency;
    return share > 0x1p-52 ? share : 0;
}

std::vector<Surface> surfaces_of(const Appearance& appearance) {
    std::vector<Surface> surfaces(1);
    const bool has_light = !appearance.point_lights.empty() || !appearance.directional_lights.empty() ||
                           appearance.ambient_light != Color(0, 0, 0);
    for (const Material& material : appearance.materials) {
        surfaces.push_back({material, has_light, own_share_of(material)});
    }
    return surfaces;
}

void add_lights(const Appearance& appearance, PreparedScene& prepared) {
    for (const PointLight& light : appearance.point_lights) {
        if (light.color != Color(0, 0, 0)) prepared.point_lights.push_back(light);
    }
    for (const DirectionalLight& light : appearance.directional_lights) {
        if (light.color == Color(0, 0, 0)) continue;
        prepared.directional_lights.push_back({unit(light.direction), light.color});
    }
}

bool is_twin(const Sphere<double>& sphere, const Sphere<double>& other) {
    return sphere.center == other.center && sphere.radius == other.radius;
}

bool is_twin(const Cylinder<double>& cylinder, const Cylinder<double>& other) {
    return cylinder.center == other.center && cylinder.radius == other.radius && cylinder.height == other.height;
}

/// `to` is a vector of `prepared`.
template <class Object>
void add_without_twins(const std::vector<Object>& objects, Subject kind, const Appearance& appearance,
                       std::vector<Object>& to, PreparedScene& prepared) {
    std::size_t twins = 0;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const auto known = [&](const Object& other) { return is_twin(objects[i], other); };
        if (std::any_of(to.begin(), to.end(), known)) {
            ++twins;
            continue;
        }
        to.push_back(objects[i]);
        prepared.surface_of.push_back(surface_index(appearance, kind, i));
    }
    if (twins > 0) {
        prepared.notes.push_back(fmt::format("{} {}{} left out: an earlier one is the same.", twins, to_string(kind),
                                             twins == 1 ? " is" : "s are"));
    }
}

// Adds the objects of a kind, in the order of for_each_kind.

void add_objects(const std::vector<Sphere<double>>& spheres, const Assignment& assignment, PreparedScene& prepared) {
    add_without_twins(spheres, Subject::sphere, assignment.appearance, prepared.spheres, prepared);
}

void add_objects(const std::vector<Triangle<double>>& triangles, const Assignment& assignment,
                 PreparedScene& prepared) {
    std::size_t flat = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const kernel::PreparedTriangle triangle(triangles[i]);
        const std::optional<Vec3<double>> normal = unit_normal(triangle);
        if (!normal) {
            ++flat;
            continue;
        }
        prepared.triangles.push_back(triangle);
        prepared.triangle_normals.push_back(*normal);
        prepared.surface_of.push_back(surface_index(assignment.appearance, Subject::triangle, i));
    }
    if (flat > 0) {
        prepared.notes.push_back(
            fmt::format("{} of {} triangles of the scene left out: they have no area.", flat, triangles.size()));
    }
}

void add_objects(const std::vector<Cylinder<double>>& cylinders, const Assignment& assignment,
                 PreparedScene& prepared) {
    add_without_twins(cylinders, Subject::cylinder, assignment.appearance, prepared.cylinders, prepared);
}

void check_size(const Assignment& assignment, const PreparedScene& prepared) {
    const auto per_pixel = std::int64_t{prepared.samples_per_side} * prepared.samples_per_side;
    const std::int64_t samples = std::int64_t{prepared.width} * prepared.height * per_pixel;
    if (prepared.width <= 1 << 20 && prepared.height <= 1 << 20 && samples <= most_samples) return;
    throw AssignmentError(
        fmt::format("{}: a picture of {} x {} pixels with {} samples each is too large: the limit is {} million "
                    "samples; use --size WxH",
                    assignment.name, prepared.width, prepared.height, per_pixel, most_samples / 1'000'000));
}

}  // namespace

PreparedScene prepare_scene(const Assignment& assignment, std::optional<PictureSize> size) {
    const Appearance& appearance = assignment.appearance;
    Scene<double> scene = scene_in_doubles(assignment);
    if (size) {
        scene.window.width = size->width;
        scene.window.height = size->height;
    }
    const auto side = static_cast<int>(std::lround(std::sqrt(appearance.samples_per_pixel)));
    PreparedScene prepared{};
    prepared.width = scene.window.width;
    prepared.height = scene.window.height;
    prepared.samples_per_side = side;
    check_size(assignment, prepared);
    prepared.eye = eye_of(scene, assignment.rubric.pixel_conventions.front(), side);
    prepared.boundary =
        assignment.rubric.boundary == BoundaryPolicy::positive ? Boundary::positive : Boundary::nonnegative;
    for_each_kind([&](Subject /*kind*/, const auto& objects) { add_objects(objects, assignment, prepared); }, scene);
    prepared.surfaces = surfaces_of(appearance);
    add_lights(appearance, prepared);
    prepared.ambient_light = appearance.ambient_light;
    prepared.background = appearance.background;
    return prepared;
}

}  // namespace reference::render
