// The named mistakes of the camera: from the pixel to the ray.
#include "harness/mark/diagnose/mistake_parts.h"
#include "reference/stages/camera.h"

namespace harness::mistakes {
namespace camera_mistakes {
namespace {

using reference::cross;
using reference::normalized;

using namespace item;
constexpr ItemId X = X_vcs, Y = Y_vcs, Z = Z_vcs, M = M_VCS_to_WCS;

Vec view(const IntervalScene& scene) {
    return scene.camera.eye - scene.camera.lookat;
}

Vec pixel_at(const IntervalScene& scene, const Interval& x, const Interval& y) {
    const auto& window = scene.window;
    const auto along = [](const Interval& from, const Interval& to, const Interval& share) {
        return from + (to - from) * share;
    };
    return Vec(along(window.clip_left, window.clip_right, x), along(window.clip_bottom, window.clip_top, y),
               -window.clip_near);
}

Interval share(double index, int count) {
    return Interval(index) / Interval(count);
}

Targets with_every_convention(const IntervalScene& scene, auto change) {
    Targets targets;
    for (const auto convention :
         {reference::PixelConvention::centre, reference::PixelConvention::grid, reference::PixelConvention::corner}) {
        targets.push_back(target_of(change(reference::pixel_to_vcs(scene.window, scene.pixel, convention))));
    }
    return targets;
}

Targets positive_z(const ItemTargets&, const IntervalScene& scene) {
    return with_every_convention(scene, [](const Vec& p) { return Vec(p.x, p.y, -p.z); });
}
Targets unit_z(const ItemTargets&, const IntervalScene& scene) {
    return with_every_convention(scene, [](const Vec& p) { return Vec(p.x, p.y, Interval(-1)); });
}
Targets zero_z(const ItemTargets&, const IntervalScene& scene) {
    return with_every_convention(scene, [](const Vec& p) { return Vec(p.x, p.y, Interval(0)); });
}
Targets integer_division(const ItemTargets&, const IntervalScene& scene) {
    return just(pixel_at(scene, Interval(0), Interval(0)));
}
Targets pixel_corner(const ItemTargets&, const IntervalScene& scene) {
    return just(reference::pixel_to_vcs(scene.window, scene.pixel, reference::PixelConvention::corner));
}
Targets pixel_upside_down(const ItemTargets&, const IntervalScene& scene) {
    IntervalScene flipped = scene;
    flipped.pixel.y = scene.window.height - 1 - scene.pixel.y;
    return {target_of(reference::pixel_to_vcs(flipped.window, flipped.pixel, reference::PixelConvention::centre)),
            target_of(reference::pixel_to_vcs(flipped.window, flipped.pixel, reference::PixelConvention::grid))};
}
Targets window_ignored(const ItemTargets&, const IntervalScene& scene) {
    const auto& window = scene.window;
    const Interval x = share(scene.pixel.x + 0.5, window.width), y = share(scene.pixel.y + 0.5, window.height);
    return {target_of(Vec(Interval(2) * x - Interval(1), Interval(2) * y - Interval(1), -window.clip_near)),
            target_of(Vec(x, y, -window.clip_near))};
}
Targets window_not_shifted(const ItemTargets&, const IntervalScene& scene) {
    const auto& window = scene.window;
    return just(Vec((window.clip_right - window.clip_left) * share(scene.pixel.x + 0.5, window.width),
                    (window.clip_top - window.clip_bottom) * share(scene.pixel.y + 0.5, window.height),
                    -window.clip_near));
}
Targets one_pixel_too_far(const ItemTargets&, const IntervalScene& scene) {
    return just(pixel_at(scene, share(scene.pixel.x + 1.0, scene.window.width),
                         share(scene.pixel.y + 1.0, scene.window.height)));
}
Targets sides_mixed_up(const ItemTargets&, const IntervalScene& scene) {
    return just(pixel_at(scene, share(scene.pixel.x + 0.5, scene.window.height),
                         share(scene.pixel.y + 0.5, scene.window.width)));
}

Targets z_forward(const ItemTargets&, const IntervalScene& scene) {
    return just(normalized(Vec(-view(scene))));
}
Targets z_long(const ItemTargets&, const IntervalScene& scene) {
    return {target_of(view(scene)), target_of(Vec(-view(scene)))};
}
Targets z_is_eye(const ItemTargets&, const IntervalScene& scene) {
    return just(normalized(scene.camera.eye));
}
Targets x_order(const ItemTargets& known, const IntervalScene& scene) {
    return from([&](const Vec& z) { return normalized(cross(z, scene.camera.vup)); }, known.vector(Z));
}
Targets x_long(const ItemTargets& known, const IntervalScene& scene) {
    Targets targets = from([&](const Vec& z) { return cross(scene.camera.vup, z); }, known.vector(Z));
    targets.push_back(target_of(cross(scene.camera.vup, view(scene))));
    return targets;
}
Targets y_order(const ItemTargets& known, const IntervalScene&) {
    return from([](const Vec& x, const Vec& z) { return cross(x, z); }, known.vector(X), known.vector(Z));
}
Targets y_is_vup(const ItemTargets&, const IntervalScene& scene) {
    return {target_of(scene.camera.vup), target_of(normalized(scene.camera.vup))};
}

/// One coordinate of each axis: a row of the table whose columns are the axes, and a column of the view matrix.
template <int coordinate>
Targets one_of_each_axis(const ItemTargets&, const IntervalScene& scene) {
    const reference::Basis<Interval> axes = reference::view_basis(scene.camera);
    return just(Vec(axes.X_vcs[coordinate], axes.Y_vcs[coordinate], axes.Z_vcs[coordinate]));
}

using Matrix = reference::Mat4<Interval>;

Matrix view_matrix(const Matrix& m) {
    Matrix inverse(Interval(0.0));
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) inverse[i][k] = m[k][i];
        inverse[3][i] = -(m[i][0] * m[3][0] + m[i][1] * m[3][1] + m[i][2] * m[3][2]);
    }
    inverse[3][3] = Interval(1);
    return inverse;
}

Matrix without_translation(const Matrix& m) {
    Matrix rotation = m;
    for (int i = 0; i < 3; ++i) rotation[3][i] = Interval(0);
    return rotation;
}

Matrix transposed(const Matrix& m) {
    Matrix result(Interval(0.0));
    for (int i = 0; i < 4; ++i) {
        for (int k = 0; k < 4; ++k) result[i][k] = m[k][i];
    }
    return result;
}

Matrix negated_translation(const Matrix& m) {
    Matrix result = m;
    for (int i = 0; i < 3; ++i) result[3][i] = -m[3][i];
    return result;
}

Matrix axes_in_rows(const Matrix& m) {
    Matrix result = transposed(without_translation(m));
    result[3] = m[3];
    return result;
}

/// The right matrix for the known axes, with `Change` applied.
template <Matrix (*Change)(const Matrix&)>
Targets matrix_with(const ItemTargets& known, const IntervalScene& scene) {
    return from(
        [&](const Vec& x, const Vec& y, const Vec& z) {
            return Change(reference::vcs_to_wcs(reference::Basis<Interval>{x, y, z}, scene.camera.eye));
        },
        known.vector(X), known.vector(Y), known.vector(Z));
}

template <Matrix (*Change)(const Matrix&)>
Targets point_by(const ItemTargets& known, const IntervalScene&) {
    return from([](const Matrix& m, const Vec& p) { return reference::pixel_to_wcs(Change(m), p); }, known.matrix4(M),
                known.vector(P_VCS));
}

Targets v_long(const ItemTargets& known, const IntervalScene& scene) {
    return from([&](const Vec& p) { return Vec(p - scene.camera.eye); }, known.vector(P_WCS));
}
Targets v_with_w(const ItemTargets& known, const IntervalScene& scene) {
    return from(
        [&](const Vec& p) {
            const Vec way = p - scene.camera.eye;
            return reference::scaled(way, Interval(1) / sqrt(reference::dot(way, way) + Interval(1)));
        },
        known.vector(P_WCS));
}
Targets v_backward(const ItemTargets& known, const IntervalScene& scene) {
    return from([&](const Vec& p) { return normalized(Vec(scene.camera.eye - p)); }, known.vector(P_WCS));
}
Targets v_from_origin(const ItemTargets& known, const IntervalScene&) {
    return from([](const Vec& p) { return normalized(p); }, known.vector(P_WCS));
}
Targets v_in_vcs(const ItemTargets& known, const IntervalScene&) {
    return from([](const Vec& p) { return normalized(p); }, known.vector(P_VCS));
}
Targets v_to_lookat(const ItemTargets&, const IntervalScene& scene) {
    return just(normalized(Vec(-view(scene))));
}

constexpr std::string_view one_coordinate =
    "This is one coordinate of each axis. If you printed a table with the axes as columns, print each axis separately. "
    "If you took the axes from GLM's view matrix, they are its rows, but view[i] is a column.";

}  // namespace
}  // namespace camera_mistakes

template <>
const std::vector<Mistake>& of<Subject::camera>() {
    using namespace camera_mistakes;
    static const std::vector<Mistake> table = {
        {"positive z", "The camera looks along -z: the image plane lies at z = -clipNear.", P_VCS, positive_z},
        {"integer division",
         "Integer division of the pixel's index by the number of pixels gives 0; divide in floating point.", P_VCS,
         integer_division},
        {"corner of the pixel", "The point is the pixel's corner; half a pixel is missing.", P_VCS, pixel_corner},
        {"y counted from the top", "y_DCS counts from the bottom of the image, not from the top.", P_VCS,
         pixel_upside_down},
        {"window not applied", "The pixel is scaled to a standard square, not to the clip window.", P_VCS,
         window_ignored},
        {"window not shifted", "The pixel is scaled to the window's size, but not moved to its left and bottom edges.",
         P_VCS, window_not_shifted},
        {"one pixel too far", "Pixels are counted from 0, not from 1.", P_VCS, one_pixel_too_far},
        {"width and height mixed up", "x is divided by the height and y by the width.", P_VCS, sides_mixed_up},
        {"near plane at 1", "The image plane is at distance clipNear, not at distance 1.", P_VCS, unit_z},
        {"z forgotten", "The image plane does not pass through the eye; its z is missing.", P_VCS, zero_z},
        {"Z points at lookat", "Z_vcs points from lookat to the eye; the camera looks along -Z.", Z, z_forward},
        {"not normalized", "Z_vcs must have length 1.", Z, z_long},
        {"lookat forgotten", "Z_vcs is the direction from lookat to the eye, not the eye itself.", Z, z_is_eye},
        {"opposite direction", "X_vcs points the opposite way: it is vup x Z, in this order.", X, x_order},
        {"not normalized", "X_vcs must have length 1.", X, x_long},
        {"opposite direction", "Y_vcs points the opposite way: it is Z x X, in this order.", Y, y_order},
        {"vup taken as Y", "Y_vcs is Z x X; vup only says roughly where up is.", Y, y_is_vup},
        {"coordinates of different axes", one_coordinate, X, one_of_each_axis<0>},
        {"coordinates of different axes", one_coordinate, Y, one_of_each_axis<1>},
        {"coordinates of different axes", one_coordinate, Z, one_of_each_axis<2>},
        {"translation missing", "The matrix has only the rotation; its fourth column must be the eye.", M,
         matrix_with<without_translation>},
        {"matrix transposed", transposed_advice, M, matrix_with<transposed>},
        {"view matrix, not its inverse", "This is the view matrix, from WCS to VCS; the question asks for its inverse.",
         M, matrix_with<view_matrix>},
        {"translation negated", "The fourth column must be the eye, not its negative.", M,
         matrix_with<negated_translation>},
        {"axes in rows", "The axes are the columns of the matrix; they are in its rows.", M, matrix_with<axes_in_rows>},
        {"translation missing", "The pixel was transformed as a direction; as a point it has w = 1.", P_WCS,
         point_by<without_translation>},
        {"view matrix, not its inverse", "The pixel was transformed by the view matrix; M_VCS_to_WCS is its inverse.",
         P_WCS, point_by<view_matrix>},
        {"matrix transposed", "The pixel was multiplied by the transposed matrix.", P_WCS, point_by<transposed>},
        {"not normalized", "V must have length 1.", V, v_long},
        {"normalized with w", "V was normalized as a vec4 whose w is 1; normalize its first three components.", V,
         v_with_w},
        {"points to the eye", "V points from the eye to the pixel, not back.", V, v_backward},
        {"eye forgotten", "V is the direction from the eye to the pixel, not from the origin.", V, v_from_origin},
        {"in view coordinates", "V must be in world coordinates; it is in view coordinates.", V, v_in_vcs},
        {"points at lookat", "V points at the pixel, not at lookat.", V, v_to_lookat},
    };
    return table;
}

}  // namespace harness::mistakes
