// What stands beside and below the views, in words.
#pragma once

#include "harness/report/picture/panel.h"

namespace harness::report::picture {

struct KeyLines {
    std::string svg;
    Spot next;  ///< where a further line begins
};
/// What each colour stands for, with the objects' own numbers; `first` is the middle of the first line's left end.
KeyLines draw_key(const DoubleScene& scene, bool with_answers, const Spot& first);

/// What the marks of printed answers stand for, as the key's further lines.
std::string draw_printed_key(bool with_answers, const Spot& first);

struct NoteLines {
    std::string svg;
    double bottom = 0;  ///< of the last line
};
/// Broken into lines; beyond some twenty the rest is left out, and that is said.
NoteLines draw_notes(const std::vector<std::string>& notes, double width, double first_baseline);

}  // namespace harness::report::picture
