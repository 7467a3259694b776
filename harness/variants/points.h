// Awards the points that a rubric gives for answers on other scenes.
#pragma once

#include <vector>

#include "harness/record/graded.h"
#include "reference/toml/assignment.h"

namespace harness::variants {

/// Throws reference::AssignmentError if the rubric gives points for other scenes but `count` is 0.
void require_variants(const reference::Assignment& assignment, int count);

/// Adds the rubric's variant_points to each score and its maximum; does nothing if the rubric gives none. Every scene
/// is worth an equal part of these points, and a program gets the share of it that its answers earn there. A scene that
/// was not tried counts with the share on the assignment's own scene, because the student is not at fault if a scene
/// was not located in the source. If that share is above 0, the flag "variants_not_tried" asks a person to decide about
/// a program that was not tried on every scene, or whose eye or one of its objects did not move. Call it after the
/// trial of on_variants.
void award_variant_points(std::vector<Graded>& graded, const reference::Rubric& rubric);

}  // namespace harness::variants
