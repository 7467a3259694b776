// What simulating a scene may call for. Decided once from the scene, then compiled in: for each set of effects there is
// a loop over the pixels that holds no test for any other.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace reference::render {

struct PreparedScene;

/// Beyond primary visibility, which every picture has. Shadows only with illumination.
struct Effects {
    bool illumination = false;
    bool shadows = false;
    bool mirrors = false;
    bool refraction = false;
    bool supersampling = false;

    bool operator==(const Effects&) const = default;
};

constexpr Effects all_effects{true, true, true, true, true};

/// Whether an effect is on, and the sentence that says why.
struct Decision {
    std::string_view effect;  ///< as in Effects
    bool on;
    std::string reason;
};

/// In the order of Effects. An effect is off only where the picture would be the same with it, to the last bit.
std::vector<Decision> decide_effects(const PreparedScene& scene);
/// What the decisions say.
Effects effects_of(const std::vector<Decision>& decisions);

}  // namespace reference::render
