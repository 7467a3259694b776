// What students call the parts of a scene.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "harness/variants/scene_part.h"

namespace harness::variants {

/// Whether a variable of this name may well hold this part, e.g. "lookFrom" or "cam.eye" the eye. A name says nothing
/// by itself: students call their eye "position", too, and other things "up".
bool may_name(std::string_view name, ScenePart part);

}  // namespace harness::variants
