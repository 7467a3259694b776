#include "harness/variants/variant_points.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "harness/report/report.h"

namespace harness::variants {
namespace {

double share_on_own_scene(const Score& score) {
    return score.max_points > 0 ? score.points / score.max_points : 0;
}

double mean_share(const std::vector<VariantRun>& runs) {
    double sum = 0;
    for (const VariantRun& run : runs) sum += run.share;
    return sum / static_cast<double>(runs.size());
}

std::string why_not_tried(const Graded& graded) {
    if (!graded.other_scenes || graded.other_scenes->not_found.empty())
        return "Its source could not be written for other scenes";
    return fmt::format("Its source was not found to state the scene ({})",
                       fmt::join(graded.other_scenes->not_found, ", "));
}

}  // namespace

void require_variants(const reference::Assignment& assignment, int count) {
    if (assignment.rubric.variant_points == 0 || count > 0) return;
    throw reference::AssignmentError(
        fmt::format("{}: gives {} points for answers on other scenes (variant_points of [rubric]), so say on how many "
                    "each program is to run: --variants 4, for example",
                    assignment.name, report::points_text(assignment.rubric.variant_points)));
}

void award_variant_points(std::vector<Graded>& graded, const reference::Rubric& rubric) {
    if (rubric.variant_points == 0) return;
    using report::points_text;
    for (Graded& one : graded) {
        const bool tried = one.other_scenes && !one.other_scenes->runs.empty();
        const double share = tried ? mean_share(one.other_scenes->runs) : share_on_own_scene(one.score);
        const ScenesScore scenes{share * rubric.variant_points, rubric.variant_points};
        one.score.other_scenes = scenes;
        one.score.points += scenes.points;
        one.score.max_points += scenes.max_points;
        if (tried || share == 0 || one.outcome == Outcome::not_graded) continue;
        one.flags.push_back(
            {"variants_not_tried",
             fmt::format("{}, so that it has not run on any. Of the {} points for other scenes it has "
                         "{}, its share on the assignment's own scene, until a person decides.",
                         why_not_tried(one), points_text(scenes.max_points), points_text(scenes.points))});
    }
}

}  // namespace harness::variants
