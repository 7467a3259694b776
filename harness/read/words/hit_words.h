// The words of a line that tell what a ray hits: English, German, French, Spanish, Italian and Portuguese.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/read/words/meaning.h"

namespace harness {

struct HitWord {
    Meaning meaning;
    std::string text;   ///< in small letters without accents
    std::size_t begin;  ///< byte offset in the line
    std::size_t end;
    std::string signs;  ///< between the word before and this one, without blanks: ",", "->", "< ("
    bool spaced;        ///< two blanks or a tab stand before it, as between the columns of a table
};

/// The words of a line of clean text. A key word of six letters or more may have one wrong, missing, extra or exchanged
/// letter. Reads at most 1000 bytes.
std::vector<HitWord> hit_words(std::string_view line);

/// The meaning of one word in small letters without accents.
Meaning meaning_of(std::string_view word);

using HitWords = std::span<const HitWord>;

/// Whether one of the words has this meaning.
bool has(HitWords words, Meaning meaning);

}  // namespace harness
