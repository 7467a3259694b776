// Random scenes near an assignment's own, and the mistakes that each of them reveals.
#pragma once

#include <cstdint>
#include <optional>

#include "harness/prepare/shown_mistakes.h"
#include "harness/variants/random/draw.h"
#include "reference/toml/assignment.h"

namespace harness::prepare {

/// How good a scene is. Revealing a mistake counts more than distinguishing it from others.
std::size_t worth(const ShownMistakes& mistakes);

class TrialScenes {
  public:
    /// `assignment` must outlive it.
    explicit TrialScenes(const reference::Assignment& assignment);

    /// Starts again. The same seed gives the same scenes on every machine.
    void begin(std::uint64_t seed) { draw_ = variants::Draw(seed); }

    /// The worth of the assignment's own scene; 0 if it has a borderline hit, so that any scene without one is better.
    std::size_t own_worth() const { return own_worth_; }
    const ShownMistakes& own_mistakes() const { return own_mistakes_; }

    /// The scene with another pixel near the assignment's, and with up to two numbers moved in steps of 1/2.
    source::DecimalScene changed(source::DecimalScene scene);

    /// Empty for a scene that can't be marked, has fewer hits than the assignment's, or has a decision that rounding in
    /// float may change.
    std::optional<ShownMistakes> try_scene(const source::DecimalScene& scene) const;

  private:
    int near(int pixel, int count);
    void change_part(source::DecimalScene& scene);

    const reference::Assignment& assignment_;
    variants::Draw draw_{0};
    int hit_before_ = 0;
    ShownMistakes own_mistakes_;
    std::size_t own_worth_ = 0;
};

}  // namespace harness::prepare
