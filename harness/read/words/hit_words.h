// The English words of a line that tell what a ray hits.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reference/stages/items.h"

namespace harness {

/// What a word tells of what a ray hits.
enum class Meaning {
    other,
    number,
    sphere,
    triangle,
    cylinder,
    any_object,    ///< "object", "anything", "the others"
    ray,           ///< who hits: "ray", "we", "it"
    hit,           ///< "hit", "intersects", "root", "solution"
    miss,          ///< "misses"
    negation,      ///< "not", "no", "never", "without"
    none,          ///< a negation that says it alone: "none", "nothing", "null"
    not_real,      ///< "complex", "imaginary"
    discriminant,  ///< "discriminant", "delta"
    negative,      ///< "negative"
    exists,        ///< what is denied in "not defined", "does not exist"
    answer,        ///< what may be missing: "t", "normal", "value"
    link,          ///< may stand between a negation and what it denies: "real", "any", "there", "of"
    partial,       ///< the sentence is about a part or another root: "caps", "second", "far", "yet"
    by,            ///< "by"
    first,         ///< "first"
    nearest,       ///< "closest", "smallest", "wins"
    before,        ///< "before", "closer", "in front of", "blocks"
    covered,       ///< "blocked": by what follows, if "by" is between
    after,         ///< "after", "behind"
    farther,       ///< "farther": with "than" the same; also a part: "the far root"
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
    std::string text;   ///< in small letters
    std::size_t begin;  ///< byte offset in the line
    std::size_t end;
    std::string signs;  ///< between the word before and this one, without blanks: ",", "->", "< ("
    bool spaced;        ///< two blanks or a tab stand before it, as between the columns of a table
};

/// The words of a line of clean text. Reads at most 1000 bytes.
std::vector<HitWord> hit_words(std::string_view line);

/// The meaning of one word in small letters.
Meaning meaning_of(std::string_view word);

using HitWords = std::span<const HitWord>;

/// Whether one of the words has this meaning.
bool has(HitWords words, Meaning meaning);

}  // namespace harness
