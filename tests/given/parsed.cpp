#include "tests/given/parsed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/match/match.h"
#include "harness/read/transcript.h"

namespace {

using harness::MatchedItem;
using harness::MatrixOrder;
using harness::PrintedNumber;

std::string show(const PrintedNumber& number) {
    constexpr int most_decimals = 30;
    if (!std::isfinite(number.value)) return fmt::format("{}", number.value);
    if (number.exact) return fmt::format("{} exactly", number.value);
    return fmt::format("{:.{}f}", number.value, std::clamp(number.decimals, 0, most_decimals));
}

std::string show_numbers(const std::vector<PrintedNumber>& numbers) {
    std::string text;
    for (const PrintedNumber& number : numbers) text += (text.empty() ? "" : " ") + show(number);
    return text;
}

std::string show_matrix(const std::vector<PrintedNumber>& numbers, MatrixOrder order) {
    const std::size_t n = numbers.size() == 9 ? 3 : 4;
    std::string text;
    for (std::size_t column = 0; column < n; ++column) {
        std::vector<PrintedNumber> group;
        for (std::size_t row = 0; row < n; ++row) {
            group.push_back(numbers[order == MatrixOrder::rows ? row * n + column : column * n + row]);
        }
        text += fmt::format("{}({})", column == 0 ? "" : " ", show_numbers(group));
    }
    switch (order) {
        case MatrixOrder::unsaid: return text;
        case MatrixOrder::rows: return text + " by rows";
        case MatrixOrder::columns: return text + " by columns";
    }
    return text;
}

std::string show(reference::FirstObject first) {
    if (const auto kind = first.kind()) return fmt::format("{} first", reference::to_string(*kind));
    return first == reference::FirstObject::tie ? "tie" : "no hit";
}

std::string show(const MatchedItem& item) {
    if (item.first_object) return fmt::format("{} @{}", show(item.first_object->object), item.first_object->line);
    if (!item.value) return "-";
    const std::vector<PrintedNumber>& numbers = item.value->numbers;
    const bool matrix = item.spec.shape == reference::Shape::matrix3 || item.spec.shape == reference::Shape::matrix4;
    std::string text = item.unreadable ? "? " : "";
    if (numbers.empty()) {
        text += "none";
    } else if (matrix && !item.unreadable) {
        text += show_matrix(numbers, item.order);
    } else {
        text += show_numbers(numbers);
    }
    return fmt::format("{} @{}", text, item.value->line);
}

}  // namespace

std::string parsed(std::string_view output) {
    std::string text;
    for (const MatchedItem& item : harness::match(harness::read_transcript(output, 10), reference::default_items())) {
        text += fmt::format("{}.{}: {}\n", item.spec.question, item.spec.name, show(item));
    }
    return text;
}

std::string parsed_values(std::string_view output) {
    std::string lines;
    std::string_view all;
    const std::string text = parsed(output);
    for (all = text; !all.empty();) {
        const std::size_t end = all.find('\n');
        const std::string_view line = all.substr(0, end);
        if (!line.ends_with(" -")) lines += std::string(line) + "\n";
        all.remove_prefix(end + 1);
    }
    return lines;
}
