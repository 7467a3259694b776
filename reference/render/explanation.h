// What a picture took, for people: the effects with their reasons, the rays by kind, the time by effect.
#pragma once

#include "reference/render/picture.h"

namespace reference::render {

/// Processor time that an effect adds to those before it.
struct EffectTime {
    std::string_view effect;
    std::chrono::duration<double> time;
};

/// Renders for primary visibility alone and again for each effect that is on, with those before it; so nothing is
/// measured within a loop, which would slow what it measures. The first is "primary visibility".
std::vector<EffectTime> time_by_effect(const PreparedScene& scene, const Effects& effects, int jobs);

/// A line an effect, a line a kind of rays. Ends with a newline.
std::string explanation(const std::vector<Decision>& decisions, const Rendering& rendering,
                        const std::vector<EffectTime>& times);

}  // namespace reference::render
