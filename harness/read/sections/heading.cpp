#include "harness/read/sections/heading.h"

#include <fmt/format.h>
#include <re2/re2.h>

#include <algorithm>
#include <array>
#include <string>

#include "harness/read/sections/heading_words.h"
#include "harness/read/tokens/token.h"
#include "harness/text/plain_word.h"

namespace harness {
namespace {

/// What may stand before a heading's first word: blanks and decoration.
constexpr const char* decoration = R"(^(?:[\s*=\-_#~+|/\\<>.:!\[({"'`]|[^\x00-\x7F\pL\pN])*)";
/// A sub-question's letter or number, then what may close the heading's number.
constexpr const char* closing =
    R"((?:\.?\s?(?:(?:[a-h]|i{1,3})\b|[(\[](?:[a-h]|i{1,3}|iv|vi{0,3})[)\]])|[._]\d\b)?(?:\s*(?:of|/)\s*\d{1,2}\b)?[\s*=_#~+|\\\])}"'`]*(?:[:.)\]\-,;>=|]+|\s|$))";
constexpr const char* question_number =
    R"((?:[.\s]*[#:.\-_(\[]*|["']?\s*[:=])\s*["']?(?i:no\.?\s*|nr\.?\s*|n[\x{B0}\x{BA}.]\s*|number\s*)?#?\s?(\d{1,2}))";
constexpr const char* part_words =
    R"((?i:parts?|answers?|ans|items?|steps?|sections?|solution|results?|output|nr|no|number|teil(?:aufgabe)?|antwort|l(?:[\x{D6}\x{F6}\x{FFFD}]|oe)sung|ergebnis|punkt|apartado|respuesta|r(?:[\x{C9}\x{E9}\x{FFFD}]|e)ponse|risposta|resposta))";
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

}  // namespace harness
