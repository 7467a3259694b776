// The objects that a sentence names, and which of them it denies.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "harness/read/words/hit_words.h"
#include "reference/stages/items.h"

namespace harness {

/// A mention of an object.
struct Mention {
    reference::Subject object;
    std::size_t at;  ///< index of its word
    bool denied;     ///< said not to be hit, or not to be the one: "not the sphere", "the sphere is missed"
};

/// The mentions in the order of the words.
std::vector<Mention> mentions_in(HitWords words);

/// The only object of these mentions; empty if there are others or none.
std::optional<reference::Subject> only_object(std::span<const Mention> mentions);

std::vector<Mention> not_denied(const std::vector<Mention>& mentions);

/// Whether the word joins objects: "and", "or".
bool is_joint(const HitWord& word);

/// Whether an arrow leads to the word.
bool has_arrow(const HitWord& word);

/// Whether a new clause begins with this word.
bool begins_clause(const HitWord& word);

}  // namespace harness
