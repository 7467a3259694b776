#include "harness/scenes/source/scene_part.h"

#include <fmt/format.h>

namespace harness::scenes {
namespace {

using reference::Decimal;
using reference::Vec3;

/// The part's vector; null for the other parts.
template <class Scene>
auto* vector_of(Scene& scene, ScenePart part) {
    switch (part) {
        case ScenePart::eye: return &scene.camera.eye;
        case ScenePart::lookat: return &scene.camera.lookat;
        case ScenePart::vup: return &scene.camera.vup;
        case ScenePart::center: return &scene.spheres.front().center;
        case ScenePart::A: return &scene.triangles.front().A;
        case ScenePart::B: return &scene.triangles.front().B;
        case ScenePart::C: return &scene.triangles.front().C;
        case ScenePart::cylinder_center: return &scene.cylinders.front().center;
        case ScenePart::radius:
        case ScenePart::cylinder_radius:
        case ScenePart::cylinder_height:
        case ScenePart::pixel: break;
    }
    return static_cast<decltype(&scene.camera.eye)>(nullptr);
}

/// The part's single number; null for the other parts.
template <class Scene>
auto* number_of(Scene& scene, ScenePart part) {
    if (part == ScenePart::radius) return &scene.spheres.front().radius;
    if (part == ScenePart::cylinder_radius) return &scene.cylinders.front().radius;
    if (part == ScenePart::cylinder_height) return &scene.cylinders.front().height;
    return static_cast<decltype(&scene.window.clip_near)>(nullptr);
}

}  // namespace

std::string_view to_string(ScenePart part) {
    switch (part) {
        case ScenePart::eye: return "eye";
        case ScenePart::lookat: return "lookat";
        case ScenePart::vup: return "vup";
        case ScenePart::center: return "center";
        case ScenePart::radius: return "radius";
        case ScenePart::A: return "A";
        case ScenePart::B: return "B";
        case ScenePart::C: return "C";
        case ScenePart::cylinder_center: return "cylinder center";
        case ScenePart::cylinder_radius: return "cylinder radius";
        case ScenePart::cylinder_height: return "cylinder height";
        case ScenePart::pixel: return "pixel";
    }
    return "";
}

reference::Subject subject_of(ScenePart part) {
    using reference::Subject;
    switch (part) {
        case ScenePart::eye:
        case ScenePart::lookat:
        case ScenePart::vup:
        case ScenePart::pixel: break;
        case ScenePart::center:
        case ScenePart::radius: return Subject::sphere;
        case ScenePart::A:
        case ScenePart::B:
        case ScenePart::C: return Subject::triangle;
        case ScenePart::cylinder_center:
        case ScenePart::cylinder_radius:
        case ScenePart::cylinder_height: return Subject::cylinder;
    }
    return Subject::camera;
}

std::size_t size_of(ScenePart part) {
    switch (part) {
        case ScenePart::radius:
        case ScenePart::cylinder_radius:
        case ScenePart::cylinder_height: return 1;
        case ScenePart::pixel: return 2;
        case ScenePart::eye:
        case ScenePart::lookat:
        case ScenePart::vup:
        case ScenePart::center:
        case ScenePart::A:
        case ScenePart::B:
        case ScenePart::C:
        case ScenePart::cylinder_center: break;
    }
    return 3;
}

std::array<double, 3> value_of(const DecimalScene& scene, ScenePart part) {
    if (const Decimal* number = number_of(scene, part)) return {number->to_double(), 0, 0};
    if (part == ScenePart::pixel) return {static_cast<double>(scene.pixel.x), static_cast<double>(scene.pixel.y), 0};
    const Vec3<Decimal>& p = *vector_of(scene, part);
    return {p.x.to_double(), p.y.to_double(), p.z.to_double()};
}

void copy_part(DecimalScene& to, const DecimalScene& from, ScenePart part) {
    if (Decimal* number = number_of(to, part)) {
        *number = *number_of(from, part);
    } else if (part == ScenePart::pixel) {
        to.pixel = from.pixel;
    } else {
        *vector_of(to, part) = *vector_of(from, part);
    }
}

void set_part(DecimalScene& scene, ScenePart part, const std::array<Decimal, 3>& numbers) {
    if (Decimal* number = number_of(scene, part)) {
        *number = numbers[0];
    } else if (part == ScenePart::pixel) {
        scene.pixel = {static_cast<int>(numbers[0].to_double()), static_cast<int>(numbers[1].to_double())};
    } else {
        *vector_of(scene, part) = {numbers[0], numbers[1], numbers[2]};
    }
}

std::string describe(const DecimalScene& scene, ScenePart part) {
    const std::array<double, 3> value = value_of(scene, part);
    switch (size_of(part)) {
        case 1: return fmt::format("{} = {}", to_string(part), value[0]);
        case 2: return fmt::format("{} = ({}, {})", to_string(part), value[0], value[1]);
        default: return fmt::format("{} = ({}, {}, {})", to_string(part), value[0], value[1], value[2]);
    }
}

}  // namespace harness::scenes
