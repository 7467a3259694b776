// The points that a rubric gives for answers on other scenes.
#pragma once

#include <vector>

#include "harness/grade.h"

namespace harness::variants {

/// Throws reference::AssignmentError where the rubric gives points for other scenes and there are to be none.
void require_variants(const reference::Assignment& assignment, int count);

/// Adds the rubric's variant_points to each score and its maximum; nothing where the rubric gives none. Every scene has
/// the same part of them, and a program gets the share of it that its answers earn there; one that was not tried counts
/// with the share on the assignment's own scene: that a scene was not found is no fault. Where that is above 0, the
/// flag "variants_not_tried" hands to a person what was not tried on every scene, or with eye, center and triangle as
/// they were. For submissions that run_variants has seen.
void award_variant_points(std::vector<Graded>& graded, const reference::Rubric& rubric);

}  // namespace harness::variants
