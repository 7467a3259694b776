#include "harness/read/first_object.h"

#include <re2/re2.h>

#include <algorithm>
#include <string_view>

#include "harness/read/no_value.h"
#include "harness/read/words/hit_words.h"
#include "harness/read/words/meaning.h"
#include "harness/read/words/mention.h"

namespace harness {
namespace {

using reference::FirstObject;
using reference::Subject;

constexpr std::size_t longest_sentence = 400;

/// Whether the word at `at` and the one at `from` before it belong to one clause.
bool in_one_clause(HitWords words, std::size_t from, std::size_t at) {
    return std::none_of(words.begin() + static_cast<std::ptrdiff_t>(from) + 1,
                        words.begin() + static_cast<std::ptrdiff_t>(at) + 1, begins_clause);
}

/// Whether another object is named in the same breath: "sphere or triangle".
bool is_joined(HitWords words, const std::vector<Mention>& mentions, const Mention& one) {
    return std::ranges::any_of(mentions, [&](const Mention& other) {
        const auto [first, last] = std::minmax(one.at, other.at);
        return other.object != one.object && last - first <= 3 &&
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

/// Whether a superlative is said of something.
bool says(Meaning superlative, HitWords words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i].meaning == superlative && !is_denied_superlative(words, i)) return true;
    }
    return false;
}

/// The object that the sentence calls the first; empty also if it calls several so, as the question's text does.
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
                                         [&](const Mention& each) { return each.object == last.object; });
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

/// The first of several objects: "the sphere is closer than the triangle", "the triangle is behind the sphere".
std::optional<Subject> first_of(HitWords words, const std::vector<Mention>& mentions) {
    if (const auto object = concluded(words, mentions)) return object;
    for (std::size_t i = 0; i + 1 < mentions.size(); ++i) {
        const Mention &one = mentions[i], &next = mentions[i + 1];
        // "misses the sphere, then hits the triangle" tells no order.
        if (one.object == next.object || one.denied != next.denied) continue;
        switch (order_between(words, one.at, next.at)) {
            case Order::none: continue;
            case Order::first_named_first:
                return i > 0 && is_joint(words[one.at - 1]) ? std::nullopt : std::optional(one.object);
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

/// Whether there is one word beside the object at most, as in "triangle", "triangle: 2.83" and "triangle at t = 2.83".
bool is_short(HitWords words) {
    return std::ranges::count_if(
               words, [](const HitWord& word) { return word.meaning != Meaning::link && word.text != "t"; }) <= 2;
}

/// The words up to where a reason begins behind the object: "the triangle, because 0 < 0.58", "triangle - its t is
/// smaller". All of them if there is none.
HitWords without_reason(HitWords words, std::size_t object) {
    const auto compares = [](const HitWord& word) {
        return word.meaning == Meaning::reason || word.meaning == Meaning::before || word.meaning == Meaning::nearest ||
               word.text == "smaller" || word.signs.find('<') != std::string::npos;
    };
    for (std::size_t i = object + 1; i < words.size(); ++i) {
        const bool begins_remark = words[i].signs == "-" || words[i].signs.find_first_of("(;.") != std::string::npos;
        if (words[i].meaning == Meaning::reason || (begins_remark && std::ranges::any_of(words.subspan(i), compares)))
            return words.first(i);
    }
    return words;
}

/// Whether only numbers stand beside the object, and say why it is the first: "t = 0 < 0.58 -> triangle", "triangle, 0
/// < 0.58".
bool is_concluded_from_numbers(HitWords words, std::size_t object) {
    bool compares = object + 1 == words.size() && has_arrow(words[object]);
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i == object) continue;
        const HitWord& word = words[i];
        if (word.meaning != Meaning::number && word.meaning != Meaning::link && word.text != "t") return false;
        compares = compares || word.signs.find('<') != std::string::npos;
    }
    return compares;
}

/// Whether the line is the row of a table with an object and a number, and does not say what that number makes of it.
bool is_row(std::string_view line) {
    const std::vector<HitWord> words = hit_words(line.substr(0, longest_sentence));
    return is_short(words) && has(words, Meaning::number) && !mentions_in(words).empty();
}

/// "sorted by t:", above rows.
bool says_sorted(std::string_view line) {
    constexpr std::string_view beginnings[] = {"sort", "order", "reihenfolge", "geordnet", "ordre", "orden", "ordin"};
    const std::vector<HitWord> words = hit_words(line.substr(0, longest_sentence));
    return mentions_in(words).empty() && std::ranges::any_of(words, [&](const HitWord& word) {
               return std::ranges::any_of(beginnings,
                                          [&](std::string_view each) { return word.text.starts_with(each); });
           });
}

/// What is said of the only object: "hits the triangle before anything else", "nothing is closer than the triangle".
std::optional<Subject> lone_object(HitWords words, const Mention& mention) {
    const bool negated = std::ranges::any_of(words, [](const HitWord& word) { return negates(word.meaning); });
    const auto order = std::ranges::find_if(words, [](const HitWord& word) {
        return word.meaning == Meaning::before || word.meaning == Meaning::after || word.meaning == Meaning::farther ||
               word.meaning == Meaning::covered;
    });
    if (order == words.end()) {
        const bool said = has(words, Meaning::hit) || has(words, Meaning::seen) ||
                          is_short(without_reason(words, mention.at)) || is_concluded_from_numbers(words, mention.at);
        return said && !negated && !has(words, Meaning::miss) ? std::optional(mention.object) : std::nullopt;
    }
    const auto at = static_cast<std::size_t>(order - words.begin());
    const bool behind = at > mention.at;  // the word that orders stands behind the object
    const bool passive = order->meaning == Meaning::covered && (has(words, Meaning::by) || has(words, Meaning::agent));
    const bool comes_after = order->meaning == Meaning::after || order->meaning == Meaning::farther || passive;
    // "closer: triangle", not "closer than the triangle"
    const bool compares = has(words.subspan(at, 1), Meaning::covered) || order->text == "before" ||
                          (at + 1 < words.size() && (words[at + 1].meaning == Meaning::before ||
                                                     words[at + 1].text == "of" || words[at + 1].text == "to"));
    const bool is_first = behind ? comes_after == negated : comes_after ? !negated : negated || !compares;
    return is_first ? std::optional(mention.object) : std::nullopt;
}

bool says_nothing_is_hit(HitWords words, const std::vector<Mention>& mentions, std::string_view line) {
    if (!mentions.empty()) {
        const bool all_denied = not_denied(mentions).empty();
        return all_denied && (!only_object(mentions) || has(words, Meaning::any_object));
    }
    const bool negated = has(words, Meaning::negation);
    return has(words, Meaning::none) || (negated && has(words, Meaning::any_object)) ||
           read_no_value(line).has_value() ||
           (words.size() == 1 && (words[0].text == "neither" || words[0].meaning == Meaning::miss)) ||
           (negated && std::ranges::any_of(words, [](const HitWord& word) { return word.text == "neither"; }));
}

bool says_nothing_is_first(HitWords words, const std::vector<Mention>& mentions) {
    return mentions.empty() &&
           (has(words, Meaning::none) || (has(words, Meaning::negation) && has(words, Meaning::any_object)));
}

/// "sphereFirst = 0": the last number denies what stands before it, as "false" does. Of "first hit t = 0" it does not.
void deny_by_zero(std::vector<HitWord>& words) {
    if (words.size() < 2 || words.back().text != "0") return;
    const Meaning before = words[words.size() - 2].meaning;
    const bool is_flag = before == Meaning::first || before == Meaning::nearest || before == Meaning::hit ||
                         object_of(before).has_value();
    if (is_flag && words.back().signs.find_first_of("=:") != std::string::npos)
        words.back().meaning = Meaning::negation;
}

/// Whether the line gives an object a later place: "the ray hits the triangle second", "2. triangle".
bool is_of_later_place(HitWords words) {
    constexpr std::string_view ordinals[] = {
        "second",  "third",  "2nd",     "3rd",     "zweiter",  "middle",  "mittlere", "last",    "farthest", "furthest",
        "zuletzt", "zweite", "zweites", "dritter", "deuxieme", "seconde", "segundo",  "segunda", "secondo",  "seconda"};
    const bool has_ordinal = std::ranges::any_of(
        words, [&](const HitWord& word) { return std::ranges::find(ordinals, word.text) != std::end(ordinals); });
    const bool is_numbered = words.size() >= 2 && (words[0].text == "2" || words[0].text == "3") &&
                             words[1].signs.find_first_of(".):") != std::string::npos;
    return has_ordinal || is_numbered;
}

bool is_yes(const HitWord& word) {
    constexpr std::string_view yes[] = {"yes", "true", "y", "1", "ja", "wahr", "oui", "vrai", "si", "sim"};
    return std::ranges::find(yes, word.text) != std::end(yes);
}

/// Whether the line says that the ray meets nothing, in words that elsewhere say nothing of it.
bool says_ray_escapes(std::string_view line) {
    static const RE2 pattern(
        R"((?i)\W*(?:so\s+)?(?:the\s+)?(?:ray\s+)?(?:escapes?(?:\s+to\s+infinity)?|(?:goes|flies|continues)\s+(?:off\s+)?(?:to|into|towards?)\s+infinity|(?:hits?\s+)?(?:the\s+)?background|there\s+is\s+no\s+first\s+(?:hit|object)|0\s+objects?\s+(?:are\s+|is\s+)?hit|number\s+of\s+hits?\s*[:=]\s*0|first(?:\s+(?:hit|object))?\s*[:=]\s*(?:-+|-1|none))\W*)");
    return RE2::FullMatch(re2::StringPiece(line.data(), line.size()), pattern);
}

/// Whether the line says that several objects are the first: "the ray hits the sphere and the triangle first".
bool says_together(std::string_view line) {
    static const RE2 pattern(
        R"((?i)\W*(?:the\s+)?(?:ray\s+)?hits?\s+(?:the\s+)?(?:both|(?:sphere|triangle|cylinder)\s*(?:and|&)\s*(?:the\s+)?(?:sphere|triangle|cylinder))(?:\s+objects)?\s+(?:first|together|simultaneously|at\s+(?:the\s+same|t\s*=).*)\W*|\W*both\b.*\b(?:are\s+hit|hit)\s+(?:first|together|simultaneously|at\s+(?:the\s+same|t\s*=).*)\W*|\W*neither\s+is\s+first.*\bboth\b.*)");
    return RE2::FullMatch(re2::StringPiece(line.data(), line.size()), pattern);
}

/// The only object of several whose flag is set: "sphere: 0, triangle: 0, cylinder: 1". Empty if the numbers are no
/// flags.
std::optional<Subject> flagged(HitWords words) {
    std::optional<Subject> set;
    std::size_t flags = 0;
    for (std::size_t i = 0; i + 1 < words.size(); i += 2) {
        const auto object = object_of(words[i].meaning);
        const std::string& flag = words[i + 1].text;
        if (!object || (flag != "0" && flag != "1") || (flag == "1" && set)) return std::nullopt;
        if (flag == "1") set = object;
        ++flags;
    }
    return flags >= 2 && words.size() == 2 * flags ? set : std::nullopt;
}

std::optional<FirstObject> first_object_in(std::string_view line, FirstObjectPlace place) {
    if (place == FirstObjectPlace::own_section && line.size() <= longest_sentence) {
        if (says_ray_escapes(line)) return FirstObject::no_hit;
        if (says_together(line)) return FirstObject::tie;
        if (const auto object = flagged(hit_words(line))) return FirstObject(*object);
    }
    std::vector<HitWord> all = hit_words(line.substr(0, longest_sentence));
    deny_by_zero(all);
    if (all.empty() || has(all, Meaning::debug) || has(all, Meaning::condition)) return std::nullopt;
    // "Which is hit first? The sphere."
    if (line.find_last_not_of(" \t") == line.find_last_of('?')) return std::nullopt;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].signs.find('?') != std::string::npos) begin = i;
    }
    HitWords words = HitWords(all).subspan(begin);
    if (begin > 0 && words.size() == 1) {
        if (is_yes(words[0])) words = HitWords(all).first(begin);  // "Is the sphere first? yes"
        if (negates(words[0].meaning)) return std::nullopt;
    }
    const std::vector<Mention> mentions = mentions_in(words);
    for (const Meaning superlative : {Meaning::first, Meaning::nearest}) {
        if (!says(superlative, words)) continue;
        if (superlative == Meaning::nearest && place == FirstObjectPlace::elsewhere) break;
        if (const auto object = object_called(superlative, words, mentions)) return FirstObject(*object);
        if (place == FirstObjectPlace::elsewhere) return std::nullopt;
        if (has(words, Meaning::tie)) return FirstObject::tie;
        return says_nothing_is_first(words, mentions) ? std::optional(FirstObject::no_hit) : std::nullopt;
    }
    if (place == FirstObjectPlace::elsewhere) return std::nullopt;
    if (says_nothing_is_hit(words, mentions, line)) return FirstObject::no_hit;
    if (has(words, Meaning::tie)) return FirstObject::tie;
    if (mentions.empty() || (only_object(mentions) && is_of_later_place(words))) return std::nullopt;
    const auto object = only_object(mentions) ? lone_object(words, mentions.front()) : first_of(words, mentions);
    return object ? std::optional(FirstObject(*object)) : std::nullopt;
}

/// The object that the first place of a sorted, numbered list has: "1. cylinder t = 1" below "Sorted by t:".
std::optional<PrintedFirstObject> first_in_numbered_list(const std::vector<PrintedLine>& lines) {
    const auto sorted = std::ranges::find_if(lines, [](const PrintedLine& line) { return says_sorted(line.text); });
    for (auto line = sorted; line != lines.end(); ++line) {
        const std::vector<HitWord> all = hit_words(line->text.substr(0, longest_sentence));
        if (all.size() < 2 || all[0].text != "1" || all[1].signs.find_first_of(".):") == std::string::npos) continue;
        const std::vector<Mention> mentions = mentions_in(HitWords(all).subspan(1));
        if (mentions.size() != 1 || mentions.front().denied) continue;
        return PrintedFirstObject{FirstObject(mentions.front().object), line->text.substr(0, longest_printed),
                                  line->number};
    }
    return std::nullopt;
}

bool is_about_a_number(std::string_view line) {
    return line.find_first_of("0123456789") != std::string_view::npos;
}

}  // namespace

std::optional<PrintedFirstObject> read_first_object(const std::vector<PrintedLine>& lines, FirstObjectPlace place) {
    std::optional<PrintedFirstObject> plain;  // a sentence
    std::optional<PrintedFirstObject>
        with_number;  // "closest hit: sphere at t = 0.58"; used if there is no plain sentence
    std::optional<PrintedFirstObject> first_row, last_row;  // "sphere 0.58"; used if there is nothing else
    bool rows_differ = false;
    for (const auto& [text, number] : lines) {
        auto object = first_object_in(text, place);
        if (!object && text.ends_with(')'))
            object = first_object_in(text.substr(0, text.rfind('(')), place);  // a remark
        if (!object) continue;
        const std::size_t begin = std::min(text.find_first_not_of(" \t:-*#>="), text.size());
        PrintedFirstObject printed{*object, text.substr(begin, longest_printed), number};
        if (!is_about_a_number(text)) {
            plain = std::move(printed);
        } else if (!is_row(text)) {
            with_number = std::move(printed);
        } else {
            if (!first_row) first_row = printed;
            rows_differ = rows_differ || first_row->object != printed.object;
            last_row = std::move(printed);
        }
    }
    if (plain || with_number) return plain ? plain : with_number;
    if (place == FirstObjectPlace::own_section) {
        if (auto numbered = first_in_numbered_list(lines)) return numbered;
    }
    if (!rows_differ) return last_row;
    const bool are_sorted = std::ranges::any_of(
        lines, [&](const PrintedLine& line) { return line.number < first_row->line && says_sorted(line.text); });
    return are_sorted ? first_row : std::nullopt;
}

}  // namespace harness
