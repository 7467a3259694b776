#include "harness/read/no_value.h"

#include <re2/re2.h>

#include <algorithm>
#include <string>

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

bool is_conjunction(Meaning meaning) {
    return meaning == Meaning::contrast || meaning == Meaning::reason || meaning == Meaning::conclusion;
}

bool is_answer_sign(const HitWord& word) {
    return word.signs.find_first_of(":=?|>") != std::string::npos || word.spaced;
}

std::vector<Clause> clauses_of(HitWords words) {
    std::vector<Clause> clauses;
    std::size_t begin = 0;
    const auto close = [&](std::size_t end) {
        if (end > begin)
            clauses.push_back({words.subspan(begin, end - begin), begin > 0 && is_answer_sign(words[begin])});
    };
    for (std::size_t i = 0; i < words.size(); ++i) {
        const bool skipped = words[i].meaning == Meaning::number || is_conjunction(words[i].meaning);
        if (!skipped && (i == 0 || !is_boundary(words[i], words[i - 1]))) continue;
        close(i);
        begin = skipped ? i + 1 : i;
    }
    close(words.size());
    return clauses;
}

bool is_named(const HitWord& word) {
    return object_of(word.meaning).has_value() || word.meaning == Meaning::any_object;
}

/// Whether the word may stand between a negation and what it denies.
bool links(const HitWord& word) {
    return word.meaning == Meaning::link || word.meaning == Meaning::exists || word.meaning == Meaning::answer ||
           word.meaning == Meaning::ray || is_named(word) || negates(word.meaning);
}

/// Whether only words of little meaning follow.
bool ends_at(HitWords words, std::size_t at) {
    return std::all_of(words.begin() + static_cast<std::ptrdiff_t>(at), words.end(), [](const HitWord& word) {
        return word.meaning == Meaning::link || word.meaning == Meaning::ray || is_named(word);
    });
}

/// Whether the negation at words[at] denies a hit, that a value exists, or a value: "no real root", "does not hit",
/// "not defined", "no normal".
bool denies(HitWords words, std::size_t at) {
    constexpr std::size_t reach = 5;
    bool exists = false, answer = false;
    for (std::size_t i = at + 1; i < words.size() && i <= at + reach; ++i) {
        if (words[i].meaning == Meaning::hit) return true;
        if (!links(words[i])) return false;
        exists = exists || words[i].meaning == Meaning::exists;
        answer = answer || words[i].meaning == Meaning::answer;
        if ((exists || answer) && ends_at(words, i + 1)) return true;
    }
    return false;
}

/// "trifft die Kugel nicht", "ray hits nothing": the negation behind the verb, at the end.
bool denies_before(HitWords words, std::size_t at) {
    if (!ends_at(words, at + 1)) return false;
    for (std::size_t i = at; i > 0; --i) {
        if (words[i - 1].meaning == Meaning::hit) return true;
        if (!links(words[i - 1])) return false;
    }
    return false;
}

/// Whether the object is passed: "passes by", "passes the sphere", but not "passes through the sphere".
bool is_passed(HitWords words) {
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        if (words[i].meaning != Meaning::passes) continue;
        const std::size_t next = words[i + 1].text == "the" || words[i + 1].text == "a" ? i + 2 : i + 1;
        if (next < words.size() && (words[next].meaning == Meaning::by || is_named(words[next]))) return true;
        if (std::ranges::any_of(words.subspan(i + 1), [](const HitWord& word) { return word.text == "by"; }))
            return true;
    }
    return false;
}

/// Whether a label is that of a part or another root: "caps", "far root".
bool names_part(HitWords words) {
    return has(words, Meaning::partial) || has(words, Meaning::farther);
}

/// Whether the line's label is that of a part: "end cap 1: t = inf, no hit".
bool is_labelled_as_part(HitWords words) {
    constexpr std::ptrdiff_t longest = 3;
    const auto colon =
        std::ranges::find_if(words, [](const HitWord& word) { return word.signs.find(':') != std::string::npos; });
    return colon != words.end() && colon - words.begin() <= longest && names_part(HitWords(words.begin(), colon));
}

/// Words such as "second" or "caps" that make a sentence one about a part only, before it is done.
bool is_partial(HitWords words) {
    constexpr Meaning meanings[] = {Meaning::partial, Meaning::farther, Meaning::first,  Meaning::nearest,
                                    Meaning::before,  Meaning::after,   Meaning::covered};
    return std::ranges::any_of(
        words, [&](const HitWord& word) { return std::ranges::find(meanings, word.meaning) != std::end(meanings); });
}

/// Where the words begin that say in the clause that nothing is hit or that a value is not there.
std::optional<std::size_t> denial_in(HitWords words) {
    if (is_partial(words)) return std::nullopt;
    const auto at = std::ranges::find_if(words, [](const HitWord& word) { return negates(word.meaning); });
    const bool negated = at != words.end();
    const bool hit = has(words, Meaning::hit);
    const bool negative = has(words, Meaning::negative);
    if (has(words, Meaning::miss) || is_passed(words))
        return negated || hit ? std::nullopt : std::optional<std::size_t>(0);
    if (!negated && has(words, Meaning::not_real) && (hit || words.size() <= 2)) return 0;
    if (!negated && negative && has(words, Meaning::discriminant)) return 0;
    if (negative) return std::nullopt;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (!negates(words[i].meaning)) continue;
        if (denies(words, i) || denies_before(words, i)) return i;
        // "t is none", "none", but not "nothing to print".
        if (words[i].meaning == Meaning::none && ends_at(words, i + 1)) return i;
        return std::nullopt;
    }
    return std::nullopt;
}

/// Whether words before a negation alone ask what it answers: "hit? no", "sphere: no", "t = no".
bool asks_for_hit(HitWords words) {
    if (names_part(words)) return false;
    return std::ranges::any_of(words, [](const HitWord& word) {
        return word.meaning == Meaning::hit || word.meaning == Meaning::answer || is_named(word);
    });
}

/// The words, without those around them that say nothing about which value it is.
HitWords name_in(HitWords words) {
    const auto says_little = [](const HitWord& word) {
        return word.meaning == Meaning::link && word.text.size() > 1;  // "c" may be that of P_c
    };
    while (!words.empty() && says_little(words.back())) words = words.first(words.size() - 1);
    const bool sentence =
        std::ranges::any_of(words, [](const HitWord& word) { return is_named(word) || word.meaning == Meaning::ray; });
    return sentence || words.size() > 4 ? HitWords() : words;
}

PrintedValue no_value(std::string_view line, std::size_t label_begin, std::size_t label_end, std::size_t begin) {
    constexpr std::string_view around = " \t:=-><,;.*#|~/\\\"'()[]{}?";
    PrintedValue value;
    std::string_view label = line.substr(label_begin, label_end - label_begin);
    const std::size_t first = label.find_first_not_of(around);
    if (first != std::string_view::npos) value.label = label.substr(first, label.find_last_not_of(around) + 1 - first);
    const std::string_view words = line.substr(begin, longest_printed);
    value.printed = words.substr(0, words.find_last_not_of(" \t\"") + 1);
    return value;
}

/// A sign in place of a value: "t: ---", "N = {}", "P_t - (outside)". Without a sign between them only what a miss
/// lacks is a name before a dash: other words before it are a title.
std::optional<PrintedValue> read_empty_value(std::string_view line) {
    static const RE2 pattern(
        R"(^\s*(.{0,80}?)\s*(?:[:=]|->|\|)\s*[(<"'\[]*\s*(-+|\{\s*\}|(?i:na|empty|(?:std::)?nullopt|flt_max|dbl_max))\s*(?:\([^()\d]{0,80}\)\s*)?\|?\s*$)");
    static const RE2 of_a_hit(
        R"(^\s*((?i:[tpn](?:_?[a-z]{1,3})?|(?:the )?(?:hit|intersection|normal|root)(?: (?:point|vector|position))?))\s+(-{1,3})\s*(?:\([^()\d]{0,80}\)\s*)?$)");
    const re2::StringPiece text(line.data(), line.size());
    re2::StringPiece label, sign;
    if (!RE2::PartialMatch(text, pattern, &label, &sign) && !RE2::PartialMatch(text, of_a_hit, &label, &sign))
        return std::nullopt;
    PrintedValue value;
    value.label = std::string(label);
    value.printed = std::string(sign);
    return value;
}

/// The end of the last number before the words; 0 if there is none.
std::size_t end_of_number_before(const std::vector<HitWord>& words, std::size_t begin) {
    std::size_t end = 0;
    for (const HitWord& word : words) {
        if (word.begin < begin && word.meaning == Meaning::number) end = word.end;
    }
    return end;
}

/// Whether the number is one that programs print in place of a value: 0, -1, 999, FLT_MAX.
bool stands_in(const HitWord& number) {
    static const RE2 pattern(R"((?i)-?0*(?:\.0*)?|-1(?:\.0*)?|-?9{3,}(?:\.0*)?|-?\d(?:\.\d*)?e\+?[1-9]\d{1,2})");
    return RE2::FullMatch(number.text, pattern);
}

/// "t = -1 (no hit)", "normal: (0, 0, 0) [miss]": the numbers of something that a miss lacks, each 0 or -1, and a
/// denial in brackets behind them. Of "d = -1 (no hit)" the number is d.
bool is_denied_in_brackets(HitWords words) {
    const auto is_number = [](const HitWord& word) { return word.meaning == Meaning::number; };
    const auto first = std::ranges::find_if(words, is_number);
    const auto end = std::find_if_not(first, words.end(), is_number);
    if (first == end || end == words.end() || !std::all_of(first, end, stands_in)) return false;
    if (end->signs.find_last_of("([{") == std::string::npos) return false;
    const auto is_lacked = [](const HitWord& word) {
        constexpr std::string_view names = "pnt";  // of points, normals and t
        const bool is_name = word.text.size() <= 2 && names.find(word.text.front()) != std::string_view::npos;
        return word.meaning == Meaning::answer || word.meaning == Meaning::hit || is_name;
    };
    const HitWords label(words.begin(), first);
    return std::ranges::any_of(label, is_lacked) && !has(label, Meaning::discriminant) &&
           !has(words, Meaning::condition) && denial_in(HitWords(end, words.end())) == std::size_t{0};
}

}  // namespace

std::optional<PrintedValue> read_no_value(std::string_view line) {
    const std::vector<HitWord> words = hit_words(line);
    if (words.empty() || has(words, Meaning::condition)) return std::nullopt;
    if (line.find_last_not_of(" \t") != std::string_view::npos && line[line.find_last_not_of(" \t")] == '?')
        return std::nullopt;
    const std::vector<Clause> clauses = clauses_of(words);
    const bool is_of_part = is_labelled_as_part(words);
    HitWords before;
    for (const Clause& clause : clauses) {
        const bool alone = negates(clause.words.front().meaning) && clause.words.size() == 1;
        const bool answers_alone =
            alone && clause.words.front().meaning == Meaning::negation && clause.answers && asks_for_hit(before);
        const auto denial = answers_alone ? std::optional<std::size_t>(0) : denial_in(clause.words);
        if (denial && !is_of_part) {
            const std::size_t begin = clause.words[*denial].begin;
            const std::size_t start = clause.words.front().begin;
            if (*denial == 0 && clause.answers && !names_part(before))
                return no_value(line, end_of_number_before(words, begin), start, begin);
            if (*denial == 0 && !clause.answers) {
                // A name in brackets: "[t] none", "P_c (none)".
                const bool beside = !before.empty() && end_of_number_before(words, begin) <= before.front().begin;
                const bool listed =
                    alone && beside && clause.words.front().signs.find_first_of(",([{])}>") != std::string::npos;
                const auto name = listed ? name_in(before) : HitWords();
                return name.empty() ? no_value(line, 0, 0, begin)
                                    : no_value(line, name.front().begin, name.back().end, begin);
            }
            if (*denial > 0) {
                const auto name = name_in(clause.words.first(*denial));
                return name.empty() ? no_value(line, 0, 0, start)
                                    : no_value(line, name.front().begin, name.back().end, begin);
            }
        }
        before = clause.words;
    }
    return read_empty_value(line);
}

bool is_title_above(std::string_view line, std::string_view next) {
    static const RE2 title(R"([^:=|>]*\s-+\s*)");
    static const RE2 numbers(R"(\s*[-+(\[{<|]*\s*[-+]?\.?\d.*)");
    return RE2::FullMatch(re2::StringPiece(line.data(), line.size()), title) &&
           RE2::FullMatch(re2::StringPiece(next.data(), next.size()), numbers);
}

bool number_means_no_hit(std::string_view line) {
    static const RE2 pattern(
        R"((?i)\(\s*-?[\d.]+\s*(?:means|stands for|is|=|->|:|for)\s*(?:that )?(?:there (?:is|was) |the ray )?(?:no\b|none|miss|not? hit))");
    if (RE2::PartialMatch(re2::StringPiece(line.data(), line.size()), pattern)) return true;
    const std::vector<HitWord> words = hit_words(line);
    if (is_denied_in_brackets(words)) return true;
    const auto zero = std::ranges::find(words, Meaning::number, &HitWord::meaning);
    if (zero == words.end() || zero->text != "0" || has(words, Meaning::condition) || is_partial(words)) return false;
    const auto denied = [](const HitWord& word) { return word.meaning == Meaning::hit; };
    const HitWords label(words.begin(), zero);
    const HitWords after(zero + 1, words.end());
    const bool is_labelled = zero->signs.find_first_of("=:") != std::string::npos;
    const auto counted = std::ranges::find_if_not(after, links);
    if (counted != after.end() && denied(*counted) && after.front().signs.empty() && !is_labelled) return true;
    // "number of hits: 0", "hit = 0", but not "hit point = 0" or "root = 0"
    const bool is_number_of = std::ranges::any_of(label, [](const HitWord& word) {
        return word.text == "number" || word.text == "count" || word.text == "num" || word.text == "anzahl" ||
               word.text == "nombre" || word.text == "numero";
    });
    const auto hit = std::ranges::find_if(label, denied);
    // "Hit sphere? 0 (no)"
    const bool is_repeated = std::ranges::all_of(after, [](const HitWord& word) { return negates(word.meaning); });
    if (!is_repeated || hit == label.end()) return false;
    const bool is_root = hit->text.starts_with("root") || hit->text.starts_with("solution");
    return is_number_of || (!is_root && std::ranges::all_of(label, [&](const HitWord& word) {
               return denied(word) || word.meaning == Meaning::link || word.meaning == Meaning::ray || is_named(word) ||
                      word.meaning == Meaning::exists || word.text == "bool" || word.text == "flag";
           }));
}

bool flag_denies_hit(std::string_view line) {
    static const RE2 pattern(
        R"((?i)\W*(?:is[\s_]?)?(?:valid|accepted|found|(?:all\s+)?conditions?\s+(?:are\s+|is\s+)?(?:fulfilled|met|satisfied)|t\s+(?:is\s+)?positive|t\s*>=?\s*0(?:\.0*)?)\s*[?:=]+\s*(?:0|no|false)\W*)");
    return RE2::FullMatch(re2::StringPiece(line.data(), line.size()), pattern);
}

bool says_not_answered(std::string_view line) {
    static const RE2 pattern(
        R"((?i)^\W*(?:not? (?:yet )?(?:done|finished|answered|implemented|attempted|solved|computed|calculated|answer)|todo|to do|skipped|skip|unfinished|incomplete|unanswered|nicht (?:gemacht|bearbeitet)|pas fait|sin hacer|non fatto|no hecho|nao feito)(?: yet)?\W*$)");
    return RE2::FullMatch(re2::StringPiece(line.data(), line.size()), pattern);
}

}  // namespace harness
