// Warns an instructor about answers that a scene leaves uncertain in float.
#pragma once

#include <string>
#include <vector>

#include "reference/key/answer.h"
#include "reference/numbers/decimal.h"
#include "reference/stages/scene.h"

namespace reference {

/// For every object with an item whose allowance exceeds a hundredth of its value, or that float can't answer: one
/// paragraph that names the items, the reason, and what to change. Empty for a scene that float answers well.
std::vector<std::string> tell_wide_allowances(const std::vector<KeyQuestion>& questions, const Scene<Decimal>& scene);

}  // namespace reference
