#include "reference/accuracy/mesh/mesh_judge.h"

#include <stdexcept>

#include "reference/render/trace/visibility.h"

namespace reference::accuracy {
namespace {

using render::CameraRay;
using render::ObjectHit;

/// The face with the t nearest to the given one, among all that the ray hits. It hits at least one.
std::uint32_t nearest_hit(const render::PreparedScene& scene, const CameraRay& ray, double t) {
    double least = HUGE_VAL;
    std::uint32_t nearest = 0;
    const auto compare = [&](std::uint32_t face, const ObjectHit& hit, double& /*until*/) {
        if (hit.is_hit && std::abs(hit.t - t) < least) {
            least = std::abs(hit.t - t);
            nearest = face;
        }
        return false;
    };
    render::HitVisitor<CameraRay, decltype(compare)> visitor(scene, ray, compare);
    render::walk(*scene.tree, ray.ray, 0, HUGE_VAL, visitor);
    return nearest;
}

}  // namespace

render::PreparedScene scene_of(const Mesh& mesh) {
    std::vector<Triangle<double>> triangles;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) triangles.push_back(mesh.triangle<double>(face));
    return render::prepare_triangles(triangles);
}

MeshHit certified_hit(const render::PreparedScene& scene, const kernel::Ray<double>& ray) {
    const render::Nearest nearest = render::ObjectTree::first_hit(scene, CameraRay{ray});
    return {nearest.is_hit(), nearest.object, nearest.t};
}

MeshVerdict verdict(const render::PreparedScene& scene, const kernel::Ray<double>& ray, const MeshHit& first,
                    const MeshHit& given) {
    const bool is_hit = given.is_hit && std::isfinite(given.t);
    if (!first.is_hit) return is_hit ? MeshVerdict::phantom : MeshVerdict::right;
    if (!is_hit) return MeshVerdict::slipped;
    if (given.face == first.face) return MeshVerdict::right;
    const CameraRay as_traced{ray};
    const bool is_true_hit = hit_object(scene, as_traced, given.face).is_hit;
    const std::uint32_t meant = is_true_hit ? given.face : nearest_hit(scene, as_traced, given.t);
    return order_exactly(scene, as_traced, meant, first.face) == 0 ? MeshVerdict::right : MeshVerdict::slipped;
}

TrueAnswer true_answer(const render::PreparedScene& scene, const kernel::Ray<double>& ray, const MeshHit& first) {
    if (!first.is_hit) return {};
    const TrueAnswer truth = true_answer(TriangleCase{ray, scene.triangles[first.face].triangle});
    if (truth.outcome != Outcome::hit) throw std::logic_error("the certified walk hits a face that the ray misses");
    return truth;
}

}  // namespace reference::accuracy
