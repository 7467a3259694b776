// What the handout's ten questions ask for, item by item.
#pragma once

#include <span>
#include <string_view>
#include <utility>

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

/// Question and name, as in ItemSpec.
using ItemId = std::pair<int, std::string_view>;

/// The ids of all items.
namespace item {
inline constexpr ItemId P_VCS{1, "P_VCS"};
inline constexpr ItemId X_vcs{2, "X_vcs"};
inline constexpr ItemId Y_vcs{2, "Y_vcs"};
inline constexpr ItemId Z_vcs{2, "Z_vcs"};
inline constexpr ItemId M_VCS_to_WCS{3, "M_VCS_to_WCS"};
inline constexpr ItemId P_WCS{4, "P_WCS"};
inline constexpr ItemId V{5, "V"};
namespace sphere {
inline constexpr ItemId a{6, "a"};
inline constexpr ItemId b{6, "b"};
inline constexpr ItemId c{6, "c"};
inline constexpr ItemId d{6, "d"};
inline constexpr ItemId t{6, "t"};
inline constexpr ItemId hit{6, "hit"};
inline constexpr ItemId normal{7, "normal"};
}  // namespace sphere
namespace triangle {
inline constexpr ItemId matrix{8, "matrix"};
inline constexpr ItemId rhs{8, "rhs"};
inline constexpr ItemId t{8, "t"};
inline constexpr ItemId u{8, "u"};
inline constexpr ItemId v{8, "v"};
inline constexpr ItemId hit{8, "hit"};
inline constexpr ItemId normal{9, "normal"};
}  // namespace triangle
inline constexpr ItemId verdict{10, "verdict"};
}  // namespace item

inline ItemId id_of(const ItemSpec& spec) {
    return {spec.question, spec.name};
}

/// Every item, in the handout's order.
std::span<const ItemSpec> all_items();

/// A few words that say what question 1 to 10 asks for.
std::string_view question_title(int question);

/// How many numbers a value of the shape has; 0 for a verdict.
int component_count(Shape shape);

}  // namespace reference
