// The words with a meaning in what students print about hits, by language.
#pragma once

#include <span>
#include <string_view>

#include "harness/read/words/meaning.h"

namespace harness {

/// Words in small letters without accents, with blanks between them.
struct MeaningRow {
    Meaning meaning;
    std::string_view english;
    std::string_view german;
    std::string_view french;
    std::string_view spanish;
    std::string_view italian;
    std::string_view portuguese;
    std::string_view others = {};  ///< the commonest in Dutch, Polish, Czech and Turkish
};

std::span<const MeaningRow> hit_words_table();

}  // namespace harness
