#include "reference/render/visibility.h"

#include "reference/render/object_hit.h"

namespace reference::render {
namespace {

/// Both t's are known to a relative error of 2^-26, so a difference above 2^-24 of them decides. No t except 0 is near
/// the smallest double, because no number of the scene is.
bool is_nearer(const PreparedScene& scene, const Ray& ray, const Hit& hit, const Hit& nearest) {
    const double difference = hit.t - nearest.t;
    if (std::abs(difference) > 0x1p-24 * hit.t) return difference < 0;
    const auto order = order_exactly(scene, ray, hit.object, nearest.object);
    return order < 0 || (order == 0 && hit.object < nearest.object);
}

bool is_before_end(const PreparedScene& scene, const Ray& ray, const Hit& hit, double end) {
    if (!hit.is_hit()) return false;
    if (hit.t < end * (1 - 0x1p-24)) return true;
    return hit.t <= end * (1 + 0x1p-24) && is_hit_before_end(scene, ray, hit.object);
}

}  // namespace

Hit first_hit(const PreparedScene& scene, const Ray& ray) {
    Hit nearest;
    for (std::uint32_t object = 0; object < scene.object_count(); ++object) {
        const Hit hit = hit_object(scene, ray, object);
        if (hit.is_hit() && is_nearer(scene, ray, hit, nearest)) nearest = hit;
    }
    return nearest;
}

bool is_blocked(const PreparedScene& scene, const Ray& ray, double end) {
    for (std::uint32_t object = 0; object < scene.object_count(); ++object) {
        if (is_before_end(scene, ray, hit_object(scene, ray, object), end)) return true;
    }
    return false;
}

bool is_blocked_by_own(const PreparedScene& scene, const Ray& ray, double end) {
    return is_before_end(scene, ray, hit_object(scene, ray, ray.start->object), end);
}

}  // namespace reference::render
