#include "harness/gradebook/changed_marks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/report/text/changed_marks.h"
#include "tests/given/report/graded_samples.h"
#include "tests/given/student/scenes.h"

namespace harness {
namespace {

using namespace report_samples;
using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;

/// Question 6's t.
ItemScore& t_of(Graded& one) {
    return one.score.questions[5].items[4];
}

/// A score with `points` for question 6's t.
Graded with_t(ItemVerdict verdict, double points) {
    Graded one = graded("zoe", output_with_a_mistake());
    t_of(one).verdict = verdict;
    t_of(one).points = points;
    one.score.questions[5].points += points;
    one.score.points += points;
    return one;
}

ClassChanges filed(const Graded& before, const Graded& after) {
    ClassChanges changes;
    add(changes, change_between(before, after));
    return changes;
}

TEST(ClassChanges, NameTheItemByWhichAMarkRisesOrFalls) {
    const Graded low = with_t(ItemVerdict::wrong, 0), high = with_t(ItemVerdict::right, 1.5);
    const ClassChanges up = filed(low, high), down = filed(high, low);
    ASSERT_THAT(up.rising, SizeIs(1));
    EXPECT_THAT(up.rising[0].reasons, ElementsAre("6.t wrong -> right (+1.5)"));
    EXPECT_NEAR(*up.rising[0].after - *up.rising[0].before, 1.5, 1e-9);
    ASSERT_THAT(down.falling, SizeIs(1));
    EXPECT_THAT(down.falling[0].reasons, ElementsAre("6.t right -> wrong (-1.5)"));
}

TEST(ClassChanges, DistinguishChangedPointsFromAChangedVerdict) {
    EXPECT_THAT(filed(with_t(ItemVerdict::follow, 1), with_t(ItemVerdict::follow, 0.5)).falling.at(0).reasons,
                ElementsAre("6.t: still follow, but 0.5 fewer points"));
}

TEST(ClassChanges, NameSourceOutcomeAndLateness) {
    Graded before = with_t(ItemVerdict::wrong, 0);
    Graded after = before;
    after.submission.source_sha256 = std::string(64, 'b');
    after.execution.outcome = Outcome::crashed;
    after.late_share = 0.1;
    const ClassChanges changes = filed(before, after);
    ASSERT_THAT(changes.falling, SizeIs(1));
    EXPECT_THAT(changes.falling[0].reasons,
                ElementsAre("the source changed", "graded -> crashed", "late: loses 10 %, 0 % before"));
    before.submission.source_sha256 = "";
    EXPECT_THAT(change_between(before, after).reasons.front(), "there is a source now");
    EXPECT_THAT(change_between(after, before).reasons.front(), "the source is gone");
}

/// A submission with `points` of 10 for other scenes: one scene was run, `not_tried` further scenes were not.
Graded with_scenes(double points, std::size_t not_tried, std::optional<std::uint64_t> seed) {
    Graded one = with_t(ItemVerdict::wrong, 0);
    one.score.variants = ScenesScore{points, 10};
    one.score.points += points;
    one.findings.variants = VariantsReport{};
    one.findings.variants->runs.resize(1);
    one.findings.variants->not_tried.resize(not_tried);
    one.findings.variants->seed = seed;
    return one;
}

TEST(ClassChanges, NameTheVariantsOnWhichPointsChanged) {
    const auto reasons = [](const Graded& before, const Graded& after) {
        return change_between(before, after).reasons;
    };
    EXPECT_THAT(reasons(with_scenes(6, 3, 7), with_scenes(4, 1, 1)),
                ElementsAre("other scenes (-2: 2 scenes of seed 1, before 4 scenes of seed 7)"));
    EXPECT_THAT(reasons(with_scenes(4, 3, 7), with_scenes(6, 0, 7)),
                ElementsAre("other scenes (+2: 1 scene of seed 7, before 4 scenes of seed 7)"));
    EXPECT_THAT(reasons(with_scenes(4, 3, 7), with_scenes(6, 3, 7)), ElementsAre("other scenes (+2)"));
    EXPECT_THAT(reasons(with_scenes(4, 0, {}), with_scenes(6, 1, 1)),
                ElementsAre("other scenes (+2: 2 scenes of seed 1, before not known)"));
    EXPECT_THAT(reasons(with_scenes(4, 3, 7), with_scenes(4, 1, 1)), IsEmpty()) << "no mark hangs on it";
    Graded without = with_t(ItemVerdict::wrong, 0);
    EXPECT_THAT(reasons(without, with_scenes(2, 3, 7)), ElementsAre("other scenes (+2)"));
    EXPECT_THAT(reasons(with_scenes(2, 3, 7), without), ElementsAre("other scenes (-2)"));
}

TEST(ClassChanges, SeparateEqualMarksWithDifferentReasons) {
    Graded after = with_t(ItemVerdict::missing, 0);
    const ClassChanges changes = filed(with_t(ItemVerdict::wrong, 0), after);
    ASSERT_THAT(changes.level, SizeIs(1));
    EXPECT_THAT(changes.level[0].reasons, ElementsAre("6.t wrong -> missing"));
    EXPECT_THAT(changes.rising, IsEmpty());
    EXPECT_THAT(changes.falling, IsEmpty());
}

TEST(ClassChanges, CountALostMarkAsAFallAndANewMarkAsARise) {
    const ClassChanges lost = filed(graded("zoe", ""), not_graded("zoe"));
    ASSERT_THAT(lost.falling, SizeIs(1)) << "also from 0 points";
    EXPECT_FALSE(lost.falling[0].after.has_value());
    EXPECT_THAT(lost.falling[0].reasons, ElementsAre("no_output -> not_graded"));
    EXPECT_THAT(filed(not_graded("zoe"), graded("zoe", "")).rising, SizeIs(1));
}

TEST(ClassChanges, IgnoreAMarkThatAnOverrideFixes) {
    Graded before = with_t(ItemVerdict::wrong, 0), after = with_t(ItemVerdict::right, 1.5);
    before.review.overrides = after.review.overrides = {{6, "t", 1, "right idea", "ada", ""}};
    const ClassChanges changes = filed(before, after);
    ASSERT_THAT(changes.level, SizeIs(1));
    EXPECT_THAT(changes.level[0].reasons, ElementsAre("6.t wrong -> right (+1.5), overridden"));
}

TEST(ClassChanges, NameAddedAndRemovedItems) {
    const Graded with = with_t(ItemVerdict::right, 1.5);
    Graded without = with;
    without.score.questions.pop_back();
    without.score.points -= 10;
    EXPECT_THAT(filed(with, without).falling.at(0).reasons, ElementsAre("10.verdict is no longer asked for (-10)"));
    EXPECT_THAT(filed(without, with).rising.at(0).reasons, ElementsAre("10.verdict is new: right (+10)"));
}

TEST(ClassChanges, AreOneLineEachWithFallsLast) {
    ClassChanges changes = filed(with_t(ItemVerdict::right, 1.5), with_t(ItemVerdict::wrong, 0));
    MarkChange rise = change_between(with_t(ItemVerdict::wrong, 0), with_t(ItemVerdict::right, 1.5));
    rise.label = "riser\n\x1b";
    add(changes, rise);
    changes.fresh = {{"newcomer", "newcomer", std::nullopt, 50.0, {}}};
    changes.gone = {{"leaver", "leaver", 60.0, std::nullopt, {}}};
    changes.untouched = 26;
    const std::string text = report::changes_text(changes);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4);
    EXPECT_THAT(text, AllOf(HasSubstr("rises  riser"), HasSubstr("+1.5  6.t wrong -> right"), Not(HasSubstr("\x1b"))));
    EXPECT_THAT(text, AllOf(HasSubstr("falls  zoe"), HasSubstr("-1.5  6.t right -> wrong")));
    EXPECT_THAT(text, HasSubstr("99.83 ->  98.33    -1.5"));
    EXPECT_LT(text.find("leaver"), text.find("newcomer"));
    EXPECT_LT(text.find("rises"), text.find("falls"));
    EXPECT_EQ(report::changes_summary(changes), "1 rises, 1 falls, 26 stay as they are, 1 is new, 1 is gone.");
    EXPECT_EQ(report::changes_summary({}), "0 rise, 0 fall, 0 stay as they are.");
}

TEST(ClassChanges, TellNamesakesApart) {
    ClassChanges changes;
    changes.fresh = {{"doe_11", "Doe, Jane", std::nullopt, 50.0, {}}, {"roe_13", "Roe, Al", std::nullopt, 50.0, {}}};
    changes.gone = {{"doe_12", "Doe, Jane", 60.0, std::nullopt, {}}};
    EXPECT_THAT(report::changes_text(changes),
                AllOf(HasSubstr("new    Doe, Jane (doe_11) "), HasSubstr("new    Roe, Al  "),
                      HasSubstr("gone   Doe, Jane (doe_12) ")));
}

TEST(ClassChanges, NameSixReasonsAndCountTheRest) {
    MarkChange change{"zoe", "zoe", 1.0, 2.0, {"a", "b", "c", "d", "e", "f", "g", "h"}};
    ClassChanges changes;
    add(changes, change);
    EXPECT_THAT(report::changes_text(changes), HasSubstr("a; b; c; d; e; f; and 2 more\n"));
}

TEST(AssignmentChange, SaysWhetherTheKeyChanged) {
    const std::string then = student::camera_on_the_axis(4) + "[[sphere]]\ncenter = [1, 1, 0]\nradius = 2\n";
    const auto change = [&](const std::string& toml, const std::string& name = "a6") {
        const reference::Assignment now = reference::parse_assignment(toml, name + ".toml");
        return assignment_change({"a6", then}, {name, toml},
                                 {now, reference::make_key(now, reference::Precision::certified)});
    };
    EXPECT_EQ(change(then), "");
    EXPECT_THAT(change(then + "[rubric]\nfollow_through = 0.5\n"), HasSubstr("its key is the same"));
    std::string moved = then;
    moved.replace(moved.find("radius = 2"), 10, "radius = 3");
    EXPECT_THAT(change(moved), HasSubstr("and so has the key"));
    EXPECT_THAT(change(then, "b7"), HasSubstr("changed from a6 to b7"));
}

MarkChange falling(const std::string& id, std::vector<std::string> reasons) {
    return {id, id, 100, 95, std::move(reasons), 100, 95};
}

TEST(ChangesText, TellsOnceWhatChangesForMost) {
    const std::string rubric = "1.P_VCS: still right, but 5 fewer points";
    ClassChanges changes;
    for (const char* id : {"ann", "ben", "cora"}) changes.falling.push_back(falling(id, {rubric}));
    changes.falling.push_back(falling("dan", {rubric, "6.t right -> wrong (-2)"}));
    changes.untouched = 1;
    const std::string text = report::changes_text(changes);
    EXPECT_THAT(text, StartsWith("3 of 5: " + rubric + "\nfalls  dan "));
    EXPECT_THAT(text, EndsWith("  the same, and 6.t right -> wrong (-2)\n"));
    changes.untouched = 2;
    EXPECT_THAT(report::changes_text(changes), StartsWith("falls  ann ")) << "half are not most";
    changes.untouched = 0;
    changes.falling.resize(2);
    EXPECT_THAT(report::changes_text(changes), StartsWith("falls  ann ")) << "two are told one by one";
}

}  // namespace
}  // namespace harness
