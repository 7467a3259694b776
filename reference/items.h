// What the handout's ten questions ask for, item by item.
#pragma once

#include <span>
#include <string_view>

namespace reference {

enum class Shape {
    scalar,
    vector,   ///< three components
    matrix3,  ///< 3 x 3
    matrix4,  ///< 4 x 4
    verdict,  ///< question 10's sentence
};

/// Which part of the scene an item is about: without that part it is not asked.
enum class Subject { camera, sphere, triangle, first_hit };

struct ItemSpec {
    int question;           ///< 1 to 10
    std::string_view name;  ///< unique within its question, e.g. "P_VCS", "t", "hit"
    Shape shape;
    Subject subject;
    std::string_view label;  ///< as the reference run prints it
};

/// Every item, in the handout's order.
std::span<const ItemSpec> all_items();

/// A few words that say what question 1 to 10 asks for.
std::string_view question_title(int question);

/// How many numbers a value of the shape has; 0 for a verdict.
int component_count(Shape shape);

}  // namespace reference
