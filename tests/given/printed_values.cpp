#include "tests/given/printed_values.h"

#include <algorithm>
#include <stdexcept>

#include "harness/mark/score/mark_transcript.h"
#include "harness/read/tokens/token.h"

using namespace harness;

namespace {

std::vector<PrintedNumber> numbers_in(std::string_view text) {
    std::vector<PrintedNumber> numbers;
    for (const Token& token : tokenize(text)) {
        if (token.kind == Token::Kind::number) numbers.push_back(token.number);
    }
    return numbers;
}

}  // namespace

PrintedNumber printed_number(std::string_view text) {
    return numbers_in(text).at(0);
}

MatchedItem printed_item(const reference::ItemId& id, std::string_view text, MatrixOrder order) {
    const auto items = reference::default_items();
    const auto spec = std::ranges::find(items, id, &reference::ItemSpec::id);
    const reference::Item& asked = reference::item_of(id);
    const bool of_2021 = spec != items.end();
    MatchedItem item{of_2021 ? *spec : reference::ItemSpec{1, id.name, asked.shape, asked.label, id},
                     PrintedValue{},
                     order,
                     {},
                     false,
                     {}};
    item.value->numbers = numbers_in(text);
    item.value->printed = std::string(text);
    item.value->line = 1;
    return item;
}

Score mark(std::string_view output, const student::Marking& marking) {
    return score(read_transcript(output, last_question(marking.assignment.questions)), marking.key, marking.assignment);
}

int question_of(const reference::ItemId& id) {
    const auto items = reference::default_items();
    const auto spec = std::ranges::find(items, id, &reference::ItemSpec::id);
    if (spec == items.end()) throw std::out_of_range("the ten questions of 2021 do not ask for this item");
    return spec->question;
}

const ItemScore& item_of(const Score& score, const reference::ItemId& id) {
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) {
            if (item.spec.id == id) return item;
        }
    }
    throw std::out_of_range("no such item");
}

std::string verdict_on(const Score& score, const reference::ItemId& id) {
    return std::string(to_string(item_of(score, id).verdict));
}
