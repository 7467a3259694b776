// How far a correct program may be off, item by item: the distance from the key to the farthest value that any of the
// usual formulations (formulations.h) may give in float32 or in anything finer, for any roundings.
#pragma once

#include <compare>
#include <map>
#include <utility>

#include "reference/key/object_programs.h"
#include "reference/numbers/interval.h"
#include "reference/numbers/rational.h"
#include "reference/stages/scene_answers.h"

namespace reference {

/// The choices of the exact decisions: the items' objects, the root and the part. An allowance does not cover a program
/// that decides otherwise; the boundary policy and follow-through from its own values do.
struct Branches {
    SphereBranch sphere = {};
    TriangleBranch triangle = {};
    CylinderBranch cylinder = {};

    friend auto operator<=>(const Branches&, const Branches&) = default;
};

/// The bounds of a scene's correct programs.
class CorrectPrograms {
  public:
    explicit CorrectPrograms(Scene<Rational> scene) : scene_(std::move(scene)) {}
    const Scene<Rational>& scene() const { return scene_; }
    /// For every item with numbers. Remembers computed values.
    const std::map<ItemId, ItemBounds>& bounds(PixelConvention convention, const Branches& branches);

  private:
    Scene<Rational> scene_;
    std::map<std::pair<PixelConvention, Branches>, std::map<ItemId, ItemBounds>> known_;
};

}  // namespace reference
