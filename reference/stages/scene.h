// The handout's "The Scene and Camera", over any scalar S. Lengths are in world units.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "reference/numbers/vector.h"
#include "reference/stages/items.h"

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
    friend bool operator==(const Pixel&, const Pixel&) = default;
};

// The objects. for_each_field calls visit(name, fields...) for each field of objects of one kind, by its name in an
// assignment file. A field is a number above 0, a point, or three vertices.

template <class S>
struct Sphere {
    Vec3<S> center;
    S radius;  ///< above 0

    template <class Visit, class... Spheres>
    static void for_each_field(const Visit& visit, Spheres&... spheres) {
        visit("center", spheres.center...);
        visit("radius", spheres.radius...);
    }
};

/// Pointers to points, which may be const.
template <class Point>
using Vertices = std::array<Point*, 3>;

template <class S>
struct Triangle {
    Vec3<S> A;
    Vec3<S> B;
    Vec3<S> C;

    template <class Visit, class... Triangles>
    static void for_each_field(const Visit& visit, Triangles&... triangles) {
        visit("vertices", std::array{&triangles.A, &triangles.B, &triangles.C}...);
    }
};

/// A cylinder whose axis is parallel to the y axis, closed by a cap at each end. Half its height is above the center.
template <class S>
struct Cylinder {
    Vec3<S> center;
    S radius;  ///< above 0
    S height;  ///< from cap to cap, above 0

    template <class Visit, class... Cylinders>
    static void for_each_field(const Visit& visit, Cylinders&... cylinders) {
        visit("center", cylinders.center...);
        visit("radius", cylinders.radius...);
        visit("height", cylinders.height...);
    }
};

template <class S>
struct Scene {
    Camera<S> camera;
    Window<S> window;
    Pixel pixel;
    std::vector<Sphere<S>> spheres = {};
    std::vector<Triangle<S>> triangles = {};
    std::vector<Cylinder<S>> cylinders = {};
};

/// Calls visit(kind, lists...) for each kind of object, in the order of the tables, with the list of that kind in each
/// of `holders`: scenes, and other types with a list for each kind.
template <class Visit, class... Holders>
void for_each_kind(const Visit& visit, Holders&... holders) {
    visit(Subject::sphere, holders.spheres...);
    visit(Subject::triangle, holders.triangles...);
    visit(Subject::cylinder, holders.cylinders...);
}

/// Calls visit(name, fields...) for each field of the objects, which are of one kind.
template <class Visit, class Object, class... Others>
void for_each_field(const Visit& visit, Object& object, Others&... others) {
    Object::for_each_field(visit, object, others...);
}

template <class Object>
std::vector<std::string_view> field_names() {
    std::vector<std::string_view> names;
    const Object object{};
    for_each_field([&](std::string_view name, const auto& /*field*/) { names.push_back(name); }, object);
    return names;
}

/// How many objects of a kind the scene has; 0 if the subject is not an object.
template <class S>
std::size_t count_of(Subject kind, const Scene<S>& scene) {
    std::size_t count = 0;
    for_each_kind(
        [&](Subject subject, const auto& objects_of_kind) {
            if (subject == kind) count = objects_of_kind.size();
        },
        scene);
    return count;
}

/// The same scene over another scalar; `convert` converts a single number.
template <class To, class From, class Convert>
Scene<To> convert_scene(const Scene<From>& scene, Convert convert) {
    const auto vec = [&](const Vec3<From>& p) { return Vec3<To>(convert(p.x), convert(p.y), convert(p.z)); };
    const Window<From>& window = scene.window;
    Scene<To> result{{vec(scene.camera.eye), vec(scene.camera.lookat), vec(scene.camera.vup)},
                     {convert(window.clip_left), convert(window.clip_right), convert(window.clip_bottom),
                      convert(window.clip_top), convert(window.clip_near), window.width, window.height},
                     scene.pixel};
    struct FieldConverter {
        const decltype(vec)& vec_of;
        Convert& number_of;
        void operator()(std::string_view /*name*/, const From& from, To& to) const { to = number_of(from); }
        void operator()(std::string_view /*name*/, const Vec3<From>& from, Vec3<To>& to) const { to = vec_of(from); }
        void operator()(std::string_view /*name*/, const Vertices<const Vec3<From>>& from,
                        const Vertices<Vec3<To>>& to) const {
            for (std::size_t i = 0; i < to.size(); ++i) *to[i] = vec_of(*from[i]);
        }
    };
    for_each_kind(
        [&](Subject /*kind*/, const auto& from, auto& to) {
            to.resize(from.size());
            for (std::size_t i = 0; i < from.size(); ++i) for_each_field(FieldConverter{vec, convert}, from[i], to[i]);
        },
        scene, result);
    return result;
}

}  // namespace reference
