// Which of the objects that a sentence names it puts first: by "first" and "nearest", or by the order it tells.
#pragma once

#include <optional>
#include <vector>

#include "harness/read/words/hit_words.h"
#include "harness/read/words/mention.h"

namespace harness {

/// Whether a superlative, Meaning::first or Meaning::nearest, is said of something.
bool says(Meaning superlative, HitWords words);

/// The object that the sentence calls so; empty also if it calls several so, as the question's text does.
std::optional<reference::Subject> object_called(Meaning superlative, HitWords words,
                                                const std::vector<Mention>& mentions);

/// The first of several objects: "the sphere is closer than the triangle", "the triangle is behind the sphere".
std::optional<reference::Subject> first_of(HitWords words, const std::vector<Mention>& mentions);

}  // namespace harness
