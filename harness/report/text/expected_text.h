// The key's values as people read them.
#pragma once

#include <map>
#include <string>

#include "reference/key/answer_key.h"

namespace harness::report {

/// By question and item: "3.41421", "(0, 0, -2)", a matrix row by row, "none", or a verdict's sentence; six significant
/// digits. Only the canonical values.
std::map<reference::ItemId, std::string> expected_texts(const reference::AnswerKey& key);

}  // namespace harness::report
