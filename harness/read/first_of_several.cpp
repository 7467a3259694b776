#include "harness/read/first_of_several.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

namespace harness {
namespace {

using reference::Subject;

/// Whether the word at `at` and the one at `from` before it belong to one clause.
bool in_one_clause(HitWords words, std::size_t from, std::size_t at) {
    return std::none_of(words.begin() + static_cast<std::ptrdiff_t>(from) + 1,
                        words.begin() + static_cast<std::ptrdiff_t>(at) + 1, begins_clause);
}

/// Whether another object is named in the same breath: "sphere or triangle".
bool is_joined(HitWords words, const std::vector<Mention>& mentions, const Mention& mention) {
    return std::ranges::any_of(mentions, [&](const Mention& other) {
        const auto [first, last] = std::minmax(mention.at, other.at);
        return other.object != mention.object && last - first <= 3 &&
               std::ranges::any_of(words.subspan(first + 1, last - first - 1), is_joint);
    });
}

/// Whether the superlative is the label of the object, which ends the line: "sphere 3.92 triangle 2.83 first:
/// triangle".
bool names(HitWords words, std::size_t superlative, std::size_t object) {
    const auto adds_nothing = [](const HitWord& word) {
        return word.meaning == Meaning::link || word.meaning == Meaning::hit || word.meaning == Meaning::any_object ||
               word.meaning == Meaning::answer || word.meaning == Meaning::number;
    };
    const HitWords between = words.subspan(superlative + 1, object - superlative - 1);
    const bool has_sign =
        std::ranges::any_of(words.subspan(superlative + 1, object - superlative),
                            [](const HitWord& word) { return word.signs == ":" || word.signs == "="; });
    return has_sign && std::ranges::all_of(between, adds_nothing) &&
           std::ranges::all_of(words.subspan(object + 1), adds_nothing);
}

/// Which object a word such as "first" is about: the one before it in its clause, else the one behind it; in other
/// clauses likewise. If that one is denied, it is the only other object.
std::optional<Subject> object_at(HitWords words, const std::vector<Mention>& mentions, std::size_t superlative) {
    constexpr std::size_t reach = 12;
    const Mention *left = nullptr, *right = nullptr;
    for (const Mention& mention : mentions) {
        if (mention.at < superlative && superlative - mention.at <= reach) left = &mention;
        if (mention.at > superlative && mention.at - superlative <= reach && right == nullptr) right = &mention;
    }
    const bool near_left = left != nullptr && in_one_clause(words, left->at, superlative);
    const bool near_right = right != nullptr && in_one_clause(words, superlative, right->at);
    const bool is_label = right != nullptr && names(words, superlative, right->at);
    const Mention* found = is_label || left == nullptr || (!near_left && near_right) ? right : left;
    if (found == nullptr) return std::nullopt;
    if (found->denied) return only_object(not_denied(mentions));
    return is_joined(words, mentions, *found) ? std::nullopt : std::optional(found->object);
}

/// Whether the superlative at `at` is said not to be so: "first: no", "would be first".
bool is_denied_superlative(HitWords words, std::size_t at) {
    constexpr std::string_view conditional[] = {"would", "could", "ware", "wurde", "serait", "seria", "sarebbe"};
    if (at + 2 == words.size() && words[at + 1].meaning == Meaning::negation) return true;
    for (std::size_t i = at; i > 0 && !begins_clause(words[i]); --i) {
        if (std::ranges::find(conditional, words[i - 1].text) != std::end(conditional)) return true;
    }
    return false;
}

enum class Order { none, first_named_first, last_named_first };

Order reversed(Order order) {
    switch (order) {
        case Order::none: return Order::none;
        case Order::first_named_first: return Order::last_named_first;
        case Order::last_named_first: return Order::first_named_first;
    }
    return Order::none;
}

/// What the words from words[from] to words[to] say about the order of these two objects.
Order order_between(HitWords words, std::size_t from, std::size_t to) {
    const bool of_t = (from > 0 && words[from - 1].text == "t") || words[from + 1].text == "t";
    bool negated = false;
    for (std::size_t i = from + 1; i <= to; ++i) {
        const HitWord& word = words[i];
        const std::string& signs = word.signs;
        Order order = Order::none;
        if (signs.find('<') != std::string::npos && signs.find('-') == std::string::npos)
            order = Order::first_named_first;
        if (signs.find('>') != std::string::npos) {
            const bool arrow = signs.find_first_of("-=") != std::string::npos;
            if (!arrow && !of_t) return Order::none;  // an arrow, or greater?
            order = arrow ? Order::first_named_first : Order::last_named_first;
        }
        if (i < to && word.meaning == Meaning::before) order = Order::first_named_first;
        if (i < to && (word.meaning == Meaning::after || word.meaning == Meaning::farther))
            order = Order::last_named_first;
        if (i < to && word.meaning == Meaning::covered) {
            const HitWords rest = words.subspan(i + 1, to - i - 1);
            const bool passive = has(rest, Meaning::by) || has(rest, Meaning::agent) || has(rest, Meaning::after);
            order = passive ? Order::last_named_first : Order::first_named_first;
        }
        if (order != Order::none) return negated ? reversed(order) : order;
        negated = negated || (i < to && negates(word.meaning));
    }
    return Order::none;
}

/// "triangle, cylinder, sphere": only objects in their order, with their t.
bool is_list(HitWords words, const std::vector<Mention>& mentions) {
    const bool plain = std::ranges::all_of(words, [](const HitWord& word) {
        return object_of(word.meaning) || word.meaning == Meaning::number || word.meaning == Meaning::link ||
               word.meaning == Meaning::answer || word.meaning == Meaning::hit || word.text.starts_with("ord") ||
               word.text == "reihenfolge";
    });
    const HitWords between = words.subspan(mentions[0].at + 1, mentions[1].at - mentions[0].at);
    // "sphere: hit, triangle: hit" tells no order.
    const bool told_apart = std::ranges::count(words, Meaning::hit, &HitWord::meaning) > 1;
    return plain && !told_apart && std::ranges::any_of(between, begins_clause);
}

/// The object that was named before and stands at the end behind an arrow or "so": "sphere 1.2, triangle 0.9 ->
/// triangle".
std::optional<Subject> concluded(HitWords words, const std::vector<Mention>& mentions) {
    const Mention& last = mentions.back();
    const std::size_t before = mentions[mentions.size() - 2].at;
    const bool is_repeated = std::any_of(mentions.begin(), mentions.end() - 1,
                                         [&](const Mention& mention) { return mention.object == last.object; });
    const HitWords between = words.subspan(before + 1, last.at - before);
    const bool concludes = has(between, Meaning::conclusion) || std::ranges::any_of(between, has_arrow);
    const bool goes_on = last.at + 1 < words.size();
    return is_repeated && concludes && !last.denied && !goes_on ? std::optional(last.object) : std::nullopt;
}

/// The object that the sentence begins with, where all that follows gives the reason: "the triangle, which is at t = 0;
/// the sphere is at t = 0.58".
std::optional<Subject> answer_before_reason(HitWords words, const std::vector<Mention>& mentions) {
    constexpr std::string_view relatives[] = {"which", "that", "it", "its", "whose"};
    const std::size_t at = mentions.front().at;
    const auto is_link = [](const HitWord& word) { return word.meaning == Meaning::link; };
    if (mentions.front().denied || at + 1 >= words.size() || !std::ranges::all_of(words.first(at), is_link))
        return std::nullopt;
    const HitWord& next = words[at + 1];
    const bool is_apart = next.signs.find_first_of(",;-(:") != std::string::npos;
    const bool gives_reason =
        next.meaning == Meaning::reason || std::ranges::find(relatives, next.text) != std::end(relatives);
    return is_apart && gives_reason ? std::optional(mentions.front().object) : std::nullopt;
}

}  // namespace

bool says(Meaning superlative, HitWords words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i].meaning == superlative && !is_denied_superlative(words, i)) return true;
    }
    return false;
}

std::optional<Subject> object_called(Meaning superlative, HitWords words, const std::vector<Mention>& mentions) {
    std::optional<Subject> found;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i].meaning != superlative || is_denied_superlative(words, i)) continue;
        const auto object = object_at(words, mentions, i);
        if (object && found && *object != *found) return std::nullopt;
        if (object) found = object;
    }
    return found;
}

std::optional<Subject> first_of(HitWords words, const std::vector<Mention>& mentions) {
    if (const auto object = concluded(words, mentions)) return object;
    for (std::size_t i = 0; i + 1 < mentions.size(); ++i) {
        const Mention &mention = mentions[i], &next = mentions[i + 1];
        // "misses the sphere, then hits the triangle" tells no order.
        if (mention.object == next.object || mention.denied != next.denied) continue;
        switch (order_between(words, mention.at, next.at)) {
            case Order::none: continue;
            case Order::first_named_first:
                return i > 0 && is_joint(words[mention.at - 1]) ? std::nullopt : std::optional(mention.object);
            case Order::last_named_first: return next.object;
        }
    }
    if (const auto object = answer_before_reason(words, mentions)) return object;
    const std::vector<Mention> rest = not_denied(mentions);
    if (rest.size() < mentions.size()) return only_object(rest);
    const std::size_t last = mentions.back().at;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const bool between = i > mentions.front().at && i < last;
        if (between) continue;
        const Mention& near = i < last ? mentions.front() : mentions.back();
        std::vector<Mention> others;
        std::ranges::copy_if(mentions, std::back_inserter(others),
                             [&](const Mention& each) { return each.object != near.object; });
        const bool leads = i < last && words[i].text == "before";
        const bool ends_farther = i > last && words[i].meaning == Meaning::farther;
        if (words[i].meaning == Meaning::after || ends_farther)
            return i < last ? std::optional(near.object) : only_object(others);
        if (words[i].meaning == Meaning::before) return leads ? only_object(others) : std::optional(near.object);
    }
    return is_list(words, mentions) ? std::optional(mentions.front().object) : std::nullopt;
}

}  // namespace harness
