#include "harness/variants/points.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/gradebook/record.h"
#include "harness/record/final_mark.h"
#include "harness/record/override_place.h"
#include "harness/report/text/sentences.h"
#include "reference/toml/assignment_error.h"

namespace harness::variants {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

/// Half of 20 points on the assignment's own scene.
Graded half_right() {
    Graded graded;
    graded.execution.outcome = Outcome::graded;
    graded.score.questions = {{5, "", ItemVerdict::wrong, 10, 20, {}}};
    graded.score.points = 10;
    graded.score.max_points = 20;
    return graded;
}

Graded with_runs(const std::vector<double>& shares) {
    Graded graded = half_right();
    graded.findings.variants = VariantsReport{};
    for (const double share : shares) {
        graded.findings.variants->runs.push_back({"scene", "", "", true, {}, share});
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

TEST(VariantPoints, AreNoneByDefault) {
    const Graded graded = awarded(with_runs({1, 0}), {});
    EXPECT_FALSE(graded.score.variants);
    EXPECT_EQ(graded.score.points, 10);
    EXPECT_EQ(graded.score.max_points, 20);
}

TEST(VariantPoints, AreSharedByTheScenesAndTheirRightAnswers) {
    const Graded graded = awarded(with_runs({1, 0.5, 0, 0.5}));
    EXPECT_EQ(graded.score.variants->points, 2.5);
    EXPECT_EQ(graded.score.points, 12.5);
    EXPECT_EQ(graded.score.max_points, 25);
    EXPECT_THAT(graded.findings.flags, IsEmpty());
    EXPECT_EQ(report::scenes_sentence(graded), "Other scenes: 2.5 of 5 points.");
}

/// The note for a person to review; "" if there is none.
std::string told(const Graded& graded) {
    EXPECT_LE(graded.findings.flags.size(), 1U);
    if (graded.findings.flags.empty()) return "";
    EXPECT_EQ(graded.findings.flags[0].kind, "variants_not_tried");
    return graded.findings.flags[0].evidence;
}

TEST(VariantPoints, EqualTheOwnScenesShareAndAreNotedIfNoSceneWasFound) {
    Graded untried = with_runs({});
    untried.findings.variants->not_found = {"eye", "center", "radius", "A", "B", "C"};
    untried.findings.variants->not_tried = {{"", "", "the scene was not found in its source"},
                                            {"", "", "the scene was not found in its source"}};
    const Graded graded = awarded(untried);
    EXPECT_EQ(graded.score.variants->points, 2.5);
    EXPECT_EQ(told(graded),
              "The program could not be run on any of 2 other scenes: the scene was not found in its source. These "
              "were not found in its source and stayed the same: eye, center, triangle. It has 2.5 of the 5 points for "
              "other scenes until you review it: a scene that was not tried counts like the assignment's own.");
}

TEST(VariantPoints, NoteScenesThatAreMuchLikeTheAssignments) {
    for (const std::string part : {"eye", "center"}) {
        Graded graded = with_runs({1, 1});
        graded.findings.variants->not_found = {part, "vup"};
        graded = awarded(graded);
        EXPECT_EQ(graded.score.variants->points, 5) << "it ran on both";
        EXPECT_THAT(told(graded), HasSubstr("stayed the same: " + part + ". It has"));
    }
    for (const std::string part : {"A", "B", "C"}) {
        Graded graded = with_runs({1, 1});
        graded.findings.variants->not_found = {part};
        EXPECT_THAT(told(awarded(graded)), HasSubstr("stayed the same: triangle. It has"));
    }
    Graded graded = with_runs({1, 1});
    graded.findings.variants->not_found = {"lookat", "vup", "radius", "pixel"};
    EXPECT_EQ(told(awarded(graded)), "");
}

TEST(VariantPoints, SayIfNoAnswerIsRight) {
    const Graded only_follows = awarded(half_right());
    EXPECT_EQ(only_follows.score.variants->points, 2.5);
    EXPECT_THAT(told(only_follows), HasSubstr("The program has no right answer, so it was not run on other"));
}

TEST(VariantPoints, SayIfRaygradeFailed) {
    Graded graded = half_right();
    ItemScore right;
    right.verdict = ItemVerdict::right;
    right.printed = "1";
    graded.score.questions[0].items = {right};
    EXPECT_THAT(told(awarded(graded)), HasSubstr("raygrade failed to run the program on other scenes."));
}

TEST(VariantPoints, NeedNoReviewIfNothingIsRight) {
    Graded nothing = half_right();
    nothing.score.points = 0;
    nothing.execution.outcome = Outcome::compile_error;
    const Graded graded = awarded(nothing);
    EXPECT_EQ(graded.score.variants->points, 0);
    EXPECT_EQ(graded.score.max_points, 25);
    EXPECT_THAT(graded.findings.flags, IsEmpty());
}

TEST(VariantPoints, AreRefusedWithoutVariants) {
    reference::Assignment assignment;
    assignment.name = "mine";
    EXPECT_NO_THROW(require_variants(assignment, 0));
    assignment.rubric = five_points();
    EXPECT_NO_THROW(require_variants(assignment, 1));
    EXPECT_THAT([&] { require_variants(assignment, 0); },
                ThrowsMessage<reference::AssignmentError>(
                    AllOf(HasSubstr("mine"), HasSubstr("5 points"), HasSubstr("--variants 4"))));
}

}  // namespace
}  // namespace harness::variants
