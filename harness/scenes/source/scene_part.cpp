#include "harness/scenes/source/scene_part.h"

#include <fmt/format.h>

namespace harness::scenes {
namespace {

using reference::Decimal;
using reference::Vec3;

/// The part's vector; null for the radius and the pixel.
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
        case ScenePart::radius:
        case ScenePart::pixel: break;
    }
    return static_cast<decltype(&scene.camera.eye)>(nullptr);
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
        case ScenePart::pixel: return "pixel";
    }
    return "";
}

bool has_part(const DecimalScene& scene, ScenePart part) {
    switch (part) {
        case ScenePart::eye:
        case ScenePart::lookat:
        case ScenePart::vup:
        case ScenePart::pixel: return true;
        case ScenePart::center:
        case ScenePart::radius: return !scene.spheres.empty();
        case ScenePart::A:
        case ScenePart::B:
        case ScenePart::C: return !scene.triangles.empty();
    }
    return false;
}

std::size_t size_of(ScenePart part) {
    if (part == ScenePart::radius) return 1;
    return part == ScenePart::pixel ? 2 : 3;
}

std::array<double, 3> value_of(const DecimalScene& scene, ScenePart part) {
    if (part == ScenePart::radius) return {scene.spheres.front().radius.to_double(), 0, 0};
    if (part == ScenePart::pixel) return {static_cast<double>(scene.pixel.x), static_cast<double>(scene.pixel.y), 0};
    const Vec3<Decimal>& p = *vector_of(scene, part);
    return {p.x.to_double(), p.y.to_double(), p.z.to_double()};
}

void copy_part(DecimalScene& to, const DecimalScene& from, ScenePart part) {
    if (part == ScenePart::radius) {
        to.spheres.front().radius = from.spheres.front().radius;
    } else if (part == ScenePart::pixel) {
        to.pixel = from.pixel;
    } else {
        *vector_of(to, part) = *vector_of(from, part);
    }
}

void set_part(DecimalScene& scene, ScenePart part, const std::array<Decimal, 3>& numbers) {
    if (part == ScenePart::radius) {
        scene.spheres.front().radius = numbers[0];
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
