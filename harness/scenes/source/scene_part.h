// The parts of a scene and their numbers.
#pragma once

#include <array>
#include <bitset>
#include <string>
#include <string_view>

#include "reference/numbers/decimal.h"
#include "reference/stages/scene.h"

namespace harness::scenes {

/// The parts that other scenes may change. With several spheres, triangles or cylinders, the first. `center` and
/// `radius` are the sphere's.
enum class ScenePart {
    eye,
    lookat,
    vup,
    center,
    radius,
    A,
    B,
    C,
    cylinder_center,
    cylinder_radius,
    cylinder_height,
    pixel
};

inline constexpr auto all_parts = [] {
    std::array<ScenePart, static_cast<std::size_t>(ScenePart::pixel) + 1> parts{};
    for (std::size_t i = 0; i < parts.size(); ++i) parts.at(i) = static_cast<ScenePart>(i);
    return parts;
}();

class PartSet {
  public:
    void insert(ScenePart part) { bits_.set(static_cast<std::size_t>(part)); }
    void erase(ScenePart part) { bits_.reset(static_cast<std::size_t>(part)); }
    bool contains(ScenePart part) const { return bits_.test(static_cast<std::size_t>(part)); }
    bool empty() const { return bits_.none(); }
    unsigned long number() const { return bits_.to_ulong(); }
    friend bool operator==(const PartSet&, const PartSet&) = default;

  private:
    std::bitset<all_parts.size()> bits_;
};

/// The handout's word for the part, e.g. "eye", "A" or "cylinder radius".
std::string_view to_string(ScenePart part);

using DecimalScene = reference::Scene<reference::Decimal>;

/// The kind of object that has the part, or the camera.
reference::Subject subject_of(ScenePart part);

/// Whether the scene has the part: a scene without a sphere has no center.
template <class S>
bool has_part(const reference::Scene<S>& scene, ScenePart part) {
    const reference::Subject subject = subject_of(part);
    return subject == reference::Subject::camera || reference::count_of(subject, scene) > 0;
}

/// How many numbers the part has: 2 for the pixel, 1 for a radius or a height, else 3.
std::size_t size_of(ScenePart part);

/// The part's numbers, as many as size_of says; the rest is 0. The scene must have the part.
std::array<double, 3> value_of(const DecimalScene& scene, ScenePart part);

/// Copies the part from `from` to `to`. Both must have the part.
void copy_part(DecimalScene& to, const DecimalScene& from, ScenePart part);

/// Sets the part, which the scene must have, to as many of the numbers as size_of says; a pixel's are whole.
void set_part(DecimalScene& scene, ScenePart part, const std::array<reference::Decimal, 3>& numbers);

/// "eye = (0, 0, 4)"
std::string describe(const DecimalScene& scene, ScenePart part);

}  // namespace harness::scenes
