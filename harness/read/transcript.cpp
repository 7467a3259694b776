#include "harness/read/transcript.h"

#include <re2/re2.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

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

/// The x, y, z or w that a label names, as 0 to 3, and the label without it: "hit point: x" is component 0 of "hit
/// point".
struct ComponentLabel {
    int component;
    std::string base;
};

std::optional<ComponentLabel> read_component(const PrintedValue& value) {
    if (value.numbers.size() != 1 || value.label.empty()) return std::nullopt;
    // The handout's own "x_DCS", and "x in VCS".
    static const RE2 of_frame(R"((?i)([xyz])(?:_|\s+in\s+|\s+)?(vcs|wcs|view|world|cam|s|t|c|hit))");
    std::string axis, frame;
    if (RE2::FullMatch(value.label, of_frame, &axis, &frame))
        return ComponentLabel{(axis[0] | 0x20) - 'x', "P_" + frame};
    static const RE2 pattern(R"((?i)^(?:(.*?)(?:[\s:.,(_\-]+|\[)?)?(?:([xyzw])|([0-3])\])\s*$)");
    re2::StringPiece base;
    re2::StringPiece letter;
    re2::StringPiece index;
    if (!RE2::FullMatch(value.label, pattern, &base, &letter, &index)) return std::nullopt;
    std::string name(base);
    while (!name.empty() && std::string_view(" \t=:-.,(").find(name.back()) != std::string_view::npos) name.pop_back();
    if (!letter.empty()) {
        constexpr std::string_view letters = "xyzw";
        return ComponentLabel{static_cast<int>(letters.find(static_cast<char>(letter[0] | 0x20))), name};
    }
    return ComponentLabel{index[0] - '0', name};
}

/// Joins the components of each vector, "x = 0, y = 0, z = -2", on one line or several, into one value.
std::vector<PrintedValue> join_values(std::vector<PrintedValue> values) {
    std::vector<PrintedValue> joined;
    for (std::size_t i = 0; i < values.size();) {
        std::size_t count = 0;
        std::string base;
        while (i + count < values.size()) {
            const auto label = read_component(values[i + count]);
            if (!label || label->component != static_cast<int>(count)) break;
            if (count > 0 && !label->base.empty() && label->base != base) break;
            if (count > 0 && values[i + count].line - values[i + count - 1].last_line > 1) break;
            if (count == 0) base = label->base;
            ++count;
        }
        if (count < 3) {
            joined.push_back(std::move(values[i++]));
            continue;
        }
        PrintedValue vector = values[i];
        vector.label = base;
        vector.printed = values[i].label + " = " + values[i].printed;
        for (std::size_t k = 1; k < count; ++k) {
            const PrintedValue& component = values[i + k];
            vector.numbers.push_back(component.numbers[0]);
            vector.printed += ", " + component.label + " = " + component.printed;
            vector.last_line = component.last_line;
        }
        joined.push_back(std::move(vector));
        i += count;
    }
    return joined;
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
