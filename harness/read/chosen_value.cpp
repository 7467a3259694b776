#include "harness/read/chosen_value.h"

#include <fmt/format.h>
#include <re2/re2.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
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

/// Whether the line ends with the choice of the smaller of two roots, "we use the smaller one", or of the larger, "the
/// larger root is taken"; empty if it does not.
std::optional<bool> chooses_smaller(std::string_view line) {
    const auto chosen = [](std::string_view which) {
        return fmt::format(
            R"((?i)\b(?:{0}\s*:?\s+(?:the\s+)?(?:{1})(?:\s+(?:positive\s+)?(?:one|root|t|value))?|(?:{1})(?:\s+(?:one|root))?\s+is\s+{0})\W*$)",
            choose, which);
    };
    static const RE2 smaller(chosen("small(?:er|est)|near(?:er|est)|clos(?:er|est)|first"));
    static const RE2 larger(chosen("larg(?:er|est)|second|far"));
    const re2::StringPiece text(line.data(), line.size());
    if (RE2::PartialMatch(text, smaller)) return true;
    return RE2::PartialMatch(text, larger) ? std::optional(false) : std::nullopt;
}

/// Keeps one of two roots that are not negative: "t = 4.41 or t = 1.59, we use the smaller".
void keep_root(std::vector<PrintedValue>& values, bool keeps_smaller) {
    if (values.size() != 2) return;
    const double value = values[0].numbers.front().value, other = values[1].numbers.front().value;
    if (std::min(value, other) < 0) return;
    if (values[1].label.empty() || values[1].label == "or") values[1].label = values[0].label;
    values.erase((value < other) == keeps_smaller ? values.begin() + 1 : values.begin());
}

bool says(std::string_view text, const RE2& words) {
    return !text.empty() && RE2::PartialMatch(re2::StringPiece(text.data(), text.size()), words);
}

/// Whether a label says that the ray comes into the object there.
bool is_entry(std::string_view label) {
    static const RE2 words(
        R"((?i)(?:^|[\W_])(?:enters?|entering|entry|near|nearer|front\s+hit|first\s+(?:hit|intersection)|eintritt|entr(?:é|e)e|entrada)(?:$|[\W_])|(?:hit|intersection)(?:\s+point)?\s*#?1\W*$)");
    return says(label, words);
}

/// The text of the line with this number; empty if there is none.
std::string_view text_of(const std::vector<PrintedLine>& lines, int number) {
    const auto line = std::ranges::lower_bound(lines, number, {}, &PrintedLine::number);
    return line != lines.end() && line->number == number ? std::string_view(line->text) : std::string_view();
}

/// Which of the values stand where the ray leaves an object, as the label says, or the words behind the only value of a
/// line: "t = 4.41 is the exit". What stands behind such a label on its line is of the exit too: "The ray leaves the
/// sphere at (4, 1, 0), t = 4.41".
std::vector<bool> are_exits(const std::vector<PrintedValue>& values, const std::vector<PrintedLine>& lines) {
    static const RE2 words(
        R"((?i)(?:^|[\W_])(?:leaves?|leaving|exits?|exiting|far|farther|back\s+hit|second\s+(?:hit|intersection)|austritt|sortie|salida)(?:$|[\W_])|(?:hit|intersection)(?:\s+point)?\s*#?2\W*$)");
    static const RE2 is_exit(
        R"((?i)\W*(?:is|was|would\s+be|=)\s+(?:only\s+)?(?:where\s+it|the|an?)?\s*(?:leaves?|exit|far|farther|other\s+(?:side|end)|austritt|sortie|salida)\b.*)");
    std::vector<bool> exits(values.size(), false);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const bool goes_on = i > 0 && exits[i - 1] && values[i - 1].line == values[i].line;
        const bool is_alone = (i == 0 || values[i - 1].line != values[i].line) &&
                              (i + 1 == values.size() || values[i + 1].line != values[i].line);
        const std::string_view line = is_alone ? text_of(lines, values[i].line) : "";
        const std::string_view behind = line.substr(std::min(line.find_last_of("0123456789"), line.size() - 1) + 1);
        exits[i] = says(values[i].label, words) || (goes_on && !is_entry(values[i].label)) ||
                   (!behind.empty() && RE2::FullMatch(re2::StringPiece(behind.data(), behind.size()), is_exit));
    }
    return exits;
}

/// Whether the ray comes in at `entry` before it leaves at `exit`: at a smaller t that is not negative, or at a point
/// that the same line names.
bool is_before(const PrintedValue& entry, const PrintedValue& exit) {
    static const RE2 root(R"((?i)^t\w{0,6}$)");
    if (entry.numbers.size() != exit.numbers.size()) return false;
    constexpr int nearby = 2;
    if (!is_single(exit)) return std::abs(entry.line - exit.line) <= nearby && is_entry(entry.label);
    const double t = entry.numbers.front().value;
    return t >= 0 && t < exit.numbers.front().value && (is_entry(entry.label) || says(entry.label, root));
}

}  // namespace

void drop_exits(std::vector<PrintedValue>& values, const std::vector<PrintedLine>& lines) {
    constexpr std::size_t nearby = 6;
    const std::vector<bool> exits = are_exits(values, lines);
    if (std::ranges::find(exits, true) == exits.end()) return;
    std::vector<PrintedValue> kept;
    for (std::size_t i = 0; i < values.size(); ++i) {
        bool is_dropped = false;
        const std::size_t end = std::min(values.size(), i + nearby);
        for (std::size_t k = i - std::min(i, nearby); k < end && exits[i] && !values[i].numbers.empty(); ++k)
            is_dropped = is_dropped || (!exits[k] && is_before(values[k], values[i]));
        if (!is_dropped) kept.push_back(values[i]);
    }
    if (kept.size() < values.size()) values = std::move(kept);
}

void keep_chosen(std::vector<PrintedValue>& values, std::string_view line) {
    static const RE2 by_name(fmt::format(R"((?i)\b{}\s*:?\s+(?:the\s+root\s+)?([a-z]\w*)\W*$)", choose));
    static const RE2 by_value(fmt::format(R"((?i){}{}(?:\s+t)?)", therefore, choose));
    if (values.size() < 2 || line.size() > longest_line || !std::ranges::all_of(values, is_single)) return;
    std::string chosen;
    if (const auto is_smaller = chooses_smaller(line)) return keep_root(values, *is_smaller);
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
    static const RE2 choice(fmt::format(
        R"((?i)(?:{}{}|(?:the\s+)?(?:small(?:er|est)|near(?:er|est)|clos(?:er|est)))(?:\s+(?:t|root|value|one))?)",
        therefore, choose));
    static const RE2 bare_choice(fmt::format(R"((?i)(.{{0,100}}\b{}{})\s+([a-z]\w*)[\s.!]*)", therefore, choose));
    static const RE2 is_nearer(fmt::format(
        R"((?i)(\W*)([a-z]\w*)\s+is\s+(?:the\s+)?(?:small(?:er|est)|near(?:er|est)|clos(?:er|est)|{})\b[\w\s,]{{0,40}}[\s.!]*)",
        choose));
    std::string label, name;
    const re2::StringPiece text(line.data(), line.size());
    if (line.size() > longest_line) return std::nullopt;
    const bool is_choice =
        RE2::FullMatch(text, bare_choice, &label, &name) || RE2::FullMatch(text, is_nearer, &label, &name);
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

std::optional<PrintedValue> choose_by_size(std::vector<PrintedValue>& values, std::string_view line) {
    static const RE2 root(R"((?i)(?:and\s+)?t[\w ]{0,6}|(?:.*\b)?roots?\b.*)");
    if (line.size() > longest_line || values.size() < 2) return std::nullopt;
    const auto is_smaller = chooses_smaller(line);
    const auto last = values.end() - 1, before = values.end() - 2;
    const bool are_roots = is_single(*last) && is_single(*before) && RE2::FullMatch(last->label, root) &&
                           RE2::FullMatch(before->label, root);
    if (!is_smaller || !are_roots) return std::nullopt;
    std::vector<PrintedValue> roots(before, values.end());
    keep_root(roots, *is_smaller);
    if (roots.size() != 1) return std::nullopt;
    values.erase(before, values.end());
    roots.front().label = "t";
    return roots.front();
}

void keep_selected(std::vector<PrintedValue>& values, PrintedValue& selected, std::string_view line) {
    constexpr std::size_t nearby = 4;
    static const RE2 name(fmt::format(
        R"((?i)(?:{1}|\W*the\s+|.{{0,80}}[.,]\s*{1}){0}(?:\s+the)?(?:\s+(?:small|near|clos)\w+)?(?:\s+(?:t\d?|root|value|one))*\W*|(?:the\s+)?(?:t|{2})(?:\s+(?:is|was))?\s+\(?{0}\)?|{2}|(?:the\s+)?final(?:\s+(?:t|root|value))?)",
        choose, therefore,
        R"((?:(?:the\s+)?(?:small|near|clos|larg|bigg)\w+(?:\s+(?:positive|non-?negative))?(?:\s+(?:root|t|value|one))?|root|solution|positive\s+root))"));
    static const RE2 arrow(R"(^\s*[-=]*>\s*[-+]?[\d.])");
    static const RE2 root(R"((?i)(?:(?:(?:and|or)\s+)?t\w{0,6}|(?:.*\b)?(?:roots?|solutions?)\b.*)\W*)");
    const bool is_behind_arrow = selected.label.empty() && says(line, arrow);
    if (!is_single(selected) || !(is_behind_arrow || RE2::FullMatch(selected.label, name))) return;
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

void drop_raw(std::vector<PrintedValue>& values, std::string_view line) {
    static const RE2 raw(
        R"((?i)[)>\]]\s*[(\[](?:before|raw|un\W?normali[sz]ed|not\s+(?:yet\s+)?normali[sz]ed)[^()]*[)\]])");
    if (values.size() != 2 || line.size() > longest_line || values[0].numbers.size() != 3 ||
        values[1].numbers.size() != 3 || !says(line, raw))
        return;
    values[1].label = values[0].label;
    values.erase(values.begin());
}

void drop_places(std::vector<PrintedValue>& values) {
    static const RE2 place(R"((?i)(.*\w.*?)\s+(?:from|at|between|through)\b(?:\s+\w+){0,3})");
    static const RE2 nameless(R"((?i)(?:is|(?:to|and|through)\b.*)?)");
    static const RE2 exit(R"((?i)\b(?:leaves|exits)\b)");  // "enters at (…) and exits at (…)" has two points
    if (values.size() < 2 || RE2::PartialMatch(values.back().label, exit) || values.back().numbers.size() != 3 ||
        !RE2::FullMatch(values.back().label, nameless))
        return;
    std::string name;
    const bool are_places = std::all_of(values.begin(), values.end() - 1, [&](const PrintedValue& value) {
        const bool is_first = &value == &values.front();
        return value.numbers.size() == 3 &&
               (is_first ? RE2::FullMatch(value.label, place, &name) : RE2::FullMatch(value.label, nameless));
    });
    if (!are_places) return;
    values.erase(values.begin(), values.end() - 1);
    values.front().label = name;
}

void drop_negated(std::vector<PrintedValue>& values, const std::vector<PrintedLine>& lines) {
    const auto begins_with_dash = [&](const PrintedValue& value) {
        const std::string_view line = text_of(lines, value.line);
        const std::size_t at = line.find_first_not_of(" \t");
        return at != std::string_view::npos && !value.label.empty() &&
               line.substr(at).starts_with(fmt::format("-{}", value.label));
    };
    constexpr std::size_t nearby = 6;
    for (std::size_t i = values.size(); i-- > 1;) {
        const std::size_t first = i - std::min(i, nearby);
        const auto has_plain = [&] {
            for (std::size_t k = first; k < i; ++k) {
                const bool is_same =
                    values[k].label == values[i].label && values[k].numbers.size() == values[i].numbers.size();
                if (is_same && !begins_with_dash(values[k])) return true;
            }
            return false;
        };
        if (values[i].numbers.size() == 3 && has_plain() && begins_with_dash(values[i]))
            values.erase(values.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

void name_normalized(std::vector<PrintedValue>& values) {
    static const RE2 own(
        R"((?i)(?:unit|normali[sz]ed?)\s*\(\s*(\w+)\s*\)|(\w+?)\s*/\s*(?:\|+\s*\w+\s*\|*|\w*len\w*(?:\s*\(\s*\w+\s*\))?|\w*norm\w*(?:\s*\(\s*\w+\s*\))?|[\d.]+)|(\w+?)_(?:norm|n|hat))");
    static const RE2 nameless(
        R"((?i)unit|(?:of\s+)?(?:unit\s+)?length(?:\s+1(?:\.0*)?)?|as\s+a?\s*unit\s+vector|normali[sz]e|normali[sz]ed\s+to)");
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
        static const RE2 raw("(?i)raw|un\\W?normali[sz]ed|not normali[sz]ed|before(?:\\W.*)?");
        if ((is_own || RE2::FullMatch(value.label, nameless)) && !before->label.empty())
            value.label = RE2::FullMatch(before->label, raw) ? "normalized" : before->label + " normalized";
    }
}

}  // namespace harness
