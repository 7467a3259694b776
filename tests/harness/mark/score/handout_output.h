// The handout's scene as a right program prints it, with some answers changed.
#pragma once

#include <map>
#include <string>

#include "harness/mark/score/score.h"
#include "reference/stages/items.h"

namespace harness {

/// The right output for the handout's scene, with the values of some labels replaced; "" leaves one out.
std::string handout_output(const std::map<std::string, std::string>& changed = {});

/// How the item is marked then.
std::string verdict_with(const std::map<std::string, std::string>& changed, const reference::ItemId& id);

/// As which other form or reading it is right then.
std::string accepted_with(const std::map<std::string, std::string>& changed, const reference::ItemId& id);

}  // namespace harness
