#include "harness/read/transcript.h"

#include <re2/re2.h>

#include <algorithm>
#include <optional>

#include "harness/read/chosen_value.h"
#include "harness/read/joined_values.h"
#include "harness/read/line_reader.h"
#include "harness/read/lines/output_lines.h"
#include "harness/read/no_value.h"
#include "harness/read/sections/find_headings.h"
#include "harness/read/sections/part.h"
#include "harness/read/sections/question_behind.h"
#include "harness/read/system_names.h"

namespace harness {
namespace {

/// Drops the middle of very many values, which come from an endless loop.
void keep_ends(std::vector<PrintedValue>& values) {
    constexpr std::ptrdiff_t end = most_values_in_section / 2;
    if (values.size() > most_values_in_section) values.erase(values.begin() + end, values.end() - end);
}

/// Whether the line begins with a dash and a name, as in "-b = 10": a sign, or the mark of a list.
bool begins_with_dash(std::string_view line) {
    const std::size_t dash = line.find_first_not_of(" \t");
    return dash != std::string_view::npos && line[dash] == '-' && dash + 1 < line.size() && is_letter(line[dash + 1]);
}

/// The line in which a dash before a name is a sign: the only one that begins with a dash, "-b = 10". A vector above
/// another one may be a column of the matrix: the numbers of "-V: 1 2 3" above "B-A: 4 5 6" are those of -V.
/// lines.size() if there is none.
std::size_t signed_line(const std::vector<std::string_view>& lines) {
    static const RE2 named(R"(\s*-\w+\s*[=:].*)");
    static const RE2 vector(R"((?:\D*\d[\d.]*(?:[^\d.]|$)){3}.*)");
    const auto matches = [&](std::size_t i, const RE2& pattern) {
        return i < lines.size() && RE2::FullMatch(re2::StringPiece(lines[i].data(), lines[i].size()), pattern);
    };
    if (std::ranges::count_if(lines, begins_with_dash) != 1) return lines.size();
    const auto at = static_cast<std::size_t>(std::ranges::find_if(lines, begins_with_dash) - lines.begin());
    const bool is_column = matches(at, vector) && matches(at + 1, vector);
    return matches(at, named) && !is_column ? at : lines.size();
}

/// The line without the right edge of a box: "* a: 1.0     *".
std::string_view without_edge(std::string_view line) {
    const std::size_t last = line.find_last_not_of(" \t*#");
    if (last == std::string_view::npos || last + 1 == line.size()) return line;
    const bool is_apart = line[last + 1] == ' ' || line[last + 1] == '\t';
    return is_apart ? line.substr(0, last + 1) : line;
}

/// Whether a heading goes on with "(the ray)", which says what its question is about, where elsewhere it names V.
bool is_ray(const std::string& title) {
    static const RE2 pattern(
        R"((?i)\W*(?:the|der|die|le|el)?\s*(?:viewing\s+|camera\s+)?(?:ray|strahl|rayon|rayo)\W*)");
    return RE2::FullMatch(title, pattern);
}

/// Whether the line is about a part of an object that the ray does not meet: "Bottom: normal (0, -1, 0), V.N = 0 ->
/// parallel".
bool is_of_missed_part(std::string_view line) {
    constexpr std::size_t longest = 200;
    static const RE2 pattern(
        R"((?i)\W*(?:the\s+)?(?:top|bottom|upper|lower|cap|tube|side|body|disk|plane)\b.*\b(?:parallel|outside|misses|missed|no\s+hit|never)\b.*)");
    return line.size() <= longest && RE2::FullMatch(re2::StringPiece(line.data(), line.size()), pattern);
}

/// The length of "(10 points)" behind a heading; 0 without.
std::size_t length_of_points(std::string_view title) {
    static const RE2 pattern(R"((?i)^(\W*\d+(?:\.\d+)?\s*(?:points?|pts?|marks?|punkte|pkt)\b\.?[)\]]?))");
    re2::StringPiece points;
    const re2::StringPiece text(title.data(), title.size());
    return RE2::PartialMatch(text, pattern, &points) ? points.size() : 0;
}

/// Whether the value is what a program sets before it looks for a hit: zeros, or a t of -1 or of 10,000 and more.
bool is_default(const PrintedValue& value) {
    static const RE2 t(R"((?i)t\w{0,9}|distance)");
    constexpr double far = 1e4;
    const auto is_zero = [](const PrintedNumber& number) { return number.value == 0; };
    if (value.numbers.size() == 3) return std::ranges::all_of(value.numbers, is_zero);
    return value.numbers.size() == 1 && RE2::FullMatch(value.label, t) &&
           (value.numbers.front().value == -1 || value.numbers.front().value >= far);
}

class TranscriptReader {
  public:
    Transcript run(const std::vector<OutputLine>& lines, int last_question) {
        std::vector<std::string_view> texts;
        for (const OutputLine& line : lines) texts.push_back(line.text);
        const auto headings = find_headings(texts, last_question);
        separators_ = OwnSeparators(texts);
        const std::size_t signed_at = signed_line(texts);
        transcript_.sections.push_back({0, {}, {}});
        const std::vector<std::size_t> part_ends = find_parts(texts, headings);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            auto [rest, number] = lines[i];
            rest.remove_prefix(std::max(part_ends[i], headings[i] ? std::min(rest.size(), headings[i]->end) : 0));
            if (headings[i]) {
                rest.remove_prefix(length_of_points(rest));
                transcript_.sections.push_back({headings[i]->question, {}, {}});
                above_.clear();
            }
            next_ = i + 1 < lines.size() ? lines[i + 1].text : std::string_view();
            read(rest, number, i == signed_at ? -1 : 1);
            if (headings[i]) {
                above_is_title_ = true;
                if (is_ray(above_)) above_.clear();
            }
        }
        for (Section& section : transcript_.sections) {
            keep_ends(section.values);
            section.values = join_values(std::move(section.values));
            drop_exits(section.values, section.lines);
            drop_negated(section.values, section.lines);
            name_normalized(section.values);
            name_unknowns(section.values, section.lines);
            name_corners(section.values);
        }
        return std::move(transcript_);
    }

  private:
    void read(std::string_view line, int number, double sign) {
        Section& section = transcript_.sections.back();
        section.lines.push_back({std::string(line), number});
        line = without_edge(line);
        LineReading reading = read_line(line, separators_);
        if (!reading.values.empty()) {
            for (PrintedNumber& each : reading.values.front().numbers) each.value *= sign;
        }
        const bool is_flag = flag_denies_hit(line);
        if (is_flag || (reading.values.size() <= 1 && number_means_no_hit(line))) {
            if (is_flag) reading.values.clear();  // its label names no item
            reading.values.resize(1);
            reading.values.front().numbers.clear();
            std::string& printed = reading.values.front().printed;
            if (printed.empty()) printed = line.substr(0, longest_printed);
        }
        const bool says_none = std::any_of(reading.values.begin(), reading.values.end(),
                                           [](const PrintedValue& value) { return value.numbers.empty(); });
        if (!says_none && std::any_of(line.begin(), line.end(), is_letter)) {
            auto none = read_no_value(line);
            const bool is_title = none && none->printed.starts_with('-') && is_title_above(line, next_);
            if (none && reading.values.size() == 1 && is_default(reading.values.front())) {
                reading.values.front().numbers.clear();  // "P_s: (0, 0, 0), since there is no hit"
            } else if (none && !is_title) {
                reading.values.push_back(std::move(*none));
            }
        }
        const bool has_values = !reading.values.empty();
        if (!has_values) {
            auto chosen = choose_by_name(section.values, line);
            if (!chosen) chosen = choose_by_size(section.values, line);
            if (chosen) reading.values.push_back(std::move(*chosen));
        }
        if (reading.values.empty()) {
            constexpr std::size_t longest_above = 200;
            if (reading.has_words) {
                above_ = std::string(line.substr(0, longest_above));
                above_is_title_ = false;
            }
            return;
        }
        if (is_of_missed_part(line)) {
            for (PrintedValue& value : reading.values) value.label = "intermediate: " + value.label;
        }
        if (has_values && reading.values.size() == 1) keep_selected(section.values, reading.values.front(), line);
        reading.values.front().above = above_;
        reading.values.front().above_is_title = above_is_title_;
        above_.clear();
        for (PrintedValue& value : reading.values) {
            value.line = value.last_line = number;
            section.values.push_back(std::move(value));
        }
    }

    Transcript transcript_;
    OwnSeparators separators_;
    std::string_view next_;        ///< the line behind the one that is read
    std::string above_;            ///< the last line of words, until a value takes it
    bool above_is_title_ = false;  ///< above_ is the rest of a heading
};

}  // namespace

Transcript read_transcript(std::string_view output, int last_question) {
    std::string text = with_questions_first(readable_text(output, last_question), last_question);
    return TranscriptReader().run(split_lines(text), last_question);
}

}  // namespace harness
