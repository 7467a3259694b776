// The parts of a scene and their numbers.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include "harness/source/code/constant.h"
#include "reference/numbers/decimal.h"
#include "reference/stages/scene.h"

namespace harness::source {

/// A part that other scenes may change: one of the camera's, or a number, a point or a vertex of an object, counted
/// over the fields of its kind. With several objects of a kind, it means the first one's.
struct ScenePart {
    reference::Subject subject = reference::Subject::camera;
    std::uint8_t place = 0;  ///< among the parts of its subject

    friend auto operator<=>(const ScenePart&, const ScenePart&) = default;
};

namespace part {
inline constexpr ScenePart eye{reference::Subject::camera, 0};
inline constexpr ScenePart lookat{reference::Subject::camera, 1};
inline constexpr ScenePart vup{reference::Subject::camera, 2};
inline constexpr ScenePart pixel{reference::Subject::camera, 3};
namespace sphere {
inline constexpr ScenePart center{reference::Subject::sphere, 0};
inline constexpr ScenePart radius{reference::Subject::sphere, 1};
}  // namespace sphere
namespace triangle {
inline constexpr ScenePart A{reference::Subject::triangle, 0};
inline constexpr ScenePart B{reference::Subject::triangle, 1};
inline constexpr ScenePart C{reference::Subject::triangle, 2};
}  // namespace triangle
namespace cylinder {
inline constexpr ScenePart center{reference::Subject::cylinder, 0};
inline constexpr ScenePart radius{reference::Subject::cylinder, 1};
inline constexpr ScenePart height{reference::Subject::cylinder, 2};
}  // namespace cylinder
}  // namespace part

/// Every part: the camera's, those of the objects in the order of the tables, the pixel.
const std::vector<ScenePart>& all_parts();

/// The parts of a kind of object, in the order of its fields.
const std::vector<ScenePart>& parts_of(reference::Subject object);

/// The parts after an object's point, if they are all numbers, such as a sphere's radius; else none.
std::vector<ScenePart> numbers_behind(ScenePart point);

using PartSet = std::set<ScenePart>;

using DecimalScene = reference::Scene<reference::Decimal>;

/// Whether the scene has the part: a scene without a sphere has no center.
template <class S>
bool has_part(const reference::Scene<S>& scene, ScenePart part) {
    return part.subject == reference::Subject::camera || reference::count_of(part.subject, scene) > 0;
}

/// How many numbers the part has: 2 for the pixel, 1 for a radius or a height, 3 for a point. 0 if there is no such
/// part.
std::size_t size_of(ScenePart part);

/// The part's numbers, as many as size_of returns; the rest is 0. The scene must have the part.
std::array<double, 3> value_of(const DecimalScene& scene, ScenePart part);

/// Copies the part from `from` to `to`. Both must have the part.
void copy_part(DecimalScene& to, const DecimalScene& from, ScenePart part);

/// Sets the part, which the scene must have, to as many of the numbers as size_of returns; a pixel's are whole.
void set_part(DecimalScene& scene, ScenePart part, const std::array<reference::Decimal, 3>& numbers);

/// A constant in the source that is a number of the scene.
struct SceneLiteral {
    std::size_t begin = 0;  ///< in the source
    std::size_t end = 0;
    ScenePart part;
    std::size_t component = 0;  ///< of the part; 0 for a splat
    bool splat = false;
    double offset = 0;  ///< added to the number in the source: 0.5 in 150.5 for a pixel's center
    Constant constant{};
    bool in_define = false;
};

}  // namespace harness::source
