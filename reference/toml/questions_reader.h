// Reads an assignment's questions from its tables [[question]].
#pragma once

#include <map>
#include <string>
#include <vector>

#include "reference/numbers/decimal.h"
#include "reference/stages/items.h"
#include "reference/stages/scene.h"
#include "reference/toml/toml_table.h"

namespace reference {

/// Of a question, one of its parts or an item.
constexpr double most_points = 1e6;

struct ReadQuestions {
    std::vector<Question> questions;
    std::map<int, double> points;  ///< of the questions that set their own
    /// Points of the items in parts that set their own, by question and the item's name in it; a part's points are
    /// shared equally among its items.
    std::map<int, std::map<std::string, double>> item_points;
};

/// The questions of 2021 if the file lists none. Throws AssignmentError for numbers that do not ascend, a name that is
/// not an item's, an item that is asked twice and an item of an object that the scene does not have; also for a
/// question that lists items besides its parts, and if only some of its parts have points.
ReadQuestions read_questions(const TomlTable& root, const Scene<Decimal>& scene);

}  // namespace reference
