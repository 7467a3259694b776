// The color that a ray brings. The set of effects E and the way to shoot rays are compile-time parameters. No ray is
// shot and no light computed whose answer is known or would be multiplied by 0.
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

/// Shoots the rays, and counts those beyond the camera's.
template <class Objects>
class CountedRays {
  public:
    explicit CountedRays(RayCounts& counts) : counts_(counts) {}

    template <class AnyRay>
    KERNEL_INLINE Nearest first_hit(const PreparedScene& scene, const AnyRay& ray) {
        return Objects::first_hit(scene, ray);
    }
    /// The light that reaches the ray's start from t = `end`.
    KERNEL_INLINE Color let_through(const PreparedScene& scene, const SurfaceRay& ray, double end, const Color& light) {
        ++counts_.shadow;
        return Objects::is_blocked(scene, ray, end) ? Color(0, 0, 0) : light;
    }
    /// The color that a ray of this kind brings.
    Color brought(const Color& color, std::uint64_t RayCounts::*kind) {
        ++(counts_.*kind);
        return color;
    }

  private:
    RayCounts& counts_;
};

template <Effects E, class Rays>
class Tracer {
  public:
    Tracer(const PreparedScene& scene, Rays rays) : scene_(scene), rays_(rays) {}

    const Rays& rays() const { return rays_; }

    /// The color of the ray through x of the window.
    KERNEL_INLINE Color camera_color(const RowOfRays& row, double x) {
        const CameraRay ray{row.ray(x)};
        const Nearest nearest = rays_.first_hit(scene_, ray);
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
        bool is_inside;       ///< the ray comes from inside a sphere or a cylinder, or from the back of a triangle
    };

    /// Of unit length; of a sphere and a cylinder outward.
    KERNEL_INLINE Vec3<double> normal_at(const Nearest& nearest, const Vec3<double>& hit) const {
        const std::uint32_t object = nearest.object;
        switch (scene_.kind_of(object)) {
            case ObjectKind::sphere: return sphere_normal(hit, scene_.spheres[object].center);
            case ObjectKind::triangle: return scene_.triangle_normals[object - scene_.sphere_count];
            case ObjectKind::cylinder: break;
        }
        return normal_of(scene_.cylinder(object), nearest.part, hit);
    }

    KERNEL_INLINE Start start_at(const Nearest& nearest, const Vec3<double>& hit, const Vec3<double>& normal,
                                 bool is_inside) const {
        const std::uint32_t object = nearest.object;
        switch (scene_.kind_of(object)) {
            case ObjectKind::sphere: return start_on(scene_.spheres[object], object, normal, is_inside);
            case ObjectKind::triangle: return start_on(scene_.triangle(object), object, hit);
            case ObjectKind::cylinder: break;
        }
        return start_on(scene_.cylinder(object), object, nearest.part, hit, is_inside);
    }

    KERNEL_INLINE Color color_at(const kernel::Ray<double>& ray, const Nearest& nearest, const Path& path) {
        const Vec3<double> hit = point_on_ray(ray.origin, ray.direction, nearest.t);
        const Vec3<double> normal = normal_at(nearest, hit);
        const Color by_normal = scaled(normal, 0.5) + Color(0.5, 0.5, 0.5);
        if constexpr (has_surfaces) {
            const Surface& surface = scene_.surfaces[scene_.surface_of[nearest.object]];
            const bool is_triangle = scene_.kind_of(nearest.object) == ObjectKind::triangle;
            const bool is_inside = is_triangle ? dot(ray.direction, normal) > 0 : nearest.from_inside;
            const Vec3<double> facing = is_inside ? -normal : normal;
            const Start start = start_at(nearest, hit, normal, is_inside);
            return surface_color(surface, {ray.direction, facing, start, is_inside}, by_normal, path);
        } else {
            return by_normal;
        }
    }

    Color surface_color(const Surface& surface, const Place& place, const Color& by_normal, const Path& path) {
        Color color = by_normal;
        if constexpr (E.illumination) {
            if (surface.is_lit && surface.own_share > 0) color = illuminated(surface, place);
        }
        if constexpr (sends_on) color = scaled(color, surface.own_share) + passed_on(surface.material, place, path);
        return color;
    }

    static Color textured(const Color& color, const Color& texel) {
        if constexpr (E.textures) return color * texel;
        return color;
    }

    /// The texture's color at the place; white without one.
    Color texel_at(const Surface& surface, const Place& place) const {
        if (!surface.texture) return {1, 1, 1};
        const std::optional<TextureFile::Plane>& plane = surface.material.texture->plane;
        if (plane || place.start.object >= scene_.sphere_count) {
            const auto [across, up] = plane.value_or(TextureFile::Plane{});
            return surface.texture->at(dot(place.start.point, across), dot(place.start.point, up));
        }
        const Vec3<double> N = place.is_inside ? -place.normal : place.normal;
        const double from_axis = std::sqrt(N.x * N.x + N.z * N.z);
        return surface.texture->at(share_of_turn(N.z, N.x), 2 * share_of_turn(-N.y, from_axis));
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
                if (!split.is_total) color += color_on({{start.point, V}, start}, path, through, &RayCounts::refracted);
            }
        }
        if (reflected > 0) {
            const SurfaceRay ray{{place.start.point, mirrored(place.V, place.normal)}, place.start};
            const bool by_mirror = material.reflectivity > 0;
            color += color_on(ray, path, reflected, by_mirror ? &RayCounts::mirrored : &RayCounts::reflected_in_glass);
        }
        return color;
    }

    /// Phong's local illumination, for each light that reaches the place.
    Color illuminated(const Surface& surface, const Place& place) {
        const Material& material = surface.material;
        Color texel(1, 1, 1);
        if constexpr (E.textures) texel = texel_at(surface, place);
        Color color = textured(scene_.ambient_light * material.ambient, texel);
        for (const PointLight& light : scene_.point_lights) {
            const Vec3<double> way = light.position - place.start.point;
            color += light_from(way, 1, light.color, material, texel, place);
        }
        for (const DirectionalLight& light : scene_.directional_lights) {
            color += light_from(-light.direction, HUGE_VAL, light.color, material, texel, place);
        }
        return color;
    }

    /// `way` leads to the light, which is at t = `end` along it.
    Color light_from(const Vec3<double>& way, double end, const Color& light, const Material& material,
                     const Color& texel, const Place& place) {
        const double height = dot(way, place.normal);
        if (!(height > 0)) return {0, 0, 0};
        const SurfaceRay ray{{place.start.point, way}, place.start};
        if constexpr (E.shadows) {
            if (is_before_end(scene_, ray, hit_own(scene_, ray), place.start.object, end)) return {0, 0, 0};
        }
        const double distance = length(way);
        Color color = textured(scaled(material.diffuse, height / distance), texel);
        const double along_mirror = dot(mirrored(place.V, place.normal), way) / distance;
        if (along_mirror > 0) color += scaled(material.specular, power(along_mirror, material.shininess));
        color = light * color;
        if constexpr (E.shadows) {
            if (color == Color(0, 0, 0) || is_alone()) return color;
            return rays_.let_through(scene_, ray, end, color);
        }
        return color;
    }

    /// The color of a ray that a surface sends on, times its `share` of the ray that arrived there. Below least_share
    /// or above most_bounces the ray is neither traced nor counted.
    [[gnu::noinline]] Color color_on(const SurfaceRay& ray, const Path& path, double share,
                                     std::uint64_t RayCounts::*kind) {
        const Path next{path.share * share, path.bounces + 1};
        if (next.share < least_share || next.bounces > most_bounces) return {0, 0, 0};
        if (meets_nothing(ray)) return scaled(scene_.background, share);
        const Nearest nearest = rays_.first_hit(scene_, ray);
        const Color color = nearest.is_hit() ? color_at(ray.ray, nearest, next) : scene_.background;
        return scaled(rays_.brought(color, kind), share);
    }

    /// Whether a ray that leaves a surface is sure to meet nothing: its object is the only one, and flat or left
    /// behind.
    bool meets_nothing(const SurfaceRay& ray) const {
        return is_alone() && (!ray.start.is_inside || scene_.kind_of(0) == ObjectKind::triangle);
    }
    /// Whether a ray that leaves a surface can only meet that surface's own object.
    bool is_alone() const { return scene_.object_count == 1; }

    const PreparedScene& scene_;
    Rays rays_;
};

template <Effects E, class Objects>
void render_row(const PreparedScene& scene, int y, std::span<Color> colors, RayCounts& counts) {
    Tracer<E, CountedRays<Objects>> tracer(scene, CountedRays<Objects>(counts));
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
