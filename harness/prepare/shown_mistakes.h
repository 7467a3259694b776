// Which of the named mistakes an assignment's scene shows, and which of them it tells apart.
#pragma once

#include <string_view>
#include <vector>

#include "harness/mark/diagnose/mistakes.h"
#include "reference/key/answer_key.h"

namespace harness::prepare {

/// A mistake in an item that is asked.
struct NamedMistake {
    ItemId item;
    std::string_view name;

    friend auto operator<=>(const NamedMistake&, const NamedMistake&) = default;
};

struct ShownMistakes {
    std::vector<NamedMistake> shown;  ///< who makes it, in any of its forms, prints another number than a right program
    std::vector<NamedMistake>
        hidden;  ///< in one of its forms the number is right all the same, or there is none on this scene
    /// Mistakes in one item that give the same number, two or more a group.
    std::vector<std::vector<NamedMistake>> alike;

    /// How many are shown and are in no group.
    std::size_t told_apart() const;
};

/// A number counts as another if it differs by more than correct programs do and than the rubric's min_decimals show.
ShownMistakes shown_mistakes(const reference::Assignment& assignment, const reference::AnswerKey& key);

}  // namespace harness::prepare
