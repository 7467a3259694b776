// What students call the parts of a scene.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "harness/scenes/source/scene_part.h"

namespace harness::scenes {

/// Whether a variable with this name may well hold this part, such as "lookFrom" or "cam.eye" for the eye. A name alone
/// proves nothing: students also call their eye "position", and other things "up".
bool may_name(std::string_view name, ScenePart part);

}  // namespace harness::scenes
