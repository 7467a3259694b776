#include "harness/match/item_place.h"

#include <algorithm>
#include <charconv>
#include <iterator>

#include "harness/match/question_match.h"
#include "harness/match/take_out.h"
#include "harness/read/tokens/own_separators.h"

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

bool is_within(const ItemPlace& place, int first, int last) {
    return place.first_line <= first && last <= place.last_line;
}

std::vector<PrintedLine> lines_at(const Transcript& transcript, const ItemPlace& place) {
    std::vector<PrintedLine> lines;
    for (const Section& section : transcript.sections) {
        for (const PrintedLine& line : section.lines) {
            if (is_within(place, line.number, line.number)) lines.push_back(line);
        }
    }
    return lines;
}

ValuesAt values_at(const Transcript& transcript, const ItemPlace& place) {
    ValuesAt found;
    for (std::size_t s = 0; s < transcript.sections.size(); ++s) {
        const auto& values = transcript.sections[s].values;
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (!is_within(place, values[i].line, values[i].last_line)) continue;
            found.values.push_back(values[i]);
            found.from.emplace_back(s, i);
        }
    }
    return found;
}

/// The value on these lines that fits the item best. It is taken out of the transcript.
std::optional<MatchedItem> value_at(Transcript& transcript, const reference::ItemSpec& item, const ItemPlace& place,
                                    std::span<const reference::ItemSpec> asked) {
    const ValuesAt there = values_at(transcript, place);
    Fits fits(asked);
    const Answers answers = answer_question({&item, 1}, {&there.values, 1}, Need::order_or_label, fits);
    if (!answers.candidate_of.front()) return std::nullopt;
    const Candidate& candidate = answers.candidates[*answers.candidate_of.front()];
    MatchedItem matched{item, candidate.value, candidate.order, {}, false, place.note};
    for (std::size_t i = candidate.first + candidate.count; i-- > candidate.first;) {
        if (candidate.parts > 1) break;  // the rest of a list is for other items
        auto& values = transcript.sections[there.from[i].first].values;
        values.erase(values.begin() + static_cast<std::ptrdiff_t>(there.from[i].second));
    }
    return matched;
}

/// A number with the text from which it comes.
struct NumberAt {
    PrintedNumber number;
    std::string_view text;
    int line;
};

std::vector<NumberAt> all_numbers(const std::vector<PrintedLine>& lines) {
    std::vector<NumberAt> numbers;
    for (const PrintedLine& line : lines) {
        const std::vector<Token> tokens = tokenize(line.text);
        for (std::size_t i = 0; i < tokens.size(); ++i) {
            if (tokens[i].kind != Token::Kind::number || is_bracketed_index(tokens, i)) continue;
            const std::string_view text(line.text);
            numbers.push_back(
                {tokens[i].number, text.substr(tokens[i].begin, tokens[i].end - tokens[i].begin), line.number});
        }
    }
    return numbers;
}

/// The lines with a blank for each letter that belongs to no number, so that "1.5m2.5m" is two numbers.
std::vector<PrintedLine> without_letters(std::vector<PrintedLine> lines) {
    for (PrintedLine& line : lines) {
        const std::string text = line.text;
        const auto is_number_part = [&](std::size_t i) {
            const bool follows_digit = i > 0 && (is_digit(text[i - 1]) || text[i - 1] == '.');
            const std::size_t next = i + 1 < text.size() && (text[i + 1] == '-' || text[i + 1] == '+') ? i + 2 : i + 1;
            return (text[i] == 'e' || text[i] == 'E') && follows_digit && next < text.size() && is_digit(text[next]);
        };
        for (std::size_t i = 0; i < text.size(); ++i) {
            if ((is_letter(text[i]) || text[i] == '_') && !is_number_part(i)) line.text[i] = ' ';
        }
    }
    return lines;
}

std::vector<reference::ItemSpec> items_of(int question, std::span<const reference::ItemSpec> asked) {
    std::vector<reference::ItemSpec> items;
    std::ranges::copy_if(asked, std::back_inserter(items),
                         [&](const reference::ItemSpec& spec) { return spec.question == question; });
    return items;
}

/// As many of these numbers as the item has: those that the place names, or else all.
std::optional<MatchedItem> as_item(Transcript& transcript, const std::vector<NumberAt>& numbers,
                                   const reference::ItemSpec& item, const ItemPlace& place,
                                   std::span<const reference::ItemSpec> asked) {
    const bool names_some = place.first_number > 0;
    const std::size_t first = names_some ? static_cast<std::size_t>(place.first_number) - 1 : 0;
    const std::size_t last = names_some ? static_cast<std::size_t>(place.last_number) : numbers.size();
    if (last > numbers.size() || !has_count(item.shape, last - first)) return std::nullopt;
    PrintedValue value;
    for (std::size_t i = first; i < last; ++i) {
        value.numbers.push_back(numbers[i].number);
        if (i > first) value.printed += ' ';
        value.printed += numbers[i].text;
    }
    value.printed.resize(std::min(value.printed.size(), longest_printed));
    value.line = numbers[first].line;
    value.last_line = numbers[last - 1].line;
    std::vector<PrintedNumber> printed;
    for (const NumberAt& number_at : numbers) printed.push_back(number_at.number);
    take_out(transcript, values_at(transcript, place), {printed, first, last}, items_of(item.question, asked));
    return MatchedItem{item, std::move(value), MatrixOrder::unsaid, {}, false, place.note};
}

/// The numbers of the lines, in order, if there are as many as the item has. They are taken out of the transcript.
std::optional<MatchedItem> numbers_at_place(Transcript& transcript, const reference::ItemSpec& item,
                                            const ItemPlace& place, std::span<const reference::ItemSpec> asked) {
    const std::vector<PrintedLine> lines = lines_at(transcript, place);
    if (auto matched = as_item(transcript, all_numbers(lines), item, place, asked)) return matched;
    const std::vector<PrintedLine> plain = without_letters(lines);
    return as_item(transcript, all_numbers(plain), item, place, asked);
}

}  // namespace

std::optional<ItemPlace> read_lines(std::string_view text) {
    const std::size_t colon = text.find(':');
    const auto lines = read_range(text.substr(0, colon));
    if (!lines) return std::nullopt;
    ItemPlace place;
    std::tie(place.first_line, place.last_line) = *lines;
    if (colon == std::string_view::npos) return place;
    const auto numbers = read_range(text.substr(colon + 1));
    if (!numbers || place.first_line != place.last_line) return std::nullopt;
    std::tie(place.first_number, place.last_number) = *numbers;
    return place;
}

std::optional<MatchedItem> read_at(Transcript& transcript, const reference::ItemSpec& item, const ItemPlace& place,
                                   std::span<const reference::ItemSpec> asked) {
    if (place.first_line == 0) return MatchedItem{item, {}, MatrixOrder::unsaid, {}, false, place.note};
    if (item.shape == Shape::first_object) {
        auto first = read_first_object(lines_at(transcript, place), FirstObjectPlace::own_section);
        if (!first) return std::nullopt;
        return MatchedItem{item, {}, MatrixOrder::unsaid, std::move(first), false, place.note};
    }
    if (place.first_number == 0) {
        if (auto matched = value_at(transcript, item, place, asked)) return matched;
    }
    return numbers_at_place(transcript, item, place, asked);
}

std::size_t numbers_at(const Transcript& transcript, const ItemPlace& place) {
    const std::vector<PrintedLine> lines = lines_at(transcript, place);
    const std::size_t count = all_numbers(lines).size();
    if (count > 0) return count;
    const std::vector<PrintedLine> plain = without_letters(lines);
    return all_numbers(plain).size();
}

}  // namespace harness
