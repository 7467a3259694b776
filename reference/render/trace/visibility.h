// Finds the first object that a ray hits, and whether an object lies before a light, either over all objects of a scene
// or over its tree. Where two t's are too close for doubles, exact arithmetic orders them. If two objects are hit at
// exactly the same t, the first in the file counts.
#pragma once

#include <bit>

#include "reference/render/scene/visitor.h"
#include "reference/render/scene/walk.h"
#include "reference/render/trace/object_hit.h"

namespace reference::render {

struct Nearest {
    double t = HUGE_VAL;  ///< infinite for none
    std::uint32_t object = 0;
    bool from_inside = false;
    kernel::CylinderPart part = kernel::CylinderPart::tube;  ///< of a cylinder

    bool is_hit() const { return t < HUGE_VAL; }
};

/// Both t's are known to a relative error of 2^-26, so a difference above 2^-24 of them decides. No t except 0 is near
/// the smallest double, because no number of the scene is.
template <class AnyRay>
KERNEL_INLINE void take_nearer(const PreparedScene& scene, const AnyRay& ray, const ObjectHit& hit,
                               std::uint32_t object, Nearest& nearest) {
    if (!hit.is_hit) return;
    const double difference = hit.t - nearest.t;
    if (!(std::abs(difference) > 0x1p-24 * hit.t)) [[unlikely]] {
        const auto order = order_exactly(scene, ray, object, nearest.object);
        if (order > 0 || (order == 0 && object > nearest.object)) return;
    } else if (difference > 0) {
        return;
    }
    nearest = {hit.t, object, hit.from_inside, hit.part};
}

inline bool starts_on(const CameraRay& /*ray*/, std::uint32_t /*object*/) {
    return false;
}
inline bool starts_on(const SurfaceRay& ray, std::uint32_t object) {
    return ray.start.object == object;
}
inline Nearest own_hit(const PreparedScene& /*scene*/, const CameraRay& /*ray*/) {
    return {};
}
inline Nearest own_hit(const PreparedScene& scene, const SurfaceRay& ray) {
    const ObjectHit hit = hit_own(scene, ray);
    return {hit.is_hit ? hit.t : HUGE_VAL, ray.start.object, hit.from_inside, hit.part};
}

/// `end` is the t of the light: 1, or infinite for a light at infinity.
template <class AnyRay>
KERNEL_INLINE bool is_before_end(const PreparedScene& scene, const AnyRay& ray, const ObjectHit& hit,
                                 std::uint32_t object, double end) {
    if (!hit.is_hit) return false;
    if (hit.t < end * (1 - 0x1p-24)) return true;
    return hit.t <= end * (1 + 0x1p-24) && is_hit_before_end(scene, ray, object);
}

/// All objects, one after the other. is_blocked() leaves out the object that the ray starts on. A scene without
/// cylinders does not pay for them.
template <bool has_cylinders>
struct ListOfObjects {
    template <class AnyRay>
    KERNEL_INLINE static Nearest first_hit(const PreparedScene& scene, const AnyRay& ray) {
        Nearest nearest = own_hit(scene, ray);
        std::uint32_t object = 0;
        for (const Sphere<double>& sphere : scene.spheres) {
            if (!starts_on(ray, object)) {
                take_nearer(scene, ray, hit_sphere(scene, ray, sphere, object), object, nearest);
            }
            ++object;
        }
        for (const kernel::PreparedTriangle<double>& triangle : scene.triangles) {
            if (!starts_on(ray, object)) {
                take_nearer(scene, ray, hit_triangle(scene, ray, triangle, object), object, nearest);
            }
            ++object;
        }
        if constexpr (has_cylinders) {
            for (; object < scene.object_count; ++object) {
                if (!starts_on(ray, object)) {
                    take_nearer(scene, ray, hit_cylinder(scene, ray, object), object, nearest);
                }
            }
        }
        return nearest;
    }

    template <class AnyRay = SurfaceRay>
    static bool is_blocked(const PreparedScene& scene, const AnyRay& ray, double end) {
        for (std::uint32_t i = 0; i < scene.object_count; ++i) {
            if (!starts_on(ray, i) && is_before_end(scene, ray, hit_object(scene, ray, i), i, end)) return true;
        }
        return false;
    }
};

using ObjectList = ListOfObjects<true>;

/// The largest t of a hit that must still be compared with a hit at t.
inline double reach(double t) {
    return t * (1 + 0x1p-22) + 0x1p-900;
}

/// Calls visit(object, hit, until) for what a walk finds.
template <class AnyRay, class Visit>
class HitVisitor final : public Visitor {
  public:
    HitVisitor(const PreparedScene& scene, const AnyRay& ray, Visit visit) : scene_(scene), ray_(ray), visit_(visit) {}

    bool visit(const Found& found, double& until) override {
        for (unsigned lanes = found.hits | found.open; lanes != 0; lanes &= lanes - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
            const std::uint32_t object = found.leaf.objects[lane];
            if (starts_on(ray_, object)) continue;
            const bool is_known = (found.hits >> lane & 1U) != 0;
            const ObjectHit hit = is_known ? ObjectHit{true, false, found.t[lane]} : hit_object(scene_, ray_, object);
            if (visit_(object, hit, until)) return true;
        }
        return false;
    }

  private:
    const PreparedScene& scene_;
    const AnyRay& ray_;
    Visit visit_;
};

/// Only the objects in boxes that the ray may meet. is_blocked() leaves out the object that the ray starts on.
struct ObjectTree {
    template <class AnyRay>
    static Nearest first_hit(const PreparedScene& scene, const AnyRay& ray) {
        Nearest nearest = own_hit(scene, ray);
        visit(scene, ray, reach(nearest.t), [&](std::uint32_t i, const ObjectHit& hit, double& until) {
            take_nearer(scene, ray, hit, i, nearest);
            until = reach(nearest.t);
            return false;
        });
        return nearest;
    }

    template <class AnyRay = SurfaceRay>
    static bool is_blocked(const PreparedScene& scene, const AnyRay& ray, double end) {
        return visit(scene, ray, reach(end), [&](std::uint32_t i, const ObjectHit& hit, double& /*until*/) {
            return is_before_end(scene, ray, hit, i, end);
        });
    }

  private:
    template <class AnyRay, class Visit>
    static bool visit(const PreparedScene& scene, const AnyRay& ray, double until, Visit visit) {
        HitVisitor<AnyRay, Visit> visitor(scene, ray, visit);
        return walk(*scene.tree, ray.ray, uncertainty_of(ray), until, visitor);
    }
};

}  // namespace reference::render
