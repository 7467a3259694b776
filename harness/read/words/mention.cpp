#include "harness/read/words/mention.h"

#include <algorithm>

#include "harness/read/words/meaning.h"

namespace harness {
namespace {

using reference::Subject;

/// The object at words[at], with an article before it or none; empty if there is none.
std::optional<std::size_t> object_from(HitWords words, std::size_t at) {
    while (at < words.size() && words[at].meaning == Meaning::link) ++at;
    return at < words.size() && object_of(words[at].meaning) ? std::optional(at) : std::nullopt;
}

/// The object that "and" or "or" at words[at] joins.
std::optional<std::size_t> joined_object(HitWords words, std::size_t at) {
    return at < words.size() && is_joint(words[at]) ? object_from(words, at + 1) : std::nullopt;
}

/// Whether words[at], which stands behind a comma, goes on with a list of objects: "the sphere, the triangle and the
/// cylinder".
bool goes_on_with_list(HitWords words, std::size_t at) {
    if (at == 0 || words[at].signs != "," || !object_of(words[at - 1].meaning)) return false;
    const auto object = object_from(words, at);
    return object && joined_object(words, *object + 1);
}

/// "first", "closest"
bool is_superlative(Meaning meaning) {
    return meaning == Meaning::first || meaning == Meaning::nearest;
}

/// Whether "and" at words[at] joins clauses: "the sphere is missed and the triangle is hit".
bool joins_clauses(HitWords words, std::size_t at) {
    return is_joint(words[at]) && words[at].meaning != Meaning::either && at > 0 && !object_of(words[at - 1].meaning);
}

bool is_denied_before(HitWords words, std::size_t object, const std::vector<Mention>& earlier) {
    for (std::size_t i = object; i > 0; --i) {
        const bool is_listed = goes_on_with_list(words, i);
        if ((begins_clause(words[i]) && !is_listed) || joins_clauses(words, i) || has_arrow(words[i])) return false;
        const HitWord& word = words[i - 1];
        if (object_of(word.meaning)) {
            // "the sphere and the triangle", but not "misses the sphere and hits the triangle"
            const bool is_joined =
                is_listed || words[i].meaning == Meaning::either || joined_object(words, i) == object;
            return is_joined && !earlier.empty() && earlier.back().denied;
        }
        // "nothing is hit before the triangle" does not deny the triangle.
        if (word.meaning == Meaning::contrast || word.meaning == Meaning::before || is_superlative(word.meaning))
            return false;
        if (negates(word.meaning)) return true;
        if (word.meaning == Meaning::miss) return i < 2 || !negates(words[i - 2].meaning);
    }
    return false;
}

bool is_denied_behind(HitWords words, std::size_t object) {
    bool negated = false;
    for (std::size_t i = object + 1; i < words.size() && !begins_clause(words[i]); ++i) {
        if (is_joint(words[i])) {  // "the sphere and the triangle are not hit", "the sphere and never reaches"
            const auto next = joined_object(words, i);
            if (!next) return negated;
            i = *next;
            continue;
        }
        const HitWord& word = words[i];
        // "the sphere is not closer than the triangle" does not deny the sphere.
        if (object_of(word.meaning) || word.meaning == Meaning::before || word.meaning == Meaning::after) return false;
        if (word.meaning == Meaning::miss) return !negated;
        if (negated && (word.meaning == Meaning::hit || word.meaning == Meaning::seen || is_superlative(word.meaning)))
            return true;
        negated = negated || negates(word.meaning);
    }
    return negated;
}

}  // namespace

bool is_joint(const HitWord& word) {
    return word.text == "and" || word.text == "und" || word.text == "et" || word.text == "y" || word.text == "e" ||
           word.text == "nor" || word.meaning == Meaning::either;
}

bool has_arrow(const HitWord& word) {
    return word.signs.find("->") != std::string::npos || word.signs.find("=>") != std::string::npos;
}

bool begins_clause(const HitWord& word) {
    return word.signs.find_first_of(",;.!") != std::string::npos || word.meaning == Meaning::contrast ||
           word.meaning == Meaning::reason || word.meaning == Meaning::conclusion;
}

std::vector<Mention> mentions_in(HitWords words) {
    std::vector<Mention> mentions;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (const auto object = object_of(words[i].meaning))
            mentions.push_back({*object, i, is_denied_before(words, i, mentions) || is_denied_behind(words, i)});
    }
    return mentions;
}

std::optional<Subject> only_object(std::span<const Mention> mentions) {
    if (mentions.empty()) return std::nullopt;
    const bool one = std::ranges::all_of(mentions, [&](const Mention& m) { return m.object == mentions[0].object; });
    return one ? std::optional(mentions[0].object) : std::nullopt;
}

std::vector<Mention> not_denied(const std::vector<Mention>& mentions) {
    std::vector<Mention> rest;
    std::ranges::copy_if(mentions, std::back_inserter(rest), [](const Mention& m) { return !m.denied; });
    return rest;
}

}  // namespace harness
