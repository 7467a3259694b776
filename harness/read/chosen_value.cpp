#include "harness/read/chosen_value.h"

#include <re2/re2.h>

#include <algorithm>
#include <string>

namespace harness {
namespace {

constexpr std::size_t longest_line = 200;

bool is_single(const PrintedValue& value) {
    return value.numbers.size() == 1;
}

/// What the line's last number was called before: "t2" in "t1 = 0.5, t2 = 3.5, so we take 3.5", else the name of the
/// last that has one.
std::string name_of_last(const std::vector<PrintedValue>& values) {
    std::string name;
    for (std::size_t i = 0; i + 1 < values.size(); ++i) {
        if (values[i].label.empty() || values[i].label == "or") continue;
        name = values[i].label;
        if (values[i].numbers.front().value == values.back().numbers.front().value) break;
    }
    return name;
}

}  // namespace

void keep_chosen(std::vector<PrintedValue>& values, std::string_view line) {
    static const RE2 by_name(
        R"((?i)\b(?:using|use|take|taking|took|choose|choosing|chose|chosen|pick|picking|picked|select|selected)\s*:?\s+(?:the\s+root\s+)?([a-z]\w*)\W*$)");
    static const RE2 by_value(
        R"((?i)(?:so|thus|hence|therefore|then)?\W*(?:we|i)?\s*(?:use|using|take|taking|choose|choosing|chose|pick|picked|took|select|selected)(?:\s+t)?)");
    if (values.size() < 2 || line.size() > longest_line || !std::ranges::all_of(values, is_single)) return;
    std::string chosen;
    if (RE2::FullMatch(values.back().label, by_value)) {
        values.back().label = chosen = name_of_last(values);
    } else if (!RE2::PartialMatch(re2::StringPiece(line.data(), line.size()), by_name, &chosen)) {
        return;
    }
    const auto found =
        std::find_if(values.rbegin(), values.rend(), [&](const PrintedValue& value) { return value.label == chosen; });
    if (chosen.empty() || found == values.rend()) return;
    const PrintedValue kept = *found;
    std::erase_if(values, [&](const PrintedValue& value) {
        return value.label == "or" || (!value.label.empty() && value.label.front() == chosen.front());
    });
    values.push_back(kept);
}

std::optional<PrintedValue> choose_by_name(std::vector<PrintedValue>& values, std::string_view line) {
    constexpr std::size_t nearby = 8;
    static const RE2 sentence(
        R"(\W*([A-Za-z][\w .']{0,60}?)\s*(?:=|:|->|\sis\s)\s*\(?([A-Za-z][\w ]{0,20}[\w+'*\-])\)?[\s.!]*)");
    static const RE2 choice(
        R"((?i)(?:so|thus|hence|therefore|then)?\W*(?:we|i)?\s*(?:use|using|take|taking|took|choose|choosing|chose|chosen|pick|picked|select|selected)(?:\s+(?:t|root|value|one))?)");
    std::string label, name;
    if (line.size() > longest_line ||
        !RE2::FullMatch(re2::StringPiece(line.data(), line.size()), sentence, &label, &name))
        return std::nullopt;
    if (name.ends_with('-')) name.pop_back();  // a label is read without it
    const auto end = values.rend() - values.rbegin() > static_cast<std::ptrdiff_t>(nearby)
                         ? values.rbegin() + static_cast<std::ptrdiff_t>(nearby)
                         : values.rend();
    const auto found =
        std::find_if(values.rbegin(), end, [&](const PrintedValue& value) { return value.label == name; });
    if (found == end || found->numbers.empty()) return std::nullopt;
    PrintedValue chosen = *found;
    if (!RE2::FullMatch(label, choice)) {
        chosen.label = label;
        return label == name ? std::nullopt : std::optional(chosen);
    }
    const auto first_nearby = values.begin() + (values.rend() - end);
    values.erase(std::remove_if(first_nearby, values.end(),
                                [&](const PrintedValue& value) {
                                    return is_single(value) && !value.label.empty() &&
                                           value.label.front() == name.front();
                                }),
                 values.end());
    return chosen;
}

}  // namespace harness
