// Scenes near an assignment's own, for whoever looks for another one, and what each of them shows.
#pragma once

#include <cstdint>
#include <optional>

#include "harness/prepare/shown_mistakes.h"
#include "harness/variants/random/draw.h"
#include "reference/toml/assignment.h"

namespace harness::prepare {

/// How good a scene is. To show a mistake counts more than to tell it from others.
std::size_t worth(const ShownMistakes& mistakes);

class TrialScenes {
  public:
    /// `assignment` must outlive it.
    explicit TrialScenes(const reference::Assignment& assignment);

    /// Begins anew: the same scenes for the same seed on every machine.
    void begin(std::uint64_t seed) { draw_ = variants::Draw(seed); }

    /// The worth of the assignment's own scene; 0 if it has a boundary case, so that any scene without one is better.
    std::size_t own_worth() const { return own_worth_; }
    const ShownMistakes& own_mistakes() const { return own_mistakes_; }

    /// The scene with another pixel near the assignment's and up to two numbers moved by halves.
    source::DecimalScene changed(source::DecimalScene scene);

    /// Empty for a scene that can't be marked, in which less is hit than in the assignment's, or in which a decision
    /// hangs on a rounding in float.
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
