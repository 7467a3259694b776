#include "harness/prepare/proposal.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>

#include "harness/scenes/source/drawing.h"
#include "harness/scenes/source/scene_part.h"
#include "reference/accuracy/measure/assignment_accuracy.h"
#include "reference/toml/scene_toml.h"

namespace harness::prepare {
namespace {

using reference::Assignment;
using reference::Decimal;
using scenes::DecimalScene;
using scenes::Draw;
using scenes::ScenePart;

/// A scene that may be proposed, and what it shows.
struct Candidate {
    DecimalScene scene;
    ShownMistakes mistakes;
};

/// To show a mistake counts more than to tell it from others.
std::size_t worth(const ShownMistakes& mistakes) {
    return 2 * mistakes.shown.size() + mistakes.told_apart();
}

int objects_hit(const reference::Decisions& decisions) {
    int hit = 0;
    for (const std::string& decision : {decisions.sphere, decisions.triangle, decisions.cylinder})
        hit += decision == "hit" || decision == "boundary" ? 1 : 0;
    return hit;
}

bool hangs_on_rounding(const Assignment& assignment, const reference::AnswerKey& key) {
    return std::ranges::any_of(reference::accuracy::decisions_of(assignment, key.canonical),
                               [](const reference::accuracy::Decision& each) { return each.hangs_on_rounding(); });
}

class Searcher {
  public:
    Searcher(const Assignment& assignment, const Search& search)
        : assignment_(assignment), search_(search), draw_(search.seed) {
        const reference::AnswerKey key = reference::make_key(assignment, reference::Precision::certified);
        hit_before_ = objects_hit(key.decisions);
        best_ = {assignment.scene, shown_mistakes(assignment, key)};
        // Any scene without a boundary case is better than one with.
        best_worth_ = hangs_on_rounding(assignment, key) ? 0 : worth(best_.mistakes);
    }

    Proposal run() {
        bool is_own = true;
        for (int step = 0; step < search_.steps; ++step) {
            if (search_.progress) search_.progress(static_cast<double>(step) / search_.steps);
            // Every other step begins anew, because the best of a few changes may need none of them.
            const DecimalScene& from = is_own || step % 2 == 0 ? assignment_.scene : best_.scene;
            std::optional<Candidate> tried = try_scene(changed(from));
            if (!tried || worth(tried->mistakes) <= best_worth_) continue;
            best_ = std::move(*tried);
            best_worth_ = worth(best_.mistakes);
            is_own = false;
        }
        return {best_.scene, changes(), best_.mistakes};
    }

  private:
    DecimalScene changed(DecimalScene scene) {
        const int most = search_.pixel_only ? 0 : 2;
        scene.pixel = {near(assignment_.scene.pixel.x, scene.window.width),
                       near(assignment_.scene.pixel.y, scene.window.height)};
        for (int n = draw_.whole(0, most); n > 0; --n) change_part(scene);
        return scene;
    }

    /// A pixel's number at most a fifth of the window away, because the objects are where the assignment's pixel is.
    int near(int pixel, int count) {
        const int reach = std::max(1, count / 5);
        return draw_.whole(std::max(0, pixel - reach), std::min(count - 1, pixel + reach));
    }

    /// Moves one number of a part by a few halves.
    void change_part(DecimalScene& scene) {
        const ScenePart part = scenes::all_parts.at(
            static_cast<std::size_t>(draw_.whole(0, static_cast<int>(scenes::all_parts.size()) - 1)));
        if (part == ScenePart::pixel || !scenes::has_part(scene, part)) return;
        const std::array<double, 3> values = scenes::value_of(scene, part);
        const auto moved = static_cast<std::size_t>(draw_.whole(0, static_cast<int>(scenes::size_of(part)) - 1));
        std::array<Decimal, 3> numbers;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const double x = values.at(i) + (i == moved ? 0.5 * draw_.whole(-3, 3) : 0.0);
            numbers.at(i) = Decimal::parse(fmt::format("{:g}", x + 0.0)).value();
        }
        scenes::set_part(scene, part, numbers);
    }

    /// Empty for a scene that can't be marked, in which less is hit or that has a boundary case.
    std::optional<Candidate> try_scene(const DecimalScene& scene) const {
        Assignment trial = assignment_;
        try {
            trial.scene = reference::check_scene(scene, "proposal");
            const reference::AnswerKey key = reference::make_key(trial, reference::Precision::certified);
            if (objects_hit(key.decisions) < hit_before_ || hangs_on_rounding(trial, key)) return std::nullopt;
            return Candidate{trial.scene, shown_mistakes(trial, key)};
        } catch (const reference::AssignmentError&) {
        } catch (const std::domain_error&) {
        }
        return std::nullopt;
    }

    std::vector<std::string> changes() const {
        std::vector<std::string> list;
        for (const ScenePart part : scenes::all_parts) {
            if (!scenes::has_part(assignment_.scene, part)) continue;
            const std::string before = scenes::describe(assignment_.scene, part);
            const std::string after = scenes::describe(best_.scene, part);
            if (before != after) list.push_back(fmt::format("{}, before {}", after, before));
        }
        return list;
    }

    const Assignment& assignment_;
    const Search& search_;
    Draw draw_;
    int hit_before_ = 0;
    Candidate best_;
    std::size_t best_worth_ = 0;
};

}  // namespace

Proposal propose(const Assignment& assignment, const Search& search) {
    return Searcher(assignment, search).run();
}

}  // namespace harness::prepare
