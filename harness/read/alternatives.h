// Lines that give more than one answer: "0.58 or 3.41", "+-4".
#pragma once

#include <string_view>

namespace harness {

/// Whether the line gives several values for one answer without choosing one, or withdraws its value: "0.58 (wrong,
/// should be 3.41)". Only words and signs count, not whether a value is right.
bool offers_several(std::string_view line);

/// Whether the line gives two numbers under one name, "b: -4 and 4", but not "b and c: -4 and 4".
bool gives_two_numbers(std::string_view line);

/// Whether the line chooses the other of two roots, or names the number it chooses: "using the larger root", "t = t2".
bool chooses_other_root(std::string_view line);

/// Whether the line gives another value for the answer above it: "or 3.41".
bool is_alternative(std::string_view line);

}  // namespace harness
