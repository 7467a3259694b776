// Judges what methods say of rays at a mesh, by the certified walk and exact arithmetic.
#pragma once

#include <vector>

#include "reference/accuracy/mesh/mesh.h"
#include "reference/accuracy/mesh/mesh_hit.h"
#include "reference/accuracy/rays/true_answer.h"
#include "reference/render/scene/prepared_scene.h"

namespace reference::accuracy {

/// The mesh as the renderer walks it, with face i as object i.
render::PreparedScene scene_of(const Mesh& mesh);

enum class MeshVerdict {
    right,
    slipped,  ///< missed what the ray hits first, or took something farther for it
    phantom,  ///< a hit where the ray hits nothing
};

/// The first face on the ray, without a wrong decision.
MeshHit certified_hit(const render::PreparedScene& scene, const kernel::Ray<double>& ray);

/// `first` is the certified hit. Rounding may put a hit onto a neighbour that the ray misses by a hair, or its t off:
/// such a hit belongs to the true hit with the nearest t, and is right if that is the first.
MeshVerdict verdict(const render::PreparedScene& scene, const kernel::Ray<double>& ray, const MeshHit& first,
                    const MeshHit& given);

/// The true t of the certified hit, in rationals. Throws std::logic_error if the ray misses that face.
TrueAnswer true_answer(const render::PreparedScene& scene, const kernel::Ray<double>& ray, const MeshHit& first);

}  // namespace reference::accuracy
