#include "harness/experiment/identify/slots.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "harness/read/tokens/token.h"

namespace harness::experiment {
namespace {

/// More numbers come from an endless loop.
constexpr std::size_t most_numbers = 4000;

constexpr std::size_t no_line = static_cast<std::size_t>(-1);

/// A line with its numbers.
struct Line {
    PrintedLine printed;
    int question;
    std::vector<NumberOfLine> numbers;
    std::string layout;  ///< the text with '#' for each number, without blanks and signs, which change with numbers
};

/// The words and signs of a line, which do not change with its numbers.
std::string layout_of(const std::string& text) {
    std::string layout;
    for (std::size_t i = 0; i < text.size();) {
        const char c = text[i];
        if (is_digit(c)) {
            while (i < text.size() && (is_digit(text[i]) || text[i] == '.')) ++i;
            const bool has_exponent = i + 1 < text.size() && (text[i] == 'e' || text[i] == 'E') &&
                                      (is_digit(text[i + 1]) || text[i + 1] == '-' || text[i + 1] == '+');
            if (has_exponent) ++i;
            while (has_exponent && i < text.size() && (is_digit(text[i]) || text[i] == '-' || text[i] == '+')) ++i;
            layout += '#';
            continue;
        }
        if (c != ' ' && c != '\t' && c != '-' && c != '+') layout += c;
        ++i;
    }
    return layout;
}

std::vector<Line> lines_of(const Transcript& transcript) {
    std::vector<Line> lines;
    std::size_t count = 0;
    for (const Section& section : transcript.sections) {
        for (const PrintedLine& line : section.lines) {
            lines.push_back({line, section.question, line.numbers, layout_of(line.text)});
            count += lines.back().numbers.size();
            if (count > most_numbers) return {};
        }
    }
    return lines;
}

/// For each line, its partner in the other output; no_line if it has none.
class Pairing {
  public:
    Pairing(std::span<const Line> own, std::span<const Line> other)
        : own_(own), other_(other), partner_(own.size(), no_line) {}

    std::vector<std::size_t> run() {
        std::size_t begin = 0, end = 0;
        const std::size_t shorter = std::min(own_.size(), other_.size());
        while (begin < shorter && is_alike(begin, begin)) pair(begin, begin), ++begin;
        while (end < shorter - begin && is_alike(own_.size() - 1 - end, other_.size() - 1 - end)) {
            pair(own_.size() - 1 - end, other_.size() - 1 - end);
            ++end;
        }
        pair_between(begin, own_.size() - end, begin, other_.size() - end);
        return std::move(partner_);
    }

  private:
    bool is_alike(std::size_t i, std::size_t k) const { return own_[i].layout == other_[k].layout; }
    void pair(std::size_t i, std::size_t k) { partner_[i] = k; }

    /// Pairs as many similar lines as possible, in order; then the lines between them if their counts agree.
    void pair_between(std::size_t own_begin, std::size_t own_end, std::size_t other_begin, std::size_t other_end) {
        const std::size_t rows = own_end - own_begin, columns = other_end - other_begin;
        constexpr std::size_t most = 400;
        if (rows == columns && (rows > most || !has_like_line(own_begin, own_end, other_begin))) {
            for (std::size_t i = 0; i < rows; ++i) pair(own_begin + i, other_begin + i);
            return;
        }
        if (rows > most || columns > most || rows == 0 || columns == 0) return;
        // longest[i][k]: the most pairs of lines from i and k on
        std::vector<std::vector<int>> longest(rows + 1, std::vector<int>(columns + 1, 0));
        for (std::size_t i = rows; i-- > 0;) {
            for (std::size_t k = columns; k-- > 0;) {
                longest[i][k] = is_alike(own_begin + i, other_begin + k)
                                    ? longest[i + 1][k + 1] + 1
                                    : std::max(longest[i + 1][k], longest[i][k + 1]);
            }
        }
        std::size_t i = 0, k = 0, gap_own = 0, gap_other = 0;
        const auto close_gap = [&] {
            if (i - gap_own != k - gap_other) return;
            for (std::size_t n = 0; n < i - gap_own; ++n) pair(own_begin + gap_own + n, other_begin + gap_other + n);
        };
        while (i < rows && k < columns) {
            if (is_alike(own_begin + i, other_begin + k)) {
                close_gap();
                pair(own_begin + i++, other_begin + k++);
                gap_own = i;
                gap_other = k;
            } else if (longest[i + 1][k] >= longest[i][k + 1]) {
                ++i;
            } else {
                ++k;
            }
        }
        i = rows;
        k = columns;
        close_gap();
    }

    /// Whether one of the lines in the same place is similar.
    bool has_like_line(std::size_t own_begin, std::size_t own_end, std::size_t other_begin) const {
        for (std::size_t i = own_begin; i < own_end; ++i) {
            if (is_alike(i, other_begin + (i - own_begin))) return true;
        }
        return false;
    }

    std::span<const Line> own_, other_;
    std::vector<std::size_t> partner_;
};

}  // namespace

bool Slot::moves() const {
    const NumberOfLine& first = numbers.size() > 1 ? numbers.front() : own;
    return std::ranges::any_of(numbers, [&](const NumberOfLine& on_scene) {
        return on_scene.number.value != first.number.value && !std::isnan(on_scene.number.value);
    });
}

std::optional<Slots> slots_of(const Transcript& own, std::span<const Transcript* const> others) {
    const std::vector<Line> lines = lines_of(own);
    std::vector<std::vector<Line>> other_lines;
    std::vector<std::vector<std::size_t>> partners;
    for (const Transcript* other : others) {
        other_lines.push_back(lines_of(*other));
        partners.push_back(Pairing(lines, other_lines.back()).run());
    }
    Slots slots;
    std::size_t total = 0;
    NumberPlace place;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const Line& line = lines[i];
        LineOnScenes on_scenes{line.question, line.printed, {}, false};
        bool is_paired = true, has_numbers = true, is_alike = true;
        for (std::size_t s = 0; s < others.size(); ++s) {
            is_paired = is_paired && partners[s][i] != no_line;
            if (!is_paired) break;
            const Line& partner = other_lines[s][partners[s][i]];
            on_scenes.lines.push_back(partner.printed);
            const Line& first = other_lines[0][partners[0][i]];
            on_scenes.words_change = on_scenes.words_change || partner.layout != first.layout;
            has_numbers = has_numbers && partner.numbers.size() == line.numbers.size();
            is_alike = is_alike && partner.layout == line.layout;
        }
        if (place.line != line.printed.number) place = {line.printed.number, 0};
        for (std::size_t n = 0; n < line.numbers.size(); ++n) {
            ++total;
            ++place.number;
            if (!is_paired || !has_numbers) continue;
            const std::size_t label = n == 0 ? 0 : line.numbers[n - 1].end;
            Slot slot{place, line.question, line.numbers[n], {}, {}, line.layout};
            slot.label = line.printed.text.substr(label, line.numbers[n].begin - label);
            for (std::size_t s = 0; s < others.size(); ++s)
                slot.numbers.push_back(other_lines[s][partners[s][i]].numbers[n]);
            slots.numbers.push_back(std::move(slot));
        }
        if (!(is_paired && is_alike) && !line.layout.empty()) slots.differing.insert(line.question);
        if (is_paired) slots.lines.push_back(std::move(on_scenes));
    }
    constexpr double least_share = 0.85;
    const double share = static_cast<double>(slots.numbers.size());
    if (total == 0 || share < least_share * static_cast<double>(total)) return std::nullopt;
    return slots;
}

}  // namespace harness::experiment
