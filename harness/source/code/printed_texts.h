// The texts that a source prints before its values, with the variables printed after each.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "harness/source/code/words.h"

namespace harness::source {

/// A piece of a string literal that contains a letter: the text between escapes such as \n
/// and conversions of printf, without blanks around it.
struct PrintedText {
    std::string text;
    std::size_t at = 0;                  ///< the index of the literal's word
    std::vector<std::string> variables;  ///< printed after it in its statement, up to the next such text
};

/// In the order of the source. Takes time linear in the number of words.
std::vector<PrintedText> printed_texts(const std::vector<Word>& words);

}  // namespace harness::source
