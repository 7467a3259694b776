#include "reference/render/trace.h"

#include <algorithm>

#include "reference/render/fresnel.h"
#include "reference/render/visibility.h"

namespace reference::render {
namespace {

/// A ray is not sent on after this many bounces, or if its share of its sample is below least_share. The picture lacks
/// its light: most at the rim of glass, where light bounces many times, and there less than 1 in 100.
constexpr int most_bounces = 256;
constexpr double least_share = 0x1p-16;

/// x^n by squaring: std::pow differs between machines.
double power(double x, int n) {
    double result = 1;
    for (; n > 0; n /= 2, x *= x) {
        if (n % 2 == 1) result *= x;
    }
    return result;
}

/// The color that a ray returns. It shoots no ray and computes no light if the result is known or would be multiplied
/// by 0.
class Tracer {
  public:
    Tracer(const PreparedScene& scene, const Effects& effects, Work& work)
        : scene_(scene),
          effects_(effects),
          sends_on_(effects.mirrors || effects.refraction),
          has_surfaces_(effects.illumination || sends_on_),
          work_(work) {}

    /// The color of the ray through x of the window.
    Color camera_color(const RowOfRays& row, double x) {
        ++work_.camera_rays;
        const Ray ray{row.ray(x)};
        const Hit hit = first_hit(scene_, ray);
        return hit.is_hit() ? color_at(ray.ray, hit, {1, 0}) : scene_.background;
    }

  private:
    /// A ray's share of its sample, and how often it was sent on.
    struct Path {
        double share;
        int bounces;
    };

    /// Where a ray meets a surface.
    struct Place {
        Vec3<double> V;       ///< the ray's direction
        Vec3<double> normal;  ///< of unit length, on the side that the ray comes from
        Start start;          ///< for rays that continue from here on that side
        bool is_inside;       ///< the ray comes from inside a sphere or a cylinder, or from the back of a triangle
    };

    /// Of unit length; outward for a sphere and a cylinder.
    Vec3<double> normal_at(const Hit& hit, const Vec3<double>& point) const {
        switch (scene_.kind_of(hit.object)) {
            case ObjectKind::sphere: return sphere_normal(point, scene_.spheres[hit.object].center);
            case ObjectKind::triangle: return scene_.triangle_normals[hit.object - scene_.spheres.size()];
            case ObjectKind::cylinder: break;
        }
        return normal_of(scene_.cylinder(hit.object), hit.part, point);
    }

    Start start_at(const Hit& hit, const Vec3<double>& point, const Vec3<double>& normal, bool is_inside) const {
        const std::uint32_t object = hit.object;
        switch (scene_.kind_of(object)) {
            case ObjectKind::sphere: return start_on(scene_.spheres[object], object, normal, is_inside);
            case ObjectKind::triangle: return start_on(scene_.triangle(object), object, point);
            case ObjectKind::cylinder: break;
        }
        return start_on(scene_.cylinder(object), object, hit.part, point, is_inside);
    }

    Color color_at(const kernel::Ray<double>& ray, const Hit& hit, const Path& path) {
        const Vec3<double> point = point_on_ray(ray.origin, ray.direction, hit.t);
        const Vec3<double> normal = normal_at(hit, point);
        const Color by_normal = scaled(normal, 0.5) + Color(0.5, 0.5, 0.5);
        if (!has_surfaces_) return by_normal;
        const Surface& surface = scene_.surfaces[scene_.surface_of[hit.object]];
        const bool is_triangle = scene_.kind_of(hit.object) == ObjectKind::triangle;
        const bool is_inside = is_triangle ? dot(ray.direction, normal) > 0 : hit.from_inside;
        const Place place{ray.direction, is_inside ? -normal : normal, start_at(hit, point, normal, is_inside),
                          is_inside};
        Color color = by_normal;
        const bool is_shaded = effects_.illumination && surface.is_lit && surface.own_share > 0;
        if (is_shaded || (effects_.illumination && effects_.forced)) {
            const Color lit = illuminated(surface, place);
            if (is_shaded) color = lit;
        }
        if (sends_on_) color = scaled(color, surface.own_share) + passed_on(surface.material, place, path);
        return color;
    }

    /// A mirror and glass both send light along the mirrored ray; a single ray is enough for both.
    Color passed_on(const Material& material, const Place& place, const Path& path) {
        Color color(0, 0, 0);
        double reflected = effects_.mirrors ? material.reflectivity : 0;
        if (effects_.refraction && (material.transparency > 0 || effects_.forced)) {
            const double from = place.is_inside ? material.refractive_index : 1;
            const double into = place.is_inside ? 1 : material.refractive_index;
            const double cos_incident = std::clamp(-dot(place.V, place.normal), 0.0, 1.0);
            const Fresnel split = fresnel(cos_incident, from, into);
            reflected += material.transparency * split.reflected;
            const double through = material.transparency * (1 - split.reflected);
            const Vec3<double> V = refracted(place.V, place.normal, cos_incident, split.cos_refracted, from / into);
            Start start = place.start;
            start.is_inside = !place.is_inside;
            if (!split.is_total) color += color_on({{start.point, V}, start}, path, through, work_.refracted_rays);
        }
        if (reflected > 0 || (effects_.mirrors && effects_.forced)) {
            const Ray ray{{place.start.point, mirrored(place.V, place.normal)}, place.start};
            const bool by_mirror = material.reflectivity > 0 || reflected == 0;
            color += color_on(ray, path, reflected, by_mirror ? work_.mirrored_rays : work_.rays_reflected_in_glass);
        }
        return color;
    }

    /// Phong's local illumination, for each light that reaches the place.
    Color illuminated(const Surface& surface, const Place& place) {
        ++work_.shaded;
        const Material& material = surface.material;
        Color color = scene_.ambient_light * material.ambient;
        for (const PointLight& light : scene_.point_lights) {
            color += light_from(light.position - place.start.point, 1, light.color, material, place);
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
        const Ray ray{{place.start.point, way}, place.start};
        if (effects_.shadows && is_blocked_by_own(scene_, ray, end)) return {0, 0, 0};
        const double distance = length(way);
        Color color = scaled(material.diffuse, height / distance);
        const double along_mirror = dot(mirrored(place.V, place.normal), way) / distance;
        if (along_mirror > 0) color += scaled(material.specular, power(along_mirror, material.shininess));
        color = light * color;
        const bool is_known = color == Color(0, 0, 0) || is_alone();
        if (!effects_.shadows || (is_known && !effects_.forced)) return color;
        ++work_.shadow_rays;
        return is_blocked(scene_, ray, end) ? Color(0, 0, 0) : color;
    }

    /// The color of a ray that a surface sends on, times its `share` of the ray that arrived there. Below least_share
    /// or above most_bounces the ray is neither traced nor counted; a forced one of no share goes to its first hit.
    Color color_on(const Ray& ray, const Path& path, double share, std::uint64_t& count) {
        const Path next{path.share * share, path.bounces + 1};
        if (effects_.forced && share == 0) {
            ++count;
            first_hit(scene_, ray);
            return {0, 0, 0};
        }
        if (next.share < least_share || next.bounces > most_bounces) return {0, 0, 0};
        if (meets_nothing(*ray.start)) return scaled(scene_.background, share);
        ++count;
        const Hit hit = first_hit(scene_, ray);
        return scaled(hit.is_hit() ? color_at(ray.ray, hit, next) : scene_.background, share);
    }

    /// Whether a ray that leaves a surface certainly hits nothing: its object is the only one, and it is flat or behind
    /// the ray.
    bool meets_nothing(const Start& start) const {
        return is_alone() && (!start.is_inside || scene_.kind_of(0) == ObjectKind::triangle);
    }
    /// Whether a ray that leaves a surface can only hit the same object.
    bool is_alone() const { return scene_.object_count() == 1; }

    const PreparedScene& scene_;
    const Effects& effects_;
    bool sends_on_;
    bool has_surfaces_;
    Work& work_;
};

}  // namespace

Work& Work::operator+=(const Work& other) {
    camera_rays += other.camera_rays;
    shaded += other.shaded;
    shadow_rays += other.shadow_rays;
    mirrored_rays += other.mirrored_rays;
    refracted_rays += other.refracted_rays;
    rays_reflected_in_glass += other.rays_reflected_in_glass;
    return *this;
}

void render_row(const PreparedScene& scene, const Effects& effects, int y, std::span<Color> colors, Work& work) {
    Tracer tracer(scene, effects, work);
    const Eye& eye = scene.eye;
    const auto side = static_cast<std::size_t>(effects.supersampling ? scene.samples_per_side : 1);
    const std::vector<double>& rows = effects.supersampling ? eye.sample_rows : eye.rows;
    const std::vector<double>& columns = effects.supersampling ? eye.sample_columns : eye.columns;
    std::fill(colors.begin(), colors.end(), Color(0, 0, 0));
    for (std::size_t i = 0; i < side; ++i) {
        const RowOfRays row = eye.row(rows[static_cast<std::size_t>(y) * side + i]);
        for (std::size_t x = 0; x < columns.size(); ++x) colors[x / side] += tracer.camera_color(row, columns[x]);
    }
    for (Color& color : colors) color = scaled(color, 1 / static_cast<double>(side * side));
}

}  // namespace reference::render
