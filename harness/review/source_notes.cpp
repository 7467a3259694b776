#include "harness/review/source_notes.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "harness/report/text/read_lines.h"
#include "harness/text/lines.h"
#include "harness/text/utf8.h"

namespace harness::review {
namespace {

constexpr std::size_t most_lines = 5000;
constexpr std::size_t widest = 400;
constexpr std::size_t shortest_literal = 2;

std::string trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\n");
    if (first == std::string_view::npos) return {};
    return std::string(text.substr(first, text.find_last_not_of(" \t\n") - first + 1));
}

/// The pieces of a line's string literals between escapes such as \n, without blanks around them.
std::vector<std::string> literals_of(std::string_view line) {
    std::vector<std::string> literals;
    std::string literal;
    bool inside = false;
    const auto end_piece = [&] {
        literal = trimmed(literal);
        const bool has_letter = std::any_of(literal.begin(), literal.end(),
                                            [](unsigned char c) { return std::isalpha(c) != 0 || c >= 0x80; });
        if (literal.size() >= shortest_literal && has_letter) literals.push_back(literal);
        literal.clear();
    };
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (!inside) {
            if (line.substr(i).starts_with("//")) break;
            inside = c == '"';
        } else if (c == '"' || c == '%') {
            end_piece();
            // A conversion of printf ends a piece; what follows its '%' is no text.
            while (c == '%' && i + 1 < line.size() &&
                   std::string_view(".0123456789+-lf").find(line[i + 1]) != std::string_view::npos)
                ++i;
            inside = c == '%';
        } else if (c == '\\' && i + 1 < line.size()) {
            end_piece();
            ++i;
        } else {
            literal += c;
        }
    }
    return literals;
}

struct Literal {
    std::string text;
    int line;  ///< from 1
};

std::vector<Literal> literals_in(std::string_view source) {
    std::vector<Literal> literals;
    int number = 0;
    for (const std::string_view line : lines_of(source, most_lines)) {
        ++number;
        for (std::string& literal : literals_of(beginning_of_characters(line, widest)))
            literals.push_back({std::move(literal), number});
    }
    return literals;
}

/// The lines of the longest literals that stand in the line of the printout.
std::set<int> lines_that_print(std::string_view printed, const std::vector<Literal>& literals) {
    std::size_t longest = 0;
    std::set<int> lines;
    for (const Literal& literal : literals) {
        if (literal.text.size() < longest || printed.find(literal.text) == std::string_view::npos) continue;
        if (literal.text.size() > longest) lines.clear();
        longest = literal.text.size();
        lines.insert(literal.line);
    }
    return lines;
}

}  // namespace

report::LineNotes printing_lines(std::string_view source, std::string_view printout, const Score& score) {
    report::LineNotes notes;
    const std::vector<Literal> literals = literals_in(source);
    const std::vector<std::string_view> lines = report::printout_lines(printout, most_lines);
    for (const auto& [number, answers] : report::answers_by_line(score)) {
        if (number < 1 || static_cast<std::size_t>(number) > lines.size()) continue;
        const std::set<int> printing = lines_that_print(lines[static_cast<std::size_t>(number) - 1], literals);
        for (const report::ReadAnswer& answer : answers) {
            if (!answer.begins) continue;
            const std::string prints = printing.size() == 1 ? "prints " : "may print ";
            for (const int line : printing)
                notes[line].push_back({prints + answer.item, std::string(to_string(answer.verdict))});
        }
    }
    return notes;
}

}  // namespace harness::review
