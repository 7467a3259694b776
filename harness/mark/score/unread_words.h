// Lines of words that may be an answer and were not understood.
#pragma once

#include "harness/mark/score/marked_printout.h"

namespace harness {

/// A line of words that were not understood, where the item would stand. 0 if there is none, and where the answer is no
/// words.
int line_of_unread_words(const MarkedPrintout& printout, const ItemScore& item);

}  // namespace harness
