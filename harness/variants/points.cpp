#include "harness/variants/points.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "harness/record/variants_sentences.h"
#include "harness/source/scene/part_name.h"
#include "harness/source/scene/scene_part.h"
#include "harness/text/points.h"
#include "harness/variants/rewritten/run_rewritten.h"
#include "reference/toml/assignment_error.h"

namespace harness::variants {
namespace {

double share_on_own_scene(const Score& score) {
    return score.max_points > 0 ? score.points / score.max_points : 0;
}

double share_of_points(const Graded& graded) {
    const double own = share_on_own_scene(graded.score);
    if (!graded.findings.variants) return own;
    const std::vector<VariantRun>& runs = graded.findings.variants->runs;
    const std::size_t not_tried = graded.findings.variants->not_tried.size();
    if (runs.size() + not_tried == 0) return own;
    double sum = static_cast<double>(not_tried) * own;
    for (const VariantRun& run : runs) sum += run.share;
    return sum / static_cast<double>(runs.size() + not_tried);
}

/// The eye and the objects that are the same on every scene. If they do not move, the scenes differ little. An object
/// of several points is called by its kind.
std::vector<std::string> unchanging(const VariantsReport& report) {
    const auto stays = [&](source::ScenePart part) {
        return std::ranges::find(report.not_found, to_string(part)) != report.not_found.end();
    };
    std::vector<std::string> parts;
    std::vector<std::string> objects;
    if (stays(source::part::eye)) parts.emplace_back(to_string(source::part::eye));
    for (const reference::Subject object : reference::objects) {
        std::vector<source::ScenePart> points = source::parts_of(object);
        std::erase_if(points, [](source::ScenePart part) { return source::size_of(part) != 3; });
        if (std::ranges::none_of(points, stays)) continue;
        if (points.size() == 1) {
            parts.emplace_back(to_string(points.front()));
        } else {
            objects.emplace_back(to_string(object));
        }
    }
    parts.insert(parts.end(), objects.begin(), objects.end());
    return parts;
}

/// Sentences about what the program was not tried on; empty if it was tried on every scene, with the eye and all
/// objects moved.
std::string what_was_not_tried(const Graded& graded) {
    if (!graded.findings.variants) {
        return has_right_answer(graded) ? "raygrade failed to run the program on other scenes."
                                        : "The program has no right answer, so it was not run on other scenes.";
    }
    std::vector<std::string> sentences = not_tried_sentences(*graded.findings.variants);
    const std::vector<std::string> same = unchanging(*graded.findings.variants);
    if (!same.empty())
        sentences.push_back(
            fmt::format("These were not found in its source and stayed the same: {}.", fmt::join(same, ", ")));
    return fmt::format("{}", fmt::join(sentences, " "));
}

}  // namespace

void require_variants(const reference::Assignment& assignment, int count) {
    if (assignment.rubric.variant_points == 0 || count > 0) return;
    throw reference::AssignmentError(
        fmt::format("{}: gives {} points for answers on other scenes (variant_points of [rubric]); say how many scenes "
                    "to run, e.g. --variants 4",
                    assignment.name, points_text(assignment.rubric.variant_points)));
}

void award_variant_points(std::vector<Graded>& graded, const reference::Rubric& rubric) {
    if (rubric.variant_points == 0) return;
    for (Graded& result : graded) {
        const double own = share_on_own_scene(result.score);
        const ScenesScore scenes{share_of_points(result) * rubric.variant_points, rubric.variant_points};
        result.score.variants = scenes;
        result.score.points += scenes.points;
        result.score.max_points += scenes.max_points;
        if (own == 0 || result.execution.outcome == Outcome::not_graded) continue;
        const std::string not_tried = what_was_not_tried(result);
        if (not_tried.empty()) continue;
        result.findings.flags.push_back(
            {"variants_not_tried",
             fmt::format("{0} It has {2} of the {1} points for other scenes until you review it: a scene that was not "
                         "tried counts like the assignment's own.",
                         not_tried, points_text(scenes.max_points), points_text(scenes.points))});
    }
}

}  // namespace harness::variants
