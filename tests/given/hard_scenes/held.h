// What answers on a hard scene are held to, and what they lose there.
#pragma once

#include <string>
#include <vector>

#include "harness/stress/losses.h"
#include "tests/student/scenes.h"

namespace harness::stress {

/// A small sphere far along the ray of a6-2021: o(0, 0, 2), d(0, 0, -1).
student::Marking far_sphere();

/// By one pixel convention alone, as hard scenes are held.
student::Marking held(student::Marking marking,
                      reference::PixelConvention convention = reference::PixelConvention::centre);

/// All right on the scene itself, whatever it is: what counts as looked at.
std::string right_printout(const student::Marking& marking);

std::vector<HardItem> losses_of(const std::string& printed, const student::Marking& marking);

/// The same in words: "6.t: hit_missed".
std::vector<std::string> told_losses(const std::string& printed, const student::Marking& marking);

}  // namespace harness::stress
