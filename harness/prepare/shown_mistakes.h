// Which named mistakes an assignment's scene reveals, and which of them give different answers.
#pragma once

#include <string_view>
#include <vector>

#include "harness/mark/diagnose/mistakes.h"
#include "reference/key/answer_key.h"

namespace harness::prepare {

/// A mistake in an item that the assignment asks for.
struct NamedMistake {
    ItemId item;
    std::string_view name;

    friend auto operator<=>(const NamedMistake&, const NamedMistake&) = default;
};

struct ShownMistakes {
    std::vector<NamedMistake> shown;   ///< every form of the mistake gives a wrong answer
    std::vector<NamedMistake> hidden;  ///< one form of the mistake gives the right answer, or no form gives a number
    /// Groups of two or more mistakes in one item that give the same number.
    std::vector<std::vector<NamedMistake>> alike;

    /// How many of `shown` are in no group.
    std::size_t told_apart() const;
};

/// Numbers count as different if they differ by more than correct programs do, and by more than min_decimals can show.
ShownMistakes shown_mistakes(const reference::Assignment& assignment, const reference::AnswerKey& key);

}  // namespace harness::prepare
