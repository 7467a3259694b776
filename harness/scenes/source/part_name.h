// What students call the parts of a scene.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "harness/scenes/source/scene_part.h"

namespace harness::scenes {

/// Whether a variable with this name may well hold this part, such as "lookFrom" or "cam.eye" for the eye. A name alone
/// proves nothing: students also call their eye "position", and other things "up".
bool may_name(std::string_view name, ScenePart part);

/// Whether the name says that it is about a cylinder: "cylCenter", "tube.r".
bool mentions_cylinder(std::string_view name);

/// What a source may state in place of a part.
enum class Form {
    itself,
    half,    ///< of the cylinder's height
    top,     ///< of the cylinder's height: the top cap's y; of its center: the top cap's
    bottom,  ///< likewise of the bottom cap
};

/// How a number or a point with this name may state how far the cylinder reaches: "cylHeight" itself, "halfHeight",
/// "yMax", "topCap". Empty for any other name.
std::optional<Form> cylinder_form(std::string_view name);

/// The numbers that state a part in this form, as many as size_of says; the rest is 0. The scene must have the part.
std::array<double, 3> value_of(const DecimalScene& scene, ScenePart part, Form form);

}  // namespace harness::scenes
