#include "harness/mark/compare/key_targets.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/given/printed_values.h"

namespace harness {
namespace {

using reference::item::P_VCS;
using reference::item::sphere::t;

const reference::ItemSpec& spec_of_t() {
    static const reference::ItemSpec spec = printed_item(t, "0").spec;
    return spec;
}

reference::KeyItem item_with_allowance(double allowance) {
    reference::Answer answer{
        reference::Numbers{4.0}, {reference::PixelConvention::centre, reference::Boundary::nonnegative}, {}, {}, {}};
    answer.lo = {4.0};
    answer.hi = {4.0};
    answer.allowance = {allowance};
    return {spec_of_t(), {answer}};
}

TEST(TargetWithAllowance, UsesTheRubricsToleranceIfWider) {
    reference::Rubric rubric;
    const reference::KeyItem item = item_with_allowance(1e-6);
    EXPECT_EQ(target_with_allowance(item, item.answers[0], rubric).allowance.at(0), 1e-6);
    rubric.tolerance = 0.01;
    EXPECT_DOUBLE_EQ(target_with_allowance(item, item.answers[0], rubric).allowance.at(0), 0.04)
        << "relative to the key's 4";
    rubric.item_tolerance["6.t"] = 0.0;
    EXPECT_EQ(target_with_allowance(item, item.answers[0], rubric).allowance.at(0), 1e-6);
    rubric.item_tolerance["6.t"] = 1e-9;
    EXPECT_EQ(target_with_allowance(item, item.answers[0], rubric).allowance.at(0), 1e-6) << "never narrower";
}

TEST(TargetWithAllowance, IsInfiniteWhereFloatCannotAnswer) {
    const reference::KeyItem item = item_with_allowance(std::numeric_limits<double>::infinity());
    EXPECT_EQ(target_with_allowance(item, item.answers[0], {}).allowance.at(0), HUGE_VAL);
}

TEST(TargetWithAllowance, IsEmptyForNoValue) {
    const reference::Answer none{reference::NoValue{},
                                 {reference::PixelConvention::centre, reference::Boundary::nonnegative}};
    const Target target = target_with_allowance({spec_of_t(), {none}}, none, {});
    EXPECT_TRUE(target.no_value);
    EXPECT_TRUE(target.allowance.empty());
}

TEST(KeysByConvention, EachHaveTheAnswersOfOneConvention) {
    const student::Marking marking = student::off_axis_scene();
    const auto keys = keys_by_convention(marking.key, marking.assignment.rubric);
    ASSERT_EQ(keys.size(), 2U);
    EXPECT_DOUBLE_EQ(keys[0].vector(P_VCS)->x.lo(), -1.5 + 4 * 211.5 / 320);
    EXPECT_NEAR(keys[1].vector(P_VCS)->x.lo(), -1.5 + 4 * 211.0 / 319, 1e-15) << "the grid";
    EXPECT_EQ(keys[0].targets().size(), keys[1].targets().size());
}

TEST(WidenedByAllowance, ReachesAsFarAsTheAllowance) {
    ItemTargets key;
    key.set(t, {false, {Interval(4.0)}, {0.5}});
    EXPECT_TRUE(widened_by_allowance(key).scalar(t)->contains(4.5));
    EXPECT_FALSE(widened_by_allowance(key).scalar(t)->contains(4.6));
}

TEST(WidenedByAllowance, ContainsValuesThatAreOffToEitherSide) {
    ItemTargets key;
    key.set(t, {false, {Interval(4.0)}, {0.25}});
    const ItemTargets widened = widened_by_allowance(key);
    const Interval range = widened.scalar(t).value();
    EXPECT_TRUE(range.contains(3.75) && range.contains(4.25));
    EXPECT_FALSE(range.contains(3.7499) || range.contains(4.2501));
}

}  // namespace
}  // namespace harness
