// Looks for rays that are shot for nothing, apart from the loops that avoid them.
#pragma once

#include <cstdint>

#include "reference/render/scene/prepared_scene.h"

namespace reference::render {

struct WastedRays {
    std::uint64_t looked_at = 0;  ///< rays beyond those of the camera
    std::uint64_t wasted = 0;     ///< of these: the sample's color is the same whatever the ray brings
};

/// Traces samples spread over the picture again, once for each of their rays: that ray brings endless light. Where the
/// sample's color stays finite, or infinity was multiplied by 0, the ray was for nothing; also a shadow ray that the
/// object blocks on which it starts. Of a sample with hundreds of rays some hundred are looked at. Ends soon after
/// `most` rays.
WastedRays wasted_rays(const PreparedScene& scene, std::uint64_t most);

}  // namespace reference::render
