// The effects that a scene needs when it is rendered. They are decided once from the scene.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace reference::render {

struct PreparedScene;

/// The effects beyond primary visibility, which every picture has. Shadows exist only with illumination.
struct Effects {
    bool illumination = false;
    bool shadows = false;
    bool mirrors = false;
    bool refraction = false;
    bool supersampling = false;
    /// Enabled effects are also computed where they add nothing: each lit place is shaded and sends a ray to each
    /// light, along the mirror and through the surface, for any material. The picture stays the same. Supersampling is
    /// not forced, because more samples change the picture.
    bool forced = false;

    bool operator==(const Effects&) const = default;
};

constexpr Effects all_effects{true, true, true, true, true, true};

/// Whether an effect is on, and the sentence that says why.
struct Decision {
    std::string_view name;  ///< "illumination"
    bool Effects::*effect;
    bool on;
    std::string reason;
};

/// In the order of Effects. An effect is off only if the picture would be the same with it, to the last bit.
std::vector<Decision> decide_effects(const PreparedScene& scene);
/// The effects that are on.
Effects effects_of(const std::vector<Decision>& decisions);

}  // namespace reference::render
