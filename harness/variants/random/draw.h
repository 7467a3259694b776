// Random numbers for scenes, the same on every machine.
#pragma once

#include <cstdint>

#include "harness/source/scene/scene_part.h"
#include "reference/numbers/splitmix.h"
#include "reference/stages/scene_numbers.h"

namespace harness::variants {

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
    std::uint64_t next() { return reference::next_random_bits(state_); }

    std::uint64_t state_;
};

/// Rounds to whole numbers, which every program can write. Never gives -0.
reference::Vec3<double> rounded(const reference::Vec3<double>& p);

/// A random unit vector perpendicular to `V`.
reference::Vec3<double> across(const reference::Vec3<double>& V, Draw& draw);

using reference::in_double;
/// Writes each number with the fewest digits that give the same double.
source::DecimalScene in_decimal(const reference::Scene<double>& scene);

}  // namespace harness::variants
