// A copy of a source that reads the scene's numbers from a table, so that one program runs on every scene.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "harness/source/scene/scene_literals.h"

namespace harness::variants {

/// The source with each located number replaced by a constant's like from a table, which the program fills from its
/// stdin before anything else runs. Lines keep their numbers, and the leading directives stay as they are. Empty if
/// there is nothing to replace, too much, or a long double, and where a number may be read too early (early_read.h).
/// The copy need not compile: a number may have to be constant where it stands. And nothing proves that it does what
/// the source does; whoever runs it compares.
std::optional<std::string> with_table(std::string_view source, const source::SceneLiterals& found);

/// What the copy reads from its stdin on the scene `other`: each number as with_scene writes it. Empty where
/// with_scene is, where with_table is, and where a number is out of its type's range.
std::optional<std::string> table_of(const source::SceneLiterals& found, const source::DecimalScene& other);

}  // namespace harness::variants
