#include "harness/read/chosen_value.h"

#include <fmt/format.h>
#include <re2/re2.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace harness {
namespace {

constexpr std::size_t longest_line = 200;

bool is_single(const PrintedValue& value) {
    return value.numbers.size() == 1;
}

/// Whether both may be one number, printed with two decimals at least.
bool is_the_same_number(const PrintedNumber& a, const PrintedNumber& b) {
    const int decimals = std::min(a.decimals, b.decimals);
    return a.value == b.value || (decimals >= 2 && std::abs(a.value - b.value) <= 0.5 * std::pow(10.0, -decimals));
}

/// A verb for "to choose", in any form.
constexpr std::string_view choose =
    "(?:us(?:e|es|ed|ing)|tak(?:e|es|en|ing)|took|choos(?:e|es|ing)|chose|chosen|pick(?:s|ed|ing)?|select(?:s|ed|ing)?"
    ")";
/// What goes before it in a sentence: "so we", "thus".
constexpr std::string_view therefore = R"((?:so|thus|hence|therefore|then)?\W*(?:we|i)?\s*)";

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
    static const RE2 by_name(fmt::format(R"((?i)\b{}\s*:?\s+(?:the\s+root\s+)?([a-z]\w*)\W*$)", choose));
    static const RE2 by_value(fmt::format(R"((?i){}{}(?:\s+t)?)", therefore, choose));
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
        R"((?:.{1,100},\s*(?:so|thus|hence|therefore|then)\s+)?\W*([A-Za-z][\w .']{0,60}?)\s*(?:=|:|->|\sis\s)\s*\(?([A-Za-z][\w ]{0,20}[\w+'*\-])\)?[\s.!]*)");
    static const RE2 choice(fmt::format(R"((?i){}{}(?:\s+(?:t|root|value|one))?)", therefore, choose));
    static const RE2 bare_choice(fmt::format(R"((?i)(.{{0,100}}\b{}{})\s+([a-z]\w*)[\s.!]*)", therefore, choose));
    std::string label, name;
    const re2::StringPiece text(line.data(), line.size());
    if (line.size() > longest_line) return std::nullopt;
    const bool is_choice = RE2::FullMatch(text, bare_choice, &label, &name);
    if (!is_choice && !RE2::FullMatch(text, sentence, &label, &name)) return std::nullopt;
    const bool is_signed = name.ends_with('-') || name.ends_with('+');
    if (is_signed) name.replace(name.size() - 1, 1, name.ends_with('-') ? " minus" : " plus");  // as labels are read
    const auto end = values.rend() - values.rbegin() > static_cast<std::ptrdiff_t>(nearby)
                         ? values.rbegin() + static_cast<std::ptrdiff_t>(nearby)
                         : values.rend();
    const auto found =
        std::find_if(values.rbegin(), end, [&](const PrintedValue& value) { return value.label == name; });
    if (found == end || found->numbers.empty()) return std::nullopt;
    PrintedValue chosen = *found;
    if (!is_choice && !RE2::FullMatch(label, choice)) {
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

void keep_selected(std::vector<PrintedValue>& values, PrintedValue& selected) {
    constexpr std::size_t nearby = 4;
    static const RE2 name(
        fmt::format(R"((?i)(?:{1}|\W*the\s+){0}(?:\s+(?:t|root|value|one))?|t\s+\(?{0}\)?)", choose, therefore));
    static const RE2 root(R"((?i)(?:t\w{0,6}|(?:.*\b)?(?:root|solution)\b.*)\W*)");
    if (!is_single(selected) || !RE2::FullMatch(selected.label, name)) return;
    const std::size_t first = values.size() > nearby ? values.size() - nearby : 0;
    const auto is_root = [&](const PrintedValue& value) {
        return is_single(value) && RE2::FullMatch(value.label, root);
    };
    // "used 3 multiplications" below "t = 0.58" chooses nothing.
    const auto is_the_same = [&](const PrintedValue& value) {
        return is_root(value) && is_the_same_number(value.numbers.front(), selected.numbers.front());
    };
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
    if (std::none_of(begin, values.end(), is_the_same)) return;
    const auto end = std::remove_if(begin, values.end(), is_root);
    values.erase(end, values.end());
    selected.label = "t";
}

void name_normalized(std::vector<PrintedValue>& values) {
    static const RE2 own(
        R"((?i)(?:unit|normali[sz]ed?)\s*\(\s*(\w+)\s*\)|(\w+?)\s*/\s*(?:\|+\s*\w+\s*\|*|\w*len\w*(?:\s*\(\s*\w+\s*\))?|\w*norm\w*(?:\s*\(\s*\w+\s*\))?|[\d.]+)|(\w+?)_(?:norm|n|hat))");
    static const RE2 nameless(
        R"((?i)unit|(?:of\s+)?(?:unit\s+)?length(?:\s+1(?:\.0*)?)?|as\s+a?\s*unit\s+vector|normali[sz]e)");
    for (std::size_t i = 1; i < values.size(); ++i) {
        PrintedValue& value = values[i];
        const PrintedValue* before = nullptr;  // behind "|N| = 16"
        for (std::size_t k = i; k-- > 0 && k + 3 > i && before == nullptr;) {
            if (values[k].numbers.size() == 3) before = &values[k];
        }
        if (before == nullptr || value.numbers.size() != 3 || value.line - before->last_line > 3) continue;
        std::string name[3];
        const bool is_own = RE2::FullMatch(value.label, own, &name[0], &name[1], &name[2]) &&
                            before->label == name[0] + name[1] + name[2];
        if ((is_own || RE2::FullMatch(value.label, nameless)) && !before->label.empty())
            value.label = before->label + " normalized";
    }
}

}  // namespace harness
