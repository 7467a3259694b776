// Of several values, those that are meant: the number that a line says is taken, the vector that a sentence is about.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "harness/read/printed_value.h"

namespace harness {

/// Keeps only the chosen one of the numbers with names alike: of "t1 = 0.5, t2 = 3.5, using t2" and "t = 0.5 or 3.5, so
/// we take 3.5" the second. Changes nothing where the line's values are not single numbers or none is chosen.
void keep_chosen(std::vector<PrintedValue>& values, std::string_view line);

/// The value that a line without numbers names: "chosen: t2", "smaller root: t2", "t = t+". `values` are those above
/// it. "chosen" takes the other numbers with names alike out of them.
std::optional<PrintedValue> choose_by_name(std::vector<PrintedValue>& values, std::string_view line);

/// The one of the two roots above that a line without numbers chooses: "using the larger root". Takes both out of the
/// values and calls it t.
std::optional<PrintedValue> choose_by_size(std::vector<PrintedValue>& values, std::string_view line);

/// Where a number is called the chosen one, "selected t = 3.5", "t used: 3.5" or "-> 3.5", which repeats one of them,
/// takes the others with names alike out of the values above it, if there are any, and calls it t.
void keep_selected(std::vector<PrintedValue>& values, PrintedValue& selected, std::string_view line);

/// Drops where the ray leaves an object, "exit t: 4.41", "leaves it at t = 4.41", "t = 4.41 is the exit", where the
/// values have the point before it at which it enters. `lines` are those of the values' section.
void drop_exits(std::vector<PrintedValue>& values, const std::vector<PrintedLine>& lines);

/// Of two vectors on a line drops the first if a remark says that it is not normalized: "N = (0, 0, 2) (before
/// normalizing), (0, 0, 1) (after)".
void drop_raw(std::vector<PrintedValue>& values, std::string_view line);

/// Drops the points that only say where from: "direction from eye (0 0 4) to pixel (0 0 2) = (0, 0, -1)" and "N at
/// (1, 2, 3) is (0, 0, 1)". `values` are a line's; the last vector, which has no name of its own, is what the words
/// before them name.
void drop_places(std::vector<PrintedValue>& values);

/// Drops vectors of a negated name where the name itself stands nearby before it: "-Z_vcs: (-1, 0, 0)" below "Z_vcs:
/// (1, 0, 0)". `lines` are those of the values' section.
void drop_negated(std::vector<PrintedValue>& values, const std::vector<PrintedLine>& lines);

/// Names the vectors that stand behind a vector as what it is when normalized, "N/|N|", "normalize(N)", "N_norm" and
/// "unit", by the vector's name: "N normalized".
void name_normalized(std::vector<PrintedValue>& values);

}  // namespace harness
