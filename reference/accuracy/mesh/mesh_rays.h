// Rays at a mesh. All numbers are floats.
#pragma once

#include <string>

#include "reference/accuracy/mesh/mesh.h"
#include "reference/accuracy/methods/method.h"

namespace reference::accuracy {

struct MeshRays {
    std::string distribution;
    bool hard = false;  ///< aims at where faces meet
    Rays<kernel::Ray> rays;
};

/// `count` rays each: of a camera that sees the mesh, row by row; from anywhere around the mesh in any direction; at
/// points of edges and at vertices, which a ray passes as near as the rounding of its direction lets it; and exactly
/// through middles of edges and vertices. A ray of the last four comes from where all faces that meet there are seen
/// from the same side, so that none passes beside the surface. Where a hundred places and starts give no such ray, the
/// last is taken.
std::vector<MeshRays> rays_at(const Mesh& mesh, std::uint64_t seed, std::uint64_t count);

}  // namespace reference::accuracy
