// What a method says of a ray and a mesh.
#pragma once

#include <cstdint>

namespace reference::accuracy {

struct MeshHit {
    bool is_hit = false;
    std::uint32_t face = 0;  ///< of a hit: which face is hit first
    double t = 0;            ///< of a hit
};

}  // namespace reference::accuracy
