// Questions that are named behind their answers.
#pragma once

#include <string>
#include <string_view>

namespace harness {

/// The text with "Q6" at the beginning of each line that names its question behind the answer or its name, as
/// "t (question 6) = 0.59" and "t = 0.59 // question 6" do; unchanged unless many questions are named so and few at
/// the beginning of a line. Lines keep their numbers.
std::string with_questions_first(std::string_view text, int last_question);

}  // namespace harness
