// Lines of words that may be an answer but were not understood.
#pragma once

#include "harness/mark/score/marked_printout.h"

namespace harness {

/// A line with words that were not understood, in the place where the item's answer is expected. 0 if there is none or
/// if the item's answer does not consist of words.
int line_of_unread_words(const MarkedPrintout& printout, const ItemScore& item);

}  // namespace harness
