// Lines that say which object the answers below them are about, in printouts that don't number their questions.
#pragma once

#include <optional>
#include <vector>

#include "harness/read/transcript.h"
#include "reference/stages/items.h"

namespace harness {

/// The object that each value of the section was printed for: that of the title above it, "--- Sphere ---", or of its
/// own row, "Sphere: t = 0.59"; none above the first title and below one about something else, "Camera:". Empty unless
/// there are titles for two objects at least.
std::vector<std::optional<reference::Subject>> titled_objects(const Section& section);

}  // namespace harness
