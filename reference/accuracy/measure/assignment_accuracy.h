// Accuracy for one assignment's scene and pixel: the errors of each scalar type, and which decisions depend on
// rounding.
#pragma once

#include <string>
#include <vector>

#include "reference/key/answer_key.h"

namespace reference::accuracy {

/// An item as the stages compute it in one scalar type, compared with the truth.
struct ItemError {
    std::string scalar;       ///< "float" or "double"
    bool otherwise = false;   ///< a value where the truth has none, none where it has a value, or a different first
                              ///< object; the errors are 0 then
    double absolute = 0;      ///< the largest of the components' errors
    double ulp = 0;           ///< the same in units of ItemAccuracy::ulp
    double of_allowance = 0;  ///< the largest error of a component, as a share of its accepted error; > 1: marked wrong
};

struct ItemAccuracy {
    ItemSpec spec;
    /// A unit in the last place of float at the value's largest component, at 1 where all are 0.
    double ulp = 0;
    /// The error that marking accepts, the largest over the components; 0 for an item that is not a number.
    double allowance = 0;
    std::vector<ItemError> errors;  ///< by scalar
};

/// A sign that decides what the ray hits.
struct Decision {
    std::string what;    ///< "triangle: t", "sphere 2: d"
    std::string asks;    ///< "whether the triangle lies ahead of the ray's start"
    int sign = 0;        ///< of the true value
    double value = 0;    ///< the true value; for the order of two hits, its sign
    bool float_is_sure;  ///< no rounding of float arithmetic, however unlucky, changes the sign
    bool double_is_sure;
    std::vector<std::string> wrong;  ///< the scalar types whose run found a different sign

    bool hangs_on_rounding() const { return sign == 0 || !float_is_sure || !double_is_sure || !wrong.empty(); }
};

struct AssignmentAccuracy {
    std::string assignment;
    std::string title;
    std::vector<ItemAccuracy> items;  ///< the items that the scene calls for, by question
    std::vector<Decision> decisions;  ///< all that are needed, including the certain ones
};

/// Under the canonical reading of the handout. Throws as make_key does.
AssignmentAccuracy assignment_accuracy(const Assignment& assignment);

/// The parts that depend on the assignment alone.
std::vector<ItemAccuracy> item_accuracies(const Assignment& assignment, const AnswerKey& key);
std::vector<Decision> decisions_of(const Assignment& assignment, const Reading& reading);

}  // namespace reference::accuracy
