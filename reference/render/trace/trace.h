// The color that a ray brings. The set of effects E and the way to find objects are compile-time parameters.
#pragma once

#include "reference/render/trace/fresnel.h"
#include "reference/render/trace/rows.h"
#include "reference/render/trace/visibility.h"

namespace reference::render {

/// x^n by squaring: std::pow differs between machines.
inline double power(double x, int n) {
    double result = 1;
    for (; n > 0; n /= 2, x *= x) {
        if (n % 2 == 1) result *= x;
    }
    return result;
}

template <Effects E, class Objects>
class Tracer {
  public:
    Tracer(const PreparedScene& scene, RayCounts& counts) : scene_(scene), counts_(counts) {}

    /// The color of the ray through x of the window.
    KERNEL_INLINE Color camera_color(const RowOfRays& row, double x) {
        const CameraRay ray{row.ray(x)};
        const Nearest nearest = Objects::first_hit(scene_, ray);
        if (!nearest.is_hit()) return scene_.background;
        return color_at(ray.ray, nearest, {1, 0});
    }

  private:
    static constexpr bool sends_on = E.mirrors || E.refraction;
    static constexpr bool has_surfaces = E.illumination || sends_on;

    /// A ray's share of its sample, and how often it was sent on.
    struct Path {
        double share;
        int bounces;
    };

    /// Where a ray meets a surface.
    struct Place {
        Vec3<double> V;       ///< the ray's direction
        Vec3<double> normal;  ///< of unit length, to the side that the ray comes from
        Start start;          ///< for rays that go on from here on that side
        bool is_inside;       ///< the ray comes from inside a sphere, or from the back of a triangle
    };

    KERNEL_INLINE Color color_at(const kernel::Ray<double>& ray, const Nearest& nearest, const Path& path) {
        const std::uint32_t sphere_count = scene_.sphere_count;
        const bool is_sphere = nearest.object < sphere_count;
        const Vec3<double> hit = point_on_ray(ray.origin, ray.direction, nearest.t);
        const Vec3<double> normal = is_sphere ? sphere_normal(hit, scene_.spheres[nearest.object].center)
                                              : scene_.triangle_normals[nearest.object - sphere_count];
        const Color by_normal = scaled(normal, 0.5) + Color(0.5, 0.5, 0.5);
        if constexpr (has_surfaces) {
            const Surface& surface = scene_.surfaces[scene_.surface_of[nearest.object]];
            const bool is_inside = is_sphere ? nearest.from_inside : dot(ray.direction, normal) > 0;
            const Vec3<double> facing = is_inside ? -normal : normal;
            const Start start = is_sphere
                                    ? start_on(scene_.spheres[nearest.object], nearest.object, normal, is_inside)
                                    : start_on(scene_.triangles[nearest.object - sphere_count], nearest.object, hit);
            return surface_color(surface, {ray.direction, facing, start, is_inside}, by_normal, path);
        } else {
            return by_normal;
        }
    }

    Color surface_color(const Surface& surface, const Place& place, const Color& by_normal, const Path& path) {
        Color color = by_normal;
        if constexpr (E.illumination) {
            if (surface.is_lit) color = illuminated(surface.material, place);
        }
        if constexpr (sends_on) color = scaled(color, surface.own_share) + passed_on(surface.material, place, path);
        return color;
    }

    /// A mirror and glass both send light along the mirrored ray; a single ray serves both.
    Color passed_on(const Material& material, const Place& place, const Path& path) {
        Color color(0, 0, 0);
        double reflected = 0;
        if constexpr (E.mirrors) reflected = material.reflectivity;
        if constexpr (E.refraction) {
            if (material.transparency > 0) {
                const double from = place.is_inside ? material.refractive_index : 1;
                const double into = place.is_inside ? 1 : material.refractive_index;
                const double cos_incident = std::clamp(-dot(place.V, place.normal), 0.0, 1.0);
                const Fresnel split = fresnel(cos_incident, from, into);
                reflected += material.transparency * split.reflected;
                const double through = material.transparency * (1 - split.reflected);
                const Vec3<double> V = refracted(place.V, place.normal, cos_incident, split.cos_refracted, from / into);
                Start start = place.start;
                start.is_inside = !place.is_inside;
                if (!split.is_total) color += color_on({{start.point, V}, start}, path, through, counts_.refracted);
            }
        }
        if (reflected > 0) {
            const SurfaceRay ray{{place.start.point, mirrored(place.V, place.normal)}, place.start};
            const bool by_mirror = material.reflectivity > 0;
            color += color_on(ray, path, reflected, by_mirror ? counts_.mirrored : counts_.reflected_in_glass);
        }
        return color;
    }

    /// Phong's local illumination, for each light that reaches the place.
    Color illuminated(const Material& material, const Place& place) {
        Color color = scene_.ambient_light * material.ambient;
        for (const PointLight& light : scene_.point_lights) {
            const Vec3<double> way = light.position - place.start.point;
            color += light_from(way, 1, light.color, material, place);
        }
        for (const DirectionalLight& light : scene_.directional_lights) {
            color += light_from(-light.direction, HUGE_VAL, light.color, material, place);
        }
        return color;
    }

    /// `way` leads to the light, which is at t = `end` along it.
    Color light_from(const Vec3<double>& way, double end, const Color& light, const Material& material,
                     const Place& place) {
        const double height = dot(way, place.normal);
        if (!(height > 0)) return {0, 0, 0};
        if constexpr (E.shadows) {
            ++counts_.shadow;
            if (Objects::is_blocked(scene_, {{place.start.point, way}, place.start}, end)) return {0, 0, 0};
        }
        const double distance = length(way);
        Color color = scaled(material.diffuse, height / distance);
        const double along_mirror = dot(mirrored(place.V, place.normal), way) / distance;
        if (along_mirror > 0) color += scaled(material.specular, power(along_mirror, material.shininess));
        return light * color;
    }

    /// The color of a ray that a surface sends on, times its `share` of the ray that arrived there. Below least_share
    /// or above most_bounces the ray is neither traced nor counted.
    [[gnu::noinline]] Color color_on(const SurfaceRay& ray, const Path& path, double share, std::uint64_t& count) {
        const Path next{path.share * share, path.bounces + 1};
        if (next.share < least_share || next.bounces > most_bounces) return {0, 0, 0};
        ++count;
        const Nearest nearest = Objects::first_hit(scene_, ray);
        return scaled(nearest.is_hit() ? color_at(ray.ray, nearest, next) : scene_.background, share);
    }

    const PreparedScene& scene_;
    RayCounts& counts_;
};

template <Effects E, class Objects>
void render_row(const PreparedScene& scene, int y, std::span<Color> colors, RayCounts& counts) {
    Tracer<E, Objects> tracer(scene, counts);
    const Eye& eye = scene.eye;
    if constexpr (E.supersampling) {
        const auto side = static_cast<std::size_t>(scene.samples_per_side);
        std::fill(colors.begin(), colors.end(), Color(0, 0, 0));
        for (std::size_t i = 0; i < side; ++i) {
            const RowOfRays row = eye.row(eye.sample_rows[static_cast<std::size_t>(y) * side + i]);
            for (std::size_t x = 0; x < colors.size() * side; ++x) {
                colors[x / side] += tracer.camera_color(row, eye.sample_columns[x]);
            }
        }
        for (Color& color : colors) color = scaled(color, 1 / static_cast<double>(side * side));
    } else {
        const RowOfRays row = eye.row(eye.rows[static_cast<std::size_t>(y)]);
        for (std::size_t x = 0; x < colors.size(); ++x) colors[x] = tracer.camera_color(row, eye.columns[x]);
    }
}

}  // namespace reference::render
