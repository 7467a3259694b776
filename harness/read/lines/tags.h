// Printouts in XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace harness {

/// The text with its tags as other programs label their answers: "a: 1" for "<a>1</a>", "Question 2:" for "<question
/// number="2">", "matrix:" for "<matrix>", and a row alone for "<row>1 0 0</row>"; unchanged unless it begins as XML
/// does or has three such values. Lines keep their numbers. An element that holds its numbers in attributes,
/// "<P x="1" y="2" z="3"/>", stays as it is. HTML is read as it is shown, with "; " for a new line within a line.
std::string without_tags(std::string_view text);

}  // namespace harness
