#include "harness/review/source_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "harness/report/text/read_lines.h"
#include "harness/source/code/printed_texts.h"
#include "harness/source/code/source_names.h"
#include "harness/text/utf8.h"

namespace harness::review {
namespace {

using source::PrintedText;

constexpr std::size_t most_lines = 5000;
constexpr std::size_t most_bytes_of_source = 64 << 10U;
constexpr std::size_t most_bytes_of_line = 2000;
constexpr std::size_t most_variables =
    12;  ///< of one item; a matrix may be printed by its sixteen numbers, named alike

bool is_letter(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Whether the line contains the text as whole words.
bool stands_in(std::string_view text, std::string_view line) {
    for (std::size_t at = line.find(text); at != std::string_view::npos; at = line.find(text, at + 1)) {
        const std::size_t end = at + text.size();
        const bool begins = at == 0 || !is_letter(line[at - 1]) || !is_letter(text.front());
        const bool ends = end == line.size() || !is_letter(line[end]) || !is_letter(text.back());
        if (begins && ends) return true;
    }
    return false;
}

/// Finds the lines of one source that print a text.
class Source {
  public:
    explicit Source(std::string_view source)
        : words_(source::words_of(source)),
          texts_(source::printed_texts(words_)),
          settings_(source::SourceNames(words_).settings()) {
        std::size_t begin = 0;
        int line = 1;
        for (const source::Word& word : words_) {
            line += static_cast<int>(std::count(source.begin() + static_cast<std::ptrdiff_t>(begin),
                                                source.begin() + static_cast<std::ptrdiff_t>(word.begin), '\n'));
            begin = word.begin;
            lines_.push_back(line);
        }
    }

    /// The longest texts in this part of an output's line.
    std::vector<const PrintedText*> texts_in(std::string_view printed) const {
        std::vector<const PrintedText*> found;
        for (const PrintedText& printed_text : texts_) {
            const std::size_t longest = found.empty() ? 0 : found.front()->text.size();
            if (printed_text.text.size() < longest || !stands_in(printed_text.text, printed)) continue;
            if (printed_text.text.size() > longest) found.clear();
            found.push_back(&printed_text);
        }
        return found;
    }

    int line_of(std::size_t word) const { return lines_[word]; }
    /// The lines that set a variable of this name.
    std::set<int> lines_setting(const std::string& variable) const {
        std::set<int> lines;
        if (const auto found = settings_.find(variable); found != settings_.end()) {
            for (const std::size_t word : found->second) lines.insert(line_of(word));
        }
        return lines;
    }

  private:
    std::vector<source::Word> words_;
    std::vector<PrintedText> texts_;
    std::map<std::string, std::vector<std::size_t>, std::less<>> settings_;
    std::vector<int> lines_;  ///< of the words, from 1
};

std::string_view line_at(const std::vector<std::string_view>& lines, int number) {
    return beginning_of_characters(lines[static_cast<std::size_t>(number) - 1], most_bytes_of_line);
}

bool is_blank(std::string_view line) {
    return line.find_first_not_of(" \t") == std::string_view::npos;
}

/// The items that were read from the first `lines` lines.
std::vector<const ItemScore*> in_order_of_printing(const Score& score, std::size_t lines) {
    std::vector<const ItemScore*> items;
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) {
            if (item.line >= 1 && static_cast<std::size_t>(item.line) <= lines) items.push_back(&item);
        }
    }
    std::ranges::stable_sort(items, {}, &ItemScore::line);
    return items;
}

/// The first of the texts after this place in the source; null if there is none.
const PrintedText* first_behind(std::size_t place, const std::vector<const PrintedText*>& texts) {
    const PrintedText* first = nullptr;
    for (const PrintedText* printed_text : texts) {
        if (printed_text->at > place && (first == nullptr || printed_text->at < first->at)) first = printed_text;
    }
    return first;
}

/// The texts before the item: in its line between the previous answer and itself, else anywhere in its line, else in
/// the line above, unless that line has an answer too.
std::vector<const PrintedText*> texts_of(const ItemScore& item, std::size_t from, const Source& source,
                                         const std::vector<std::string_view>& lines,
                                         const std::map<int, std::vector<report::ReadAnswer>>& answers) {
    const std::string_view line = line_at(lines, item.line);
    const std::size_t value = line.find(item.printed, from);
    if (value != std::string_view::npos) {
        auto found = source.texts_in(line.substr(from, value - from));
        if (!found.empty()) return found;
    }
    auto found = source.texts_in(line);
    if (!found.empty()) return found;
    int above = item.line - 1;
    while (above > 0 && is_blank(line_at(lines, above))) --above;
    return above > 0 && !answers.contains(above) ? source.texts_in(line_at(lines, above)) : found;
}

/// The notes of one item.
class ItemNotes {
  public:
    ItemNotes(Computing& computing, const Source& source, const ItemScore& item)
        : computing_(computing),
          source_(source),
          item_(fmt::format("{}.{}", item.spec.question, item.spec.name)),
          kind_(to_string(item.verdict)) {}

    /// `likeliest` is the line that printed the item if several lines have its text; 0 if it is unknown.
    void add(const std::vector<const PrintedText*>& texts, int likeliest) {
        std::set<int> lines;
        for (const PrintedText* text : texts) lines.insert(source_.line_of(text->at));
        if (lines.empty()) return;
        const bool is_sure = lines.size() == 1;
        computing_.first_printing[item_] = likeliest == 0 ? *lines.begin() : likeliest;
        for (const PrintedText* text : texts) {
            is_framed_ = likeliest == 0 || source_.line_of(text->at) == likeliest;
            note(source_.line_of(text->at), (is_sure ? "prints " : "may print ") + report::shown_item(item_));
            const std::size_t count = std::min(text->variables.size(), most_variables);
            for (std::size_t i = 0; i < count; ++i) {
                const std::string& variable = text->variables[i];
                for (const int line : source_.lines_setting(variable))
                    note(line, fmt::format("sets {}, {} {}", variable, is_sure ? "printed as" : "may be printed as",
                                           report::shown_item(item_)));
            }
        }
    }

  private:
    void note(int number, std::string text) {
        if (is_framed_) computing_.lines[item_].insert(number);
        std::vector<report::LineNote>& line = computing_.notes[number];
        const bool is_known = std::any_of(line.begin(), line.end(),
                                          [&](const report::LineNote& line_note) { return line_note.text == text; });
        if (!is_known) line.push_back({std::move(text), kind_});
    }

    Computing& computing_;
    const Source& source_;
    std::string item_;
    std::string kind_;
    bool is_framed_ = true;
};

}  // namespace

Computing computing_lines(std::string_view text, std::string_view printout, const Score& score) {
    const Source source(beginning_of_characters(text, most_bytes_of_source));
    const std::vector<std::string_view> lines = report::printout_lines(printout, most_lines);
    const auto answers = report::answers_by_line(score);
    std::map<int, std::size_t> read_up_to;  // by line: the end of the previous answer
    std::size_t printed_by = 0;             // the place in the source that printed the previous answer
    Computing computing;
    for (const ItemScore* item : in_order_of_printing(score, lines.size())) {
        std::size_t& from = read_up_to[item->line];
        const auto texts = texts_of(*item, from, source, lines, answers);
        int above = item->line - 1;
        while (above > 0 && (answers.contains(above) || is_blank(line_at(lines, above)))) --above;
        const auto heading = above > 0 ? source.texts_in(line_at(lines, above)) : std::vector<const PrintedText*>();
        if (heading.size() == 1) printed_by = std::max(printed_by, heading.front()->at);
        const PrintedText* next = first_behind(printed_by, texts);
        ItemNotes(computing, source, *item).add(texts, next == nullptr ? 0 : source.line_of(next->at));
        if (next != nullptr) printed_by = next->at;
        const std::size_t value = lines[static_cast<std::size_t>(item->line) - 1].find(item->printed, from);
        if (value != std::string_view::npos) from = value + item->printed.size();
    }
    return computing;
}

}  // namespace harness::review
