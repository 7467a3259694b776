// Random scenes as an instructor might write them, in short decimals.
#pragma once

#include <cstdint>

#include "reference/assignment.h"

/// One sphere and one triangle, about half of each hit by the ray; valid but for accidents that do not happen.
reference::Assignment random_assignment(std::uint64_t seed);
