// The verdicts, points and doubts of a submission's answers.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reference/stages/items.h"

namespace harness {

enum class ItemVerdict {
    right,
    follow,  ///< wrong, but it follows from the student's own earlier wrong values
    wrong,
    missing,
    unreadable,  ///< a value of another shape was printed for it
};

/// The name in reports and in grades.json.
std::string_view to_string(ItemVerdict verdict);

/// The reason why the value read for an item may not be the student's answer.
struct Doubt {
    enum class Why {
        right_elsewhere,  ///< the right value is elsewhere in the printout, outside all right answers
        numbers_left,     ///< its question has numbers that belong to no answer
        words_left,       ///< its question has only words that were not understood
        printed_again,    ///< its question was printed more than once, and one printing was read
        little_read,      ///< less than half of the answers were found in the whole printout
        another_answer,   ///< the printout offers another answer too: "0.58 or 3.41"
        by_order,         ///< only its order tells which of several items it is
        by_columns,       ///< it fits if a matrix read by rows is read by columns, or vice versa
    };
    Why why = Why::numbers_left;
    int line = 0;  ///< of the printout, 1-based: where to look; 0 for the whole
};

/// The name in grades.json.
std::string_view to_string(Doubt::Why why);

struct ItemScore {
    reference::ItemSpec spec;
    ItemVerdict verdict = ItemVerdict::missing;
    double points = 0;
    double max_points = 0;
    std::string printed;          ///< verbatim, at most 200 bytes; empty if nothing was printed
    int line = 0;                 ///< of the output, 1-based; 0 when nothing was printed
    int last_line = 0;            ///< of the output
    std::optional<double> error;  ///< the largest distance of a component from the key; empty when there is none
    std::optional<double> allowance = 0;  ///< how far a component may be off, besides its rounding; empty if float
                                          ///< can't compute it (reference/key/graded_allowance.h)
    std::string accepted_as;              ///< why another form or reading is right; empty for the canonical one
    std::string diagnosis;                ///< the mistake's name, e.g. "far root"; empty when unknown
    std::string advice;                   ///< one sentence about the mistake; never the expected value
    /// All named mistakes that give this value, with their advice; `diagnosis` and `advice` are made from them. Not in
    /// the record.
    std::vector<std::pair<std::string, std::string>> mistakes = {};
    bool may_be_chance = false;         ///< other mistakes may give this value: known ones do, or the value is simple
    std::string difference;             ///< the difference from the right answer (diagnose/difference.h), if it is
                                        ///< wrong
    std::optional<Doubt> doubt;         ///< about the reading; for a right answer, only another_answer
    std::optional<Doubt> layout_doubt;  ///< the doubt from the printout alone, if `doubt` is right_elsewhere
    std::string reread;                 ///< who located the answer, and why; empty if nobody did
    std::string experiment;             ///< how runs on other scenes located the answer; empty if they did not
    bool by_order = false;              ///< no words name it: it was found by its shape and order
    // How the value was read. `printed` alone does not show it: "none (d < 0)" contains a number.
    bool no_value = false;    ///< read as "none"
    bool not_finite = false;  ///< its numbers include nan or inf
    double half_unit = 0;     ///< half a unit of the last printed digit; the largest among its numbers
    bool by_columns = false;  ///< for a matrix that is not right: it was printed column by column
    /// The share of its points that an answer earns. Set if it follows and the share is not the rubric's
    /// follow_through, and if it is wrong by a mistake that the rubric prices.
    std::optional<double> credit;
};

struct QuestionScore {
    int number = 0;
    std::string title = {};
    ItemVerdict verdict = ItemVerdict::right;  ///< the worst of its items, in the order: wrong or unreadable, missing,
                                               ///< follow, right
    double points = 0;
    double max_points = 0;
    std::vector<ItemScore> items;
};

/// The points for answers on other scenes, as part of a score.
struct ScenesScore {
    double points = 0;
    double max_points = 0;
};

struct Score {
    double points = 0;
    double max_points = 0;
    std::optional<ScenesScore> variants;   ///< included in both sums above; empty if the rubric gives none
    std::optional<double> follow_cap;      ///< the rubric's cap on follow-through in points, if it reduced the points
    std::vector<QuestionScore> questions;  ///< by number
};

/// Calls `visit` for the item of every question.
template <class Visit>
void for_each_item(const Score& score, Visit visit) {
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) visit(item);
    }
}

/// These mistakes as one diagnosis and one advice: "far root or closest approach". Both are empty if there is none.
std::pair<std::string, std::string> in_words(const std::vector<std::pair<std::string, std::string>>& mistakes);

/// Whether a person or an experiment located the item's answer.
bool is_settled(const ItemScore& item);

/// The doubt that the student may see: one that does not depend on the key. Any other would reveal which number is
/// right.
const std::optional<Doubt>& told_doubt(const ItemScore& item);

/// The items of all questions.
std::vector<reference::ItemSpec> asked_items(const Score& score);
/// The highest number of a question; 0 if there is none.
int last_question(const Score& score);

}  // namespace harness
