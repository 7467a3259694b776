// Shared by the files with the mistakes of the simulated student; only for them.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "tests/given/student/mistakes.h"

namespace student {

/// The mistakes in the items of the cylinder.
std::vector<NamedMistake> of_cylinder();

/// The handout's names, as the formulas use them.
struct Names {
    explicit Names(const Program& p) : program(p) {}
    glm::vec3 eye() const { return program.scene().camera.eye; }
    glm::vec3 lookat() const { return program.scene().camera.lookat; }
    glm::vec3 vup() const { return program.scene().camera.vup; }
    glm::vec3 center() const { return program.scene().spheres.front().center; }
    float radius() const { return program.scene().spheres.front().radius; }
    const reference::Cylinder<float>& cylinder() const { return program.scene().cylinders.front(); }
    glm::vec3 A() const { return program.scene().triangles.front().A; }
    glm::vec3 B() const { return program.scene().triangles.front().B; }
    glm::vec3 C() const { return program.scene().triangles.front().C; }
    glm::vec3 S() const { return program.vector(reference::item::P_WCS); }
    glm::vec3 direction() const { return program.vector(reference::item::V); }
    float at(const ItemId& id) const { return program.scalar(id); }
    glm::vec3 vec(const ItemId& id) const { return program.vector(id); }
    const reference::Window<float>& window() const { return program.scene().window; }
    float x() const { return static_cast<float>(program.scene().pixel.x); }
    float y() const { return static_cast<float>(program.scene().pixel.y); }
    float W() const { return static_cast<float>(window().width); }
    float H() const { return static_cast<float>(window().height); }

    const Program& program;
};

template <class Formula>
NamedMistake on(std::string_view name, const ItemId& item, Formula formula) {
    return {name, {item, [formula](const Program& p, const auto&) -> std::optional<Floats> {
                       return floats(formula(Names(p)));
                   }}};
}

/// A change of the right value.
template <class Change>
NamedMistake changed(std::string_view name, const ItemId& item, Change change) {
    return {name, {item, [change](const Program&, const auto& right) -> std::optional<Floats> {
                       if (!right) return right;
                       Floats value = *right;
                       change(value);
                       return value;
                   }}};
}

inline void negate(Floats& value) {
    for (float& x : value) x = -x;
}

}  // namespace student
