#include "harness/match/item_place.h"

#include <fmt/format.h>
#include <re2/re2.h>

#include <algorithm>
#include <charconv>
#include <iterator>

#include "harness/match/question_match.h"
#include "harness/match/take_out.h"
#include "harness/read/tokens/lists.h"

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

/// The item without a value, found at this place.
MatchedItem matched_at(const ItemPlace& place, const reference::ItemSpec& item) {
    return {item, {}, MatrixOrder::unsaid, {}, false, place.note, place.by_experiment};
}

/// The value on these lines that fits the item best. It is taken out of the transcript.
std::optional<MatchedItem> value_at(Transcript& transcript, const reference::ItemSpec& item, const ItemPlace& place,
                                    std::span<const reference::ItemSpec> asked) {
    const ValuesAt there = values_at(transcript, place);
    Fits fits(asked);
    const Answers answers = answer_question({&item, 1}, {&there.values, 1}, Need::order_or_label, fits);
    if (!answers.candidate_of.front()) return std::nullopt;
    const Candidate& candidate = answers.candidates[*answers.candidate_of.front()];
    MatchedItem matched = matched_at(place, item);
    matched.value = candidate.value;
    matched.order = candidate.order;
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
    NumberPlace place;
};

/// Calls `then(number, text)` for each number of the text that stands by itself.
template <class Then>
void for_each_number(std::string_view text, Then then) {
    const std::vector<Token> tokens = tokenize(text);
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (tokens[i].kind != Token::Kind::number || is_bracketed_index(tokens, i)) continue;
        then(tokens[i].number, text.substr(tokens[i].begin, tokens[i].end - tokens[i].begin));
    }
}

std::vector<NumberAt> all_numbers(const std::vector<PrintedLine>& lines) {
    std::vector<NumberAt> numbers;
    for (const PrintedLine& line : lines) {
        int count = numbers.empty() || numbers.back().place.line != line.number ? 0 : numbers.back().place.number;
        for_each_number(line.text, [&](const PrintedNumber& number, std::string_view text) {
            numbers.push_back({number, text, {line.number, ++count}});
        });
    }
    return numbers;
}

/// The text with a blank for each letter that belongs to no number, so that "1.5m2.5m" is two numbers.
std::string without_letters(std::string text) {
    const std::string original = text;
    const auto is_number_part = [&](std::size_t i) {
        const bool follows_digit = i > 0 && (is_digit(original[i - 1]) || original[i - 1] == '.');
        const bool has_sign = i + 1 < original.size() && (original[i + 1] == '-' || original[i + 1] == '+');
        const std::size_t next = has_sign ? i + 2 : i + 1;
        const bool is_exponent = original[i] == 'e' || original[i] == 'E';
        return is_exponent && follows_digit && next < original.size() && is_digit(original[next]);
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        if ((is_letter(original[i]) || original[i] == '_') && !is_number_part(i)) text[i] = ' ';
    }
    return text;
}

std::vector<PrintedLine> without_letters(std::vector<PrintedLine> lines) {
    for (PrintedLine& line : lines) line.text = without_letters(std::move(line.text));
    return lines;
}

/// The text without the letters of words that contain a decimal number: "6.7 " for "6.7t".
std::string without_glued_letters(std::string text) {
    static const RE2 glued(R"(([\pL_]*[0-9]\.[0-9][\pL\d_.]*))");
    const std::string original = text, plain = without_letters(text);
    re2::StringPiece rest(original), word;
    while (RE2::FindAndConsume(&rest, glued, &word)) {
        const auto begin = static_cast<std::size_t>(word.data() - original.data());
        text.replace(begin, word.size(), plain, begin, word.size());
    }
    return text;
}

/// The lines with glued numbers apart; one in which there is still no number is without letters.
std::vector<PrintedLine> with_numbers_apart(std::vector<PrintedLine> lines) {
    for (PrintedLine& line : lines) {
        line.text = without_glued_letters(std::move(line.text));
        std::size_t count = 0;
        for_each_number(line.text, [&](const PrintedNumber&, std::string_view) { ++count; });
        if (count == 0) line.text = without_letters(std::move(line.text));
    }
    return lines;
}

std::vector<reference::ItemSpec> items_of(int question, std::span<const reference::ItemSpec> asked) {
    std::vector<reference::ItemSpec> items;
    std::ranges::copy_if(asked, std::back_inserter(items),
                         [&](const reference::ItemSpec& spec) { return spec.question == question; });
    return items;
}

/// The indices of the numbers that the place names, or of all; empty if one of them is not there.
std::vector<std::size_t> indices_at(const std::vector<NumberAt>& numbers, const ItemPlace& place) {
    std::vector<std::size_t> indices;
    if (place.numbers.empty()) {
        for (std::size_t i = 0; i < numbers.size(); ++i) indices.push_back(i);
    }
    for (const NumberPlace& named : place.numbers) {
        const NumberPlace plain{named.line, named.number};
        const auto found = std::ranges::lower_bound(numbers, plain, {}, &NumberAt::place);
        if (found == numbers.end() || found->place != plain) return {};
        indices.push_back(static_cast<std::size_t>(found - numbers.begin()));
    }
    return indices;
}

/// As many of these numbers as the item has: those that the place names, or else all.
std::optional<MatchedItem> as_item(Transcript& transcript, const std::vector<NumberAt>& numbers,
                                   const reference::ItemSpec& item, const ItemPlace& place,
                                   std::span<const reference::ItemSpec> asked) {
    const std::vector<std::size_t> indices = indices_at(numbers, place);
    if (!has_count(item.shape, indices.size())) return std::nullopt;
    PrintedValue value;
    value.line = value.last_line = numbers[indices.front()].place.line;
    for (const std::size_t i : indices) {
        if (!value.numbers.empty()) value.printed += ' ';
        const bool is_negated = !place.numbers.empty() && place.numbers[value.numbers.size()].is_negated;
        value.numbers.push_back(numbers[i].number);
        if (is_negated) value.numbers.back().value = -value.numbers.back().value;
        if (is_negated) value.printed += '-';
        value.printed += numbers[i].text;
        value.line = std::min(value.line, numbers[i].place.line);
        value.last_line = std::max(value.last_line, numbers[i].place.line);
    }
    value.printed.resize(std::min(value.printed.size(), longest_printed));
    std::vector<PrintedNumber> printed;
    for (const NumberAt& number_at : numbers) printed.push_back(number_at.number);
    take_out(transcript, values_at(transcript, place), {printed, indices}, items_of(item.question, asked));
    MatchedItem matched = matched_at(place, item);
    matched.value = std::move(value);
    matched.order = place.order;
    return matched;
}

/// The numbers of the lines, in order, if there are as many as the item has. They are taken out of the transcript.
std::optional<MatchedItem> numbers_at_place(Transcript& transcript, const reference::ItemSpec& item,
                                            const ItemPlace& place, std::span<const reference::ItemSpec> asked) {
    const std::vector<PrintedLine> lines = with_numbers_apart(lines_at(transcript, place));
    if (auto matched = as_item(transcript, all_numbers(lines), item, place, asked)) return matched;
    const std::vector<PrintedLine> plain = without_letters(lines);
    return as_item(transcript, all_numbers(plain), item, place, asked);
}

/// The indices of the numbers that are a value's, in order; empty if they are not all there.
std::vector<std::size_t> indices_of(const std::vector<PrintedNumber>& value, const std::vector<NumberAt>& numbers) {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < numbers.size() && indices.size() < value.size(); ++i) {
        if (numbers[i].number.value == value[indices.size()].value) indices.push_back(i);
    }
    return indices.size() == value.size() ? indices : std::vector<std::size_t>();
}

/// The lone minus sign before this byte, with at most a blank, a quote or a letter between.
MinusBefore minus_before(std::string_view text, std::size_t begin) {
    constexpr std::size_t most_between = 2;
    bool is_apart = false;
    for (std::size_t back = 1; back <= most_between + 1 && back <= begin; ++back) {
        const char c = text[begin - back];
        if (c == '-') {
            const char before = back == begin ? ' ' : text[begin - back - 1];
            if (before == '-' || before == '<') return MinusBefore::none;
            return is_apart ? MinusBefore::apart : MinusBefore::glued;
        }
        if (is_digit(c) || c == '+' || c == '=' || c == ':' || c == ',' || c == '>') return MinusBefore::none;
        is_apart = is_apart || c == ' ' || c == '\t';
    }
    return MinusBefore::none;
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

std::vector<NumberOfLine> numbers_of_line(const PrintedLine& line) {
    std::vector<NumberOfLine> numbers;
    const std::vector<PrintedLine> apart = with_numbers_apart({line});
    const std::string& text = apart.front().text;
    for_each_number(text, [&](const PrintedNumber& number, std::string_view digits) {
        const auto begin = static_cast<std::size_t>(digits.data() - text.data());
        numbers.push_back({number, minus_before(line.text, begin), begin, begin + digits.size()});
    });
    return numbers;
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
    if (place.numbers.empty()) {
        if (auto matched = value_at(transcript, item, place, asked)) return matched;
    }
    return numbers_at_place(transcript, item, place, asked);
}

void take_value(Transcript& transcript, const MatchedItem& item, std::span<const reference::ItemSpec> asked) {
    if (!item.value) return;
    ItemPlace place;
    place.first_line = item.value->line;
    place.last_line = item.value->last_line;
    const std::vector<NumberAt> numbers = all_numbers(with_numbers_apart(lines_at(transcript, place)));
    std::vector<PrintedNumber> printed;
    for (const NumberAt& number_at : numbers) printed.push_back(number_at.number);
    const std::vector<std::size_t> indices = indices_of(item.value->numbers, numbers);
    take_out(transcript, values_at(transcript, place), {printed, indices}, items_of(item.spec.question, asked));
}

std::size_t numbers_at(const Transcript& transcript, const ItemPlace& place) {
    const std::vector<PrintedLine> lines = with_numbers_apart(lines_at(transcript, place));
    return all_numbers(lines).size();
}

}  // namespace harness
