// The numbers of a scene, by what they are.
#pragma once

#include <array>
#include <bitset>
#include <string>
#include <string_view>

#include "reference/decimal.h"
#include "reference/scene.h"

namespace harness::variants {

/// What a variant may change. Of several spheres or triangles the first one.
enum class ScenePart { eye, lookat, vup, center, radius, A, B, C, pixel };

inline constexpr std::array all_parts{ScenePart::eye,    ScenePart::lookat, ScenePart::vup,
                                      ScenePart::center, ScenePart::radius, ScenePart::A,
                                      ScenePart::B,      ScenePart::C,      ScenePart::pixel};

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

/// The handout's word for it, e.g. "eye" or "A".
std::string_view to_string(ScenePart part);

using DecimalScene = reference::Scene<reference::Decimal>;

/// Whether the scene has it: one without a sphere has no center.
bool has_part(const DecimalScene& scene, ScenePart part);

/// How many numbers it is: 3, 2 for the pixel, 1 for the radius.
std::size_t size_of(ScenePart part);

/// Its numbers, as many as size_of says, the others 0. The scene must have it.
std::array<double, 3> value_of(const DecimalScene& scene, ScenePart part);

/// `to` with the part as `from` has it. Both must have it.
void copy_part(DecimalScene& to, const DecimalScene& from, ScenePart part);

/// "eye = (0, 0, 4)"
std::string describe(const DecimalScene& scene, ScenePart part);

}  // namespace harness::variants
