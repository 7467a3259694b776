// Keys for hard scenes, and the losses of printed answers there.
#pragma once

#include <string>
#include <vector>

#include "harness/stress/losses.h"
#include "tests/given/student/scenes.h"

namespace harness::stress {

/// A small sphere far along the ray of a6-2021: o(0, 0, 2), d(0, 0, -1).
student::Marking far_sphere();

/// Restricts the rubric to one pixel convention, as hard scenes do, and computes the key again.
student::Marking held(student::Marking marking,
                      reference::PixelConvention convention = reference::PixelConvention::centre);

/// A printout with the right answers of the scene. losses() only examines answers that are right on the original scene.
std::string right_printout(const student::Marking& marking);

std::vector<HardItem> losses_of(const std::string& printed, const student::Marking& marking);

/// The same in words: "6.t: hit_missed".
std::vector<std::string> told_losses(const std::string& printed, const student::Marking& marking);

}  // namespace harness::stress
