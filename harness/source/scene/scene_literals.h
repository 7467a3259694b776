// Finds where a student's source states the scene, and writes other scenes into the source.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/source/scene/scene_part.h"

namespace harness::source {

/// The numbers of the scene that were found in a source.
struct SceneLiterals {
    std::vector<SceneLiteral> literals;  ///< of the located parts, in the source's order, without overlaps
    PartSet located;
};

/// Finds the scene's numbers in the source. A value identifies a part if no other part has it and if it is not a common
/// value such as (0, 0, 0). Otherwise the name that it initializes identifies the part, or its place among others, as
/// in lookAt(eye, at, up). A part is located if every place that may state it surely does. A doubtful part is not
/// located and must stay unchanged. Numbers within a formula are never used. Parts that belong together according to an
/// object's file are located as a whole or not at all. Linear in the source's size, except for sorting the results.
SceneLiterals find_scene(std::string_view source, const DecimalScene& scene);

/// The numbers of `other` in the literal's place, three for a splat, each a literal of the same type. Empty if one
/// can't be written that way, such as 1.5 where the source has an int.
std::optional<std::vector<std::string>> numbers_in_place(const SceneLiteral& literal, const DecimalScene& other);

/// The source with its located numbers replaced by those of `other`, each written like the number that it replaces.
/// `other` may differ from the original scene only in located parts. Empty if a number can't be written that way.
std::optional<std::string> with_scene(std::string_view source, const SceneLiterals& found, const DecimalScene& other);

}  // namespace harness::source
