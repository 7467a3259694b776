#include "harness/mark/compare/item_targets.h"

#include <gtest/gtest.h>

#include "tests/given/printed_values.h"

namespace harness {
namespace {

using reference::item::M_VCS_to_WCS;
using reference::item::V;
using reference::item::sphere::t;
using reference::item::triangle::matrix;

TEST(ItemTargets, GivesNothingForAnUnknownItemOrNoValue) {
    ItemTargets known;
    EXPECT_FALSE(known.scalar(t));
    known.set(t, no_value());
    EXPECT_FALSE(known.scalar(t));
    EXPECT_FALSE(known.number(t));
}

TEST(ItemTargets, GivesNothingInADifferentShape) {
    ItemTargets known;
    known.set(V, target_of(Interval(1.0)));
    EXPECT_FALSE(known.vector(V));
    EXPECT_TRUE(known.scalar(V));
}

TEST(ItemTargets, StoresAMatrixByColumns) {
    ItemTargets known;
    known.set(matrix, printed_target(printed_item(matrix, "1 2 3 4 5 6 7 8 9"), Digits::as_printed));
    const auto m = known.matrix3(matrix);
    ASSERT_TRUE(m);
    EXPECT_TRUE((*m)[1][0].contains(4.0));
    EXPECT_TRUE((*m)[0][1].contains(2.0));
    EXPECT_EQ(target_of(*m).components.size(), 9U);
}

TEST(ItemTargets, TurnsAMatrixPrintedByRowsIntoColumns) {
    ItemTargets known;
    known.set(M_VCS_to_WCS,
              printed_target(printed_item(M_VCS_to_WCS, "1 0 0 7 0 1 0 8 0 0 1 9 0 0 0 1", MatrixOrder::rows),
                             Digits::as_printed));
    const auto m = known.matrix4(M_VCS_to_WCS);
    ASSERT_TRUE(m);
    EXPECT_TRUE((*m)[3][0].contains(7.0));
    EXPECT_TRUE((*m)[0][3].is_zero());
}

TEST(PrintedTarget, DropsTheW) {
    EXPECT_EQ(printed_target(printed_item(V, "0 0 -1 0"), Digits::as_printed).components.size(), 3U);
}

TEST(PrintedTarget, HasNoValueForAWord) {
    EXPECT_TRUE(printed_target(printed_item(t, "none"), Digits::as_printed).no_value);
}

TEST(PrintedTarget, IsWidenedByTheRoundingsOfAStage) {
    const Interval x = printed_target(printed_item(t, "10000"), Digits::as_printed).components.front();
    EXPECT_TRUE(x.contains(10000 + 8 * 0x1p-24 * 10000));
    EXPECT_FALSE(x.contains(10000.01));
    EXPECT_TRUE(printed_target(printed_item(t, "0"), Digits::as_printed).components.front().is_zero())
        << "zero has no roundings";
}

TEST(TargetOf, ContainsTheEnclosureOfACertifiedAnswer) {
    const student::Marking marking = student::off_axis_scene();
    const reference::Answer& answer = marking.key.questions.front().items.front().answers.front();
    const Target target = target_of(answer);
    ASSERT_EQ(target.components.size(), 3U);
    EXPECT_EQ(target.components[0].lo(), answer.lo[0]);
    EXPECT_EQ(target.components[0].hi(), answer.hi[0]);
}

}  // namespace
}  // namespace harness
