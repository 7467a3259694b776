#include "harness/read/no_value.h"

#include <re2/re2.h>

#include <algorithm>
#include <string>

#include "harness/read/words/hit_words.h"

namespace harness {
namespace {

/// Words without a sign or a conjunction between them. Numbers stand between clauses.
struct Clause {
    HitWords words;
    bool answers;  ///< what stands before it is a label or a question: "hit: no", "hit? no"
};

bool is_boundary(const HitWord& word, const HitWord& before) {
    constexpr std::string_view glue = "'\"_/*-";
    if (word.signs.find_first_not_of(glue) != std::string::npos) return true;
    const bool dash = word.signs.find('-') != std::string::npos;
    return word.spaced || (dash && word.begin - before.end > word.signs.size());
}

std::vector<Clause> clauses_of(HitWords words) {
    std::vector<Clause> clauses;
    std::size_t begin = 0;
    const auto close = [&](std::size_t end) {
        if (end <= begin) return;
        const HitWord& first = words[begin];
        const bool answers = begin > 0 && (first.spaced || first.signs.find_first_of(":=?|>") != std::string::npos);
        clauses.push_back({words.subspan(begin, end - begin), answers});
    };
    for (std::size_t i = 0; i < words.size(); ++i) {
        const Meaning meaning = words[i].meaning;
        const bool is_between = meaning == Meaning::number || meaning == Meaning::contrast ||
                                meaning == Meaning::reason || meaning == Meaning::conclusion;
        if (!is_between && (i == 0 || !is_boundary(words[i], words[i - 1]))) continue;
        close(i);
        begin = is_between ? i + 1 : i;
    }
    close(words.size());
    return clauses;
}

bool is_named(const HitWord& word) {
    return object_of(word.meaning).has_value() || word.meaning == Meaning::any_object;
}

/// Whether only words of little meaning follow.
bool ends_at(HitWords words, std::size_t at) {
    return std::ranges::all_of(words.subspan(at), [](const HitWord& word) {
        return word.meaning == Meaning::link || word.meaning == Meaning::ray || is_named(word);
    });
}

/// Whether the negation at words[at] denies a hit, that a value exists, or a value: "no real root", "does not hit",
/// "hits nothing", "not defined", "no normal".
bool denies(HitWords words, std::size_t at) {
    constexpr std::size_t reach = 5;
    const auto links = [](const HitWord& word) {
        return word.meaning == Meaning::link || word.meaning == Meaning::exists || word.meaning == Meaning::answer ||
               word.meaning == Meaning::ray || is_named(word) || negates(word.meaning);
    };
    bool is_value = false;
    for (std::size_t i = at + 1; i < words.size() && i <= at + reach; ++i) {
        if (words[i].meaning == Meaning::hit) return true;
        if (!links(words[i])) return false;
        is_value = is_value || words[i].meaning == Meaning::exists || words[i].meaning == Meaning::answer;
        if (is_value && ends_at(words, i + 1)) return true;
    }
    if (!ends_at(words, at + 1)) return false;
    std::size_t before = at;
    while (before > 0 && links(words[before - 1])) --before;
    return before > 0 && words[before - 1].meaning == Meaning::hit;
}

bool names_part(HitWords words) {
    return has(words, Meaning::partial) || has(words, Meaning::farther);
}

/// Whether the sentence is about a part, another root or an order only, before it is done: "no second hit".
bool is_partial(HitWords words) {
    return names_part(words) || has(words, Meaning::first) || has(words, Meaning::nearest) ||
           has(words, Meaning::before) || has(words, Meaning::after) || has(words, Meaning::covered);
}

/// Where the words begin that say in the clause that nothing is hit or that a value is not there.
std::optional<std::size_t> denial_in(HitWords words) {
    if (is_partial(words)) return std::nullopt;
    const auto negation = std::ranges::find_if(words, [](const HitWord& word) { return negates(word.meaning); });
    const bool negated = negation != words.end();
    const bool hit = has(words, Meaning::hit);
    const bool is_without_negation = (has(words, Meaning::miss) && !hit) ||
                                     (has(words, Meaning::not_real) && (hit || words.size() <= 2)) ||
                                     (has(words, Meaning::negative) && has(words, Meaning::discriminant));
    if (is_without_negation && !negated) return 0;
    if (!negated || has(words, Meaning::miss) || has(words, Meaning::negative)) return std::nullopt;
    const auto at = static_cast<std::size_t>(negation - words.begin());
    const bool is_none = negation->meaning == Meaning::none && ends_at(words, at + 1);
    return is_none || denies(words, at) ? std::optional(at) : std::nullopt;
}

/// The words, without those around them that say nothing about which value it is; empty for a sentence.
HitWords name_in(HitWords words) {
    while (!words.empty() && words.back().meaning == Meaning::link && words.back().text.size() > 1)
        words = words.first(words.size() - 1);
    const bool is_sentence =
        std::ranges::any_of(words, [](const HitWord& word) { return is_named(word) || word.meaning == Meaning::ray; });
    return is_sentence || words.size() > 4 ? HitWords() : words;
}

PrintedValue no_value(std::string_view line, std::size_t label_begin, std::size_t label_end, std::size_t begin) {
    constexpr std::string_view around = " \t:=-><,;.*#|~/\\\"'()[]{}?";
    PrintedValue value;
    const std::string_view label = line.substr(label_begin, label_end - label_begin);
    const std::size_t first = label.find_first_not_of(around);
    if (first != std::string_view::npos) value.label = label.substr(first, label.find_last_not_of(around) + 1 - first);
    const std::string_view words = line.substr(begin, longest_printed);
    value.printed = words.substr(0, words.find_last_not_of(" \t\"") + 1);
    return value;
}

/// A sign in place of a value: "t: ---", "N = {}".
std::optional<PrintedValue> read_empty_value(std::string_view line) {
    static const RE2 pattern(R"(^\s*(.{0,80}?)\s*(?:[:=]|->|\|)\s*[(<"'\[]*\s*(-+|\{\s*\})\s*\|?\s*$)");
    PrintedValue value;
    const bool is_one =
        RE2::FullMatch(re2::StringPiece(line.data(), line.size()), pattern, &value.label, &value.printed);
    return is_one ? std::optional(value) : std::nullopt;
}

/// The end of the last number before the words; 0 if there is none.
std::size_t end_of_number_before(HitWords words, std::size_t begin) {
    std::size_t end = 0;
    for (const HitWord& word : words) {
        if (word.begin < begin && word.meaning == Meaning::number) end = word.end;
    }
    return end;
}

}  // namespace

std::optional<PrintedValue> read_no_value(std::string_view line) {
    const std::vector<HitWord> words = hit_words(line);
    if (words.empty() || has(words, Meaning::condition)) return std::nullopt;
    if (line[line.find_last_not_of(" \t")] == '?') return std::nullopt;
    HitWords before;
    for (const Clause& clause : clauses_of(words)) {
        const HitWord& first = clause.words.front();
        const bool is_alone = clause.words.size() == 1 && negates(first.meaning);
        const bool is_answer =
            is_alone && clause.answers && !names_part(before) &&  // "hit? no", "t = no"
            std::ranges::any_of(before, [](const HitWord& word) {
                return word.meaning == Meaning::hit || word.meaning == Meaning::answer || is_named(word);
            });
        const auto denial = is_answer ? std::optional<std::size_t>(0) : denial_in(clause.words);
        if (denial && !names_part(before)) {
            const std::size_t begin = clause.words[*denial].begin;
            const std::size_t number = end_of_number_before(words, begin);
            if (*denial == 0 && clause.answers) return no_value(line, number, first.begin, begin);
            const bool is_beside = is_alone && !before.empty() && number <= before.front().begin;  // "P_c (none)"
            const HitWords name = *denial > 0 ? name_in(clause.words.first(*denial))
                                  : is_beside ? name_in(before)
                                              : HitWords();
            if (name.empty()) return no_value(line, 0, 0, *denial > 0 ? first.begin : begin);
            return no_value(line, name.front().begin, name.back().end, begin);
        }
        before = clause.words;
    }
    return read_empty_value(line);
}

bool says_not_answered(std::string_view line) {
    static const RE2 pattern(
        R"((?i)^\W*(?:not? (?:yet )?(?:done|finished|answered|implemented|attempted|solved|computed|calculated|answer)|todo|to do|skipped|skip|unfinished|incomplete|unanswered)(?: yet)?\W*$)");
    return RE2::FullMatch(re2::StringPiece(line.data(), line.size()), pattern);
}

}  // namespace harness
