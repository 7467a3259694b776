// Random scenes as an instructor might write them, in short decimals.
#pragma once

#include <cstdint>

#include "reference/toml/assignment.h"

/// One sphere and one triangle. The ray hits about half of the spheres and half of the triangles. An invalid scene is
/// possible, but has never occurred.
reference::Assignment random_assignment(std::uint64_t seed);

/// The same scene with a cylinder, which the ray hits in a third of the scenes, and a question 11 about it.
reference::Assignment random_assignment_with_cylinder(std::uint64_t seed);
