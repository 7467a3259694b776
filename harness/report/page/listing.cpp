#include "harness/report/page/listing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <iterator>

#include "harness/report/text/read_lines.h"
#include "harness/report/text/verdict_words.h"
#include "harness/text/lines.h"
#include "harness/text/markup.h"
#include "harness/text/utf8.h"

namespace harness::report {
namespace {

constexpr std::size_t longest_line = 500;

/// The lines of a source as a compiler counts them, without their ends.
std::vector<std::string_view> source_lines(std::string_view source, std::size_t most) {
    std::vector<std::string_view> lines = lines_of(source, most);
    for (std::string_view& line : lines) {
        if (line.ends_with('\r')) line.remove_suffix(1);
    }
    return lines;
}

/// The worst note decides the color of a line.
int badness(std::string_view kind) {
    constexpr std::string_view ascending[] = {"right", "follow", "warning", "missing", "unreadable", "wrong", "error"};
    return static_cast<int>(std::find(std::begin(ascending), std::end(ascending), kind) - std::begin(ascending));
}

std::string worst_kind(const std::vector<LineNote>& notes) {
    return std::max_element(notes.begin(), notes.end(),
                            [](const LineNote& a, const LineNote& b) { return badness(a.kind) < badness(b.kind); })
        ->kind;
}

std::string line_html(std::string_view line, int number, const std::vector<LineNote>* notes, const std::string& id) {
    std::string html = fmt::format("<span id=\"{}\"", id);
    if (notes != nullptr) html += fmt::format(" class=\"{}\"", worst_kind(*notes));
    html += fmt::format("><i>{}</i>{}", number, escape_markup(beginning_of_characters(line, longest_line)));
    if (line.size() > longest_line) html += "…";
    for (std::size_t i = 0; notes != nullptr && i < notes->size(); ++i) {
        const LineNote& note = (*notes)[i];
        if (!note.text.empty())
            html += fmt::format(" <span class=\"verdict {}\">{}</span>", note.kind, escape_markup(note.text));
    }
    return html + "\n</span>";
}

/// "line 12" or "Line 12" in a sentence.
struct NamedLine {
    int line;
    std::size_t begin, end;  ///< in the sentence
};

std::vector<NamedLine> named_lines(std::string_view sentence) {
    constexpr std::string_view word = "line ";
    std::vector<NamedLine> named;
    for (std::size_t at = 0; at + word.size() < sentence.size(); ++at) {
        const bool begins_a_word = at == 0 || std::isalnum(static_cast<unsigned char>(sentence[at - 1])) == 0;
        const bool is_line =
            (sentence[at] == 'L' || sentence[at] == 'l') && sentence.substr(at + 1).starts_with(word.substr(1));
        if (!begins_a_word || !is_line) continue;
        const std::string_view digits = sentence.substr(at + word.size());
        int line = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), line);
        if (error == std::errc())
            named.push_back({line, at, at + word.size() + static_cast<std::size_t>(end - digits.data())});
    }
    return named;
}

}  // namespace

std::vector<int> lines_named(std::string_view sentence) {
    std::vector<int> lines;
    for (const NamedLine& named : named_lines(sentence)) lines.push_back(named.line);
    return lines;
}

std::string source_line(std::string_view source, int line) {
    if (line < 1) return "";
    const auto lines = source_lines(source, static_cast<std::size_t>(line));
    if (lines.size() < static_cast<std::size_t>(line)) return "";
    std::string_view text = lines.back();
    const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
    text = text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
    return std::string(beginning_of_characters(text, longest_line));
}

LineNotes notes_of_answers(const Score& score) {
    LineNotes notes;
    for (const auto& [line, answers] : answers_by_line(score)) {
        for (const ReadAnswer& answer : answers) {
            const std::string shown = fmt::format("{} {}", shown_item(answer.item), word_of(answer.verdict));
            notes[line].push_back({answer.begins ? shown : "", std::string(to_string(answer.verdict))});
        }
    }
    return notes;
}

LineNotes notes_of_compiler(const std::vector<CompilerMessage>& messages) {
    LineNotes notes;
    for (const CompilerMessage& message : messages) notes[message.line].push_back({message.text, message.kind});
    return notes;
}

bool is_printout_too_long(const Graded& graded) {
    if (!graded.execution.printout.empty()) return false;
    if (!graded.execution.printout_beginning.empty()) return true;
    if (graded.execution.outcome == Outcome::output_limit) return true;
    const auto& questions = graded.score.questions;
    return std::any_of(questions.begin(), questions.end(), [](const QuestionScore& question) {
        return std::any_of(question.items.begin(), question.items.end(),
                           [](const ItemScore& item) { return item.line != 0; });
    });
}

Listing Listing::of_printout(std::string_view text, const LineNotes& notes, const std::string& prefix,
                             const ListingBounds& bounds) {
    const auto lines = printout_lines(text, bounds.lines + 1);
    return {lines, lines.size() <= bounds.lines, notes, prefix, bounds};
}

Listing Listing::of_source(std::string_view text, const LineNotes& notes, const std::string& prefix,
                           const ListingBounds& bounds) {
    const auto lines = source_lines(text, bounds.lines + 1);
    return {lines, lines.size() <= bounds.lines, notes, prefix, bounds};
}

Listing::Listing(const std::vector<std::string_view>& lines, bool is_whole, const LineNotes& notes,
                 const std::string& prefix, const ListingBounds& bounds)
    : prefix_(prefix) {
    std::size_t bytes = 0;
    for (const std::string_view line : lines) {
        bytes += std::min(line.size(), longest_line) + 1;
        if (bytes > bounds.bytes) is_whole = false;
        if (bytes > bounds.bytes || static_cast<std::size_t>(last_line_) == bounds.lines) break;
        const auto found = notes.find(++last_line_);
        const bool has_notes = found != notes.end() && !found->second.empty();
        html_ += line_html(line, last_line_, has_notes ? &found->second : nullptr, prefix + std::to_string(last_line_));
    }
    if (is_whole || lines.empty()) return;
    cut_ = last_line_ == 0 ? "Left out because the page would be too long."
                           : fmt::format("Cut after line {}.", last_line_);
}

std::string Listing::html(std::string_view label) const {
    std::string html;
    if (!html_.empty()) {
        html = fmt::format("<pre class=\"listing\" tabindex=\"0\" role=\"region\" aria-label=\"{}\">{}</pre>\n",
                           escape_markup(label), html_);
    }
    if (!cut_.empty()) html += fmt::format("<p class=\"facts\">{}</p>\n", cut_);
    return html;
}

bool Listing::has_anchor(int line) const {
    return line >= 1 && line <= last_line_;
}

std::string Listing::address_of(int line) const {
    return fmt::format("#{}{}", prefix_, line);
}

std::string Listing::with_links(std::string_view sentence) const {
    std::string html;
    std::size_t done = 0;
    for (const NamedLine& named : named_lines(sentence)) {
        html += escape_markup(sentence.substr(done, named.begin - done));
        const std::string text = escape_markup(sentence.substr(named.begin, named.end - named.begin));
        html += has_anchor(named.line) ? fmt::format("<a href=\"{}\">{}</a>", address_of(named.line), text) : text;
        done = named.end;
    }
    return html + escape_markup(sentence.substr(done));
}

}  // namespace harness::report
