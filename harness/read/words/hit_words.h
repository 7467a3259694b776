// The English words of a line that say what a ray hits.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reference/stages/items.h"

namespace harness {

/// The meaning of a word in a sentence about hits.
enum class Meaning {
    other,
    number,
    sphere,
    triangle,
    cylinder,
    any_object,    ///< "object", "anything", "the others"
    ray,           ///< the hitting ray: "ray", "we", "it"
    hit,           ///< "hit", "intersects", "root", "solution"
    miss,          ///< "misses"
    negation,      ///< "not", "no", "never", "without"
    none,          ///< a negation by itself: "none", "nothing", "null"
    not_real,      ///< "complex", "imaginary"
    discriminant,  ///< "discriminant", "delta"
    negative,      ///< "negative"
    exists,        ///< the verb in "not defined", "does not exist"
    answer,        ///< something that may be missing: "t", "normal", "value"
    link,          ///< may come between a negation and the word it denies: "real", "any", "there", "of"
    partial,       ///< the sentence is about a part or another root: "caps", "second", "far", "yet"
    by,            ///< "by"
    first,         ///< "first"
    nearest,       ///< "closest", "smallest", "wins"
    before,        ///< "before", "closer", "in front of", "blocks"
    covered,       ///< "blocked": by the object that follows, if "by" is between
    after,         ///< "after", "behind"
    farther,       ///< "farther": same as `after` with "than"; also a part: "the far root"
    tie,
    seen,        ///< "visible", "chosen"
    condition,   ///< "if": the sentence states nothing
    contrast,    ///< "but"
    reason,      ///< "because"
    conclusion,  ///< "so"
    either,      ///< "or"
    debug,
};

/// The object that a word names.
std::optional<reference::Subject> object_of(Meaning meaning);

inline bool negates(Meaning meaning) {
    return meaning == Meaning::negation || meaning == Meaning::none;
}

struct HitWord {
    Meaning meaning;
    std::string text;   ///< in lower case
    std::size_t begin;  ///< byte offset in the line
    std::size_t end;
    std::string signs;  ///< between the word before and this one, without blanks: ",", "->", "< ("
    bool spaced;        ///< two blanks or a tab come before it, as between the columns of a table
};

/// The words of a line of clean text. Reads at most 1000 bytes.
std::vector<HitWord> hit_words(std::string_view line);

/// The meaning of one word in lower case.
Meaning meaning_of(std::string_view word);

using HitWords = std::span<const HitWord>;

/// Whether one of the words has this meaning.
bool has(HitWords words, Meaning meaning);

}  // namespace harness
