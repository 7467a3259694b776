// What a word tells of what a ray hits.
#pragma once

#include <optional>

#include "reference/stages/items.h"

namespace harness {

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
    passes,        ///< "passes", "goes": a miss with "by" or an object behind it
    by,            ///< "by", "past", "over"
    agent,         ///< who does what is done, in "verdeckt vom Dreieck"
    first,         ///< "first"
    nearest,       ///< "closest", "smallest", "wins"
    before,        ///< "before", "closer", "in front of", "blocks"
    covered,       ///< "blocked": by what follows, if a word such as "by" stands between
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

}  // namespace harness
