#include "harness/scenes/source/scene_part.h"

#include <fmt/format.h>

#include <algorithm>

namespace harness::scenes {
namespace {

using reference::Decimal;
using reference::Vec3;

using reference::Pixel;
using reference::Subject;

struct Part {
    ScenePart part;
    Subject subject;  ///< the kind of object that has it, or the camera
    std::string_view name;
    std::size_t size;  ///< how many numbers it has
};

constexpr std::array parts{
    Part{ScenePart::eye, Subject::camera, "eye", 3},
    Part{ScenePart::lookat, Subject::camera, "lookat", 3},
    Part{ScenePart::vup, Subject::camera, "vup", 3},
    Part{ScenePart::center, Subject::sphere, "center", 3},
    Part{ScenePart::radius, Subject::sphere, "radius", 1},
    Part{ScenePart::A, Subject::triangle, "A", 3},
    Part{ScenePart::B, Subject::triangle, "B", 3},
    Part{ScenePart::C, Subject::triangle, "C", 3},
    Part{ScenePart::cylinder_center, Subject::cylinder, "cylinder center", 3},
    Part{ScenePart::cylinder_radius, Subject::cylinder, "cylinder radius", 1},
    Part{ScenePart::cylinder_height, Subject::cylinder, "cylinder height", 1},
    Part{ScenePart::pixel, Subject::camera, "pixel", 2},
};
static_assert(std::ranges::equal(parts, all_parts, {}, &Part::part), "a row for each part, in the enum's order");

constexpr const Part& row_of(ScenePart part) {
    return parts.at(static_cast<std::size_t>(part));
}

/// Calls visit(place) with the part's place in each of the scenes: a vector, a number or the pixel.
template <class Visit, class... Scenes>
void visit_part(ScenePart part, const Visit& visit, Scenes&... scenes) {
    switch (part) {
        case ScenePart::eye: return visit(scenes.camera.eye...);
        case ScenePart::lookat: return visit(scenes.camera.lookat...);
        case ScenePart::vup: return visit(scenes.camera.vup...);
        case ScenePart::center: return visit(scenes.spheres.front().center...);
        case ScenePart::radius: return visit(scenes.spheres.front().radius...);
        case ScenePart::A: return visit(scenes.triangles.front().A...);
        case ScenePart::B: return visit(scenes.triangles.front().B...);
        case ScenePart::C: return visit(scenes.triangles.front().C...);
        case ScenePart::cylinder_center: return visit(scenes.cylinders.front().center...);
        case ScenePart::cylinder_radius: return visit(scenes.cylinders.front().radius...);
        case ScenePart::cylinder_height: return visit(scenes.cylinders.front().height...);
        case ScenePart::pixel: return visit(scenes.pixel...);
    }
}

struct Reader {
    std::array<double, 3>& numbers;
    void operator()(const Vec3<Decimal>& p) const { numbers = {p.x.to_double(), p.y.to_double(), p.z.to_double()}; }
    void operator()(const Decimal& x) const { numbers[0] = x.to_double(); }
    void operator()(const Pixel& pixel) const {
        numbers = {static_cast<double>(pixel.x), static_cast<double>(pixel.y), 0};
    }
};

struct Writer {
    const std::array<Decimal, 3>& numbers;
    void operator()(Vec3<Decimal>& p) const { p = {numbers[0], numbers[1], numbers[2]}; }
    void operator()(Decimal& x) const { x = numbers[0]; }
    void operator()(Pixel& pixel) const {
        pixel = {static_cast<int>(numbers[0].to_double()), static_cast<int>(numbers[1].to_double())};
    }
};

}  // namespace

std::string_view to_string(ScenePart part) {
    return row_of(part).name;
}

reference::Subject subject_of(ScenePart part) {
    return row_of(part).subject;
}

std::size_t size_of(ScenePart part) {
    return row_of(part).size;
}

std::array<double, 3> value_of(const DecimalScene& scene, ScenePart part) {
    std::array<double, 3> numbers{};
    visit_part(part, Reader{numbers}, scene);
    return numbers;
}

void copy_part(DecimalScene& to, const DecimalScene& from, ScenePart part) {
    visit_part(
        part, [](auto& place, const auto& value) { place = value; }, to, from);
}

void set_part(DecimalScene& scene, ScenePart part, const std::array<Decimal, 3>& numbers) {
    visit_part(part, Writer{numbers}, scene);
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
