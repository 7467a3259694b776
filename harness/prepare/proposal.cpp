#include "harness/prepare/proposal.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "harness/prepare/trial_scenes.h"
#include "harness/source/scene/part_name.h"
#include "harness/source/scene/scene_part.h"

namespace harness::prepare {
namespace {

/// The parts in which the second scene differs from the first.
std::vector<std::string> changes_between(const source::DecimalScene& own, const source::DecimalScene& other) {
    std::vector<std::string> list;
    for (const source::ScenePart part : source::all_parts()) {
        if (!source::has_part(own, part)) continue;
        const std::string before = source::describe(own, part);
        const std::string after = source::describe(other, part);
        if (before != after) list.push_back(fmt::format("{} (was {})", after, before));
    }
    return list;
}

}  // namespace

Proposal propose(const reference::Assignment& assignment, const Search& search) {
    TrialScenes trials(assignment);
    trials.begin(search.seed);
    Proposal best{assignment.scene, {}, trials.own_mistakes(), trials.own_mistakes()};
    std::size_t best_worth = trials.own_worth();
    bool is_own = true;
    for (int step = 0; step < search.steps; ++step) {
        if (search.progress) search.progress(static_cast<double>(step) / search.steps);
        // Every other step starts again from the assignment's scene, because the best changes may not be those of
        // `best`.
        const source::DecimalScene scene = trials.changed(is_own || step % 2 == 0 ? assignment.scene : best.scene);
        std::optional<ShownMistakes> shown = trials.try_scene(scene);
        if (!shown || worth(*shown) <= best_worth) continue;
        best_worth = worth(*shown);
        best.scene = scene;
        best.mistakes = std::move(*shown);
        is_own = false;
    }
    best.changes = changes_between(assignment.scene, best.scene);
    return best;
}

}  // namespace harness::prepare
