// The loop over the pixels of a row, compiled for each set of effects.
#pragma once

#include <cstdint>
#include <span>

#include "reference/render/effects.h"
#include "reference/render/prepared_scene.h"

namespace reference::render {

/// Rays beyond those of the camera, by kind. A loop without an effect can't count its rays.
struct RayCounts {
    std::uint64_t shadow = 0;
    std::uint64_t mirrored = 0;
    std::uint64_t refracted = 0;
    std::uint64_t reflected_in_glass = 0;  ///< where the glass is no mirror as well

    RayCounts& operator+=(const RayCounts& other);
};

/// Fills the colors of one row of pixels; y counts from the bottom as in DCS. `colors` has the scene's width. The
/// counts are added to.
using RenderRow = void (*)(const PreparedScene& scene, int y, std::span<Color> colors, RayCounts& counts);

/// The loop for these effects, over the scene's objects or its tree as it has one. Shadows without illumination are
/// without shadows.
RenderRow row_renderer(const PreparedScene& scene, const Effects& effects);

/// No ray is sent on that had been sent on so often, nor one whose share in its sample is below this. What it would
/// have brought is missing: most at the rim of glass, where light goes round for long, and there below 1 in 100.
constexpr int most_bounces = 256;
constexpr double least_share = 0x1p-16;

}  // namespace reference::render
