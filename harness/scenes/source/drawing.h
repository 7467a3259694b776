// Random numbers for scenes, the same on every machine.
#pragma once

#include <cstdint>

#include "harness/scenes/source/scene_part.h"
#include "reference/stages/scene_numbers.h"

namespace harness::scenes {

/// splitmix64 (Steele, Lea and Flood 2014), because the standard library's distributions differ between machines.
class Draw {
  public:
    explicit Draw(std::uint64_t seed) : state_(seed) {}

    /// A whole number in [least, most].
    int whole(int least, int most) {
        return least + static_cast<int>(next() % static_cast<std::uint64_t>(most - least + 1));
    }
    double between(double least, double most) {
        return least + (most - least) * static_cast<double>(next() >> 11U) * 0x1p-53;
    }
    reference::Vec3<double> vector(int size) {
        const double x = whole(-size, size);
        const double y = whole(-size, size);
        const double z = whole(-size, size);
        return {x, y, z};
    }

  private:
    std::uint64_t next() {
        state_ += 0x9E3779B97F4A7C15U;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
        return z ^ (z >> 31U);
    }

    std::uint64_t state_;
};

/// Rounds to whole numbers, which every program can state. Never gives -0.
reference::Vec3<double> rounded(const reference::Vec3<double>& p);

/// A random unit vector perpendicular to `V`.
reference::Vec3<double> across(const reference::Vec3<double>& V, Draw& draw);

using reference::in_double;
/// Writes each number with the fewest digits that give the same double.
DecimalScene in_decimal(const reference::Scene<double>& scene);

}  // namespace harness::scenes
