#include "harness/mark/diagnose/interval_scene.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "reference/stages/scene_answers.h"
#include "reference/stages/scene_numbers.h"

namespace harness {
namespace {

using reference::Boundary;
using reference::Vec3;

/// The largest number of the scene, at least 1.
class Size {
  public:
    explicit Size(const reference::Scene<double>& scene) {
        reach(scene.camera.eye);
        reference::for_each_kind(
            [&](reference::Subject /*kind*/, const auto& objects) {
                for (const auto& object : objects)
                    reference::for_each_field([&](std::string_view, const auto& field) { reach(field); }, object);
            },
            scene);
    }
    double size() const { return size_; }

  private:
    void reach(double x) { size_ = std::max(size_, std::abs(x)); }
    void reach(const Vec3<double>& p) { reach(p.x), reach(p.y), reach(p.z); }
    void reach(const reference::Vertices<const Vec3<double>>& vertices) {
        for (const Vec3<double>* vertex : vertices) reach(*vertex);
    }

    double size_ = 1;
};

}  // namespace

IntervalScene real_scene(const reference::Assignment& assignment, const reference::Reading& reading) {
    const auto scene = reference::in_double(assignment.scene);
    const auto answers = reference::answer_scene(scene, reading.convention, reading.boundary);
    IntervalScene real{reference::convert_scene<Interval>(scene, [](double x) { return Interval(x); }), {}};
    reference::for_each_kind(
        [&](reference::Subject kind, auto& objects) {
            if (!objects.empty()) std::swap(objects.front(), objects[reference::asked_index(kind, answers)]);
        },
        real);
    real.size = Size(scene).size();
    using reference::BoundaryPolicy;
    if (assignment.rubric.boundary != BoundaryPolicy::positive) real.boundaries.push_back(Boundary::nonnegative);
    if (assignment.rubric.boundary != BoundaryPolicy::nonnegative) real.boundaries.push_back(Boundary::positive);
    return real;
}

}  // namespace harness
