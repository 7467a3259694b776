#include "harness/read/sections/heading.h"

#include <fmt/format.h>
#include <re2/re2.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "harness/read/tokens/token.h"
#include "harness/text/plain_word.h"

namespace harness {
namespace {

constexpr std::size_t longest_heading = 200;

/// What may stand before a heading's first word: blanks and decoration.
constexpr const char* decoration = R"(^(?:[\s*=\-_#~+|/\\<>.:!\[({"'`]|[^\x00-\x7F\pL\pN])*)";
/// A sub-question's letter or number, then what may close the heading's number.
constexpr const char* closing =
    R"((?:\.?\s?(?:(?:[a-h]|i{1,3})\b|[(\[](?:[a-h]|i{1,3}|iv|vi{0,3})[)\]])|[._]\d\b)?(?:\s*(?:of|/)\s*\d{1,2}\b)?[\s*=_#~+|\\\])}"'`]*(?:[:.)\]\-,;>=|]+|\s|$))";
constexpr const char* question_number =
    R"([.\s]*[#:.\-_(\[]*\s*(?i:no\.?\s*|nr\.?\s*|n[\x{B0}\x{BA}.]\s*|number\s*)?#?\s?(\d{1,2}))";
/// What may stand before the word: the course and the assignment, or what the program does with the question.
constexpr const char* question_words =
    R"((?i:(?:[a-z]{2,4}\s?\d{3}\W+)?(?:assignment\s\d|a\d|hw\s?\d|(?:sheet|lab|blatt|(?:\x{FC}|ue)bungsblatt|serie|hoja|feuille)\s\d{1,2})[\s,:\-]*|(?:my )?(?:answers?|solutions?|results?|outputs?) (?:to|for|of) |section[\s:]+|antwort (?:auf|zu) |(?:this|here) is |(?:now )?(?:computing|calculating|running|solving|answering|evaluating|doing|working on|begin|beginning|start|starting)(?: of)? |now |the )?(?i:§|questions?|quest|ques|qn?|exercises?|exer|exc|ex|exo|problems?|prob|tasks?|aufgabe|aufg|(?:[\x{DC}\x{FC}\x{FFFD}]|ue)bung|frage|vraag|opgave|pregunta|ejercicio|domanda|esercizio|pergunta))";
constexpr const char* part_words =
    R"((?i:parts?|answers?|ans|items?|steps?|sections?|solution|results?|output|nr|no|number|teil(?:aufgabe)?|antwort|l(?:[\x{D6}\x{F6}\x{FFFD}]|oe)sung|ergebnis|punkt|apartado|respuesta|r(?:[\x{C9}\x{E9}\x{FFFD}]|e)ponse|risposta|resposta))";
constexpr const char* number_words =
    R"((?i:(one|two|three|four|five|six|seven|eight|nine|ten|eins|zwei|drei|vier|f(?:\x{FC}|\x{DC}|ue)nf|sechs|sieben|acht|neun|zehn|uno|dos|tres|cuatro|cinco|seis|siete|ocho|nueve|diez)))";

/// Words that head a question and may have a letter wrong: "Qestion 3".
constexpr std::array<std::string_view, 13> long_question_words = {
    "question", "exercise",  "problem", "aufgabe",   "pregunta", "ejercicio", "exercice",
    "domanda",  "esercizio", "questao", "exercicio", "pergunta", "probleme"};

std::string pattern_of(std::string_view words, std::string_view rest) {
    return fmt::format("({}{}{})", decoration, words, rest);
}

/// What stands behind a heading's word if its number is in digits.
std::string in_digits() {
    return fmt::format("{}{}", question_number, closing);
}

/// The same if its number is spelled.
std::string spelled() {
    return fmt::format(R"(\s*[#:\-_]?\s*{}\b[\s:.)\-*=]*)", number_words);
}

struct HeadingForm {
    Heading::Style style;
    RE2 digits;
    RE2 words;
};

const std::array<HeadingForm, 2>& forms() {
    static const std::array<HeadingForm, 2> all = {
        HeadingForm{Heading::Style::question, RE2(pattern_of(question_words, in_digits())),
                    RE2(pattern_of(question_words, spelled()))},
        HeadingForm{Heading::Style::part, RE2(pattern_of(part_words, in_digits())),
                    RE2(pattern_of(part_words, spelled()))}};
    return all;
}

/// The value of one of the number_words; 0 for another word.
int spelled_number(std::string_view word) {
    constexpr std::array<std::array<std::string_view, 4>, 10> words = {{
        {"one", "eins", "uno"},
        {"two", "zwei", "dos"},
        {"three", "drei", "tres"},
        {"four", "vier", "cuatro"},
        {"five", "funf", "cinco", "fuenf"},
        {"six", "sechs", "seis"},
        {"seven", "sieben", "siete"},
        {"eight", "acht", "ocho"},
        {"nine", "neun", "nueve"},
        {"ten", "zehn", "diez"},
    }};
    const std::string plain = plain_letters(word);
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (!plain.empty() && std::ranges::find(words.at(i), plain) != words.at(i).end())
            return static_cast<int>(i) + 1;
    }
    return 0;
}

/// Where a heading of `length` bytes ends. A '-' directly before a number belongs to that number.
std::size_t end_of(std::string_view start, std::size_t length) {
    const bool number_goes_on = length < start.size() && (is_digit(start[length]) || start[length] == '.');
    return length > 0 && start[length - 1] == '-' && number_goes_on ? length - 1 : length;
}

/// Where a heading of `length` bytes ends if its letter begins a list, as in "Question 6 a, b: 1 -4", and is no part's.
std::size_t before_list(std::string_view start, std::size_t length) {
    static const RE2 list(R"((.*?\W)[a-h],\s*[a-h]\b.*)");
    re2::StringPiece before;
    const std::size_t shown = std::min(start.size(), length + 3);  // to the next letter
    const bool is_list = RE2::FullMatch(re2::StringPiece(start.data(), shown), list, &before);
    return is_list ? before.size() : length;
}

/// "Qestion 3:", "Questão 3".
std::optional<Heading> misspelt(std::string_view start) {
    static const RE2 pattern(pattern_of(R"(([A-Za-z\x{C0}-\x{24F}\x{FFFD}]{6,12}))", in_digits()));
    re2::StringPiece whole, letters;
    int question = 0;
    if (!RE2::PartialMatch(re2::StringPiece(start.data(), start.size()), pattern, &whole, &letters, &question) ||
        question < 1)
        return std::nullopt;
    const std::string word = plain_letters(std::string_view(letters.data(), letters.size()));
    const bool is_known = std::ranges::any_of(long_question_words,
                                              [&](std::string_view right) { return is_one_letter_off(word, right); });
    return is_known ? std::optional(Heading{question, end_of(start, whole.size()), Heading::Style::question})
                    : std::nullopt;
}

/// "Question 2X: 1 0 0", where the heading's number stands right before an answer's name.
std::optional<Heading> before_name(std::string_view start) {
    static const RE2 pattern(
        fmt::format(R"(({}{}{})[A-Za-z][A-Za-z_]{{0,7}}\s*[:=)\]])", decoration, question_words, question_number));
    re2::StringPiece whole;
    int question = 0;
    if (!RE2::PartialMatch(re2::StringPiece(start.data(), start.size()), pattern, &whole, &question) || question < 1)
        return std::nullopt;
    return Heading{question, whole.size(), Heading::Style::question};
}

/// The same without a word, "2X: 1 0 0". "3D:" is none.
std::optional<Heading> bare_before_name(std::string_view start, int last_question) {
    static const RE2 pattern(R"(^([\s*#]*(\d{1,2}))(?:[A-CE-Za-z]|[A-Za-z][A-Za-z_]{1,7})\s*[:=)\]])");
    re2::StringPiece whole;
    int question = 0;
    if (!RE2::PartialMatch(re2::StringPiece(start.data(), start.size()), pattern, &whole, &question) || question < 1 ||
        question > last_question)
        return std::nullopt;
    return Heading{question, whole.size(), Heading::Style::bare};
}

std::optional<Heading> with_keyword(std::string_view start) {
    const re2::StringPiece text(start.data(), start.size());
    for (const HeadingForm& form : forms()) {
        re2::StringPiece whole;
        int question = 0;
        if (RE2::PartialMatch(text, form.digits, &whole, &question) && question >= 1) {
            // "Part 1.25" has a decimal number; "Question 6.1:" is the first part of question 6.
            const bool decimal = whole.size() < start.size() && whole.ends_with(".") && is_digit(start[whole.size()]);
            if (!decimal) return Heading{question, end_of(start, before_list(start, whole.size())), form.style};
        }
        std::string word;
        if (RE2::PartialMatch(text, form.words, &whole, &word)) {
            return Heading{spelled_number(word), end_of(start, whole.size()), form.style};
        }
    }
    return misspelt(start);
}

/// Whether a line that begins with "4." is a list of numbers, such as the matrix row "1. 0. 0. 4.".
bool is_row_of_numbers(std::string_view line, std::size_t heading_end) {
    const std::vector<Token> tokens = tokenize(line.substr(heading_end));
    const bool only_numbers = std::all_of(tokens.begin(), tokens.end(), [](const Token& token) {
        return token.kind == Token::Kind::number || token.kind == Token::Kind::comma;
    });
    const bool any_point = std::any_of(tokens.begin(), tokens.end(), [&](const Token& token) {
        return token.kind == Token::Kind::number && line[heading_end + token.end - 1] == '.';
    });
    return only_numbers && any_point;
}

/// "1.", "2)", "(3)", "--- 4 ---", "#5", "[6]", "6a)", "6(a)", JSON's "\"6\": {".
std::optional<Heading> bare(std::string_view start, int last_question) {
    static const RE2 pattern(
        R"((^([\s*=\-_#~+|/\[({"]*)(\d{1,2})(?:\s?\(?([a-h])|\.\d\b|")?(\s*[.):\]}][\s.)\]}:*=\-_#~|]*|[\s*=\-_#~|]*$)))");
    re2::StringPiece whole, before, letter, after;
    int question = 0;
    if (!RE2::PartialMatch(re2::StringPiece(start.data(), start.size()), pattern, &whole, &before, &question, &letter,
                           &after)) {
        return std::nullopt;
    }
    if (question < 1 || question > last_question) return std::nullopt;
    std::size_t end = whole.size();
    const bool number_goes_on = end < start.size() && is_digit(start[end]);
    const bool punctuated =
        std::string_view(after.data(), after.size()).find_first_of(".):]}") != std::string_view::npos;
    // In "5. -2.0" the sign belongs to the answer.
    if (punctuated && number_goes_on && end > 0 && start[end - 1] == '-') --end;
    if (number_goes_on && (start[end - 1] == '.' || !punctuated)) return std::nullopt;  // "1.25"
    const bool decorated =
        std::string_view(before.data(), before.size()).find_first_of("*=-_#~+|/[({") != std::string_view::npos;
    const bool signed_number = before.ends_with("-") || before.ends_with("+");
    const bool ruled = before.find("--") != re2::StringPiece::npos;
    if (signed_number && !ruled) return std::nullopt;    // "-4"
    if (!punctuated && !decorated) return std::nullopt;  // a lone number
    if (is_row_of_numbers(start, end)) return std::nullopt;
    return Heading{question, end, Heading::Style::bare};
}

/// "2.1 t: 1.5", "2.1: t = 1.5", "2-1 t = 1.5".
std::optional<Heading> dotted(std::string_view start, int last_question) {
    static const RE2 pattern(R"(^([\s*=\-_#]*(\d{1,2})[.\-]\d{1,2}[.):]?\s+)[A-Za-z_(\[])");
    re2::StringPiece whole;
    int question = 0;
    if (!RE2::PartialMatch(re2::StringPiece(start.data(), start.size()), pattern, &whole, &question))
        return std::nullopt;
    if (question < 1 || question > last_question) return std::nullopt;
    return Heading{question, whole.size(), Heading::Style::dotted};
}

/// A way to number questions that counts only if it numbers many of them, one behind the other.
struct ColumnForm {
    /// What group 3 of the pattern is: the number written otherwise, how many questions there are, or the question's
    /// number, where group 2 is the assignment's.
    enum class Third { alternative, total, question };
    RE2 pattern;  ///< group 1 is the heading, 2 the number
    Third third;
};

const std::array<ColumnForm, 9>& column_forms() {
    using enum ColumnForm::Third;
    const auto behind_decoration = [](const std::string& form) { return R"((^[\s*=\-_#(\[]*)" + form + ")"; };
    static const std::array<ColumnForm, 9> all = {
        // "| 6 | t | 0.59 |", "6\tt\t0.59"
        ColumnForm{
            RE2(R"((^\s*(?:[|\x{2502}]\s*(?:Q\s?)?(\d{1,2})\s*[|\x{2502}]|(?:Q\s?)?(\d{1,2})(?:\s*[;|,\x{2502}]|\t|\s{2,}))\s*)(?:[-+.]\s*)?[^\s\d.+\-])"),
            alternative},
        // "#6 t 0.59", "6 t = 0.59", "6-1 t = 0.59", "6.1 t = 0.59"
        ColumnForm{RE2(R"((^\s*#?(\d{1,2})(?:[.\-]\d)?\s+)[A-Za-z_(\[])"), alternative},
        // "6 - the sphere"
        ColumnForm{RE2(R"((^\s*(\d{1,2})\s+-+(?:\s+|$)))"), alternative},
        // "VI.", but not "V:", which names the ray's direction
        ColumnForm{RE2(behind_decoration(R"((?i:(X|IX|IV|V?I{0,3}))\s?[.)\]]+(?:\s|$))")), alternative},
        // "SIX."
        ColumnForm{RE2(behind_decoration(std::string(number_words) + R"(\s?[.):\]]+(?:\s|$))")), alternative},
        // "A6:", "6th question"
        ColumnForm{
            RE2(behind_decoration(
                R"((?:A(\d{1,2})(?:[.):\]]+(?:\s|$)|\s*$)|(\d{1,2})(?:st|nd|rd|th)\s(?i:question|exercise|problem|task|answer)\b[\s:.)\]*=\-]*))")),
            alternative},
        // "[6/10]", "6 of 10"
        ColumnForm{RE2(behind_decoration(R"((\d{1,2})\s?(?:/|of)\s?(\d{1,2})(?:[\s:.)\]*=\-]+|$))")), total},
        // "HW6.2", "Exercise 6.2"
        ColumnForm{RE2(behind_decoration(R"((?:HW|A|)" + std::string(question_words) +
                                         R"()\s?(\d{1,2})\.(\d{1,2})(?:[\s:.)\]*=\-]+|$))")),
                   question},
        // "6.2", but not "6.2 1.5"
        ColumnForm{RE2(behind_decoration(R"((\d{1,2})\.(\d{1,2})(?:[:.)\]*=]+\s*|\s+|$))") + R"((?:$|[^\d\s.+\-]))"),
                   question}};
    return all;
}

int number_in(std::string_view digits_or_word) {
    constexpr std::array<std::string_view, 10> roman = {"I", "II", "III", "IV", "V", "VI", "VII", "VIII", "IX", "X"};
    int value = 0;
    const char* end = digits_or_word.data() + digits_or_word.size();
    if (std::from_chars(digits_or_word.data(), end, value).ptr == end && value > 0) return value;
    const auto found = std::find(roman.begin(), roman.end(), digits_or_word);
    return found != roman.end() ? static_cast<int>(found - roman.begin()) + 1 : spelled_number(digits_or_word);
}

/// The numbers in a line's heading: of the assignment, 0 without one, and of the question.
struct ColumnNumbers {
    int assignment;
    Heading heading;
};

std::optional<ColumnNumbers> heading_in(const ColumnForm& form, std::string_view start, int last_question) {
    using enum ColumnForm::Third;
    std::array<re2::StringPiece, 4> groups;
    if (!form.pattern.Match(re2::StringPiece(start.data(), start.size()), 0, start.size(), RE2::UNANCHORED,
                            groups.data(), 1 + form.pattern.NumberOfCapturingGroups()))
        return std::nullopt;
    const auto group_number = [&](std::size_t group) {
        return groups.at(group).empty() ? 0 : number_in(std::string_view(groups[group].data(), groups[group].size()));
    };
    const int second = group_number(2), third = group_number(3);
    if (form.third == total && third != last_question) return std::nullopt;
    const int found = form.third == question || second == 0 ? third : second;
    if (found < 1 || found > last_question) return std::nullopt;
    return ColumnNumbers{form.third == question ? second : 0,
                         {found, end_of(start, groups[1].size()), Heading::Style::column}};
}

/// The headings of this form; empty unless they number many questions, what belongs to each standing together.
std::vector<std::optional<Heading>> question_column(const ColumnForm& form, const std::vector<std::string_view>& lines,
                                                    int last_question) {
    constexpr std::size_t fewest = 5;
    std::vector<std::optional<Heading>> headings(lines.size());
    std::set<int> named, all, assignments;  // named: in this printing
    int last = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto numbers = heading_in(form, lines[i].substr(0, longest_heading), last_question);
        if (!numbers) continue;
        headings[i] = numbers->heading;
        assignments.insert(numbers->assignment);
        if (headings[i]->question == last) continue;
        last = headings[i]->question;
        all.insert(last);
        if (named.insert(last).second) continue;
        if (named.size() < fewest) return {};
        named = {last};  // as for another pixel
    }
    if (all.size() < fewest || assignments.size() != 1) headings.clear();
    return headings;
}

/// The headings where each question or part of one is numbered alone on a line, "2.3" or "5"; empty unless these
/// numbers go up one by one, from the first question or its first part to the last question. A line with another number
/// alone is an answer, but one with the same number again may be the heading just as well.
std::vector<std::optional<Heading>> lone_numbers(const std::vector<std::string_view>& lines, int last_question) {
    constexpr std::size_t fewest = 5;
    static const RE2 pattern(R"(\s*(\d{1,2})(?:\.(\d))?\s*)");
    std::vector<std::optional<Heading>> headings(lines.size());
    std::map<std::pair<int, int>, int> times;  // that a question's number and its part's, 0 without one, stand alone
    std::vector<std::pair<int, int>> numbers;  // of the headings
    for (std::size_t i = 0; i < lines.size(); ++i) {
        re2::StringPiece part;
        int question = 0;
        const re2::StringPiece line(lines[i].data(), lines[i].size());
        if (line.size() > longest_heading || !RE2::FullMatch(line, pattern, &question, &part)) continue;
        const std::pair<int, int> here(question, part.empty() ? 0 : part[0] - '0');
        ++times[here];
        const std::pair<int, int> last = numbers.empty() ? std::pair(0, 0) : numbers.back();
        const bool is_next_part = here.first == last.first && last.second > 0 && here.second == last.second + 1;
        const bool is_next_question = here.first == last.first + 1 && here.second <= 1;
        if (!is_next_part && !is_next_question) continue;
        numbers.push_back(here);
        headings[i] = Heading{question, lines[i].size(), Heading::Style::column};
    }
    const bool are_headings =
        numbers.size() >= fewest && numbers.back().first == last_question &&
        std::ranges::all_of(numbers, [&](const auto& question_and_part) { return times[question_and_part] == 1; });
    if (!are_headings) headings.clear();
    return headings;
}

/// A line that begins with a word and a number: "Soru 2 (the sphere):". A short word of ASCII letters with its number
/// directly behind it is a name such as "t1".
std::optional<std::pair<std::string_view, Heading>> word_and_number(std::string_view line) {
    static const RE2 pattern(
        R"((^[\s*=\-_#~]*(\p{L}{1,20})(\s*)(\d{1,2})(?:[\s*=_#~]*(?:[:.)\]\-]+(?:\s|$)|\s|$)+)\s*))");
    const std::string_view start = line.substr(0, longest_heading);
    re2::StringPiece whole, word, gap;
    int number = 0;
    if (!RE2::PartialMatch(re2::StringPiece(start.data(), start.size()), pattern, &whole, &word, &gap, &number))
        return std::nullopt;
    if (const bool is_ascii = (word[0] & 0x80) == 0; gap.empty() && is_ascii) return std::nullopt;
    return std::pair(std::string_view(word.data(), word.size()),
                     Heading{number, end_of(start, whole.size()), Heading::Style::question});
}

/// The headings where one word that is none of the known ones stands before numbers that go up one by one from the
/// first question to the last, as in a language that is not known; empty if there is no such word.
std::vector<std::optional<Heading>> counted_by_a_word(const std::vector<std::string_view>& lines, int last_question) {
    constexpr int fewest = 5;
    if (last_question < fewest) return {};
    std::map<std::string_view, int> last;  // number behind a word; 0 if its numbers do not go up
    std::vector<std::optional<std::pair<std::string_view, Heading>>> found;
    for (const std::string_view line : lines) {
        found.push_back(word_and_number(line));
        if (!found.back()) continue;
        const auto& [word, heading] = *found.back();
        const auto [known, is_new] = last.try_emplace(word, heading.question == 1 ? 1 : 0);
        const bool goes_up = heading.question == known->second || heading.question == known->second + 1;
        if (!is_new && known->second > 0) known->second = goes_up ? heading.question : 0;
    }
    const auto counting = std::ranges::find_if(last, [&](const auto& each) { return each.second == last_question; });
    if (counting == last.end()) return {};
    std::vector<std::optional<Heading>> headings(lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (found[i] && found[i]->first == counting->first) headings[i] = found[i]->second;
    }
    return headings;
}

/// Of numbers alone, in brackets and without, those that name fewer questions are something else: "[1]: 0 4 0" below
/// "3)" is a row.
void keep_one_dress(std::vector<std::optional<Heading>>& headings, const std::vector<std::string_view>& lines) {
    std::array<std::set<int>, 2> named;
    const auto is_in_brackets = [&](std::size_t i) {
        return lines[i][std::min(lines[i].find_first_not_of(" \t"), lines[i].size() - 1)] == '[' ? 1U : 0U;
    };
    const auto is_bare = [&](std::size_t i) { return headings[i] && headings[i]->style == Heading::Style::bare; };
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (is_bare(i)) named.at(is_in_brackets(i)).insert(headings[i]->question);
    }
    const std::size_t fewer = named[0].size() < named[1].size() ? 0 : 1;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (is_bare(i) && is_in_brackets(i) == fewer) headings[i].reset();
    }
}

/// Chooses the style of the headings; named[style] holds the questions that a style names. The later styles also number
/// steps within questions, so they must name many more questions to be chosen.
std::size_t choose_style(const std::array<std::set<int>, 4>& named) {
    constexpr std::size_t fewest_bare = 3;
    const std::size_t questions = named[0].size();
    const std::size_t parts = named[1].size();
    const std::size_t bare_numbers = named[2].size() < fewest_bare ? 0 : named[2].size();
    const std::size_t others = std::max(parts, bare_numbers);
    if (questions == 0 && others == 0 && named[3].size() >= fewest_bare) return 3;
    if (questions > 0 && (others < 5 || 3 * questions >= others)) return 0;
    return parts > 0 && 2 * parts >= bare_numbers ? 1 : bare_numbers > 0 ? 2 : 0;
}

}  // namespace

std::optional<Heading> read_heading(std::string_view line, int last_question) {
    const std::string_view start = line.substr(0, longest_heading);
    if (start.find_first_not_of(" \t") == std::string_view::npos) return std::nullopt;
    if (auto heading = with_keyword(start)) return heading;
    if (auto heading = before_name(start)) return heading;
    if (auto heading = bare(start, last_question)) return heading;
    if (auto heading = bare_before_name(start, last_question)) return heading;
    return dotted(start, last_question);
}

std::vector<std::optional<Heading>> find_headings(const std::vector<std::string_view>& lines, int last_question) {
    std::vector<std::optional<Heading>> headings;
    headings.reserve(lines.size());
    std::array<std::set<int>, 4> named;  // by style
    for (const std::string_view line : lines) {
        headings.push_back(read_heading(line, last_question));
        if (!headings.back() || headings.back()->question > last_question) continue;
        named.at(static_cast<std::size_t>(headings.back()->style)).insert(headings.back()->question);
    }
    if (named[0].size() < 3 && named[1].size() < 3) {
        if (auto counted = counted_by_a_word(lines, last_question); !counted.empty()) return counted;
    }
    if (named[0].size() < 3) {
        for (const ColumnForm& form : column_forms()) {
            if (auto column = question_column(form, lines, last_question); !column.empty()) return column;
        }
        if (auto column = lone_numbers(lines, last_question); !column.empty()) return column;
    }
    const std::size_t best = choose_style(named);
    keep_one_dress(headings, lines);
    constexpr auto bare_style = static_cast<std::size_t>(Heading::Style::bare);
    const auto is_chosen = [&](const Heading& heading) {
        // "2.1 X" and "2.2 Y" beside "1. P" and "3. M".
        const bool is_only_dotted =
            heading.style == Heading::Style::dotted && best == bare_style && !named[best].contains(heading.question);
        return static_cast<std::size_t>(heading.style) == best || is_only_dotted;
    };
    for (auto& heading : headings) {
        if (heading && !is_chosen(*heading)) heading.reset();
    }
    return headings;
}

}  // namespace harness
