#include "harness/match/object_titles.h"

#include <re2/re2.h>

#include <algorithm>
#include <set>

#include "harness/read/words/hit_words.h"

namespace harness {
namespace {

using reference::Subject;

/// The one object that the words name, if they tell nothing of it but that the ray may meet it.
std::optional<Subject> object_in(HitWords words) {
    constexpr std::size_t most_words = 7;
    std::optional<Subject> object;
    if (words.size() > most_words) return std::nullopt;
    for (const HitWord& word : words) {
        const auto named = object_of(word.meaning);
        const bool is_neutral = word.meaning == Meaning::other || word.meaning == Meaning::hit ||
                                word.meaning == Meaning::ray || word.meaning == Meaning::link ||
                                word.meaning == Meaning::number || word.meaning == Meaning::answer;
        if ((!named && !is_neutral) || (named && object && named != object)) return std::nullopt;
        if (named) object = named;
    }
    return object;
}

/// The object that a row of a table begins with: "Sphere: t = 0.59", "| sphere | 0.59 |".
std::optional<Subject> object_of_row(HitWords words) {
    const auto object = words.empty() ? std::nullopt : object_of(words.front().meaning);
    const bool has_more = words.size() > 1 && (words[1].spaced || words[1].signs.find_first_of(":|-=") == 0);
    return has_more ? object : std::nullopt;
}

/// Whether the line is a title of something that is no object.
bool is_other_title(const std::string& line) {
    static const RE2 title(
        R"((?i)[\W\d]*(?:the\s+)?(?:camera|view(?:ing)?|pixel|ray|eye|scene|setup|results?|summary|comparison|verdict|conclusion|winner|answers?|overall|final|first|closest|nearest|kamera|strahl|bild|ergebnis|zusammenfassung|camara|resumen|vue|resultats?)\b[\w \-]{0,30}\W*)");
    return RE2::FullMatch(line, title);
}

}  // namespace

std::vector<std::optional<Subject>> titled_objects(const Section& section) {
    std::set<int> lines_of_values;
    for (const PrintedValue& value : section.values) {
        for (int line = value.line; line <= value.last_line; ++line) lines_of_values.insert(line);
    }
    std::vector<std::optional<Subject>> objects;
    std::set<Subject> titled;
    std::optional<Subject> of_title, of_row;
    auto line = section.lines.begin();
    for (const PrintedValue& value : section.values) {
        for (; line != section.lines.end() && line->number <= value.line; ++line) {
            const std::vector<HitWord> words = hit_words(line->text);
            if (lines_of_values.contains(line->number)) {
                of_row = object_of_row(words);
            } else if (const auto named = object_in(words)) {
                of_title = named;
                titled.insert(*named);
            } else if (is_other_title(line->text)) {
                of_title.reset();
            }
        }
        objects.push_back(of_row ? of_row : of_title);
    }
    return titled.size() < 2 ? std::vector<std::optional<Subject>>() : objects;
}

}  // namespace harness
