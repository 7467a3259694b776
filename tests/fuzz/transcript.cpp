#include "harness/read/transcript.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "harness/match/match.h"
#include "tests/fuzz/properties.h"

namespace {

using harness::MatchedItem;
using reference::Shape;

constexpr std::size_t longest_text = 2000;

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

int count_lines(std::string_view output) {
    // CR, LF and CR LF each end a line.
    return 2 +
           static_cast<int>(std::count_if(output.begin(), output.end(), [](char c) { return c == '\n' || c == '\r'; }));
}

bool has_the_shape(const MatchedItem& item) {
    const std::size_t count = item.value->numbers.size();
    if (item.unreadable || count == 0) return true;
    switch (item.spec.shape) {
        case Shape::scalar: return count == 1;
        case Shape::vector: return count == 3 || count == 4;
        case Shape::matrix3: return count == 9;
        case Shape::matrix4: return count == 16;
        case Shape::first_object: return false;
    }
    return false;
}

std::string check_matched(const std::vector<MatchedItem>& matched, int lines) {
    const auto specs = reference::default_items();
    if (matched.size() != specs.size()) return "not every item once";
    for (std::size_t i = 0; i < matched.size(); ++i) {
        const MatchedItem& item = matched[i];
        if (item.spec.question != specs[i].question || item.spec.name != specs[i].name) return "items out of order";
        if (item.first_object && (item.spec.shape != Shape::first_object || item.first_object->line < 1 ||
                                  item.first_object->line > lines)) {
            return "a first object beyond the output";
        }
        if (!item.value) continue;
        if (!has_the_shape(item)) return "a value of another shape";
        if (item.value->line < 1 || item.value->line > lines) return "a value beyond the output";
        if (!item.value->numbers.empty() && (item.value->last_line < item.value->line || item.value->last_line > lines))
            return "a value that ends before it begins";
        if (item.value->printed.size() > longest_text) return "a text beyond its limit";
    }
    return {};
}

std::vector<MatchedItem> match_output(std::string_view output) {
    return harness::match(harness::read_transcript(output, 10), reference::default_items());
}

/// Whether the same values, by their lines and sizes, answer the same items.
bool answers_alike(const std::vector<MatchedItem>& one, const std::vector<MatchedItem>& other) {
    return std::equal(
        one.begin(), one.end(), other.begin(), other.end(), [](const MatchedItem& a, const MatchedItem& b) {
            if (a.value.has_value() != b.value.has_value() || a.unreadable != b.unreadable) return false;
            if (a.first_object.has_value() != b.first_object.has_value()) return false;
            return !a.value || (a.value->line == b.value->line && a.value->last_line == b.value->last_line &&
                                a.value->numbers.size() == b.value->numbers.size() && a.order == b.order);
        });
}

/// The output of a program on a system whose lines end in CR LF.
std::string with_other_line_ends(std::string_view output) {
    std::string text;
    for (const char c : output) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
    return text;
}

/// The output with other digits from the third decimal on, which belong to no label, heading or sign.
std::string with_other_decimals(std::string_view output) {
    std::string text(output);
    std::size_t decimals = 0;
    bool behind_point = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '.' && i > 0 && is_digit(text[i - 1]) && !behind_point) {
            behind_point = true;
            decimals = 0;
        } else if (!is_digit(text[i])) {
            behind_point = false;
        } else if (behind_point && ++decimals >= 3 && text[i] != '0') {
            text[i] = text[i] == '9' ? '1' : static_cast<char>(text[i] + 1);
        }
    }
    return text;
}

/// Says of every item that was read where it stands. Then it is read from there, and keeps its shape.
std::string check_places(const harness::Transcript& transcript, const std::vector<MatchedItem>& matched, int lines) {
    std::vector<harness::ItemPlace> places;
    for (const MatchedItem& item : matched) {
        if (!item.value || item.unreadable) continue;
        harness::ItemPlace& place = places.emplace_back();
        place.question = item.spec.question;
        place.item = item.spec.name;
        place.first_line = item.value->line;
        place.last_line = item.value->last_line;
        place.note = "said";
    }
    const std::vector<MatchedItem> again = harness::match(transcript, reference::default_items(), places);
    if (std::string broken = check_matched(again, lines); !broken.empty()) return "with places: " + broken;
    for (std::size_t i = 0; i < again.size(); ++i) {
        if (again[i].place_note.empty() || !again[i].value) continue;
        const auto place = std::find_if(places.begin(), places.end(), [&](const harness::ItemPlace& each) {
            return each.question == again[i].spec.question && each.item == again[i].spec.name;
        });
        if (place == places.end()) return "an item is read from a place that nobody named";
        if (again[i].value->line < place->first_line || again[i].value->last_line > place->last_line)
            return "an item is read beyond its place";
    }
    return {};
}

}  // namespace

std::string check_transcript(std::string_view output) {
    const harness::Transcript transcript = harness::read_transcript(output, 10);
    const std::vector<MatchedItem> matched = harness::match(transcript, reference::default_items());
    const int lines = count_lines(output);
    if (std::string broken = check_matched(matched, lines); !broken.empty()) return broken;
    if (std::string broken = check_places(transcript, matched, lines); !broken.empty()) return broken;
    // An escape sequence goes on over a line's end.
    const bool is_plain = output.find_first_of("\r\x1b") == std::string_view::npos;
    for (const auto& [changed, broken] : {std::pair{with_other_decimals(output), "the decimals of answers decide"},
                                          std::pair{with_other_line_ends(output), "line ends decide"}}) {
        if (is_plain && changed != output && !answers_alike(matched, match_output(changed))) return broken;
    }
    return {};
}
