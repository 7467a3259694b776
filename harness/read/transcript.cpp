#include "harness/read/transcript.h"

#include <re2/re2.h>

#include <algorithm>

#include "harness/read/joined_values.h"
#include "harness/read/line_reader.h"
#include "harness/read/no_value.h"
#include "harness/read/sections/part.h"
#include "harness/read/tokens/clean_text.h"
#include "harness/text/lines.h"

namespace harness {
namespace {

/// Drops the middle of very many values, which come from an endless loop.
void keep_ends(std::vector<PrintedValue>& values) {
    constexpr std::ptrdiff_t end = most_values_in_section / 2;
    if (values.size() > most_values_in_section) values.erase(values.begin() + end, values.end() - end);
}

/// The length of "(10 points)" behind a heading; 0 without.
std::size_t length_of_points(std::string_view title) {
    static const RE2 pattern(R"((?i)^(\W*\d+(?:\.\d+)?\s*(?:points?|pts?|marks?)\b\.?[)\]]?))");
    re2::StringPiece points;
    const re2::StringPiece text(title.data(), title.size());
    return RE2::PartialMatch(text, pattern, &points) ? points.size() : 0;
}

/// The line in which a dash before a name is a sign, "-b = 10": the only one that begins with a dash. With others it is
/// the mark of a list, and above another vector the name of a matrix' column, "-V: 1 2 3" above "B-A: 4 5 6". The
/// number of lines if there is none.
std::size_t signed_line(const std::vector<std::string_view>& lines) {
    static const RE2 named(R"(\s*-\w+\s*[=:].*)"), vector(R"((?:\D*\d[\d.]*(?:[^\d.]|$)){3}.*)");
    const auto matches = [&](std::size_t i, const RE2& pattern) {
        return i < lines.size() && RE2::FullMatch(re2::StringPiece(lines[i].data(), lines[i].size()), pattern);
    };
    std::size_t found = lines.size();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::size_t dash = lines[i].find_first_not_of(" \t");
        const bool begins_with_dash = dash != std::string_view::npos && lines[i][dash] == '-' &&
                                      dash + 1 < lines[i].size() && is_letter(lines[i][dash + 1]);
        if (begins_with_dash && found != lines.size()) return lines.size();
        if (begins_with_dash) found = i;
    }
    const bool is_column = matches(found, vector) && matches(found + 1, vector);
    return matches(found, named) && !is_column ? found : lines.size();
}

class TranscriptReader {
  public:
    Transcript run(const std::vector<std::string_view>& lines, int last_question) {
        const auto headings = find_headings(lines, last_question);
        const std::size_t signed_at = signed_line(lines);
        transcript_.sections.push_back({0, {}, {}});
        const std::vector<std::size_t> part_ends = find_parts(lines, headings);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            std::string_view rest = lines[i];
            rest.remove_prefix(std::max(part_ends[i], headings[i] ? std::min(rest.size(), headings[i]->end) : 0));
            if (headings[i]) {
                rest.remove_prefix(length_of_points(rest));
                transcript_.sections.push_back({headings[i]->question, {}, {}});
                above_.clear();
            }
            read(rest, static_cast<int>(i) + 1, i == signed_at ? -1 : 1);
            if (headings[i]) above_is_title_ = true;
        }
        for (Section& section : transcript_.sections) {
            keep_ends(section.values);
            section.values = join_values(std::move(section.values));
        }
        return std::move(transcript_);
    }

  private:
    void read(std::string_view line, int number, double sign) {
        constexpr std::size_t longest_above = 200;
        Section& section = transcript_.sections.back();
        section.lines.push_back({std::string(line), number, numbers_of_line(line, number)});
        LineReading reading = read_line(line);
        if (!reading.values.empty()) {
            for (PrintedNumber& printed : reading.values.front().numbers) printed.value *= sign;
        }
        if (std::ranges::any_of(line, is_letter)) {
            if (auto none = read_no_value(line)) reading.values.push_back(std::move(*none));
        }
        if (reading.values.empty()) {
            if (!reading.has_words) return;
            above_ = std::string(line.substr(0, longest_above));
            above_is_title_ = false;
            return;
        }
        reading.values.front().above = above_;
        reading.values.front().above_is_title = above_is_title_;
        above_.clear();
        for (PrintedValue& value : reading.values) {
            value.line = value.last_line = number;
            for (PrintedNumber& printed : value.numbers) printed.line = number;
            section.values.push_back(std::move(value));
        }
    }

    Transcript transcript_;
    std::string above_;            ///< the last line of words, until a value takes it
    bool above_is_title_ = false;  ///< above_ is the rest of a heading
};

}  // namespace

Transcript read_transcript(std::string_view output, int last_question) {
    const std::string text = clean_text(output);
    return TranscriptReader().run(lines_of(text), last_question);
}

}  // namespace harness
