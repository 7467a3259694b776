#include "harness/variants/variant_points.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/final_mark.h"
#include "harness/graded_record.h"
#include "harness/override_place.h"
#include "harness/report/report.h"

namespace harness::variants {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// Half of 20 points on the assignment's own scene.
Graded half_right() {
    Graded graded;
    graded.outcome = Outcome::graded;
    graded.score.questions = {{5, ItemVerdict::wrong, 10, 20, {}}};
    graded.score.points = 10;
    graded.score.max_points = 20;
    return graded;
}

Graded with_runs(const std::vector<double>& shares) {
    Graded graded = half_right();
    graded.other_scenes = VariantReport{};
    for (const double share : shares) {
        graded.other_scenes->runs.push_back({"scene", "", "", true, {}, share});
    }
    return graded;
}

reference::Rubric five_points() {
    reference::Rubric rubric;
    rubric.variant_points = 5;
    return rubric;
}

Graded awarded(Graded graded, const reference::Rubric& rubric = five_points()) {
    std::vector<Graded> all{std::move(graded)};
    award_variant_points(all, rubric);
    return all.front();
}

TEST(VariantPoints, AreNoneUnlessTheRubricGivesSome) {
    const Graded graded = awarded(with_runs({1, 0}), {});
    EXPECT_FALSE(graded.score.other_scenes);
    EXPECT_EQ(graded.score.points, 10);
    EXPECT_EQ(graded.score.max_points, 20);
}

TEST(VariantPoints, AreSharedByTheScenesAndWhatIsRightThere) {
    const Graded graded = awarded(with_runs({1, 0.5, 0, 0.5}));
    EXPECT_EQ(graded.score.other_scenes->points, 2.5);
    EXPECT_EQ(graded.score.points, 12.5);
    EXPECT_EQ(graded.score.max_points, 25);
    EXPECT_THAT(graded.flags, IsEmpty());
    EXPECT_EQ(report::scenes_sentence(graded), "Other scenes: 2.5 of 5 points.");
}

TEST(VariantPoints, AreThoseOfItsOwnSceneWhereTheSceneWasNotFoundAndAPersonIsTold) {
    Graded untried = with_runs({});
    untried.other_scenes->not_found = {"eye", "center"};
    const Graded graded = awarded(untried);
    EXPECT_EQ(graded.score.other_scenes->points, 2.5);
    ASSERT_EQ(graded.flags.size(), 1U);
    EXPECT_EQ(graded.flags[0].kind, "variants_not_tried");
    EXPECT_THAT(graded.flags[0].evidence, HasSubstr("eye, center"));
}

TEST(VariantPoints, NeedNoPersonWhereNothingIsRight) {
    Graded nothing = half_right();
    nothing.score.points = 0;
    nothing.outcome = Outcome::compile_error;
    const Graded graded = awarded(nothing);
    EXPECT_EQ(graded.score.other_scenes->points, 0);
    EXPECT_EQ(graded.score.max_points, 25);
    EXPECT_THAT(graded.flags, IsEmpty());
}

TEST(VariantPoints, CountInTheMarkWithOverridesAndAreOverriddenThemselves) {
    Graded graded = awarded(with_runs({1, 0.5, 0, 0.5}));
    EXPECT_EQ(final_mark(graded)->points, 12.5);
    graded.overrides = {{5, "", 20, "fine", "ada", ""}};
    EXPECT_EQ(final_mark(graded)->points, 22.5);
    const OverridePlace place = read_place("variants", graded);
    graded.overrides.push_back({place.question, place.item, 4, "looked at", "ada", ""});
    EXPECT_EQ(final_mark(graded)->points, 24);
    EXPECT_EQ(points_at(graded.score, graded.overrides.back())->most, 5);
    EXPECT_EQ(place_of(graded.overrides.back()), "variants");
    EXPECT_EQ(place_in_words(graded.overrides.back()), "the other scenes");
    EXPECT_FALSE(points_at(half_right().score, graded.overrides.back())) << "where the rubric gives none";
}

TEST(VariantPoints, AreKeptByTheGradebook) {
    const Graded graded = awarded(with_runs({1, 0.5}));
    const auto again = from_record(to_record(graded));
    ASSERT_TRUE(again);
    EXPECT_EQ(again->score.other_scenes->points, graded.score.other_scenes->points);
    EXPECT_EQ(again->score.other_scenes->max_points, 5);
    EXPECT_EQ(again->other_scenes->runs.at(1).share, 0.5);
}

TEST(VariantPoints, AreRefusedWithoutOtherScenes) {
    reference::Assignment assignment;
    assignment.name = "mine";
    EXPECT_NO_THROW(require_variants(assignment, 0));
    assignment.rubric = five_points();
    EXPECT_NO_THROW(require_variants(assignment, 1));
    try {
        require_variants(assignment, 0);
        FAIL() << "no complaint";
    } catch (const reference::AssignmentError& error) {
        EXPECT_THAT(error.what(), testing::AllOf(HasSubstr("mine"), HasSubstr("5 points"), HasSubstr("--variants 4")));
    }
}

}  // namespace
}  // namespace harness::variants
