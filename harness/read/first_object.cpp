#include "harness/read/first_object.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "harness/read/no_value.h"
#include "harness/read/words/hit_words.h"

namespace harness {
namespace {

using reference::FirstObject;
using reference::Subject;

constexpr std::size_t longest_sentence = 400;

/// What a line says, clause by clause.
struct Statements {
    std::set<Subject> mentioned;
    std::set<Subject> called_first;  ///< "the triangle is hit first", "the sphere is closer than the triangle"
    std::set<Subject> hit;           ///< "the ray hits the triangle"
    std::set<Subject> denied;        ///< "misses the sphere", "the sphere is behind", "first: no"
    bool nothing_first = false;      ///< "no object is hit first"
};

/// Whether the words say that something is hit, missed or first.
bool states(HitWords words) {
    return has(words, Meaning::hit) || has(words, Meaning::miss) || has(words, Meaning::first) ||
           has(words, Meaning::nearest);
}

/// Where a clause ends: at a sign, at a conjunction, or at an "and" that a statement follows. The "and" of a list does
/// not end a clause: "misses the sphere and the triangle".
std::size_t end_of_clause(HitWords words, std::size_t begin) {
    const auto ends = [&](std::size_t at) {
        const HitWord& word = words[at];
        return word.signs.find_first_of(",;.!|/(){}>") != std::string::npos || word.text == "then" ||
               word.meaning == Meaning::contrast || word.meaning == Meaning::reason ||
               word.meaning == Meaning::conclusion;
    };
    for (std::size_t i = begin + 1; i < words.size(); ++i) {
        if (ends(i)) return i;
        if (words[i].text != "and") continue;
        std::size_t end = i + 1;
        while (end < words.size() && !ends(end)) ++end;
        if (states(words.subspan(i, end - i))) return i;
    }
    return words.size();
}

std::set<Subject> objects_in(HitWords words) {
    std::set<Subject> objects;
    for (const HitWord& word : words) {
        if (const auto object = object_of(word.meaning)) objects.insert(*object);
    }
    return objects;
}

/// Whether a clause denies: "misses the sphere", "hits the triangle second", "sphere first: 0", "would be first".
bool denies(HitWords words) {
    constexpr std::string_view later[] = {"second", "third",    "2nd",   "3rd",  "middle",
                                          "last",   "farthest", "would", "could"};
    const bool is_flag =
        words.size() >= 2 && words.back().text == "0" && words[words.size() - 2].meaning == Meaning::first;
    return is_flag || std::ranges::any_of(words, [&](const HitWord& word) {
               return negates(word.meaning) || word.meaning == Meaning::miss ||
                      std::ranges::find(later, word.text) != std::end(later);
           });
}

/// Of two objects the one that is first by the words between them: "the sphere is closer than the triangle".
std::optional<Subject> first_of_two(HitWords words) {
    std::vector<std::size_t> at;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (object_of(words[i].meaning)) at.push_back(i);
    }
    if (at.size() != 2 || denies(words)) return std::nullopt;
    const HitWords between = words.subspan(at[0] + 1, at[1] - at[0] - 1);
    const bool is_before = has(between, Meaning::before);
    const bool is_behind = has(between, Meaning::after) || has(between, Meaning::farther) ||
                           (has(between, Meaning::covered) && has(between, Meaning::by));
    if (is_before == is_behind) return std::nullopt;
    return object_of(words[is_before ? at[0] : at[1]].meaning);
}

/// Whether words say that nothing is hit, without an object's name.
bool says_nothing(HitWords words) {
    return has(words, Meaning::none) || (has(words, Meaning::negation) && has(words, Meaning::any_object));
}

bool tells_order(HitWords words) {
    return has(words, Meaning::before) || has(words, Meaning::after) || has(words, Meaning::farther) ||
           has(words, Meaning::covered);
}

void add_clause(Statements& said, HitWords words, const std::set<Subject>& in_line) {
    const bool is_superlative = has(words, Meaning::first) || has(words, Meaning::nearest);
    std::set<Subject> objects = objects_in(words);
    if (objects.empty() && is_superlative && says_nothing(words)) said.nothing_first = true;
    if (objects.empty() && is_superlative && in_line.size() == 1) objects = in_line;  // "triangle: t = 2, first: yes"
    if (const auto first = first_of_two(words)) {
        said.called_first.insert(*first);
    } else if (denies(words) ? !tells_order(words) : objects.size() == 1 && has(words, Meaning::after)) {
        said.denied.insert(objects.begin(), objects.end());
    } else if (objects.size() == 1 && is_superlative) {
        said.called_first.insert(*objects.begin());
    } else if (!tells_order(words) && (has(words, Meaning::hit) || has(words, Meaning::seen))) {
        said.hit.insert(objects.begin(), objects.end());
    }
}

Statements statements_in(HitWords words) {
    Statements said;
    said.mentioned = objects_in(words);
    for (std::size_t begin = 0, end = 0; begin < words.size(); begin = end) {
        end = end_of_clause(words, begin);
        add_clause(said, words.subspan(begin, end - begin), said.mentioned);
    }
    return said;
}

/// Whether there is one word beside the object at most, as in "triangle", "triangle: 2.83" and "Winner: triangle", up
/// to a reason: "triangle, because its t is smaller".
bool is_short(HitWords words) {
    const auto reason = std::ranges::find(words, Meaning::reason, &HitWord::meaning);
    return std::count_if(words.begin(), reason,
                         [](const HitWord& word) { return word.meaning != Meaning::link && word.text != "t"; }) <= 2;
}

std::optional<FirstObject> only(const std::set<Subject>& objects) {
    return objects.size() == 1 ? std::optional(FirstObject(*objects.begin())) : std::nullopt;
}

/// What a line says is hit first. A statement overrides those of lower ranks.
struct Statement {
    FirstObject object;
    int rank;  ///< 3: "first", 2: "hits", 1: an object alone, or a hit with its numbers
};

std::optional<Statement> ranked(const std::optional<FirstObject>& object, int rank) {
    return object ? std::optional(Statement{*object, rank}) : std::nullopt;
}

/// Empty for a line that states none, and for one that says it in a more complicated way: runs on other scenes or a
/// person tell what such words mean.
std::optional<Statement> statement_in(std::string_view line, FirstObjectPlace place) {
    const std::vector<HitWord> all = hit_words(line.substr(0, longest_sentence));
    const HitWords words = all;
    if (words.empty() || has(words, Meaning::debug) || has(words, Meaning::condition)) return std::nullopt;
    if (line.find('?') != std::string_view::npos) return std::nullopt;
    const Statements said = statements_in(words);
    if (has(words, Meaning::either) && said.mentioned.size() > 1 && said.denied.empty()) return std::nullopt;
    if (place == FirstObjectPlace::elsewhere)
        return has(words, Meaning::first) ? ranked(only(said.called_first), 3) : std::nullopt;
    if (!said.called_first.empty()) return ranked(only(said.called_first), 3);
    if (said.nothing_first) return Statement{FirstObject::no_hit, 3};
    if (has(words, Meaning::tie)) return Statement{FirstObject::tie, 3};
    const int rank = line.find_first_of("0123456789") == std::string_view::npos ? 2 : 1;
    if (!said.hit.empty()) return ranked(only(said.hit), rank);
    if (said.mentioned.empty()) {
        const bool is_miss = words.size() == 1 && words[0].meaning == Meaning::miss;
        const bool is_said = is_miss || says_nothing(words) || read_no_value(line);
        return is_said && !has(words, Meaning::partial) ? std::optional(Statement{FirstObject::no_hit, rank})
                                                        : std::nullopt;
    }
    if (said.denied.size() > 1 || (!said.denied.empty() && says_nothing(words)))
        return Statement{FirstObject::no_hit, rank};
    const bool is_alone = said.denied.empty() && !tells_order(words) && is_short(words);
    return is_alone ? ranked(only(said.mentioned), 1) : std::nullopt;
}

}  // namespace

std::optional<PrintedFirstObject> read_first_object(const std::vector<PrintedLine>& lines, FirstObjectPlace place) {
    std::optional<Statement> best;
    std::optional<PrintedFirstObject> printed;
    bool is_ambiguous = false;
    for (const auto& [text, number, numbers] : lines) {
        const auto statement = statement_in(text, place);
        if (!statement || (best && statement->rank < best->rank)) continue;
        is_ambiguous = best && statement->rank == best->rank && (is_ambiguous || statement->object != best->object);
        best = statement;
        const std::size_t begin = std::min(text.find_first_not_of(" \t:-*#>="), text.size());
        printed = PrintedFirstObject{statement->object, text.substr(begin, longest_printed), number};
    }
    return is_ambiguous ? std::nullopt : printed;
}

}  // namespace harness
