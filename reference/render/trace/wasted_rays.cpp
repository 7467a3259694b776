#include "reference/render/trace/wasted_rays.h"

#include <limits>
#include <numeric>

#include "reference/render/trace/trace.h"

namespace reference::render {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr std::uint64_t none = std::numeric_limits<std::uint64_t>::max();

/// Lets the ray with the number `endless_one` bring endless light.
template <class Objects>
class DoubtedRays {
  public:
    explicit DoubtedRays(std::uint64_t endless_one) : endless_one_(endless_one) {}

    /// How many rays there were beyond the camera's.
    std::uint64_t count() const { return count_; }

    template <class AnyRay>
    Nearest first_hit(const PreparedScene& scene, const AnyRay& ray) {
        return Objects::first_hit(scene, ray);
    }
    Color let_through(const PreparedScene& scene, const SurfaceRay& ray, double end, const Color& light) {
        if (is_before_end(scene, ray, hit_own(scene, ray), ray.start.object, end)) {
            ++count_;
            return {0, 0, 0};
        }
        if (count_++ == endless_one_) return scaled(light, endless);
        return Objects::is_blocked(scene, ray, end) ? Color(0, 0, 0) : light;
    }
    Color brought(const Color& color, std::uint64_t RayCounts::* /*kind*/) {
        return count_++ == endless_one_ ? Color(endless, endless, endless) : color;
    }

  private:
    std::uint64_t endless_one_;
    std::uint64_t count_ = 0;
};

bool is_endless(const Color& color) {
    return color.x == endless || color.y == endless || color.z == endless;
}

template <class Objects>
WastedRays wasted_rays_over(const PreparedScene& scene, std::uint64_t most) {
    using Rays = DoubtedRays<Objects>;
    const Eye& eye = scene.eye;
    const std::uint64_t columns = eye.sample_columns.size();
    const std::uint64_t samples = columns * eye.sample_rows.size();
    // Steps of some 0.618 of the samples spread any number of them evenly, and visit each once.
    auto step = static_cast<std::uint64_t>(0.618 * static_cast<double>(samples)) + 1;
    while (std::gcd(step, samples) != 1) ++step;
    WastedRays result;
    // Each ray that is looked at costs all rays of its sample, which may be tens of thousands.
    constexpr std::uint64_t most_of_sample = 100;
    std::uint64_t traced = 0, sample = 0;
    for (std::uint64_t i = 0; i < samples && result.looked_at < most && traced / most_of_sample < most;
         ++i, sample = (sample + step) % samples) {
        const RowOfRays row = eye.row(eye.sample_rows[sample / columns]);
        const double x = eye.sample_columns[sample % columns];
        Tracer<all_effects, Rays> plain(scene, Rays(none));
        plain.camera_color(row, x);
        const std::uint64_t rays = plain.rays().count();
        const std::uint64_t apart = rays / most_of_sample + 1;
        for (std::uint64_t ray = i % apart; ray < rays && traced / most_of_sample < most; ray += apart) {
            traced += rays;
            Tracer<all_effects, Rays> doubted(scene, Rays(ray));
            ++result.looked_at;
            if (!is_endless(doubted.camera_color(row, x))) ++result.wasted;
        }
    }
    return result;
}

}  // namespace

WastedRays wasted_rays(const PreparedScene& scene, std::uint64_t most) {
    return scene.tree ? wasted_rays_over<ObjectTree>(scene, most) : wasted_rays_over<ObjectList>(scene, most);
}

}  // namespace reference::render
