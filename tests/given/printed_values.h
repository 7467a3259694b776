// Printed values and marks for the tests of marking, without a whole program's output.
#pragma once

#include <string>
#include <string_view>

#include "harness/mark/compare/closeness.h"
#include "harness/mark/score/score.h"
#include "reference/stages/item_values.h"
#include "tests/given/student/scenes.h"

/// The only number in `text`, read as in a program's output.
harness::PrintedNumber printed_number(std::string_view text);

/// The item with the numbers in `text` as its printed value. A text without numbers, such as "none", gives no numbers.
/// Its question is that of 2021; 1 for an item that 2021 did not ask for.
harness::MatchedItem printed_item(const reference::ItemId& id, std::string_view text,
                                  harness::MatrixOrder order = harness::MatrixOrder::unsaid);

/// Marks a program's output.
harness::Score mark(std::string_view output, const student::Marking& marking);

/// The number of the question of 2021 that asks for the item.
int question_of(const reference::ItemId& id);

const harness::ItemScore& item_of(const harness::Score& score, const reference::ItemId& id);

/// The item's verdict in words, e.g. "follow".
std::string verdict_on(const harness::Score& score, const reference::ItemId& id);
