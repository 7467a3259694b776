// The loop over the pixels of a row, compiled for each set of effects.
#pragma once

#include <cstdint>
#include <span>

#include "reference/render/scene/effects.h"
#include "reference/render/scene/prepared_scene.h"

namespace reference::render {

/// Rays beyond those of the camera, by kind. A loop without an effect can't count that effect's rays.
struct RayCounts {
    std::uint64_t shadow = 0;
    std::uint64_t mirrored = 0;
    std::uint64_t refracted = 0;
    std::uint64_t reflected_in_glass = 0;  ///< where the glass is not also a mirror

    RayCounts& operator+=(const RayCounts& other);
};

/// Fills the colors of one row of pixels; y counts from the bottom as in DCS. `colors` has the scene's width. Adds to
/// `counts`.
using RenderRow = void (*)(const PreparedScene& scene, int y, std::span<Color> colors, RayCounts& counts);

/// The loop for these effects, over the scene's tree if it has one, else over its objects. Without illumination,
/// shadows are ignored.
RenderRow row_renderer(const PreparedScene& scene, const Effects& effects);

/// A ray is not sent on after this many bounces, or if its share of its sample is below least_share. Its light is
/// missing in the picture: most at the rim of glass, where light bounces many times, and there less than 1 in 100.
constexpr int most_bounces = 256;
constexpr double least_share = 0x1p-16;

}  // namespace reference::render
