#include "harness/mark/score/listed_numbers.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "harness/match/question_match.h"

namespace harness {
namespace {

/// More numbers in the output, or below one heading, come from an endless loop.
constexpr std::size_t most_numbers = 8000, most_in_section = 2000;

/// Values that the output says are not answers: at most this many are examined.
constexpr std::size_t most_asides = 500;

bool same(const PrintedNumber& a, const PrintedNumber& b) {
    return std::abs(a.value) == std::abs(b.value) || (std::isnan(a.value) && std::isnan(b.value));
}

/// Whether the item's value contains this number.
bool has_number(const MatchedItem& item, const ListedNumber& found) {
    return item.value && std::any_of(item.value->numbers.begin(), item.value->numbers.end(),
                                     [&](const PrintedNumber& x) { return same(x, found.number); });
}

}  // namespace

MarkedPrintout::MarkedPrintout(const Transcript& printed, const std::vector<MatchedItem>& read,
                               const reference::AnswerKey& right, const reference::Rubric& points, const Score& marked)
    : transcript(printed), matched(read), key(right), rubric(points), score(marked) {
    for (const Section& section : transcript.sections) headings.insert(section.question);
}

ItemVerdict MarkedPrintout::verdict_of(const reference::ItemId& id) const {
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) {
            if (item.spec.id == id) return item.verdict;
        }
    }
    return ItemVerdict::missing;
}

const reference::KeyItem& MarkedPrintout::key_item(const reference::ItemSpec& spec) const {
    const reference::KeyItem* item = reference::asked_item(key, spec.id);
    return item == nullptr ? key.questions.front().items.front() : *item;
}

const MatchedItem* MarkedPrintout::matched_to(const reference::ItemId& id) const {
    const auto own = std::ranges::find_if(matched, [&](const MatchedItem& item) { return item.spec.id == id; });
    return own == matched.end() ? nullptr : &*own;
}

bool was_read_from(const MatchedItem& item, const ListedNumber& found) {
    return !item.unreadable && item.value && std::ranges::any_of(item.value->numbers, [&](const PrintedNumber& number) {
        return number.line == found.line && number.index == found.number.index;
    });
}

bool names(const MatchedItem& item, const reference::ItemSpec& other) {
    return item.value && !item.unreadable && fit_label(item.value->label, item.value->above, other) >= LabelFit::named;
}

ListedNumbers::ListedNumbers(const MarkedPrintout& printout) {
    list(printout.transcript);
    account_for_answers(printout);
    account_for_asides(printout);
}

void ListedNumbers::list(const Transcript& transcript) {
    for (const Section& section : transcript.sections) {
        const std::size_t first = numbers_.size();
        for (const PrintedLine& line : section.lines) {
            if (numbers_.size() >= most_numbers) return;
            if (numbers_.size() - first >= most_in_section) break;
            const auto is_letters = [](char a, char b) { return is_letter(a) && is_letter(b); };
            if (std::ranges::adjacent_find(line.text, is_letters) != line.text.end()) sentences_.insert(line.number);
            for (const NumberOfLine& number : line.numbers) {
                numbers_.push_back({number.number, section.question, line.number});
                numbers_.back().has_loose_sign = number.minus == MinusBefore::glued;
                if (number.is_behind_equals) equations_.insert(line.number);
            }
        }
    }
}

void ListedNumbers::account_for_answers(const MarkedPrintout& printout) {
    for (const MatchedItem& item : printout.matched) {
        if (!item.value) continue;
        for (ListedNumber& found : numbers_) {
            if (has_number(item, found) && !std::isnan(found.number.value)) answered_.push_back(found.number.value);
            if (!was_read_from(item, found)) continue;
            found.in_answer = true;
            const ItemVerdict verdict = printout.verdict_of(item.spec.id);
            found.in_right_answer = found.in_right_answer || verdict == ItemVerdict::right;
            const bool is_sure = verdict == ItemVerdict::right || verdict == ItemVerdict::follow;
            found.is_scalar = found.is_scalar || (is_sure && item.spec.shape == reference::Shape::scalar);
            if (names(item, item.spec)) found.named = &item;
        }
    }
}

/// Accounts for repeated answers, values that the output says are not answers, and whole numbers in sentences.
void ListedNumbers::account_for_asides(const MarkedPrintout& printout) {
    std::sort(answered_.begin(), answered_.end());
    std::set<std::pair<int, int>> asides;  // first and last lines
    std::set<int> with_values;
    std::size_t seen = 0;
    for (const Section& section : printout.transcript.sections) {
        for (const PrintedValue& value : section.values) {
            if (++seen > most_numbers) break;
            for (int line = value.line; line <= value.last_line; ++line) with_values.insert(line);
            const auto& items = printout.key.questions.front().items;
            if (asides.size() < most_asides &&
                fit_label(value.label, value.above, items.front().spec) == LabelFit::forbidden)
                asides.insert({value.line, value.last_line});
        }
    }
    for (ListedNumber& found : numbers_) {
        found.repeats = std::binary_search(answered_.begin(), answered_.end(), found.number.value);
        const bool counts = found.number.decimals == 0 && sentences_.contains(found.line) &&
                            !with_values.contains(found.line) && !equations_.contains(found.line);
        const bool aside = std::any_of(asides.begin(), asides.end(), [&](const auto& lines) {
            return lines.first <= found.line && found.line <= lines.second;
        });
        found.is_aside = counts || aside;
    }
}

bool ListedNumbers::is_one_value(std::size_t first, std::size_t size, std::size_t stride) const {
    const std::size_t last = first + (size - 1) * stride;
    if (numbers_[first].line == numbers_[last].line) return true;
    if (stride == 1) return begins_line(first) && ends_line(last);
    std::size_t row = first;
    while (!begins_line(row)) --row;
    for (std::size_t i = row; i < row + size * stride; ++i) {
        const bool is_start = (i - row) % stride == 0, is_end = (i - row) % stride == stride - 1;
        if (i >= numbers_.size() || begins_line(i) != is_start || ends_line(i) != is_end) return false;
    }
    return true;
}

}  // namespace harness
