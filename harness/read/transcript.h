// A program's output as read: one section per heading, with its values and their labels. The reader never sees the key.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/read/printed_value.h"

namespace harness {

/// The output under one heading.
struct Section {
    int question = 0;  ///< 0 before the first heading
    std::vector<PrintedValue> values;
    std::vector<PrintedLine> lines;  ///< the text line by line, from the heading's title on
};

struct Transcript {
    std::vector<Section> sections;  ///< in the order printed; a question may come more than once
};

/// Reads a program's output. Questions are numbered from 1 to `last_question`. Accepts any bytes. Time and memory are
/// linear in the number of bytes.
Transcript read_transcript(std::string_view output, int last_question);

}  // namespace harness
