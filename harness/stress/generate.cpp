#include "harness/stress/generate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "harness/source/scene/part_name.h"
#include "harness/stress/recipe.h"
#include "reference/stages/scene_numbers.h"
#include "reference/toml/assignment_error.h"
#include "reference/toml/scene_toml.h"

namespace harness::stress {
namespace {

using reference::Assignment;

/// Whether the shortest decimal that reads back as this double equals it exactly.
bool is_short(double x) {
    constexpr double largest = 1e6, parts = 256;
    return std::abs(x) < largest && x * parts == std::round(x * parts);
}
bool is_short(const Point& p) {
    return is_short(p.x) && is_short(p.y) && is_short(p.z);
}

Stage stage_of(const Assignment& assignment, reference::PixelConvention convention, const PartSet& located) {
    Stage stage{variants::in_double(assignment.scene), convention, &located, {}};
    stage.follow_camera();
    const auto exact =
        reference::answer_camera(reference::certified_scene(reference::rational_scene(assignment.scene)), convention);
    const reference::Enclosure S[] = {exact.P_WCS.x.enclosure(), exact.P_WCS.y.enclosure(), exact.P_WCS.z.enclosure()};
    stage.ray.P_WCS = {S[0].nearest, S[1].nearest, S[2].nearest};
    const bool is_double = std::ranges::all_of(S, [](const auto& x) { return x.lo == x.hi; });
    stage.is_exact = is_double && is_short(stage.ray.P_WCS) && is_short(stage.scene.camera.eye);
    return stage;
}

/// The recipes about one kind of object, or about the ray.
struct Recipes {
    std::optional<reference::Subject> about;
    std::vector<HardRecipe> list;
};

/// In the order of the report. A scene's seed is the number of its recipe, so the camera's recipes must stay after
/// those of the first two kinds of object.
std::vector<Recipes> all_recipes() {
    std::vector<Recipes> all;
    reference::for_each_object([&]<reference::Subject object>() { all.push_back({object, recipes<object>()}); });
    constexpr std::ptrdiff_t before_camera = 2;
    all.insert(all.begin() + before_camera, {std::nullopt, recipes<reference::Subject::camera>()});
    return all;
}

/// Names the needed parts that were not located; empty if all were.
std::string missing_parts(const HardRecipe& recipe, std::optional<reference::Subject> about, const PartSet& located) {
    std::vector<ScenePart> parts = about ? source::parts_of(*about) : std::vector<ScenePart>();
    parts.insert(parts.end(), recipe.camera.begin(), recipe.camera.end());
    std::vector<std::string_view> names;
    for (const ScenePart part : parts) {
        if (!located.contains(part)) names.push_back(to_string(part));
    }
    return names.empty() ? "" : fmt::format("these were not found in the source: {}", fmt::join(names, ", "));
}

Scene with_moved_objects_alone(Scene scene) {
    reference::for_each_kind(
        [](reference::Subject /*kind*/, auto& objects) {
            if (!objects.empty()) objects.resize(1);
        },
        scene);
    return scene;
}

/// Whether the questions are about another object of this kind than the moved one: they are about the one that the ray
/// hits first.
bool asked_of_another(reference::Subject kind, const Scene& scene, reference::PixelConvention convention) {
    const auto boundaries = {reference::Boundary::positive, reference::Boundary::nonnegative};
    return std::ranges::any_of(boundaries, [&](reference::Boundary boundary) {
        return reference::asked_index(kind, reference::answer_scene(scene, convention, boundary)) != 0;
    });
}

/// Sets the scene of `hard`, or `why_not` if it cannot be made.
void draw_scene(HardScene& hard, const HardRecipe& recipe, const Stage& stage, std::uint64_t seed) {
    Draw draw(seed);
    std::optional<Scene> best;
    double most = 0;
    const char* not_allowed = "not possible with this assignment's ray and window";
    hard.why_not = not_allowed;
    for (int i = 0; i < recipe.attempts; ++i) {
        Stage drawn = stage;
        recipe.draw(drawn, draw);
        const Answers answers = reference::answer_scene(with_moved_objects_alone(drawn.scene), stage.convention,
                                                        reference::Boundary::nonnegative);
        const double worth = recipe.worth(answers, drawn.scene);
        if (!(worth > most)) continue;
        if (hard.about && asked_of_another(*hard.about, drawn.scene, stage.convention)) {
            hard.why_not = fmt::format("the ray would hit another {} of this assignment first", to_string(*hard.about));
            continue;
        }
        most = worth;
        best = std::move(drawn.scene);
    }
    if (!best) return;
    try {
        hard.scene = reference::check_scene(variants::in_decimal(*best), "a hard scene");
        hard.why_not.clear();
    } catch (const reference::AssignmentError&) {
        hard.why_not = not_allowed;
    }
}

}  // namespace

std::vector<HardScene> hard_scenes(const Assignment& assignment, reference::PixelConvention convention,
                                   const PartSet& located) {
    const Stage stage = stage_of(assignment, convention, located);
    std::vector<HardScene> scenes;
    std::uint64_t seed = 0;
    for (const auto& [about, recipes] : all_recipes()) {
        for (const HardRecipe& recipe : recipes) {
            ++seed;
            if (about && reference::count_of(*about, stage.scene) == 0) continue;
            HardScene hard{std::string(recipe.name), recipe.asks, about};
            hard.why_not = missing_parts(recipe, about, located);
            if (hard.why_not.empty() && recipe.needs_exact && !stage.is_exact)
                hard.why_not = "no point of this ray is exact in decimals";
            if (hard.why_not.empty()) draw_scene(hard, recipe, stage, seed);
            scenes.push_back(std::move(hard));
        }
    }
    return scenes;
}

std::size_t most_hard_scenes() {
    std::size_t count = 0;
    for (const Recipes& recipes : all_recipes()) count += recipes.list.size();
    return count;
}

}  // namespace harness::stress
