// A copy of a source that reads the scene's numbers from a table, so that one program runs on every scene.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "harness/source/scene/scene_literals.h"

namespace harness::variants {

/// The source with each located number replaced by a constant-like value from a table, which the program fills from its
/// stdin before anything else runs. Lines keep their numbers, and the leading directives stay unchanged. Empty if there
/// is nothing to replace, too much, or a long double, and if a number may be read too early (early_read.h). The copy
/// may fail to compile: a number may have to be constant at its place. Nothing proves that the copy behaves like the
/// source; the caller compares them.
std::optional<std::string> with_table(std::string_view source, const source::SceneLiterals& found);

/// The copy's stdin for the scene `other`: each number as with_scene writes it. Empty if with_scene or with_table
/// returns empty, or if a number is out of its type's range.
std::optional<std::string> table_of(const source::SceneLiterals& found, const source::DecimalScene& other);

}  // namespace harness::variants
