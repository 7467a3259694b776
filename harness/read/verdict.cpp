#include "harness/read/verdict.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace harness {
namespace {

using reference::Subject;
using reference::Verdict;

constexpr std::size_t longest_verdict_line = 400;

std::vector<std::string> words_of(std::string_view line) {
    std::vector<std::string> words;
    bool in_word = false;
    for (char c : line.substr(0, longest_verdict_line)) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
        const bool letter = (c >= 'a' && c <= 'z') || c == '\'';
        if (letter && !in_word) words.emplace_back();
        if (letter) words.back() += c;
        in_word = letter;
    }
    return words;
}

template <std::size_t N>
bool is_one_of(const std::string& word, const std::array<std::string_view, N>& list) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

/// What students call an object.
struct ObjectWords {
    Subject object;
    std::array<std::string_view, 4> words;
};
constexpr ObjectWords object_words[] = {{Subject::sphere, {"sphere", "sphere's", "spheres", "ball"}},
                                        {Subject::triangle, {"triangle", "triangle's", "triangles", "tri"}},
                                        {Subject::cylinder, {"cylinder", "cylinder's", "cylinders", "cyl"}}};

constexpr std::array<std::string_view, 18> hit_words = {
    "hit",     "hits",  "closest", "nearest",  "closer", "nearer", "before",     "wins",        "winner",
    "visible", "front", "smaller", "smallest", "seen",   "chosen", "intersects", "intersected", "earlier"};
constexpr std::array<std::string_view, 8> negations = {"not",    "doesn't", "never", "misses",
                                                       "missed", "miss",    "no",    "isn't"};
constexpr std::array<std::string_view, 4> debug_words = {"debug", "dbg", "trace", "log"};

std::optional<Subject> object_of(const std::string& word) {
    for (const ObjectWords& each : object_words) {
        if (is_one_of(word, each.words)) return each.object;
    }
    return std::nullopt;
}

/// The object that the words name beside this one; empty if there is none or more than one.
std::optional<Subject> other_than(Subject object, const std::vector<std::string>& words) {
    std::optional<Subject> other;
    for (const std::string& word : words) {
        const auto named = object_of(word);
        if (!named || named == object || named == other) continue;
        if (other) return std::nullopt;
        other = named;
    }
    return other;
}

/// Whether the words before the object deny it: "does not hit triangle first".
bool is_denied(const std::vector<std::string>& words, std::size_t object) {
    constexpr std::array<std::string_view, 4> denials = {"not", "doesn't", "isn't", "never"};
    constexpr std::size_t reach = 4;
    for (std::size_t k = 1; k <= reach && k <= object; ++k) {
        if (is_one_of(words[object - k], denials)) return true;
        if (words[object - k] == "first" || object_of(words[object - k])) return false;
    }
    return false;
}

/// The nearest object before the word "first", else the nearest object after it. If the words deny that this object is
/// first, the result is the other object, provided that it is named too.
std::optional<Subject> object_at_first(const std::vector<std::string>& words) {
    constexpr std::size_t reach = 6;
    std::optional<Subject> found;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] != "first") continue;
        std::optional<Subject> near;
        for (std::size_t k = 1; k <= reach && k <= i && !near; ++k) {
            near = object_of(words[i - k]);
            if (!near || !is_denied(words, i - k)) continue;
            near = other_than(*near, words);
            if (!near) break;
        }
        for (std::size_t k = 1; k <= reach && i + k < words.size() && !near; ++k) near = object_of(words[i + k]);
        if (near && found && *near != *found)
            return std::nullopt;  // the question's text: "triangle first / sphere first"
        if (near) found = near;
    }
    return found;
}

bool any(const std::vector<std::string>& words, const auto& list) {
    return std::any_of(words.begin(), words.end(), [&](const std::string& word) { return is_one_of(word, list); });
}

bool says_nothing_is_hit(const std::vector<std::string>& words) {
    constexpr std::array<std::string_view, 4> nothing = {"nothing", "neither", "none", "anything"};
    if (any(words, nothing)) return true;
    const bool several =
        std::count_if(words.begin(), words.end(), [](const std::string& w) { return object_of(w).has_value(); }) >= 2;
    constexpr std::array<std::string_view, 5> all = {"both", "everything", "object", "objects", "any"};
    const bool about_all = several || any(words, all) || words.size() <= 3;
    constexpr std::array<std::string_view, 7> hit = {"hit",  "hits",         "misses",   "missed",
                                                     "miss", "intersection", "intersect"};
    return about_all && any(words, negations) && any(words, hit);
}

bool says_tie(const std::vector<std::string>& words) {
    constexpr std::array<std::string_view, 5> tie = {"tie", "tied", "simultaneously", "same", "equal"};
    return any(words, tie);
}

/// "sphere is closer than triangle", "closest: sphere", or just "sphere".
std::optional<Subject> object_compared(const std::vector<std::string>& words) {
    std::vector<Subject> objects;
    for (const std::string& word : words) {
        if (const auto object = object_of(word)) objects.push_back(*object);
    }
    if (objects.empty()) return std::nullopt;
    const bool one_object =
        std::all_of(objects.begin(), objects.end(), [&](Subject each) { return each == objects.front(); });
    if (one_object) {
        if (any(words, negations)) return std::nullopt;
        return any(words, hit_words) || words.size() <= 2 ? std::optional(objects.front()) : std::nullopt;
    }
    constexpr std::array<std::string_view, 13> compares = {"before",  "order",   "closer",  "nearer", "smaller",
                                                           "less",    "front",   "earlier", "than",   "wins",
                                                           "closest", "nearest", "then"};
    for (const std::string_view later : {"after", "behind"}) {  // "the triangle is behind the sphere"
        const auto at = std::ranges::find(words, later);
        const auto before = std::find_if(at, words.end(), [](const std::string& word) { return object_of(word); });
        if (before != words.end()) return object_of(*before);
        if (at != words.end()) return objects.front();
    }
    return any(words, compares) ? std::optional(objects.front()) : std::nullopt;
}

std::optional<Verdict> verdict_of(std::string_view line, VerdictPlace place) {
    const std::vector<std::string> words = words_of(line);
    if (words.empty() || any(words, debug_words)) return std::nullopt;
    if (const auto object = object_at_first(words)) return Verdict(*object);
    if (place == VerdictPlace::elsewhere) return std::nullopt;
    if (says_nothing_is_hit(words)) return Verdict::no_hit;
    if (std::find(words.begin(), words.end(), "first") != words.end() && !says_tie(words)) return std::nullopt;
    if (says_tie(words)) return Verdict::tie;
    const auto object = object_compared(words);
    return object ? std::optional(Verdict(*object)) : std::nullopt;
}

bool is_about_a_number(std::string_view line) {
    return line.find_first_of("0123456789") != std::string_view::npos;
}

}  // namespace

std::optional<PrintedVerdict> read_verdict(const std::vector<PrintedLine>& lines, VerdictPlace place) {
    std::optional<PrintedVerdict> plain;        // a sentence
    std::optional<PrintedVerdict> with_number;  // "closest hit: sphere at t = 0.58"; used if there is no plain verdict
    for (const auto& [text, number] : lines) {
        const auto verdict = verdict_of(text, place);
        if (!verdict) continue;
        const std::size_t begin = std::min(text.find_first_not_of(" \t:-*#>="), text.size());
        PrintedVerdict printed{*verdict, text.substr(begin, longest_printed), number};
        (is_about_a_number(text) ? with_number : plain) = std::move(printed);
    }
    return plain ? plain : with_number;
}

}  // namespace harness
