// The items that an assignment may ask for, and the questions that ask for them.
#pragma once

#include <compare>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace reference {

enum class Shape {
    scalar,
    vector,        ///< three components
    matrix3,       ///< 3 x 3
    matrix4,       ///< 4 x 4
    first_object,  ///< the sentence about the first hit
};

/// The part of the scene that an item belongs to: without that part the item is not asked.
enum class Subject { camera, sphere, triangle, cylinder, first_hit };

/// The kinds of object that a ray may hit, in the order of the tables.
inline constexpr Subject objects[] = {Subject::sphere, Subject::triangle, Subject::cylinder};

/// Calls visit.operator()<kind>() for each of them, for code that is defined object by object.
template <class Visit>
void for_each_object(const Visit& visit) {
    visit.template operator()<Subject::sphere>();
    visit.template operator()<Subject::triangle>();
    visit.template operator()<Subject::cylinder>();
}

/// "camera", "sphere", …, as assignments name it.
std::string_view to_string(Subject subject);

/// The identity of an item: the part of the scene and the item's name there, unique among that part's items.
struct ItemId {
    Subject subject = Subject::camera;
    std::string_view name = {};  ///< e.g. "P_VCS", "t", "hit"; of static storage

    friend auto operator<=>(const ItemId&, const ItemId&) = default;
};

/// The ids of all items.
namespace item {
inline constexpr ItemId P_VCS{Subject::camera, "P_VCS"};
inline constexpr ItemId X_vcs{Subject::camera, "X_vcs"};
inline constexpr ItemId Y_vcs{Subject::camera, "Y_vcs"};
inline constexpr ItemId Z_vcs{Subject::camera, "Z_vcs"};
inline constexpr ItemId M_VCS_to_WCS{Subject::camera, "M_VCS_to_WCS"};
inline constexpr ItemId P_WCS{Subject::camera, "P_WCS"};
inline constexpr ItemId V{Subject::camera, "V"};
namespace sphere {
inline constexpr ItemId a{Subject::sphere, "a"};
inline constexpr ItemId b{Subject::sphere, "b"};
inline constexpr ItemId c{Subject::sphere, "c"};
inline constexpr ItemId d{Subject::sphere, "d"};
inline constexpr ItemId t{Subject::sphere, "t"};
inline constexpr ItemId hit{Subject::sphere, "hit"};
inline constexpr ItemId normal{Subject::sphere, "normal"};
}  // namespace sphere
namespace triangle {
inline constexpr ItemId matrix{Subject::triangle, "matrix"};
inline constexpr ItemId rhs{Subject::triangle, "rhs"};
inline constexpr ItemId t{Subject::triangle, "t"};
inline constexpr ItemId u{Subject::triangle, "u"};
inline constexpr ItemId v{Subject::triangle, "v"};
inline constexpr ItemId hit{Subject::triangle, "hit"};
inline constexpr ItemId normal{Subject::triangle, "normal"};
}  // namespace triangle
namespace cylinder {
inline constexpr ItemId a{Subject::cylinder, "a"};  ///< of the tube's quadratic, like b, c and d
inline constexpr ItemId b{Subject::cylinder, "b"};
inline constexpr ItemId c{Subject::cylinder, "c"};
inline constexpr ItemId d{Subject::cylinder, "d"};
inline constexpr ItemId t{Subject::cylinder, "t"};
inline constexpr ItemId hit{Subject::cylinder, "hit"};
inline constexpr ItemId normal{Subject::cylinder, "normal"};
}  // namespace cylinder
inline constexpr ItemId first_object{Subject::first_hit, "verdict"};
}  // namespace item

/// When an item has a value.
enum class Exists {
    always,
    unless_parallel,  ///< if the ray meets the object's plane, inside the object or not
    with_hit,         ///< if the ray hits the object
};

/// An item that an assignment may ask for.
struct Item {
    ItemId id;
    std::string_view full_name;  ///< its name in an assignment: "P_VCS", "sphere.t", "first_hit"
    Shape shape;
    std::string_view label;  ///< as printed by the reference run
    Exists exists = Exists::always;
};

/// Every item.
std::span<const Item> known_items();

/// Null if there is no item of this name.
const Item* find_item(std::string_view full_name);

const Item& item_of(const ItemId& id);

/// A part of a question: "a)", "b)", …
struct QuestionPart {
    std::string title;  ///< may be empty
    std::vector<ItemId> items;
};

/// A question of an assignment.
struct Question {
    int number;                 ///< 1 or more
    std::string title;          ///< a few words about the question
    std::vector<ItemId> items;  ///< its parts' items, if it has parts
    std::vector<QuestionPart> parts = {};
};

/// The ten questions of 2021, used if an assignment lists none.
const std::vector<Question>& default_questions();

/// The highest number of a question; 0 if there is none.
int last_question(const std::vector<Question>& questions);

/// An item as a question asks for it.
struct ItemSpec {
    int question;
    std::string_view name;  ///< unique within its question: the item's name, or its full name if two have the same
    Shape shape;
    std::string_view label;  ///< as printed by the reference run
    ItemId id;
    char part = 0;  ///< 'a' in its question's first part; 0 if the question has none
};

/// The items of the questions, in their order.
std::vector<ItemSpec> asked_items(const std::vector<Question>& questions);

/// The items of the ten questions of 2021.
std::span<const ItemSpec> default_items();

/// How many numbers a value of the shape has; 0 for the first object.
int component_count(Shape shape);

}  // namespace reference
