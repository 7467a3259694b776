#include "harness/experiment/identify/printed_words.h"

#include <algorithm>
#include <string>

namespace harness::experiment {
namespace {

using reference::ItemSpec;

/// The words of a label without signs such as "==>" and the letter of a part, "b)".
std::string words_alone(std::string_view label) {
    const std::size_t part = label.find(')');
    const std::size_t letter = label.find_first_not_of(" \t(");
    if (part != std::string_view::npos && letter != std::string_view::npos && part == letter + 1)
        label.remove_prefix(part + 1);
    std::string words;
    for (const char c : label) words += is_letter(c) || is_digit(c) || c == '_' || c == '\'' ? c : ' ';
    const std::size_t first = words.find_first_not_of(' ');
    if (first == std::string::npos) return "";
    return words.substr(first, words.find_last_not_of(' ') + 1 - first);
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
    if (found == matched_.end() || !found->value || found->unreadable) return nullptr;
    const std::vector<PrintedNumber>& numbers = found->value->numbers;
    const bool has_w = numbers.size() == 4 && (numbers[3].value == 0 || numbers[3].value == 1);
    return numbers.size() == 4 && !has_w ? nullptr : &*found;
}

std::vector<std::size_t> PrintedWords::slots_of(const PrintedValue& value) const {
    const std::vector<Slot>& all = slots_.numbers;
    std::vector<std::size_t> found;
    for (const PrintedNumber& number : value.numbers) {
        const NumberPlace place{number.line, number.index};
        const auto slot = std::ranges::lower_bound(all, place, {}, &Slot::place);
        if (slot == all.end() || slot->place != place) return {};
        found.push_back(static_cast<std::size_t>(slot - all.begin()));
    }
    return found;
}

LabelFit PrintedWords::fit(std::size_t slot, const ItemSpec& item) {
    if (values_[slot] != nullptr) return has_shape(*values_[slot], item) ? fits_(*values_[slot], item) : LabelFit::none;
    const Slot& own = slots_.numbers[slot];
    // Words between the numbers of a line may separate the components of a vector: "0.5 x 0.25 x 1".
    if (item.shape != reference::Shape::scalar && own.place.number > 1) return LabelFit::none;
    PrintedValue value;
    value.label = words_alone(own.label);
    return value.label.empty() ? LabelFit::none : fits_(value, item);
}

bool PrintedWords::is_no_answer(std::size_t slot, const ItemSpec& item) {
    const int line = slots_.numbers[slot].place.line;
    const auto [known, is_new] = no_answer_.try_emplace(line, false);
    for (const LineOnScenes& on_scenes : slots_.lines) {
        if (is_new && on_scenes.own.number == line) known->second = known->second || says_no_answer(on_scenes.own.text);
    }
    // The rows of a matrix have their own labels: "B" is not a corner of the triangle.
    const PrintedValue* value = side_of(item.shape) > 1 ? nullptr : values_[slot];
    return known->second || (value != nullptr && (says_no_answer(value->label) || says_no_answer(value->above)));
}

bool PrintedWords::is_barred(std::size_t slot, const ItemSpec& item) {
    if (is_no_answer(slot, item)) return true;
    if (side_of(item.shape) > 1 || fit(slot, item) >= LabelFit::named) return false;
    return std::ranges::any_of(items_, [&](const ItemSpec& other) {
        const bool has_its_shape =
            values_[slot] != nullptr ? has_shape(*values_[slot], other) : other.shape == item.shape;
        return other.question == item.question && other.id != item.id && has_its_shape &&
               fit(slot, other) >= LabelFit::named;
    });
}

bool PrintedWords::is_barred(const Candidate& candidate, const ItemSpec& item) {
    return std::ranges::any_of(candidate.slots, [&](std::size_t slot) { return is_barred(slot, item); });
}

bool PrintedWords::may_be_named_at(std::size_t slot, const ItemSpec& item) {
    if (has_heading(item.question)) return slots_.numbers[slot].question == item.question;
    const LabelFit own = fit(slot, item);
    return std::ranges::none_of(items_,
                                [&](const ItemSpec& other) { return other.id != item.id && fit(slot, other) >= own; });
}

bool PrintedWords::is_named_somewhere(const ItemSpec& item) {
    for (std::size_t slot = 0; slot < slots_.numbers.size(); ++slot) {
        if (fit(slot, item) >= LabelFit::named && may_be_named_at(slot, item)) return true;
    }
    return false;
}

MatrixOrder PrintedWords::stated_order(const std::vector<std::size_t>& slots, const ItemSpec& item) const {
    const MatchedItem* own = value_of(item.id);
    const bool is_read = own != nullptr && slots_of(*own->value) == slots;
    if (is_read && own->order != MatrixOrder::unsaid) return own->order;
    const int first = slots_.numbers[slots.front()].place.line;
    for (const LineOnScenes& line : slots_.lines) {
        const auto slot =
            std::ranges::find(slots, line.own.number, [&](std::size_t i) { return slots_.numbers[i].place.line; });
        if (slot == slots.end() && line.own.number + 1 != first) continue;  // neither a row nor the title
        const std::string_view text = line.own.text;
        const std::string_view words =
            text.substr(0, slot == slots.end() ? text.size() : slots_.numbers[*slot].own.begin);
        if (const MatrixOrder order = matrix_order(words); order != MatrixOrder::unsaid) return order;
        const auto row = read_row_label(words_alone(words));
        if (row && row->order != MatrixOrder::unsaid) return row->order;
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
