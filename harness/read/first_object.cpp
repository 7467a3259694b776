#include "harness/read/first_object.h"

#include <re2/re2.h>

#include <algorithm>
#include <string_view>

#include "harness/read/first_of_several.h"
#include "harness/read/no_value.h"
#include "harness/read/words/hit_words.h"
#include "harness/read/words/meaning.h"
#include "harness/read/words/mention.h"

namespace harness {
namespace {

using reference::FirstObject;
using reference::Subject;

constexpr std::size_t longest_sentence = 400;

/// Whether there is one word beside the object at most, as in "triangle", "triangle: 2.83" and "triangle at t = 2.83".
/// The names of a record and its fields do not count: "Result { object: triangle }", "ObjectType::Triangle".
bool is_short(HitWords words) {
    constexpr std::string_view of_records[] = {"result", "object", "obj",   "type",      "kind", "id",
                                               "name",   "index",  "shape", "primitive", "t"};
    const auto adds_something = [&](const HitWord& word) {
        return word.meaning != Meaning::link && std::ranges::find(of_records, word.text) == std::end(of_records);
    };
    return std::ranges::count_if(words, adds_something) <= 2;
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
                                          [&](std::string_view beginning) { return word.text.starts_with(beginning); });
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

/// "The smaller t is 0 (triangle)": of two, the smaller is the smallest.
void take_comparative_for_superlative(std::vector<HitWord>& words) {
    constexpr std::string_view smaller[] = {"smaller", "lower", "lesser", "kleinere", "kleineres"};
    constexpr std::string_view what[] = {"t", "one", "value", "distance", "parameter", "wert"};
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        if (std::ranges::find(smaller, words[i].text) != std::end(smaller) &&
            std::ranges::find(what, words[i + 1].text) != std::end(what))
            words[i].meaning = Meaning::nearest;
    }
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
    if (mentions_in(all).size() == 1) take_comparative_for_superlative(all);
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
