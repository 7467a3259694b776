// Explains to people what a picture took: the effects with their reasons, the rays by kind, the time by effect.
#pragma once

#include "reference/render/picture.h"

namespace reference::render {

/// The processor time that an effect adds to the effects before it.
struct EffectTime {
    std::string_view effect;
    std::chrono::duration<double> time;
};

/// Renders with primary visibility alone, then again for each of `effects`, together with the effects before it.
/// So nothing is measured inside the loop, which would slow it down. The first entry is "primary visibility".
std::vector<EffectTime> time_by_effect(const PreparedScene& scene, const std::vector<Decision>& decisions,
                                       const Effects& effects, int jobs);

/// One line per effect and one line per kind of rays. Ends with a newline.
std::string explanation(const std::vector<Decision>& decisions, const Rendering& rendering,
                        const std::vector<EffectTime>& times);

}  // namespace reference::render
