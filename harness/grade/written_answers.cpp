#include "harness/grade/written_answers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "harness/mark/score/doubts_text.h"
#include "harness/source/code/cpp_lexer.h"

namespace harness {
namespace {

constexpr std::string_view of_numbers = "0123456789.";

/// The numbers in a text, without their signs, as views into the text.
std::vector<std::string_view> numbers_in(std::string_view text) {
    std::vector<std::string_view> numbers;
    for (std::size_t at = text.find_first_of(of_numbers); at != std::string_view::npos;) {
        const std::size_t end = std::min(text.find_first_not_of(of_numbers, at), text.size());
        numbers.push_back(text.substr(at, end - at));
        at = text.find_first_of(of_numbers, end);
    }
    return numbers;
}

/// The number without redundant zeros, so that 0.5857860 and 0.585786 are equal.
std::string plain_number(std::string_view number) {
    std::string text(number);
    if (text.find('.') != std::string::npos) {
        while (text.back() == '0') text.pop_back();
        if (text.back() == '.') text.pop_back();
    }
    while (text.size() > 1 && text.front() == '0' && text[1] != '.') text.erase(0, 1);
    return text;
}

bool is_telling(const std::string& number) {
    constexpr std::size_t fewest = 4;
    const std::size_t first = number.find_first_of("123456789");
    if (number.find('.') == std::string::npos || first == std::string::npos) return false;
    return number.size() - first - (number.find('.') > first ? 1 : 0) >= fewest;
}

/// The places of a source in which numbers count.
enum class Place { anywhere, where_printed };

/// The numbers in the source's strings and literals that are long enough to count, each with the first line that has
/// it.
std::map<std::string, std::size_t> numbers_of(std::string_view source, Place place) {
    std::map<std::string, std::size_t> lines;
    std::size_t line = 1;
    std::string_view before;  // the last token that is neither blank nor comment
    for (const source::Token& token : source::lex_cpp(source)) {
        const std::string_view text = source.substr(token.begin, token.end - token.begin);
        const bool is_printed = place == Place::anywhere || before == "<<";
        if (token.kind == source::TokenKind::text || (token.kind == source::TokenKind::number && is_printed)) {
            for (const std::string_view number : numbers_in(text)) {
                const std::string known = plain_number(number);
                if (is_telling(known)) lines.try_emplace(known, line);
            }
        }
        line += static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
        const bool is_code = token.kind != source::TokenKind::blank && token.kind != source::TokenKind::line_end &&
                             token.kind != source::TokenKind::comment;
        if (is_code && text != "-") before = text;
    }
    return lines;
}

/// Removes the scene's own numbers.
void leave_out_scene(std::map<std::string, std::size_t>& lines, const source::DecimalScene& scene) {
    for (const source::ScenePart part : source::all_parts()) {
        if (!source::has_part(scene, part)) continue;
        for (const double number : source::value_of(scene, part))
            lines.erase(plain_number(fmt::format("{}", std::abs(number))));
    }
}

/// The answers that have a number in `lines`.
std::vector<WrittenAnswer> answers_in(const std::map<std::string, std::size_t>& lines, const Score& score,
                                      bool only_right) {
    std::vector<WrittenAnswer> written;
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) {
            if (only_right && item.verdict != ItemVerdict::right) continue;
            for (const std::string_view number : numbers_in(item.printed)) {
                const auto found = lines.find(plain_number(number));
                if (found == lines.end()) continue;
                written.push_back({question.number, std::string(item.spec.name), std::string(number), found->second});
                break;
            }
        }
    }
    return written;
}

}  // namespace

std::vector<WrittenAnswer> written_answers(std::string_view source, const Score& score,
                                           const source::DecimalScene& scene) {
    std::map<std::string, std::size_t> lines = numbers_of(source, Place::anywhere);
    leave_out_scene(lines, scene);
    return answers_in(lines, score, /*only_right=*/true);
}

std::vector<WrittenAnswer> printed_constants(std::string_view source, const Score& score,
                                             const source::DecimalScene& scene) {
    std::map<std::string, std::size_t> lines = numbers_of(source, Place::where_printed);
    leave_out_scene(lines, scene);
    return answers_in(lines, score, /*only_right=*/false);
}

std::string written_evidence(const std::vector<WrittenAnswer>& written) {
    std::vector<std::string> places;
    for (const WrittenAnswer& answer : written)
        places.push_back(fmt::format("question {}, {} = {} (line {})", answer.question, name_in_words(answer.item),
                                     answer.number, answer.line));
    return fmt::format("These answers are typed into the source: {}.", fmt::join(places, "; "));
}

}  // namespace harness
