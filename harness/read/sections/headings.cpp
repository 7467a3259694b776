#include "harness/read/sections/headings.h"

#include <fmt/format.h>
#include <re2/re2.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <deque>
#include <map>
#include <set>
#include <string>

#include "harness/text/letters.h"
#include "harness/text/lower_case.h"

namespace harness {
namespace {

using Headings = std::vector<std::optional<Heading>>;

constexpr std::size_t longest_heading = 200;  ///< bytes of a line
constexpr std::size_t few = 3, many = 5;      ///< questions

/// How the number is introduced.
enum class Style {
    question,  ///< by "Question", "Q", "Exercise", "Problem", …
    part,      ///< by "Part", "Answer", "Step", "No.", …, which may also number steps within a question
    bare,      ///< by nothing: "1.", "2)", "--- 3 ---", "6a)"
    column,    ///< by its place at the beginning of lines: "| 6 | t | 0.59 |", "6 -> 0.59", "VI."
};

struct Form {
    Form(Style style_of_all, const std::string& text) : style(style_of_all), pattern(text) {}

    Style style;
    RE2 pattern;  ///< group 1 is the heading, the others its number
};

constexpr const char* question_words =
    R"((?i:(?:(?:[a-z]{2,4}\s?\d{3}\W+)?(?:assignment\s|a|hw\s?)\d[\s,:\-]*|(?:my )?(?:answers?|solutions?|results?|outputs?) (?:to|for|of) |section[\s:]+|(?:this|here) is |(?:now )?(?:[a-z]+ing)(?: of)? |now |the )?(?:§|questions?|quest?|ques|qn?|exercises?|exer|exc?|problems?|prob|tasks?)))";
constexpr const char* part_words =
    R"((?i:parts?|answers?|ans|items?|steps?|sections?|solution|results?|output|no|number))";

/// The patterns by style. What stands before and behind a number in digits may be a sign of any kind.
const std::deque<Form>& forms() {
    static const std::deque<Form> all = [] {
        const std::string decoration = R"(^(?:[\s*=\-_#~+|/\\<>.:!\[({"'`]|[^\x00-\x7F\pL\pN])*)";
        const std::string in_column = R"(^[\s*=\-_#(\[]*)";
        const std::string number =
            R"((?:[.\s]*[#:.\-_(\[]*|["']?\s*[:=])\s*["']?(?i:(?:no|nr|n|number)\b[^\pL\pN\n]{0,3})?#?\s?(\d{1,2}))";
        // The letter of a part, as in "Question 6a:", and what closes the heading.
        const std::string closing =
            R"((?:\.?\s?(?:(?:[a-h]|i{1,3})\b|[(\[](?:[a-h]|i{1,3}|iv|vi{0,3})[)\]])|[._]\d\b)?(?:\s*(?:of|/)\s*\d{1,2}\b)?[\s*=_#~+|\\\])}"'`]*(?:[:.)\]\-,;>=|]+|\s|$))";
        const std::string spelled = R"((?i:(one|two|three|four|five|six|seven|eight|nine|ten))\b)";
        std::deque<Form> forms;
        const auto add = [&](Style style, const std::string& pattern) { forms.emplace_back(style, pattern); };
        for (const auto& [style, words] : {std::pair(Style::question, question_words), {Style::part, part_words}}) {
            add(style, fmt::format("({}{}{}{})", decoration, words, number, closing));
            add(style, fmt::format(R"(({}{}\s*[#:\-_]?\s*{}[\s:.)\-*=]*))", decoration, words, spelled));
        }
        add(Style::bare,
            R"((^[\s*=\-_#~+|/\[({"]*(\d{1,2})(?:\s?\(?[a-h]|\.\d\b|")?(?:(?:\.|\s*[):\]}])[\s.)\]}:*=\-_#~|]*|[\s*=\-_#~|]*$)))");
        for (
            const char* pattern : {
                // "| 6 | t | 0.59 |", "6\tt\t0.59", "6   t   0.59"
                R"((^\s*(?:[|\x{2502}]\s*(?:Q\s?)?(\d{1,2})\s*[|\x{2502}]|(?:Q\s?)?(\d{1,2})(?:\s*[;|,\x{2502}]|\t|\s{2,}))\s*)(?:[-+.]\s*)?[^\s\d.+\-])",
                // "#6 t 0.59", "6.1 t = 0.59"
                R"((^\s*#?(\d{1,2})(?:[.\-]\d)?[.:]?\s+)[A-Za-z_(\[])",
                // "6 - the sphere", "6.1 -> 0.59"
                R"((^\s*(\d{1,2})(?:\s+-+|(?:\.\d)?\s*[-=]+>)(?:\s+|$)))",
            })
            add(Style::column, pattern);
        for (const std::string& pattern : {
                 // "VI.", but not "V:", which names the ray's direction
                 std::string(R"((X|IX|IV|V?I{0,3})\s?[.)\]](?:\s|$))"),
                 spelled + R"(\s?[.):\]]+(?:\s|$))",
                 // "HW6.2", "Exercise 6.2:", "6.2" alone on a line
                 std::string(R"([A-Za-z]{0,9}\s?\d{1,2}\.(\d{1,2})[:.)\]*=]*(?:$|\s+[A-Za-z]))"),
                 // "[6/10]", "A6:"
                 std::string(R"((\d{1,2})\s?(?:/|of)\s?\d{1,2}(?:[\s:.)\]*=\-]+|$))"),
                 std::string(R"(A(\d{1,2})(?:[.):\]]+(?:\s|$)|\s*$))"),
             })
            add(Style::column, fmt::format("({}{})", in_column, pattern));
        return forms;
    }();
    return all;
}

/// In digits, spelled, or as a Roman numeral; 0 for anything else.
int number_in(std::string_view text) {
    constexpr std::array<std::string_view, 10> spelled = {"one", "two",   "three", "four", "five",
                                                          "six", "seven", "eight", "nine", "ten"};
    constexpr std::array<std::string_view, 10> roman = {"i", "ii", "iii", "iv", "v", "vi", "vii", "viii", "ix", "x"};
    int value = 0;
    if (std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc()) return value;
    const std::string plain = lower_case(text);
    for (const auto& numerals : {spelled, roman}) {
        const auto* found = std::ranges::find(numerals, plain);
        if (found != numerals.end()) return static_cast<int>(found - numerals.begin()) + 1;
    }
    return 0;
}

/// Where a heading of `length` bytes ends. A '-' directly before a number belongs to that number.
std::size_t end_of(std::string_view start, std::size_t length) {
    const bool goes_on = length < start.size() && (is_digit(start[length]) || start[length] == '.');
    return length > 0 && start[length - 1] == '-' && goes_on ? length - 1 : length;
}

/// Whether a number alone is a heading's: not "-4", "1.25" or "17".
bool may_be_bare(std::string_view start, std::string_view whole, std::string_view number) {
    const std::string_view before = whole.substr(0, static_cast<std::size_t>(number.data() - whole.data()));
    const std::string_view after = whole.substr(before.size() + number.size());
    const bool is_signed = (before.ends_with('-') || before.ends_with('+')) && before.find("--") == before.npos;
    const bool is_closed = after.find_first_of(".):]}") != after.npos;
    const bool is_decorated = before.find_first_of("*=-_#~+|/[({") != before.npos;
    const bool goes_on = whole.size() < start.size() && is_digit(start[whole.size()]);
    if (goes_on && (whole.ends_with('.') || !is_closed)) return false;
    return !is_signed && (is_closed || is_decorated);
}

std::optional<Heading> heading_at(const Form& form, std::string_view line, int last_question) {
    const std::string_view start = line.substr(0, longest_heading);
    std::array<re2::StringPiece, 4> groups;
    if (!form.pattern.Match(re2::StringPiece(start.data(), start.size()), 0, start.size(), RE2::UNANCHORED,
                            groups.data(), 1 + form.pattern.NumberOfCapturingGroups()))
        return std::nullopt;
    const re2::StringPiece& digits = groups[2].empty() ? groups[3] : groups[2];
    const std::string_view whole(groups[1].data(), groups[1].size()), number(digits.data(), digits.size());
    const int question = number_in(number);
    if (question < 1 || question > last_question) return std::nullopt;
    if (form.style == Style::bare && !may_be_bare(start, whole, number)) return std::nullopt;
    const bool is_decimal = whole.size() < start.size() && whole.ends_with('.') && is_digit(start[whole.size()]);
    if (is_decimal) return std::nullopt;  // "Part 1.25"
    Heading heading{question, end_of(start, whole.size())};
    for (const char c : start.substr(0, static_cast<std::size_t>(number.data() - start.data()))) {
        if (c != ' ' && c != '\t' && !heading.before.ends_with(c)) heading.before += c;
    }
    return heading;
}

std::set<int> questions_in(const Headings& headings) {
    std::set<int> questions;
    for (const auto& heading : headings) {
        if (heading) questions.insert(heading->question);
    }
    return questions;
}

/// Keeps the headings whose number follows the same text, the text that numbers the most questions. Among "1)", "2)" …,
/// "[2]:" is not a heading; nor is "Step 2" among "Part 1", "Part 2" ….
void keep_alike(Headings& headings) {
    std::map<std::string, std::set<int>> questions;  // by the text before
    for (const auto& heading : headings) {
        if (heading) questions[heading->before].insert(heading->question);
    }
    const auto most = std::ranges::max_element(questions, {}, [](const auto& alike) { return alike.second.size(); });
    for (auto& heading : headings) {
        if (heading && heading->before != most->first) heading.reset();
    }
}

/// Drops numbers of parts, such as "2.1", "2.2", and "3.1", if several questions have them.
void drop_parts(Headings& headings) {
    const auto is_dotted = [](const std::optional<Heading>& heading) {
        return heading && !heading->before.empty() && is_digit(heading->before.front());
    };
    std::set<std::string> questions;
    for (const auto& heading : headings) {
        if (is_dotted(heading)) questions.insert(heading->before);
    }
    for (auto& heading : headings) {
        if (questions.size() > 1 && is_dotted(heading)) heading.reset();
    }
}

/// The headings of a style; of several forms of a line, the first counts.
Headings headings_in(Style style, const std::vector<std::string_view>& lines, int last_question) {
    Headings headings(lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        for (const Form& form : forms()) {
            if (form.style == style && !headings[i]) headings[i] = heading_at(form, lines[i], last_question);
        }
    }
    if (style != Style::question) keep_alike(headings);
    return headings;
}

/// Whether the lines of each question stand together, as they do under headings. The numbers of rows start over with
/// every matrix. One question may come back, and all may be printed again.
bool stand_together(const Headings& headings) {
    std::set<int> printed;
    int last = 0, returns = 0;
    for (const auto& heading : headings) {
        if (!heading || heading->question == last) continue;
        last = heading->question;
        if (printed.insert(last).second) continue;
        if (printed.size() >= many) {
            printed = {last};
        } else if (++returns > 1) {
            return false;
        }
    }
    return true;
}

/// The headings in a column: those of the form that numbers the most questions, at least `many`.
Headings column(const std::vector<std::string_view>& lines, int last_question) {
    Headings best;
    for (const Form& form : forms()) {
        if (form.style != Style::column) continue;
        Headings headings;
        for (const std::string_view line : lines) headings.push_back(heading_at(form, line, last_question));
        drop_parts(headings);
        keep_alike(headings);
        const std::size_t questions = questions_in(headings).size();
        if (stand_together(headings) && questions >= many && questions > questions_in(best).size())
            best = std::move(headings);
    }
    return best;
}

}  // namespace

std::vector<std::optional<Heading>> find_headings(const std::vector<std::string_view>& lines, int last_question) {
    Headings by_question = headings_in(Style::question, lines, last_question);
    const std::size_t questions = questions_in(by_question).size();
    if (questions >= few) return by_question;
    const auto number_of = [](const Headings& headings) {
        const std::size_t number = questions_in(headings).size();
        return number >= few && stand_together(headings) ? number : 0;
    };
    Headings by_part = headings_in(Style::part, lines, last_question);
    const std::size_t parts = number_of(by_part);
    Headings in_column = column(lines, last_question);
    if (!in_column.empty() && questions_in(in_column).size() >= parts) return in_column;
    Headings bare = headings_in(Style::bare, lines, last_question);
    const std::size_t numbers = number_of(bare);
    const std::size_t others = std::max(parts, numbers);
    if (questions > 0 && (others < many || few * questions >= others)) return by_question;
    if (parts > 0 && 2 * parts >= numbers) return by_part;
    return numbers > 0 ? bare : by_question;
}

}  // namespace harness
