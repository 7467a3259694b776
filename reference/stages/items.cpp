#include "reference/stages/items.h"

#include <algorithm>
#include <array>

namespace reference {
namespace {

constexpr std::array items = {
    Item{item::P_VCS, "P_VCS", Shape::vector, "Pixel in VCS"},
    Item{item::X_vcs, "X_vcs", Shape::vector, "X_vcs"},
    Item{item::Y_vcs, "Y_vcs", Shape::vector, "Y_vcs"},
    Item{item::Z_vcs, "Z_vcs", Shape::vector, "Z_vcs"},
    Item{item::M_VCS_to_WCS, "M_VCS_to_WCS", Shape::matrix4, "M_VCS_to_WCS"},
    Item{item::P_WCS, "P_WCS", Shape::vector, "Pixel in WCS"},
    Item{item::V, "V", Shape::vector, "V"},
    Item{item::sphere::a, "sphere.a", Shape::scalar, "a"},
    Item{item::sphere::b, "sphere.b", Shape::scalar, "b"},
    Item{item::sphere::c, "sphere.c", Shape::scalar, "c"},
    Item{item::sphere::d, "sphere.d", Shape::scalar, "d"},
    Item{item::sphere::t, "sphere.t", Shape::scalar, "t", Exists::with_hit},
    Item{item::sphere::hit, "sphere.hit", Shape::vector, "P_s", Exists::with_hit},
    Item{item::sphere::normal, "sphere.normal", Shape::vector, "N", Exists::with_hit},
    Item{item::triangle::matrix, "triangle.matrix", Shape::matrix3, "Matrix A, columns t u v"},
    Item{item::triangle::rhs, "triangle.rhs", Shape::vector, "Right-hand side"},
    Item{item::triangle::t, "triangle.t", Shape::scalar, "t", Exists::unless_parallel},
    Item{item::triangle::u, "triangle.u", Shape::scalar, "u", Exists::unless_parallel},
    Item{item::triangle::v, "triangle.v", Shape::scalar, "v", Exists::unless_parallel},
    Item{item::triangle::hit, "triangle.hit", Shape::vector, "P_t", Exists::with_hit},
    Item{item::triangle::normal, "triangle.normal", Shape::vector, "N"},
    Item{item::cylinder::a, "cylinder.a", Shape::scalar, "a"},
    Item{item::cylinder::b, "cylinder.b", Shape::scalar, "b"},
    Item{item::cylinder::c, "cylinder.c", Shape::scalar, "c"},
    Item{item::cylinder::d, "cylinder.d", Shape::scalar, "d"},
    Item{item::cylinder::t, "cylinder.t", Shape::scalar, "t", Exists::with_hit},
    Item{item::cylinder::hit, "cylinder.hit", Shape::vector, "P_c", Exists::with_hit},
    Item{item::cylinder::normal, "cylinder.normal", Shape::vector, "N", Exists::with_hit},
    Item{item::first_object, "first_hit", Shape::first_object, ""},
};

bool has_its_name_twice(const Question& question, const ItemId& id) {
    return std::ranges::count(question.items, id.name, &ItemId::name) > 1;
}

/// The letter of the part that asks for the item; 0 if none does.
char part_with(const Question& question, const ItemId& id) {
    char letter = 'a';
    for (const QuestionPart& part : question.parts) {
        if (std::ranges::find(part.items, id) != part.items.end()) return letter;
        ++letter;
    }
    return 0;
}

}  // namespace

std::string_view to_string(Subject subject) {
    switch (subject) {
        case Subject::camera: return "camera";
        case Subject::sphere: return "sphere";
        case Subject::triangle: return "triangle";
        case Subject::cylinder: return "cylinder";
        case Subject::first_hit: return "first_hit";
    }
    return "";
}

std::span<const Item> known_items() {
    return items;
}

const Item* find_item(std::string_view full_name) {
    const auto found = std::ranges::find(items, full_name, &Item::full_name);
    return found == items.end() ? nullptr : &*found;
}

const Item& item_of(const ItemId& id) {
    return *std::ranges::find(items, id, &Item::id);
}

const std::vector<Question>& default_questions() {
    static const std::vector<Question> questions = {
        {1, "pixel in VCS", {item::P_VCS}},
        {2, "basis vectors of VCS", {item::X_vcs, item::Y_vcs, item::Z_vcs}},
        {3, "M_VCS_to_WCS", {item::M_VCS_to_WCS}},
        {4, "pixel in WCS", {item::P_WCS}},
        {5, "ray direction", {item::V}},
        {6,
         "ray and sphere",
         {item::sphere::a, item::sphere::b, item::sphere::c, item::sphere::d, item::sphere::t, item::sphere::hit}},
        {7, "sphere normal", {item::sphere::normal}},
        {8,
         "ray and triangle",
         {item::triangle::matrix, item::triangle::rhs, item::triangle::t, item::triangle::u, item::triangle::v,
          item::triangle::hit}},
        {9, "triangle normal", {item::triangle::normal}},
        {10, "first hit", {item::first_object}},
    };
    return questions;
}

int last_question(const std::vector<Question>& questions) {
    return questions.empty() ? 0 : std::ranges::max(questions, {}, &Question::number).number;
}

std::vector<ItemSpec> asked_items(const std::vector<Question>& questions) {
    std::vector<ItemSpec> specs;
    for (const Question& question : questions) {
        for (const ItemId& id : question.items) {
            const Item& item = item_of(id);
            const std::string_view name = has_its_name_twice(question, id) ? item.full_name : id.name;
            specs.push_back({question.number, name, item.shape, item.label, id, part_with(question, id)});
        }
    }
    return specs;
}

std::span<const ItemSpec> default_items() {
    static const std::vector<ItemSpec> specs = asked_items(default_questions());
    return specs;
}

int component_count(Shape shape) {
    switch (shape) {
        case Shape::scalar: return 1;
        case Shape::vector: return 3;
        case Shape::matrix3: return 9;
        case Shape::matrix4: return 16;
        case Shape::first_object: return 0;
    }
    return 0;
}

}  // namespace reference
