#include "reference/stages/items.h"

#include <array>

namespace reference {
namespace {

constexpr std::array items = {
    ItemSpec{1, "P_VCS", Shape::vector, Subject::camera, "Pixel in VCS"},
    ItemSpec{2, "X_vcs", Shape::vector, Subject::camera, "X_vcs"},
    ItemSpec{2, "Y_vcs", Shape::vector, Subject::camera, "Y_vcs"},
    ItemSpec{2, "Z_vcs", Shape::vector, Subject::camera, "Z_vcs"},
    ItemSpec{3, "M_VCS_to_WCS", Shape::matrix4, Subject::camera, "M_VCS_to_WCS"},
    ItemSpec{4, "P_WCS", Shape::vector, Subject::camera, "Pixel in WCS"},
    ItemSpec{5, "V", Shape::vector, Subject::camera, "V"},
    ItemSpec{6, "a", Shape::scalar, Subject::sphere, "a"},
    ItemSpec{6, "b", Shape::scalar, Subject::sphere, "b"},
    ItemSpec{6, "c", Shape::scalar, Subject::sphere, "c"},
    ItemSpec{6, "d", Shape::scalar, Subject::sphere, "d"},
    ItemSpec{6, "t", Shape::scalar, Subject::sphere, "t"},
    ItemSpec{6, "hit", Shape::vector, Subject::sphere, "P_s"},
    ItemSpec{7, "normal", Shape::vector, Subject::sphere, "N"},
    ItemSpec{8, "matrix", Shape::matrix3, Subject::triangle, "Matrix A, columns t u v"},
    ItemSpec{8, "rhs", Shape::vector, Subject::triangle, "Right-hand side"},
    ItemSpec{8, "t", Shape::scalar, Subject::triangle, "t"},
    ItemSpec{8, "u", Shape::scalar, Subject::triangle, "u"},
    ItemSpec{8, "v", Shape::scalar, Subject::triangle, "v"},
    ItemSpec{8, "hit", Shape::vector, Subject::triangle, "P_t"},
    ItemSpec{9, "normal", Shape::vector, Subject::triangle, "N"},
    ItemSpec{10, "verdict", Shape::verdict, Subject::first_hit, ""},
};

constexpr std::array<std::string_view, 10> titles = {
    "pixel in VCS",   "basis vectors of VCS", "M_VCS_to_WCS",     "pixel in WCS",    "ray direction",
    "ray and sphere", "sphere normal",        "ray and triangle", "triangle normal", "first hit",
};

}  // namespace

std::span<const ItemSpec> all_items() {
    return items;
}

std::string_view question_title(int question) {
    return titles.at(static_cast<std::size_t>(question - 1));
}

int component_count(Shape shape) {
    switch (shape) {
        case Shape::scalar: return 1;
        case Shape::vector: return 3;
        case Shape::matrix3: return 9;
        case Shape::matrix4: return 16;
        case Shape::verdict: return 0;
    }
    return 0;
}

}  // namespace reference
