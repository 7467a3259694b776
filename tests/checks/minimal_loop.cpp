#include "tests/checks/minimal_loop.h"

#include "reference/kernel/first.h"

using namespace reference;

namespace {

/// Called for two hits too close for doubles to order. The measured scenes have no such hits.
[[gnu::noinline, gnu::cold]] void give_up() {
    throw std::logic_error("hits too close for a minimal loop");
}

}  // namespace

void minimal_row(const render::PreparedScene& scene, int y, std::span<Color> colors) {
    const render::Eye& eye = scene.eye;
    const double window_y = eye.rows[static_cast<std::size_t>(y)];
    const Vec3<double> row = scaled(eye.basis.Y_vcs, window_y);
    const Vec3<double> depth = scaled(eye.basis.Z_vcs, eye.z);
    for (std::size_t x = 0; x < colors.size(); ++x) {
        const Vec3<double> start = scaled(eye.basis.X_vcs, eye.columns[x]) + row + depth + eye.position;
        const kernel::Ray<double> ray{start, normalized(Vec3<double>(start - eye.position))};
        const Sphere<double>* sphere = nullptr;
        const Vec3<double>* normal = nullptr;
        double t = HUGE_VAL;
        for (const Sphere<double>& other : scene.spheres) {
            const kernel::SphereFilter filter(ray, other);
            if (!filter.is_known(kernel::SphereFilter::margin_for_t)) [[unlikely]] {
                const kernel::SphereHit hit = kernel::intersect(ray, other);
                if (hit.result == kernel::SphereResult::miss || hit.t > t) continue;
                t = hit.t;
                sphere = &other;
                continue;
            }
            if (!filter.is_hit()) continue;
            const double other_t = filter.root();
            if (std::abs(other_t - t) < 0x1p-24 * other_t) [[unlikely]]
                give_up();
            if (other_t > t) continue;
            t = other_t;
            sphere = &other;
        }
        const Vec3<double>* other_normal = scene.triangle_normals.data();
        for (const kernel::PreparedTriangle<double>& other : scene.triangles) {
            const Vec3<double>* const its_normal = other_normal++;
            const kernel::TriangleFilter filter(ray, other);
            if (!filter.is_known_with_t()) [[unlikely]] {
                const kernel::TriangleHit hit = kernel::intersect(ray, other.triangle);
                if (hit.result == kernel::TriangleResult::miss || hit.t > t) continue;
                t = hit.t;
                sphere = nullptr;
                normal = its_normal;
                continue;
            }
            if (!filter.is_hit()) continue;
            const double other_t = filter.t();
            if (std::abs(other_t - t) < 0x1p-24 * other_t) [[unlikely]]
                give_up();
            if (other_t > t) continue;
            t = other_t;
            sphere = nullptr;
            normal = its_normal;
        }
        if (t == HUGE_VAL) {
            colors[x] = scene.background;
            continue;
        }
        const Vec3<double> N = sphere != nullptr
                                   ? normalized(Vec3<double>(ray.origin + scaled(ray.direction, t) - sphere->center))
                                   : *normal;
        colors[x] = scaled(N, 0.5) + Color(0.5, 0.5, 0.5);
    }
}
