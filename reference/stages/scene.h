// What the handout calls "The Scene and Camera", over any scalar S. Lengths are in world units.
#pragma once

#include <vector>

#include "reference/numbers/vector.h"

namespace reference {

template <class S>
struct Camera {
    Vec3<S> eye;
    Vec3<S> lookat;
    Vec3<S> vup;
};

/// The image plane: the clip window at distance clip_near before the eye, divided into width x height pixels.
template <class S>
struct Window {
    S clip_left;
    S clip_right;
    S clip_bottom;
    S clip_top;
    S clip_near;
    int width;   ///< W, pixels, at least 1
    int height;  ///< H, pixels, at least 1
};

/// P_DCS, device coordinates: x counts from the left, y from the bottom, both from 0.
struct Pixel {
    int x;
    int y;
};

template <class S>
struct Sphere {
    Vec3<S> center;
    S radius;  ///< above 0
};

template <class S>
struct Triangle {
    Vec3<S> A;
    Vec3<S> B;
    Vec3<S> C;
};

/// A cylinder whose axis is parallel to the y axis, closed by a cap at each end. Half its height lies above the center.
template <class S>
struct Cylinder {
    Vec3<S> center;
    S radius;  ///< above 0
    S height;  ///< from cap to cap, above 0
};

template <class S>
struct Scene {
    Camera<S> camera;
    Window<S> window;
    Pixel pixel;
    std::vector<Sphere<S>> spheres;
    std::vector<Triangle<S>> triangles;
    std::vector<Cylinder<S>> cylinders = {};
};

/// The same scene over another scalar; `convert` converts a single number.
template <class To, class From, class Convert>
Scene<To> convert_scene(const Scene<From>& scene, Convert convert) {
    const auto vec = [&](const Vec3<From>& p) { return Vec3<To>(convert(p.x), convert(p.y), convert(p.z)); };
    const Window<From>& window = scene.window;
    Scene<To> result{{vec(scene.camera.eye), vec(scene.camera.lookat), vec(scene.camera.vup)},
                     {convert(window.clip_left), convert(window.clip_right), convert(window.clip_bottom),
                      convert(window.clip_top), convert(window.clip_near), window.width, window.height},
                     scene.pixel,
                     {},
                     {}};
    for (const Sphere<From>& sphere : scene.spheres) {
        result.spheres.push_back({vec(sphere.center), convert(sphere.radius)});
    }
    for (const Triangle<From>& triangle : scene.triangles) {
        result.triangles.push_back({vec(triangle.A), vec(triangle.B), vec(triangle.C)});
    }
    for (const Cylinder<From>& cylinder : scene.cylinders) {
        result.cylinders.push_back({vec(cylinder.center), convert(cylinder.radius), convert(cylinder.height)});
    }
    return result;
}

}  // namespace reference
