// The methods that a mesh is measured with.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "reference/accuracy/mesh/embree.h"
#include "reference/accuracy/mesh/mesh_rays.h"
#include "reference/render/scene/prepared_scene.h"

namespace reference::accuracy {

struct MeshMethod {
    std::string kernel;
    std::string scalar;
    std::string source;
    bool certain = false;
    /// hits[i] for ray i, of the first `count` rays.
    std::function<void(const Rays<kernel::Ray>& rays, std::size_t count, std::vector<MeshHit>& hits)> run;
};

/// Certified, with each set of instructions of this machine; the textbook in doubles and in floats; and Embree, fast
/// and robust, unless it is null. What belongs to the mesh alone is built here. `scene` is that of the mesh and must
/// outlive the methods: those that are certified set its tree's instructions and walk it.
std::vector<MeshMethod> mesh_methods(const Mesh& mesh, render::PreparedScene& scene,
                                     const std::shared_ptr<const EmbreeLibrary>& embree);

}  // namespace reference::accuracy
