// Which parts of a scene the names of a source mean, where a name may mean several.
#pragma once

#include <string_view>
#include <vector>

#include "harness/source/scene/scene_part.h"
#include "harness/source/scene/stated_numbers.h"

namespace harness::source {

/// Those of an object's parts that are points.
std::vector<ScenePart> points_of(reference::Subject object);

/// The scene and the vectors must outlive it.
class MeantParts {
  public:
    MeantParts(const DecimalScene& scene, const std::vector<StatedVector>& vectors)
        : scene_(scene), vectors_(vectors) {}

    /// Whether the scene has the part, and the name may mean it.
    bool is_called(std::string_view name, ScenePart part) const;

    /// Whether the part is a point of the scene with this value.
    bool is_point_of_scene(ScenePart part, const std::array<double, 3>& value) const;

    /// The parts that a vector's name means. Where it may mean several, its words and its value decide, then the other
    /// names.
    std::vector<ScenePart> parts_of_point(const StatedVector& vector) const;

  private:
    std::vector<ScenePart> first_called(std::string_view name, const std::vector<ScenePart>& parts) const;
    ScenePart likeliest(const std::vector<ScenePart>& parts) const;
    bool is_any_called(ScenePart part) const;

    const DecimalScene& scene_;
    const std::vector<StatedVector>& vectors_;
};

}  // namespace harness::source
