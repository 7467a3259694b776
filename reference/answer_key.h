// The answer key: for every item the values that are right, the canonical one first.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "reference/assignment.h"
#include "reference/items.h"
#include "reference/stages/first_hit.h"
#include "reference/stages/sphere.h"

namespace reference {

/// There is no such value: the ray misses, or the linear system has no solution.
struct NoValue {
    friend bool operator==(NoValue, NoValue) = default;
};

/// The components of a scalar, a vector or a matrix; a matrix column by column (GLM's order).
using Numbers = std::vector<double>;

using Value = std::variant<NoValue, Numbers, Verdict>;

/// How one right program may read the handout where the handout leaves it open.
struct Reading {
    PixelConvention convention;
    Boundary boundary;
};

/// One right answer to an item, and the reading of the handout that gives it.
struct Answer {
    Value value;
    Reading reading;
};

struct KeyItem {
    ItemSpec spec;
    std::vector<Answer> answers;  ///< at least one; the first is canonical
};

struct KeyQuestion {
    int number;  ///< the handout's, 1 to 10
    std::vector<KeyItem> items;
};

/// How the ray meets the scene; empty for what the scene does not hold.
struct Decisions {
    std::string sphere;               ///< hit, miss, tangent or unsure
    std::string triangle;             ///< hit, miss, boundary, parallel or unsure
    std::string first;                ///< sphere, triangle, tie, none or unsure
    std::vector<std::string> policy;  ///< "boundary" and "pixel convention" where an answer depends on them
};

enum class Precision { float_, double_ };
std::string_view to_string(Precision precision);

struct AnswerKey {
    std::string assignment;
    Precision precision;
    Reading canonical;                   ///< the reading of every item's first answer
    std::vector<KeyQuestion> questions;  ///< those the scene calls for, by number
    Decisions decisions;
};

/// What makes `answer` right beside the canonical one, as a phrase that follows "accepted because": "the rubric accepts the
/// grid pixel convention". Empty for the canonical reading.
std::string reason(const Answer& answer, const AnswerKey& key);

/// Runs the stages on the assignment's scene. Throws std::domain_error naming the item when a value is not finite or a
/// decision is unsure: that scene can't be marked at this precision.
AnswerKey make_key(const Assignment& assignment, Precision precision);

/// As a right program prints it: the handout's questions, one labelled answer a line, in glm::to_string's format.
std::string to_text(const AnswerKey& key);

/// The format raygrade/key/1, indented, with a final newline. Numbers read back as the same doubles.
std::string to_json(const AnswerKey& key);

/// The handout's sentence for a verdict, e.g. "ray hits triangle first".
std::string_view sentence(Verdict verdict);

}  // namespace reference
