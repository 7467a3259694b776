#include "reference/cast/first_hit.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <tuple>

#include "reference/kernel/first.h"
#include "reference/render/scene/visitor.h"
#include "reference/render/scene/walk.h"

namespace reference::cast {
namespace {

using render::ObjectKind;
using render::PreparedScene;

/// An object that is hit. t is known to a relative error of 2^-26, or to one unit in the last place if it is subnormal.
struct Candidate {
    std::uint32_t object;
    double t;
};

std::optional<double> t_of(const PreparedScene& scene, const kernel::Ray<double>& ray, std::uint32_t object) {
    switch (scene.kind_of(object)) {
        case ObjectKind::sphere: {
            const auto hit = intersect_to_float(ray, scene.spheres[object]);
            return hit.result == kernel::SphereResult::miss ? std::nullopt : std::optional(hit.t);
        }
        case ObjectKind::triangle: {
            const auto hit = intersect_to_float(ray, scene.triangle(object));
            return hit.result == kernel::TriangleResult::hit ? std::optional(hit.t) : std::nullopt;
        }
        case ObjectKind::cylinder: break;
    }
    const kernel::CylinderHit hit = intersect(ray, scene.cylinder(object));
    return hit.result == kernel::CylinderResult::miss ? std::nullopt : std::optional(hit.t);
}

kernel::Object object_of(const PreparedScene& scene, std::uint32_t object) {
    switch (scene.kind_of(object)) {
        case ObjectKind::sphere: return scene.spheres[object];
        case ObjectKind::triangle: return scene.triangle(object).triangle;
        case ObjectKind::cylinder: break;
    }
    return scene.cylinder(object);
}

/// Keeps the nearest of the objects that a walk finds.
class NearestVisitor final : public render::Visitor {
  public:
    NearestVisitor(const PreparedScene& scene, const kernel::Ray<double>& ray) : scene_(scene), ray_(ray) {}

    bool visit(const render::Found& found, double& until) override {
        for (unsigned lanes = found.hits | found.open; lanes != 0; lanes &= lanes - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
            const std::uint32_t object = found.leaf.objects[lane];
            const bool is_known = (found.hits >> lane & 1U) != 0;
            const std::optional<double> t = is_known ? found.t[lane] : t_of(scene_, ray_, object);
            if (t) take({object, *t});
        }
        // What is hit at the same t may still come.
        if (nearest_) until = nearest_->t * (1 + 0x1p-22) + 0x1p-900;
        return false;
    }

    const std::optional<Candidate>& nearest() const { return nearest_; }
    bool is_tie() const { return is_tie_; }

  private:
    void take(const Candidate& candidate) {
        const auto order = nearest_ ? order_of(candidate, *nearest_) : std::partial_ordering::less;
        if (order > 0) return;
        is_tie_ = order == 0;
        if (order < 0 || candidate.object < nearest_->object) nearest_ = candidate;
    }

    /// A difference above 2^-24 of the smaller t decides, if no t is subnormal or infinite.
    std::partial_ordering order_of(const Candidate& one, const Candidate& other) const {
        const double difference = one.t - other.t;
        const double slack = 0x1p-24 * std::min(one.t, other.t) + 0x1p-1000;
        if (std::abs(difference) > slack && std::isfinite(difference)) return difference <=> 0;
        return kernel::order_exactly(ray_, object_of(scene_, one.object), object_of(scene_, other.object));
    }

    const PreparedScene& scene_;
    const kernel::Ray<double>& ray_;
    std::optional<Candidate> nearest_;
    bool is_tie_ = false;
};

/// The hit with an object that is known to be hit.
FirstHit hit_with(const PreparedScene& scene, const kernel::Ray<double>& ray, std::uint32_t object) {
    FirstHit first;
    first.index = scene.number_of[object];
    switch (scene.kind_of(object)) {
        case ObjectKind::sphere:
            first.kind = FirstHit::Kind::sphere;
            first.t = intersect(ray, scene.spheres[object]).t;
            return first;
        case ObjectKind::triangle: {
            first.kind = FirstHit::Kind::triangle;
            const kernel::TriangleHit hit = intersect(ray, scene.triangle(object).triangle);
            std::tie(first.t, first.u, first.v) = std::tie(hit.t, hit.u, hit.v);
            const auto& meshes = scene.first_of_mesh;
            const auto after = std::upper_bound(meshes.begin(), meshes.end(), object);
            if (after != meshes.begin()) {
                first.kind = FirstHit::Kind::mesh;
                first.face = first.index;
                first.index = static_cast<std::uint32_t>(after - meshes.begin()) - 1;
            }
            return first;
        }
        case ObjectKind::cylinder: break;
    }
    const kernel::CylinderHit hit = intersect(ray, scene.cylinder(object));
    first.kind = FirstHit::Kind::cylinder;
    first.part = hit.part;
    first.t = hit.t;
    return first;
}

}  // namespace

PreparedScene objects_of(const Assignment& scene) {
    // No picture is drawn, so its size does not matter.
    PreparedScene objects = render::prepare_scene(scene, render::PictureSize{1, 1});
    if (!objects.tree && objects.object_count > 0) add_tree(objects);
    return objects;
}

FirstHit first_hit(const PreparedScene& scene, const kernel::Ray<double>& ray) {
    FirstHit first;
    if (!is_valid(ray)) {
        first.kind = FirstHit::Kind::invalid;
        return first;
    }
    if (!scene.tree) return first;
    NearestVisitor visitor(scene, ray);
    walk(*scene.tree, ray, 0, HUGE_VAL, visitor);
    if (!visitor.nearest()) return first;
    first = hit_with(scene, ray, visitor.nearest()->object);
    first.is_tie = visitor.is_tie();
    return first;
}

}  // namespace reference::cast
