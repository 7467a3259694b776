// Questions 1 to 5 of the handout: from the pixel to the ray.
#pragma once

#include "reference/stages/item_values.h"
#include "reference/stages/scene.h"

namespace reference {

/// Where in its pixel a ray starts. The handout prescribes no convention; the rubric lists the accepted ones.
enum class PixelConvention {
    centre,  ///< (x + 1/2) / W of the window's width
    grid,    ///< x / (W - 1): the first and last pixels lie on the window's edges
    corner,  ///< x / W: the pixel's lower left corner
};

/// The position of pixel number `index` of `count` between `from` and `to`. With a grid of one pixel, it is in the
/// middle.
template <class S>
S along_window(const S& from, const S& to, int index, int count, PixelConvention convention) {
    // Twice the numerator and denominator, so that half of a pixel stays a whole number.
    int numerator = 2 * index + 1;
    int denominator = 2 * count;
    if (convention == PixelConvention::corner) numerator = 2 * index;
    if (convention == PixelConvention::grid && count > 1) {
        numerator = 2 * index;
        denominator = 2 * (count - 1);
    }
    return from + (to - from) * S(numerator) / S(denominator);
}

/// Question 1, P_VCS: the pixel in view (camera) coordinates; the camera looks along -z, so z = -clip_near.
template <class S>
Vec3<S> pixel_to_vcs(const Window<S>& window, const Pixel& pixel, PixelConvention convention) {
    return Vec3<S>(along_window(window.clip_left, window.clip_right, pixel.x, window.width, convention),
                   along_window(window.clip_bottom, window.clip_top, pixel.y, window.height, convention),
                   -window.clip_near);
}

/// The axes of the view coordinate system in world coordinates, orthonormal and right-handed.
template <class S>
struct Basis {
    Vec3<S> X_vcs;
    Vec3<S> Y_vcs;
    Vec3<S> Z_vcs;
};

/// Question 2: Z points from lookat back to the eye, X = vup x Z, Y = Z x X. NaN if eye = lookat or vup is parallel to
/// the view.
template <class S>
Basis<S> view_basis(const Camera<S>& camera) {
    const Vec3<S> Z = normalized(Vec3<S>(camera.eye - camera.lookat));
    const Vec3<S> X = normalized(cross(camera.vup, Z));
    return {X, cross(Z, X), Z};
}

/// Question 3, M_VCS_to_WCS: the inverse of the view matrix. Its columns are X, Y, Z and the eye.
template <class S>
Mat4<S> vcs_to_wcs(const Basis<S>& basis, const Vec3<S>& eye) {
    const S zero(0);
    const S one(1);
    const auto column = [](const Vec3<S>& p, const S& w) { return Vec4<S>(p.x, p.y, p.z, w); };
    return Mat4<S>(column(basis.X_vcs, zero), column(basis.Y_vcs, zero), column(basis.Z_vcs, zero), column(eye, one));
}

/// Question 4, P_WCS: M times (P_VCS, 1), divided by its w.
template <class S>
Vec3<S> pixel_to_wcs(const Mat4<S>& M, const Vec3<S>& P_VCS) {
    const auto row = [&](int i) { return M[0][i] * P_VCS.x + M[1][i] * P_VCS.y + M[2][i] * P_VCS.z + M[3][i]; };
    const S w = row(3);
    return Vec3<S>(row(0) / w, row(1) / w, row(2) / w);
}

/// Question 5, V: the unit vector from the eye to the pixel.
template <class S>
Vec3<S> ray_direction(const Vec3<S>& P_WCS, const Vec3<S>& eye) {
    return normalized(Vec3<S>(P_WCS - eye));
}

/// Questions 1 to 5.
template <class S>
struct CameraAnswers {
    Vec3<S> P_VCS;
    Basis<S> basis;
    Mat4<S> M_VCS_to_WCS;
    Vec3<S> P_WCS;
    Vec3<S> V;
};

template <class S>
CameraAnswers<S> answer_camera(const Scene<S>& scene, PixelConvention convention) {
    const Vec3<S> P_VCS = pixel_to_vcs(scene.window, scene.pixel, convention);
    const Basis<S> basis = view_basis(scene.camera);
    const Mat4<S> M = vcs_to_wcs(basis, scene.camera.eye);
    const Vec3<S> P_WCS = pixel_to_wcs(M, P_VCS);
    return {P_VCS, basis, M, P_WCS, ray_direction(P_WCS, scene.camera.eye)};
}

template <class S>
void add_values(const CameraAnswers<S>& camera, ItemValues<S>& values) {
    values[item::P_VCS] = components(camera.P_VCS);
    values[item::X_vcs] = components(camera.basis.X_vcs);
    values[item::Y_vcs] = components(camera.basis.Y_vcs);
    values[item::Z_vcs] = components(camera.basis.Z_vcs);
    values[item::M_VCS_to_WCS] = components(camera.M_VCS_to_WCS);
    values[item::P_WCS] = components(camera.P_WCS);
    values[item::V] = components(camera.V);
}

}  // namespace reference
