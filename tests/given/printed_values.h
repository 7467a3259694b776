// Printed values and marks for the tests of the marking, without the way through a whole program.
#pragma once

#include <string>
#include <string_view>

#include "harness/closeness.h"
#include "harness/score.h"
#include "reference/item_values.h"
#include "tests/student/scenes.h"

/// The one number in `text`, as it would be read in a program's output.
harness::PrintedNumber printed_number(std::string_view text);

/// The item with the numbers in `text` printed for it; none for a text without numbers, such as "none".
harness::MatchedItem printed_item(const reference::ItemId& id, std::string_view text,
                                  harness::MatrixOrder order = harness::MatrixOrder::unsaid);

/// Marks a program's output.
harness::Score mark(std::string_view output, const student::Marking& marking);

const harness::ItemScore& item_of(const harness::Score& score, const reference::ItemId& id);

/// The item's verdict in words, e.g. "follow".
std::string verdict_on(const harness::Score& score, const reference::ItemId& id);
