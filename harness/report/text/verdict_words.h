// Verdicts on pages: a word, a symbol, and the HTML class that colors both.
#pragma once

#include <string>
#include <string_view>

#include "harness/record/graded.h"

namespace harness::report {

/// "right", "follows", "wrong", "missing" or "unreadable".
std::string_view word_of(ItemVerdict verdict);

/// A question's verdict; "unreadable" if all its answers are.
std::string word_of(const QuestionScore& question);

/// "compile error"; "finished" for Outcome::graded, because every submission with a mark is graded.
std::string outcome_words(Outcome outcome);

/// A single character, which pages hide from screen readers: ✓ ↳ ✗ –.
std::string_view symbol_of(const QuestionScore& question);

/// The HTML class: right, follow, wrong or missing.
std::string_view class_of(const QuestionScore& question);

}  // namespace harness::report
