#include "harness/read/first_object.h"

#include <algorithm>
#include <string_view>

#include "harness/read/no_value.h"
#include "harness/read/words/hit_words.h"

namespace harness {
namespace {

using reference::FirstObject;
using reference::Subject;

constexpr std::size_t longest_sentence = 400;

/// A mention of an object.
struct Mention {
    Subject object;
    std::size_t at;  ///< index of its word
    bool denied;     ///< said not to be hit, or not to be the one: "not the sphere", "the sphere is missed"
};
using Mentions = std::vector<Mention>;

/// Whether a new clause begins with this word.
bool begins_clause(const HitWord& word) {
    return word.signs.find_first_of(",;.!") != std::string::npos || word.meaning == Meaning::contrast ||
           word.meaning == Meaning::reason || word.meaning == Meaning::conclusion;
}

/// "and", "or"
bool is_joint(const HitWord& word) {
    return word.text == "and" || word.text == "nor" || word.meaning == Meaning::either;
}

bool has_arrow(const HitWord& word) {
    return word.signs.find("->") != std::string::npos || word.signs.find("=>") != std::string::npos;
}

bool is_superlative(Meaning meaning) {
    return meaning == Meaning::first || meaning == Meaning::nearest;
}

/// The object that "and", "or" or a comma at words[at] adds to a list: "the sphere, the triangle and the cylinder".
std::optional<std::size_t> joined_object(HitWords words, std::size_t at) {
    const bool is_listed = words[at].signs == "," && at > 0 && object_of(words[at - 1].meaning);
    if (!is_joint(words[at]) && !is_listed) return std::nullopt;
    if (is_joint(words[at])) ++at;
    while (at < words.size() && words[at].meaning == Meaning::link) ++at;
    return at < words.size() && object_of(words[at].meaning) ? std::optional(at) : std::nullopt;
}

bool is_denied_before(HitWords words, std::size_t object, const Mentions& earlier) {
    for (std::size_t i = object; i > 0; --i) {
        const bool is_joined = joined_object(words, i) == object;
        const HitWord& word = words[i - 1];
        if (object_of(word.meaning)) {
            // "the sphere and the triangle", but not "misses the sphere and hits the triangle"
            return (is_joined || words[i].meaning == Meaning::either) && !earlier.empty() && earlier.back().denied;
        }
        // "the sphere is missed and the triangle is hit"
        const bool joins_clauses = is_joint(words[i]) && words[i].meaning != Meaning::either;
        if ((begins_clause(words[i]) && !is_joined) || joins_clauses || has_arrow(words[i])) return false;
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
    for (std::size_t i = object + 1; i < words.size(); ++i) {
        if (const auto next = joined_object(words, i)) {  // "the sphere and the triangle are not hit"
            i = *next;
            continue;
        }
        if (begins_clause(words[i]) || is_joint(words[i])) break;
        const HitWord& word = words[i];
        // "the sphere is not closer than the triangle" does not deny the sphere.
        if (object_of(word.meaning) || word.meaning == Meaning::before || word.meaning == Meaning::after) return false;
        if (word.meaning == Meaning::miss) return !negated;
        negated = negated || negates(word.meaning);
    }
    return negated;
}

Mentions mentions_in(HitWords words) {
    Mentions mentions;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (const auto object = object_of(words[i].meaning))
            mentions.push_back({*object, i, is_denied_before(words, i, mentions) || is_denied_behind(words, i)});
    }
    return mentions;
}

/// The only object of these mentions; empty if there are others or none.
std::optional<Subject> only_object(const Mentions& mentions) {
    if (mentions.empty()) return std::nullopt;
    const bool is_one = std::ranges::all_of(mentions, [&](const Mention& m) { return m.object == mentions[0].object; });
    return is_one ? std::optional(mentions[0].object) : std::nullopt;
}

Mentions not_denied(const Mentions& mentions) {
    Mentions rest;
    std::ranges::copy_if(mentions, std::back_inserter(rest), [](const Mention& m) { return !m.denied; });
    return rest;
}

/// Whether the superlative at `at` is said not to be so: "first: no", "would be first".
bool is_denied_superlative(HitWords words, std::size_t at) {
    if (at + 2 == words.size() && (negates(words[at + 1].meaning) || words[at + 1].text == "0")) return true;
    for (std::size_t i = at; i > 0 && !begins_clause(words[i]); --i) {
        if (words[i - 1].text == "would" || words[i - 1].text == "could") return true;
    }
    return false;
}

/// Which object the superlative is about: the nearest of its clause, the one before it first; else the nearest. Of a
/// denied one it is the only other object. Empty if several are named in one breath, "sphere or triangle first".
std::optional<Subject> object_at(HitWords words, const Mentions& mentions, std::size_t superlative) {
    const auto is_in_clause = [&](const Mention& mention) {
        const auto [from, to] = std::minmax(mention.at, superlative);
        return std::ranges::none_of(words.subspan(from + 1, to - from), begins_clause);
    };
    const Mention *left = nullptr, *right = nullptr;
    for (const Mention& mention : mentions) {
        if (mention.at < superlative) left = &mention;
        if (mention.at > superlative && right == nullptr) right = &mention;
    }
    // "sphere 3.92 triangle 2.83 first: triangle"
    const bool is_label =
        right != nullptr && right->at + 1 == words.size() &&
        std::ranges::any_of(words.subspan(superlative + 1, right->at - superlative),
                            [](const HitWord& word) { return word.signs == ":" || word.signs == "="; });
    const bool is_right =
        left == nullptr || is_label || (right != nullptr && !is_in_clause(*left) && is_in_clause(*right));
    const Mention* found = is_right ? right : left;
    if (found == nullptr) return std::nullopt;
    if (found->denied) return only_object(not_denied(mentions));
    const bool is_joined = std::ranges::any_of(mentions, [&](const Mention& other) {
        const auto [from, to] = std::minmax(found->at, other.at);
        return other.object != found->object && joined_object(words, from + 1) == to;
    });
    return is_joined ? std::nullopt : std::optional(found->object);
}

/// The object that all superlatives are about.
std::optional<Subject> object_called(Meaning superlative, HitWords words, const Mentions& mentions) {
    std::optional<Subject> found;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i].meaning != superlative || is_denied_superlative(words, i)) continue;
        const auto object = object_at(words, mentions, i);
        if (object && found && *object != *found) return std::nullopt;
        if (object) found = object;
    }
    return found;
}

/// What the words between two mentions say: 1 if the one before them is first, -1 if the one behind them is, 0 if they
/// tell no order.
int order_between(HitWords words, std::size_t from, std::size_t to) {
    bool negated = false;
    for (std::size_t i = from + 1; i <= to; ++i) {
        const HitWord& word = words[i];
        int order = 0;
        if (word.signs.find('<') != std::string::npos && word.signs.find('-') == std::string::npos) order = 1;
        if (word.signs.find('>') != std::string::npos) return 0;  // an arrow, or greater?
        if (i < to && word.meaning == Meaning::before) order = 1;
        if (i < to && (word.meaning == Meaning::after || word.meaning == Meaning::farther)) order = -1;
        if (i < to && word.meaning == Meaning::covered)
            order = has(words.subspan(i + 1, to - i - 1), Meaning::by) ? -1 : 1;
        if (order != 0) return negated ? -order : order;
        negated = negated || (i < to && negates(word.meaning));
    }
    return 0;
}

/// The first of several objects by what is said of their order.
std::optional<Subject> first_of(HitWords words, const Mentions& mentions) {
    for (std::size_t i = 0; i + 1 < mentions.size(); ++i) {
        const Mention &mention = mentions[i], &next = mentions[i + 1];
        // "misses the sphere, then hits the triangle" tells no order.
        if (mention.object == next.object || mention.denied != next.denied) continue;
        const int order = order_between(words, mention.at, next.at);
        if (order < 0) return next.object;
        if (order > 0)  // "the sphere and the triangle are before the cylinder"
            return i > 0 && joined_object(words, mentions[i - 1].at + 1) ? std::nullopt : std::optional(mention.object);
    }
    const Mentions rest = not_denied(mentions);
    if (rest.size() < mentions.size()) return only_object(rest);
    const HitWord& last = words.back();  // "the sphere is hit, the triangle is behind"
    const bool is_last_behind = last.meaning == Meaning::after && mentions.back().at + 1 < words.size();
    return is_last_behind && mentions.size() == 2 ? std::optional(mentions.front().object) : std::nullopt;
}

/// Whether there is one word beside the object at most, as in "triangle", "triangle: 2.83" and "Winner: triangle", up
/// to a reason: "triangle, because its t is smaller".
bool is_short(HitWords words) {
    const auto reason = std::ranges::find(words, Meaning::reason, &HitWord::meaning);
    return std::count_if(words.begin(), reason,
                         [](const HitWord& word) { return word.meaning != Meaning::link && word.text != "t"; }) <= 2;
}

/// What is said of the only object: "hits the triangle before anything else", "nothing is closer than the triangle".
std::optional<Subject> lone_object(HitWords words, const Mention& mention) {
    const bool negated = std::ranges::any_of(words, [](const HitWord& word) { return negates(word.meaning); });
    const auto order = std::ranges::find_if(words, [](const HitWord& word) {
        return word.meaning == Meaning::before || word.meaning == Meaning::after || word.meaning == Meaning::farther ||
               word.meaning == Meaning::covered;
    });
    if (order == words.end()) {
        const bool is_said = has(words, Meaning::hit) || has(words, Meaning::seen) || is_short(words);
        return is_said && !negated && !has(words, Meaning::miss) ? std::optional(mention.object) : std::nullopt;
    }
    const auto at = static_cast<std::size_t>(order - words.begin());
    const bool is_covered = order->meaning == Meaning::covered && has(words, Meaning::by);
    const bool comes_after = order->meaning == Meaning::after || order->meaning == Meaning::farther || is_covered;
    // "closer: triangle", not "closer than the triangle"
    const bool compares =
        order->text == "before" ||
        (at + 1 < words.size() && (words[at + 1].meaning == Meaning::before || words[at + 1].text == "of"));
    if (at > mention.at) return comes_after == negated ? std::optional(mention.object) : std::nullopt;
    const bool is_first = comes_after ? !negated : negated || !compares;
    return is_first ? std::optional(mention.object) : std::nullopt;
}

bool says_nothing_is_hit(HitWords words, const Mentions& mentions, std::string_view line) {
    if (!mentions.empty())
        return not_denied(mentions).empty() && (!only_object(mentions) || has(words, Meaning::any_object));
    const bool is_alone = words.size() == 1 && (words[0].text == "neither" || words[0].meaning == Meaning::miss);
    const bool negated = has(words, Meaning::negation);
    const bool is_neither = std::ranges::any_of(words, [](const HitWord& word) { return word.text == "neither"; });
    return has(words, Meaning::none) || (negated && has(words, Meaning::any_object)) || is_neither || is_alone ||
           read_no_value(line).has_value();
}

/// Whether the line gives an object a later place: "the ray hits the triangle second", "2. triangle".
bool is_of_later_place(HitWords words) {
    constexpr std::string_view ordinals[] = {"second", "third", "2nd", "3rd", "middle", "last", "farthest"};
    const bool has_ordinal = std::ranges::any_of(
        words, [&](const HitWord& word) { return std::ranges::find(ordinals, word.text) != std::end(ordinals); });
    const bool is_numbered = words.size() >= 2 && (words[0].text == "2" || words[0].text == "3") &&
                             words[1].signs.find_first_of(".):") != std::string::npos;
    return has_ordinal || is_numbered;
}

/// The words behind a question, or those of the question if it is answered by "yes". Empty if it has no answer.
HitWords answer_in(HitWords words, std::string_view line) {
    if (line.find_last_not_of(" \t") == line.find_last_of('?')) return {};
    std::size_t begin = 0;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i].signs.find('?') != std::string::npos) begin = i;
    }
    if (begin == 0 || words.size() - begin > 1) return words.subspan(begin);
    const HitWord& answer = words[begin];
    if (answer.text == "yes" || answer.text == "true" || answer.text == "1") return words.first(begin);
    return negates(answer.meaning) ? HitWords() : words.subspan(begin);
}

std::optional<FirstObject> first_object_in(std::string_view line, FirstObjectPlace place) {
    const std::vector<HitWord> all = hit_words(line.substr(0, longest_sentence));
    if (has(all, Meaning::debug) || has(all, Meaning::condition)) return std::nullopt;
    const HitWords words = answer_in(all, line);
    if (words.empty()) return std::nullopt;
    const Mentions mentions = mentions_in(words);
    for (const Meaning superlative : {Meaning::first, Meaning::nearest}) {
        if (!has(words, superlative) || (superlative == Meaning::nearest && place == FirstObjectPlace::elsewhere))
            continue;
        if (const auto object = object_called(superlative, words, mentions)) return FirstObject(*object);
        if (place == FirstObjectPlace::elsewhere) return std::nullopt;
        if (has(words, Meaning::tie)) return FirstObject::tie;
        const bool is_nothing =
            has(words, Meaning::none) || (has(words, Meaning::negation) && has(words, Meaning::any_object));
        return mentions.empty() && is_nothing ? std::optional(FirstObject::no_hit) : std::nullopt;
    }
    if (place == FirstObjectPlace::elsewhere) return std::nullopt;
    if (says_nothing_is_hit(words, mentions, line)) return FirstObject::no_hit;
    if (has(words, Meaning::tie)) return FirstObject::tie;
    if (mentions.empty() || (only_object(mentions) && is_of_later_place(words))) return std::nullopt;
    const auto object = only_object(mentions) ? lone_object(words, mentions.front()) : first_of(words, mentions);
    return object ? std::optional(FirstObject(*object)) : std::nullopt;
}

}  // namespace

std::optional<PrintedFirstObject> read_first_object(const std::vector<PrintedLine>& lines, FirstObjectPlace place) {
    std::optional<PrintedFirstObject> plain;        // the last sentence
    std::optional<PrintedFirstObject> with_number;  // "closest hit: sphere at t = 0.58"
    bool numbers_differ = false;                    // "sphere 0.58" above "triangle 0"
    for (const auto& [text, number] : lines) {
        auto object = first_object_in(text, place);
        if (!object && text.ends_with(')'))
            object = first_object_in(text.substr(0, text.rfind('(')), place);  // a remark
        if (!object) continue;
        const std::size_t begin = std::min(text.find_first_not_of(" \t:-*#>="), text.size());
        PrintedFirstObject printed{*object, text.substr(begin, longest_printed), number};
        if (text.find_first_of("0123456789") == std::string::npos) {
            plain = std::move(printed);
            continue;
        }
        const std::vector<HitWord> words = hit_words(text);
        const bool is_called_first = has(words, Meaning::first) || has(words, Meaning::nearest);
        const bool was_called_first = with_number && (has(hit_words(with_number->printed), Meaning::first) ||
                                                      has(hit_words(with_number->printed), Meaning::nearest));
        if (was_called_first && !is_called_first) continue;
        numbers_differ = with_number && was_called_first == is_called_first && with_number->object != printed.object;
        with_number = std::move(printed);
    }
    if (plain) return plain;
    return numbers_differ ? std::nullopt : with_number;
}

}  // namespace harness
