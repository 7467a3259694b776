#include "harness/match/item_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>

#include "harness/match/candidates.h"
#include "harness/match/question_match.h"

namespace harness {
namespace {

using reference::Shape;

/// "12" or "12-14": whole numbers from 1 on, the second not below the first.
std::optional<std::pair<int, int>> read_range(std::string_view text) {
    const auto whole = [](std::string_view digits) -> std::optional<int> {
        int number = 0;
        const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
        const bool is_number = error == std::errc{} && stop == digits.data() + digits.size();
        return is_number && number > 0 ? std::optional(number) : std::nullopt;
    };
    const std::size_t dash = text.find('-');
    const auto first = whole(text.substr(0, dash));
    const auto last = dash == std::string_view::npos ? first : whole(text.substr(dash + 1));
    if (!first || !last || *last < *first) return std::nullopt;
    return std::pair(*first, *last);
}

std::vector<PrintedLine> lines_at(const Transcript& transcript, const ItemPlace& place) {
    std::vector<PrintedLine> lines;
    for (const Section& section : transcript.sections) {
        for (const PrintedLine& line : section.lines) {
            if (place.first_line <= line.number && line.number <= place.last_line) lines.push_back(line);
        }
    }
    return lines;
}

/// The item without a value, found at this place.
MatchedItem matched_at(const ItemPlace& place, const reference::ItemSpec& item) {
    MatchedItem matched{item};
    matched.place_note = place.note;
    matched.by_experiment = place.by_experiment;
    return matched;
}

/// A list with a name for each of its numbers, as in "a, b, c: 1 2 3", as its numbers; any other value as it is.
std::vector<PrintedValue> named_numbers(const PrintedValue& value, std::span<const reference::ItemSpec> items) {
    std::vector<PrintedValue> numbers;
    for (Candidate& candidate : candidates_of({value}, items)) numbers.push_back(std::move(candidate.value));
    return numbers.size() == value.numbers.size() ? numbers : std::vector{value};
}

/// Takes the numbers of a value out of the transcript, so that they are read for no other item. What remains of a list
/// is for other items of the question.
void take_out(Transcript& transcript, const PrintedValue& taken, int question,
              std::span<const reference::ItemSpec> asked) {
    std::vector<reference::ItemSpec> items;
    std::ranges::copy_if(asked, std::back_inserter(items),
                         [&](const reference::ItemSpec& spec) { return spec.question == question; });
    const auto is_taken = [&](const PrintedNumber& number) {
        return std::ranges::any_of(taken.numbers, [&](const PrintedNumber& other) {
            return number.index != 0 && number.line == other.line && number.index == other.index;
        });
    };
    for (Section& section : transcript.sections) {
        std::vector<PrintedValue> kept;
        for (PrintedValue& value : section.values) {
            const bool is_same_word = value.numbers.empty() && taken.numbers.empty() && value.line == taken.line;
            if (is_same_word) continue;
            if (std::ranges::none_of(value.numbers, is_taken)) {
                kept.push_back(std::move(value));
                continue;
            }
            for (PrintedValue& part : named_numbers(value, items)) {
                if (std::erase_if(part.numbers, is_taken) > 0) part.groups = 1;
                if (!part.numbers.empty()) kept.push_back(std::move(part));
            }
        }
        section.values = std::move(kept);
    }
}

/// The value on these lines that fits the item best.
std::optional<MatchedItem> value_at(const Transcript& transcript, const reference::ItemSpec& item,
                                    const ItemPlace& place, std::span<const reference::ItemSpec> asked) {
    std::vector<PrintedValue> values;
    for (const Section& section : transcript.sections) {
        std::ranges::copy_if(section.values, std::back_inserter(values), [&](const PrintedValue& value) {
            return place.first_line <= value.line && value.last_line <= place.last_line;
        });
    }
    Fits fits(asked);
    const Answers answers = answer_question({&item, 1}, {&values, 1}, Need::order_or_label, fits);
    if (!answers.candidate_of.front()) return std::nullopt;
    const Candidate& candidate = answers.candidates[*answers.candidate_of.front()];
    MatchedItem matched = matched_at(place, item);
    matched.value = candidate.value;
    matched.order = candidate.order;
    return matched;
}

/// The numbers that the place names, or all on its lines, if there are as many as the item has.
std::optional<MatchedItem> numbers_at(const std::vector<PrintedLine>& lines, const reference::ItemSpec& item,
                                      const ItemPlace& place) {
    PrintedValue value;
    const auto add = [&](const PrintedLine& line, const NumberOfLine& number, bool is_negated) {
        value.printed += fmt::format("{}{}{}", value.numbers.empty() ? "" : " ", is_negated ? "-" : "",
                                     line.text.substr(number.begin, number.end - number.begin));
        value.line = value.numbers.empty() ? line.number : std::min(value.line, line.number);
        value.last_line = std::max(value.last_line, line.number);
        value.numbers.push_back(number.number);
        if (is_negated) value.numbers.back().value = -value.numbers.back().value;
    };
    for (const PrintedLine& line : lines) {
        if (!place.numbers.empty()) break;
        for (const NumberOfLine& number : line.numbers) add(line, number, false);
    }
    for (const NumberPlace& named : place.numbers) {
        const auto line = std::ranges::find(lines, named.line, &PrintedLine::number);
        if (line == lines.end()) return std::nullopt;
        const std::vector<NumberOfLine>& numbers = line->numbers;
        const auto index = static_cast<std::size_t>(named.number) - 1;
        if (index >= numbers.size()) return std::nullopt;
        add(*line, numbers[index], named.is_negated);
    }
    if (!has_count(item.shape, value.numbers.size())) return std::nullopt;
    value.printed.resize(std::min(value.printed.size(), longest_printed));
    MatchedItem matched = matched_at(place, item);
    matched.value = std::move(value);
    matched.order = place.order;
    return matched;
}

/// "12:2", "12:2-4" or "12:-2": some numbers of one line.
bool read_numbers(std::string_view text, std::vector<NumberPlace>& numbers) {
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) return false;
    const bool is_negated = text.substr(colon + 1).starts_with('-');
    const auto line = read_range(text.substr(0, colon));
    const auto named = read_range(text.substr(colon + (is_negated ? 2 : 1)));
    constexpr int most = 1000;  // numbers of a line
    if (!line || line->first != line->second || !named || named->second > most) return false;
    if (is_negated && named->first != named->second) return false;
    for (int number = named->first; number <= named->second; ++number)
        numbers.push_back({line->first, number, is_negated});
    return true;
}

}  // namespace

std::optional<ItemPlace> read_lines(std::string_view text) {
    ItemPlace place;
    if (text.find(':') == std::string_view::npos) {
        const auto lines = read_range(text);
        if (!lines) return std::nullopt;
        std::tie(place.first_line, place.last_line) = *lines;
        return place;
    }
    constexpr std::size_t most_components = 16;
    for (bool goes_on = true; goes_on;) {
        const std::size_t comma = text.find(',');
        if (!read_numbers(text.substr(0, comma), place.numbers)) return std::nullopt;
        goes_on = comma != std::string_view::npos;
        if (goes_on) text.remove_prefix(comma + 1);
        if (place.numbers.size() > most_components) return std::nullopt;
    }
    const auto [first, last] = std::ranges::minmax(place.numbers);
    place.first_line = first.line;
    place.last_line = last.line;
    return place;
}

std::string lines_text(const ItemPlace& place) {
    if (place.first_line == 0) return "";
    if (place.numbers.empty() && place.first_line == place.last_line) return std::to_string(place.first_line);
    if (place.numbers.empty()) return fmt::format("{}-{}", place.first_line, place.last_line);
    std::string text;
    for (std::size_t i = 0, end = 0; i < place.numbers.size(); i = end) {
        const auto [line, number, is_negated] = place.numbers[i];
        end = i + (is_negated ? 1 : 0);
        while (end < place.numbers.size() &&
               place.numbers[end] == NumberPlace{line, number + static_cast<int>(end - i)})
            ++end;
        text += fmt::format("{}{}:{}{}", text.empty() ? "" : ",", line, is_negated ? "-" : "", number);
        if (end - i > 1) text += fmt::format("-{}", place.numbers[end - 1].number);
    }
    return text;
}

std::optional<MatchedItem> read_at(Transcript& transcript, const reference::ItemSpec& item, const ItemPlace& place,
                                   std::span<const reference::ItemSpec> asked) {
    if (place.first_line == 0) return matched_at(place, item);
    if (item.shape == Shape::first_object) {
        const std::vector<PrintedLine> lines = lines_at(transcript, place);
        auto first = read_first_object(lines, FirstObjectPlace::own_section);
        if (place.first_object && !lines.empty())
            first = {*place.first_object, lines.back().text.substr(0, longest_printed), lines.back().number};
        if (!first) return std::nullopt;
        MatchedItem matched = matched_at(place, item);
        matched.first_object = std::move(first);
        return matched;
    }
    auto matched = place.numbers.empty() ? value_at(transcript, item, place, asked) : std::nullopt;
    if (!matched) matched = numbers_at(lines_at(transcript, place), item, place);
    if (matched) take_value(transcript, *matched, asked);
    return matched;
}

void take_value(Transcript& transcript, const MatchedItem& item, std::span<const reference::ItemSpec> asked) {
    if (item.value) take_out(transcript, *item.value, item.spec.question, asked);
}

std::size_t numbers_at(const Transcript& transcript, const ItemPlace& place) {
    std::size_t count = 0;
    for (const PrintedLine& line : lines_at(transcript, place)) count += line.numbers.size();
    return count;
}

}  // namespace harness
