#include "harness/prepare/trial_scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "harness/source/scene/scene_part.h"
#include "reference/accuracy/measure/assignment_accuracy.h"
#include "reference/toml/assignment_error.h"
#include "reference/toml/scene_toml.h"

namespace harness::prepare {
namespace {

using reference::Assignment;
using reference::Decimal;
using source::DecimalScene;
using source::ScenePart;

int objects_hit(const reference::Decisions& decisions) {
    return static_cast<int>(std::ranges::count_if(decisions.objects, [](const auto& decided) {
        return decided.second == "hit" || decided.second == "boundary";
    }));
}

bool hangs_on_rounding(const Assignment& assignment, const reference::AnswerKey& key) {
    return std::ranges::any_of(
        reference::accuracy::decisions_of(assignment, key.canonical),
        [](const reference::accuracy::Decision& decision) { return decision.hangs_on_rounding(); });
}

}  // namespace

std::size_t worth(const ShownMistakes& mistakes) {
    return 2 * mistakes.shown.size() + mistakes.told_apart();
}

TrialScenes::TrialScenes(const Assignment& assignment) : assignment_(assignment) {
    const reference::AnswerKey key = reference::make_key(assignment, reference::Precision::certified);
    hit_before_ = objects_hit(key.decisions);
    own_mistakes_ = shown_mistakes(assignment, key);
    own_worth_ = hangs_on_rounding(assignment, key) ? 0 : worth(own_mistakes_);
}

DecimalScene TrialScenes::changed(DecimalScene scene) {
    scene.pixel = {near(assignment_.scene.pixel.x, scene.window.width),
                   near(assignment_.scene.pixel.y, scene.window.height)};
    for (int n = draw_.whole(0, 2); n > 0; --n) change_part(scene);
    return scene;
}

/// At most a fifth of the window away, because the objects are near the assignment's pixel.
int TrialScenes::near(int pixel, int count) {
    const int reach = std::max(1, count / 5);
    return draw_.whole(std::max(0, pixel - reach), std::min(count - 1, pixel + reach));
}

/// Moves one number of a part in steps of 1/2.
void TrialScenes::change_part(DecimalScene& scene) {
    const std::vector<ScenePart>& parts = source::all_parts();
    const ScenePart part = parts.at(static_cast<std::size_t>(draw_.whole(0, static_cast<int>(parts.size()) - 1)));
    if (part == source::part::pixel || !source::has_part(scene, part)) return;
    const std::array<double, 3> values = source::value_of(scene, part);
    const auto moved = static_cast<std::size_t>(draw_.whole(0, static_cast<int>(source::size_of(part)) - 1));
    std::array<Decimal, 3> numbers;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const double x = values.at(i) + (i == moved ? 0.5 * draw_.whole(-3, 3) : 0.0);
        numbers.at(i) = Decimal::parse(fmt::format("{:g}", x + 0.0)).value();
    }
    source::set_part(scene, part, numbers);
}

std::optional<ShownMistakes> TrialScenes::try_scene(const DecimalScene& scene) const {
    Assignment trial = assignment_;
    try {
        trial.scene = reference::check_scene(scene, "trial");
        const reference::AnswerKey key = reference::make_key(trial, reference::Precision::certified);
        if (objects_hit(key.decisions) < hit_before_ || hangs_on_rounding(trial, key)) return std::nullopt;
        return shown_mistakes(trial, key);
    } catch (const reference::AssignmentError&) {
    } catch (const std::domain_error&) {
    }
    return std::nullopt;
}

}  // namespace harness::prepare
