// The key's values in readable form.
#pragma once

#include <map>
#include <string>

#include "harness/mark/score/score.h"
#include "reference/key/answer_key.h"

namespace harness::report {

/// The right value of an item: "3.41421", "(0, 0, -2)", "none", or a verdict's sentence; six significant digits. A
/// matrix is written both by rows and by columns, and says which.
struct ExpectedText {
    std::string text;
    std::string by_columns;  ///< only for a matrix; otherwise empty

    /// The text to show next to the printed value: a matrix in the same order.
    const std::string& beside(const ItemScore& printed) const {
        return printed.by_columns && !by_columns.empty() ? by_columns : text;
    }
};
using ExpectedTexts = std::map<reference::ItemId, ExpectedText>;

/// Only the canonical values.
ExpectedTexts expected_texts(const reference::AnswerKey& key);

}  // namespace harness::report
