#include "harness/stress/generate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

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
    Stage stage{variants::in_double(assignment.scene), convention, {}, {}, false};
    for (const ScenePart part : source::all_parts()) {
        if (located.contains(part) && source::has_part(assignment.scene, part)) stage.located.insert(part);
    }
    stage.ray = reference::answer_camera(stage.scene, convention);
    const auto exact =
        reference::answer_camera(reference::certified_scene(reference::rational_scene(assignment.scene)), convention);
    const reference::Enclosure S[] = {exact.P_WCS.x.enclosure(), exact.P_WCS.y.enclosure(), exact.P_WCS.z.enclosure()};
    stage.ray.P_WCS = {S[0].nearest, S[1].nearest, S[2].nearest};
    const bool is_double = std::all_of(std::begin(S), std::end(S), [](const auto& x) { return x.lo == x.hi; });
    stage.is_exact = is_double && is_short(stage.ray.P_WCS) && is_short(stage.scene.camera.eye);
    return stage;
}

bool has_all(const Scene& scene, const std::vector<ScenePart>& parts) {
    return std::ranges::all_of(parts, [&](ScenePart part) { return source::has_part(scene, part); });
}

/// Says which of the needed parts were not located; empty if all were.
std::string missing_parts(const HardRecipe& recipe, const PartSet& located) {
    std::vector<std::string_view> names;
    for (const ScenePart part : recipe.needs) {
        if (!located.contains(part)) names.push_back(to_string(part));
    }
    return names.empty() ? "" : fmt::format("the source was not found to state {}", fmt::join(names, ", "));
}

Scene with_moved_objects_alone(Scene scene) {
    reference::for_each_kind(
        [](reference::Subject /*kind*/, auto& objects) {
            if (!objects.empty()) objects.resize(1);
        },
        scene);
    return scene;
}

/// The kind of a moved object that the questions are not about. They are about the object that the ray hits first,
/// which may be a different one. Empty if they are about those that were moved.
std::optional<reference::Subject> asked_of_another(const HardRecipe& recipe, const Scene& scene,
                                                   reference::PixelConvention convention) {
    for (const auto boundary : {reference::Boundary::positive, reference::Boundary::nonnegative}) {
        const Answers answers = reference::answer_scene(scene, convention, boundary);
        for (const ScenePart part : recipe.needs) {
            if (reference::asked_index(part.subject, answers) != 0) return part.subject;
        }
    }
    return std::nullopt;
}

/// Sets the scene of `hard`, or `why_not` if it can't be made.
void draw_scene(HardScene& hard, const HardRecipe& recipe, const Stage& stage, std::uint64_t seed) {
    Draw draw(seed);
    std::optional<Scene> best;
    double most = 0;
    hard.why_not = "this assignment's ray and window do not allow it";
    for (int i = 0; i < recipe.attempts; ++i) {
        Scene scene = recipe.draw(stage, draw);
        const double worth = recipe.worth(reference::answer_scene(with_moved_objects_alone(scene), stage.convention,
                                                                  reference::Boundary::nonnegative),
                                          scene);
        if (!(worth > most)) continue;
        if (const auto other = asked_of_another(recipe, scene, stage.convention)) {
            hard.why_not = fmt::format("the ray hits another {} of this assignment first there", to_string(*other));
            continue;
        }
        most = worth;
        best = std::move(scene);
    }
    if (!best) return;
    try {
        hard.scene = reference::check_scene(variants::in_decimal(*best), "a hard scene");
        hard.why_not.clear();
    } catch (const reference::AssignmentError&) {
        hard.why_not = "this assignment's ray and window do not allow it";
    }
}

struct Recipes {
    std::optional<reference::Subject> about;
    std::vector<HardRecipe> list;
};

/// In the order of the report. A scene's seed is its recipe's number, so that the camera's stay behind those of the
/// first two kinds of object.
std::vector<Recipes> all_recipes() {
    std::vector<Recipes> all;
    reference::for_each_object([&]<reference::Subject object>() { all.push_back({object, recipes<object>()}); });
    constexpr std::ptrdiff_t before_camera = 2;
    all.insert(all.begin() + before_camera, {std::nullopt, recipes<reference::Subject::camera>()});
    return all;
}

}  // namespace

Point across(const Stage& stage, Draw& draw) {
    return variants::across(stage.ray.V, draw);
}

std::vector<HardScene> hard_scenes(const Assignment& assignment, reference::PixelConvention convention,
                                   const PartSet& located) {
    const Stage stage = stage_of(assignment, convention, located);
    std::vector<HardScene> scenes;
    std::uint64_t seed = 0;
    for (const auto& [about, recipes] : all_recipes()) {
        for (const HardRecipe& recipe : recipes) {
            ++seed;
            if (!has_all(stage.scene, recipe.needs)) continue;
            HardScene hard{std::string(recipe.name), recipe.asks, about};
            hard.why_not = missing_parts(recipe, located);
            if (hard.why_not.empty() && recipe.needs_exact && !stage.is_exact)
                hard.why_not = "no point of this ray can be written exactly in decimals";
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
