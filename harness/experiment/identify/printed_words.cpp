#include "harness/experiment/identify/printed_words.h"

#include <algorithm>
#include <string>

namespace harness::experiment {
namespace {

using reference::ItemSpec;

/// Where the words at the beginning of a line end.
std::size_t begin_of_numbers(std::string_view line) {
    const std::size_t digit = std::min(line.find_first_of("0123456789"), line.size());
    return digit > 0 && (line[digit - 1] == '-' || line[digit - 1] == '+') ? digit - 1 : digit;
}

bool has_sign_apart(const Slot& slot) {
    const auto is_apart = [](const NumberOfLine& number) { return number.minus == MinusBefore::apart; };
    return is_apart(slot.own) || std::ranges::any_of(slot.numbers, is_apart);
}

}  // namespace

PrintedWords::PrintedWords(const Transcript& transcript, const std::vector<MatchedItem>& matched, const Slots& slots,
                           std::span<const ItemSpec> items)
    : matched_(matched), slots_(slots), items_(items), fits_(items), values_(slots.numbers.size(), nullptr) {
    for (const Section& section : transcript.sections) {
        headings_.insert(section.question);
        for (const PrintedValue& value : section.values) {
            for (const std::size_t slot : slots_of(value)) values_[slot] = &value;
        }
    }
}

const MatchedItem* PrintedWords::value_of(const reference::ItemId& id) const {
    const auto found = std::ranges::find_if(matched_, [&](const MatchedItem& item) { return item.spec.id == id; });
    return found == matched_.end() || !found->value || found->unreadable ? nullptr : &*found;
}

std::vector<std::size_t> PrintedWords::slots_of(const PrintedValue& value) const {
    const std::vector<Slot>& all = slots_.numbers;
    std::vector<std::size_t> found;
    auto slot = std::ranges::lower_bound(all, value.line, {}, [](const Slot& s) { return s.place.line; });
    for (const PrintedNumber& number : value.numbers) {
        const auto is_past = [&] { return slot == all.end() || slot->place.line > value.last_line; };
        while (!is_past() && slot->own.number.value != number.value) ++slot;
        if (is_past()) return {};
        found.push_back(static_cast<std::size_t>(slot - all.begin()));
        ++slot;
    }
    return found;
}

LabelFit PrintedWords::fit(std::size_t slot, const ItemSpec& item) {
    return values_[slot] == nullptr ? LabelFit::none : fits_(*values_[slot], item);
}

bool PrintedWords::is_no_answer(std::size_t slot, const ItemSpec& item) {
    const int line = slots_.numbers[slot].place.line;
    const auto [known, is_new] = no_answer_.try_emplace(line, false);
    for (const LineOnScenes& on_scenes : slots_.lines) {
        if (is_new && on_scenes.own.number == line) known->second = known->second || says_no_answer(on_scenes.own.text);
    }
    // The rows of a matrix have labels of their own: "B" is no corner of the triangle.
    const PrintedValue* value = side_of(item.shape) > 1 ? nullptr : values_[slot];
    return known->second || (value != nullptr && (says_no_answer(value->label) || says_no_answer(value->above)));
}

bool PrintedWords::is_barred(std::size_t slot, const ItemSpec& item) {
    if (is_no_answer(slot, item)) return true;
    if (side_of(item.shape) > 1 || values_[slot] == nullptr || fit(slot, item) == LabelFit::exact) return false;
    return std::ranges::any_of(items_, [&](const ItemSpec& other) {
        return other.question == item.question && other.id != item.id && has_shape(*values_[slot], other) &&
               fit(slot, other) == LabelFit::exact;
    });
}

bool PrintedWords::is_barred(const Candidate& candidate, const ItemSpec& item) {
    return std::ranges::any_of(candidate.slots, [&](std::size_t slot) { return is_barred(slot, item); });
}

std::optional<std::pair<int, int>> PrintedWords::named_lines(const ItemSpec& item) {
    const MatchedItem* own = value_of(item.id);
    if (own == nullptr) return std::nullopt;
    const LabelFit own_fit = fits_(*own->value, item);
    if (own_fit < LabelFit::named) return std::nullopt;
    // Where the question has no heading, another question's item may have the same name.
    const auto is_named_too = [&](const ItemSpec& other) {
        return other.id != item.id && fits_(*own->value, other) >= own_fit;
    };
    if (!has_heading(item.question) && std::ranges::any_of(items_, is_named_too)) return std::nullopt;
    return std::pair(own->value->line, own->value->last_line);
}

MatrixOrder PrintedWords::stated_order(const std::vector<std::size_t>& slots, const ItemSpec& item) const {
    const MatchedItem* own = value_of(item.id);
    if (own != nullptr && slots_of(*own->value) == slots) return own->order;
    const int first = slots_.numbers[slots.front()].place.line, last = slots_.numbers[slots.back()].place.line;
    for (const LineOnScenes& line : slots_.lines) {
        if (line.own.number < first - 1 || last < line.own.number) continue;
        const std::string_view words = std::string_view(line.own.text).substr(0, begin_of_numbers(line.own.text));
        if (const MatrixOrder order = matrix_order(words); order != MatrixOrder::unsaid) return order;
        const auto row = read_row_label(words.substr(0, words.find_last_not_of(" \t:=") + 1));
        if (row && row->is_certain && row->order != MatrixOrder::unsaid) return row->order;
    }
    return MatrixOrder::unsaid;
}

bool PrintedWords::has_only_dashes(const Candidate& candidate) const {
    return std::ranges::all_of(candidate.slots, [&](std::size_t slot) {
        return !has_sign_apart(slots_.numbers[slot]) || values_[slot] != nullptr;
    });
}

bool PrintedWords::has_signs_apart(const Candidate& candidate) const {
    return std::ranges::any_of(candidate.slots, [&](std::size_t slot) { return has_sign_apart(slots_.numbers[slot]); });
}

int PrintedWords::distance_from_question(const std::vector<std::size_t>& slots, const ItemSpec& item) const {
    int farthest = 0;
    for (const std::size_t slot : slots) {
        const bool is_own = slots_.numbers[slot].question == item.question;
        farthest = std::max(farthest, is_own ? 0 : has_heading(item.question) ? 2 : 1);
    }
    return farthest;
}

}  // namespace harness::experiment
