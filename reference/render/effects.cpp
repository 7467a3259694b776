#include "reference/render/effects.h"

#include <fmt/format.h>

#include <algorithm>

#include "reference/render/prepared_scene.h"

namespace reference::render {
namespace {

bool is_dark(const Color& color) {
    return color == Color(0, 0, 0);
}

/// Whether any object's surface has the property.
template <class Property>
bool any_surface(const PreparedScene& scene, Property property) {
    std::vector<bool> is_used(scene.surfaces.size());
    for (const std::uint32_t surface : scene.surface_of) is_used[surface] = true;
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
        if (is_used[i] && property(scene.surfaces[i])) return true;
    }
    return false;
}

bool refracts(const PreparedScene& scene) {
    return any_surface(scene, [](const Surface& surface) { return surface.material.transparency > 0; });
}

/// Whether a plane clearly separates the sphere from the window, on which camera rays start.
bool is_outside(const PreparedScene& scene, const Sphere<double>& sphere) {
    Vec3<double> middle(0, 0, 0);
    for (const Vec3<double>& corner : scene.eye.corners) middle += scaled(corner, 0.25);
    // Tries two planes: perpendicular to the view, and perpendicular to the line from the window's middle to the
    // sphere's centre.
    for (const Vec3<double>& across : {scene.eye.basis.Z_vcs, Vec3<double>(middle - sphere.center)}) {
        for (const double sign : {1.0, -1.0}) {
            const auto height = [&](const Vec3<double>& p) {
                return sign * dot(Vec3<double>(p - sphere.center), across) / length(across);
            };
            const auto& corners = scene.eye.corners;
            const auto is_beyond = [&](const Vec3<double>& p) {
                const double size = std::max({length(p), length(sphere.center), sphere.radius});
                return height(p) > sphere.radius + 0x1p-40 * size;
            };
            if (std::all_of(corners.begin(), corners.end(), is_beyond)) return true;
        }
    }
    return false;
}

/// A sphere around the cylinder.
Sphere<double> around(const Cylinder<double>& cylinder) {
    return {cylinder.center, std::hypot(cylinder.radius, cylinder.height / 2) * (1 + 0x1p-40)};
}

Decision illumination(const PreparedScene& scene) {
    const bool has_lights = !scene.point_lights.empty() || !scene.directional_lights.empty();
    const bool is_lit = any_surface(scene, [](const Surface& surface) { return surface.is_lit; });
    if (any_surface(scene, [](const Surface& surface) { return surface.is_lit && surface.own_share > 0; })) {
        if (has_lights)
            return {"illumination", &Effects::illumination, true, "lights and materials for them to act on"};
        if (is_dark(scene.ambient_light))
            return {"illumination", &Effects::illumination, true,
                    "every light is black, so whatever is lit is black too"};
        return {"illumination", &Effects::illumination, true, "ambient light and materials for it to act on"};
    }
    if (is_lit)
        return {"illumination", &Effects::illumination, false,
                "every material mirrors or lets through all light: no shading"};
    if (has_lights || !is_dark(scene.ambient_light)) {
        return {"illumination", &Effects::illumination, false, "no object has a material: no shading, no shadow rays"};
    }
    return {"illumination", &Effects::illumination, false, "no light: no shading, no shadow rays"};
}

/// Whether the surface scatters some of the light.
bool scatters(const Surface& surface, const Color& light) {
    return surface.is_lit && surface.own_share > 0 &&
           !(is_dark(light * surface.material.diffuse) && is_dark(light * surface.material.specular));
}

Decision shadows(const PreparedScene& scene, const Decision& illumination) {
    if (!illumination.on) return {"shadows", &Effects::shadows, false, illumination.reason};
    if (scene.point_lights.empty() && scene.directional_lights.empty()) {
        return {"shadows", &Effects::shadows, false, "ambient light alone: it comes from everywhere and casts none"};
    }
    const auto is_scattered = [&](const auto& light) {
        return any_surface(scene, [&](const Surface& surface) { return scatters(surface, light.color); });
    };
    if (!std::any_of(scene.point_lights.begin(), scene.point_lights.end(), is_scattered) &&
        !std::any_of(scene.directional_lights.begin(), scene.directional_lights.end(), is_scattered)) {
        return {"shadows", &Effects::shadows, false,
                "no material is diffuse or specular in a light's colors: nothing to be in shadow"};
    }
    if (scene.object_count() == 1) {
        if (scene.kind_of(0) == ObjectKind::triangle) {
            return {"shadows", &Effects::shadows, false, "one triangle: nothing can cast a shadow on another"};
        }
        const bool is_sphere = scene.kind_of(0) == ObjectKind::sphere;
        if (!refracts(scene) && is_outside(scene, is_sphere ? scene.spheres.front() : around(scene.cylinder(0)))) {
            return {"shadows", &Effects::shadows, false, "one convex object: nothing can cast a shadow on another"};
        }
        return {"shadows", &Effects::shadows, true,
                fmt::format("a {} seen from inside is its own shade", is_sphere ? "sphere" : "cylinder")};
    }
    return {"shadows", &Effects::shadows, true, "objects may stand between a light and each other"};
}

Decision mirrors(const PreparedScene& scene) {
    const bool on = any_surface(scene, [](const Surface& surface) { return surface.material.reflectivity > 0; });
    return {"mirrors", &Effects::mirrors, on,
            on ? "an object's reflectivity is above 0" : "no reflectivity above 0: no mirrored rays"};
}

Decision refraction(const PreparedScene& scene) {
    const bool on = refracts(scene);
    return {"refraction", &Effects::refraction, on,
            on ? "an object's transparency is above 0"
               : "no transparency above 0: no refracted rays, no reflection in glass"};
}

Decision supersampling(const PreparedScene& scene) {
    const bool on = scene.samples_per_side > 1;
    return {"supersampling", &Effects::supersampling, on,
            on ? "samples_per_pixel is above 1" : "one sample a pixel: nothing to average"};
}

}  // namespace

std::vector<Decision> decide_effects(const PreparedScene& scene) {
    const Decision lit = illumination(scene);
    return {lit, shadows(scene, lit), mirrors(scene), refraction(scene), supersampling(scene)};
}

Effects effects_of(const std::vector<Decision>& decisions) {
    Effects effects;
    for (const Decision& decision : decisions) effects.*decision.effect = decision.on;
    return effects;
}

}  // namespace reference::render
