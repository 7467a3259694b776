// What the colours and marks stand for, beside the views, and the notes below them.
#pragma once

#include <string>
#include <vector>

#include "harness/report/picture/frame.h"
#include "harness/report/picture/svg.h"

namespace harness::report::picture {

struct KeyLines {
    std::string svg;
    Spot next;  ///< where a further line begins
};
/// Says what each colour stands for, with the objects' numbers; `first` is the middle of the first line's left end.
KeyLines draw_key(const DoubleScene& scene, bool with_answers, const Spot& first);

/// Further lines of the key: what the marks of printed answers stand for.
std::string draw_printed_key(bool with_answers, const Spot& first);

struct NoteLines {
    std::string svg;
    double bottom = 0;  ///< of the last line
};
/// Breaks the notes into lines; after some twenty lines, a last line says that more are left out.
NoteLines draw_notes(const std::vector<std::string>& notes, double width, double first_baseline);

}  // namespace harness::report::picture
