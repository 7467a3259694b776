// What an assignment asks, from its tables [[question]].
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
    std::map<int, double> points;  ///< of the questions that state theirs
    /// Of the items in parts that state theirs, by question and the item's name in it; a part's points are shared
    /// equally among its items.
    std::map<int, std::map<std::string, double>> item_points;
};

/// The questions of 2021 if the file lists none. Throws AssignmentError for numbers that do not ascend, a name that is
/// no item's, an item that is asked twice and one of an object that the scene does not have; also for a question that
/// lists items beside its parts, and where only some of its parts have points.
ReadQuestions read_questions(const TomlTable& root, const Scene<Decimal>& scene);

}  // namespace reference
