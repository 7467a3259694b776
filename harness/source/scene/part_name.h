// The names of the parts of a scene in the handout and in students' sources.
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include "harness/source/scene/scene_part.h"

namespace harness::source {

/// The handout's word for the part, e.g. "eye", "A" or "cylinder radius".
std::string_view to_string(ScenePart part);

/// "eye = (0, 0, 4)"
std::string describe(const DecimalScene& scene, ScenePart part);

/// Whether a variable with this name may well be this part, such as "lookFrom" or "cam.eye" for the eye. A name alone
/// proves nothing: students also call their eye "position", and other things "up".
bool may_name(std::string_view name, ScenePart part);

/// Whether the name says that it belongs to such an object: "sphereCenter", "tube.r".
bool mentions(std::string_view name, reference::Subject object);

/// Whether the name says that it belongs to any object but this one.
bool mentions_another(std::string_view name, reference::Subject object);

// For code that interprets names.

/// The last word of a name: "C" of "spheres[0].C".
std::string_view last_word(std::string_view name);

/// The name in lower case and without underscores.
std::string plain_name(std::string_view name);

using Words = std::initializer_list<std::string_view>;

bool is_one_of(std::string_view name, Words words);
bool holds_one_of(std::string_view name, std::span<const std::string_view> words);
bool holds_one_of(std::string_view name, Words words);

/// Whether a last word may mean a radius, both as written and as plain_name returns it. "r" alone does not: the
/// window's right edge is called r or clipR.
bool may_name_radius(std::string_view written, std::string_view plain);

}  // namespace harness::source
