// The colors of a picture's rows: one loop for all scenes. What it computes is decided once per scene.
#pragma once

#include <cstdint>
#include <span>

#include "reference/render/effects.h"
#include "reference/render/prepared_scene.h"

namespace reference::render {

/// Counts of the work: the rays by kind, and how often a surface was lit. An effect that is off adds nothing to its
/// counts.
struct Work {
    std::uint64_t camera_rays = 0;
    std::uint64_t shaded = 0;  ///< places whose color was computed from the lights
    std::uint64_t shadow_rays = 0;
    std::uint64_t mirrored_rays = 0;
    std::uint64_t refracted_rays = 0;
    std::uint64_t rays_reflected_in_glass = 0;  ///< where the glass is not also a mirror

    Work& operator+=(const Work& other);
    bool operator==(const Work&) const = default;
};

/// Fills the colors of one row of pixels; y counts from the bottom as in DCS. `colors` has the scene's width. Adds to
/// `work`. Without illumination, shadows are ignored.
void render_row(const PreparedScene& scene, const Effects& effects, int y, std::span<Color> colors, Work& work);

}  // namespace reference::render
