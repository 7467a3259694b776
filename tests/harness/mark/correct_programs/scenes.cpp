#include "tests/harness/mark/correct_programs/scenes.h"

#include <fmt/format.h>

#include "reference/accuracy/rays/random_numbers.h"
#include "reference/stages/camera.h"

namespace correct {
namespace {

using reference::Decimal;
using reference::Vec3;
using reference::accuracy::P;
using reference::accuracy::Random;

/// x in `digits` significant digits.
Decimal written(double x, int digits) {
    return *Decimal::parse(fmt::format("{:.{}e}", x, digits - 1));
}

Vec3<Decimal> written(const P& p, int digits) {
    return {written(p.x, digits), written(p.y, digits), written(p.z, digits)};
}

double read(const Decimal& x) {
    return x.to_double();
}

/// A unit vector at a right angle to the unit vector `axis`.
P across(Random& random, const P& axis) {
    for (;;) {
        const P p = reference::cross(axis, random.direction());
        if (reference::length(p) > 0.3) return reference::normalized(p);
    }
}

P along(double x, const P& p, double y, const P& q) {
    return reference::scaled(p, x) + reference::scaled(q, y);
}

}  // namespace

reference::Assignment scene_of(std::string_view kind, std::uint64_t seed) {
    Random random(seed * kinds.size() + static_cast<std::uint64_t>(kind.front()) * 7919 + kind.size());
    const bool is_beyond_float = kind.starts_with(beyond);
    const auto is = [&, name_of = kind.substr(is_beyond_float ? beyond.size() : 0)](std::string_view name) {
        return name_of == name;
    };
    const double hardness = std::pow(10.0, is_beyond_float ? random.between(5, 9) : random.between(1, 5));
    const double scale = is("small") ? 1e-3 : is("large") ? 1e4 : 1;
    const P moved = is("offset") ? random.point(hardness) : P(0);
    const int digits = is_beyond_float                                                    ? 14
                       : is("offset") || is("far")                                        ? 9
                       : is("grazing") || is("sliver") || is("parallel") || is("upright") ? 7
                                                                                          : 4;

    reference::Assignment assignment;
    assignment.name = fmt::format("{} {}", kind, seed);
    reference::Scene<Decimal>& scene = assignment.scene;
    const P eye = reference::scaled(random.point(9), scale) + moved;
    const P view = random.direction();
    const P lookat = eye - reference::scaled(view, scale * random.between(2, 9));
    const P vup = is("upright") ? along(1, view, random.between(1, 3) / hardness, across(random, view))
                                : along(random.between(0.1, 1), view, random.between(1, 2), across(random, view));
    scene.camera = {written(eye, digits), written(lookat, digits), written(vup, digits)};
    const double aside = is("wide") ? random.between(3, 20) : 1;
    scene.window = {written(-scale * aside * random.between(0.5, 2), 3),
                    written(scale * aside * random.between(0.5, 2), 3),
                    written(-scale * aside * random.between(0.5, 2), 3),
                    written(scale * aside * random.between(0.5, 2), 3),
                    written(scale * random.between(0.5, 3), 3),
                    random.whole(100, 800),
                    random.whole(100, 600)};
    scene.pixel = {random.whole(0, scene.window.width - 1), random.whole(0, scene.window.height - 1)};

    const auto numbers = reference::convert_scene<double>(scene, read);
    const reference::Basis<double> axes = reference::view_basis(numbers.camera);
    const P p = reference::pixel_to_vcs(numbers.window, numbers.pixel, reference::PixelConvention::centre);
    const P start = reference::pixel_to_wcs(reference::vcs_to_wcs(axes, numbers.camera.eye), p);
    const P V = reference::ray_direction(start, numbers.camera.eye);

    const double away = scale * (is("far") ? hardness : 1);
    const double radius = scale * random.between(1, 4);
    // How far the ray passes from the center, as a share of the radius.
    const double share = is("grazing") ? std::sqrt(1 - 1 / hardness) : random.between(0.05, 0.8);
    const P nearest = start + reference::scaled(V, radius + away * random.between(1, 5));
    scene.spheres.push_back({written(nearest + reference::scaled(across(random, V), share * radius), digits),
                             written(radius, is("grazing") ? 7 : 3)});

    const P hit = start + reference::scaled(V, away * random.between(1, 5));
    const P edge = across(random, V);
    const P upward =
        is("parallel") ? V : reference::normalized(along(random.between(0.1, 0.7), V, 1, reference::cross(edge, V)));
    const P out = is("parallel") ? along(1, upward, 1 / hardness, reference::cross(edge, V)) : upward;
    const double length = scale * random.between(2, 6);
    const double height = is("sliver") ? length / hardness : scale * random.between(2, 6);
    const double u = random.between(0.15, 0.6), v = random.between(0.15, 0.95 - u);
    const P e1 = reference::scaled(edge, length);
    const P e2 = along(length * random.between(0.2, 0.8), edge, height, out);
    const P A = hit - along(u, e1, v, e2);
    scene.triangles.push_back({written(A, digits), written(A + e1, digits), written(A + e2, digits)});
    assignment.rubric.pixel_conventions = {reference::PixelConvention::centre};
    return assignment;
}

}  // namespace correct
