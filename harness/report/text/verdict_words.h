// Verdicts as pages show them: a word, a sign, and the class that colours both.
#pragma once

#include <string>
#include <string_view>

#include "harness/score.h"

namespace harness::report {

/// "right", "follows", "wrong", "missing" or "unreadable".
std::string_view word_of(ItemVerdict verdict);

/// Of a question: "unreadable" where all of it is.
std::string word_of(const QuestionScore& question);

/// A single character for the eye alone: ✓ ↳ ✗ –.
std::string_view symbol_of(const QuestionScore& question);

/// right, follow, wrong or missing.
std::string_view class_of(const QuestionScore& question);

}  // namespace harness::report
