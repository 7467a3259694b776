#include "reference/numbers/interval.h"

#include <gtest/gtest.h>

#include <limits>

#include "reference/stages/scene_answers.h"

namespace {

using reference::Interval;
using I = Interval<float>;

TEST(Interval, ContainsTheExactResultOfEveryOperation) {
    const float xs[] = {-3.7F, -0.1F, 0.0F, 1e-30F, 0.3F, 1.0F, 16777217.0F};
    for (const float x : xs) {
        for (const float y : xs) {
            const double a = x;
            const double b = y;
            const auto holds = [](const I& interval, double truth) {
                return interval.lo() <= truth && truth <= interval.hi();
            };
            EXPECT_TRUE(holds(I(x) + I(y), a + b)) << x << ' ' << y;
            EXPECT_TRUE(holds(I(x) - I(y), a - b)) << x << ' ' << y;
            EXPECT_TRUE(holds(I(x) * I(y), a * b)) << x << ' ' << y;
            if (y != 0) {
                EXPECT_TRUE(holds(I(x) / I(y), a / b)) << x << ' ' << y;
            }
        }
    }
}

TEST(Interval, ContainsTheResultsOfAllNumbersOfBothIntervals) {
    // The ends of a product and of a quotient come from any two of the four bounds, as the signs say.
    const auto expect = [](const I& interval, float lo, float hi) {
        EXPECT_EQ(interval.lo(), std::nextafter(lo, -HUGE_VALF));
        EXPECT_EQ(interval.hi(), std::nextafter(hi, HUGE_VALF));
    };
    expect(I(2, 3) * I(5, 7), 10, 21);
    expect(I(-2, 3) * I(5, 7), -14, 21);
    expect(I(-2, 3) * I(-7, 5), -21, 15);
    expect(I(-3, -2) * I(-7, 5), -15, 21);
    expect(I(-3, -2) * I(-7, -5), 10, 21);
    expect(I(2, 3) / I(4, 8), 0.25F, 0.75F);
    expect(I(-2, 3) / I(4, 8), -0.5F, 0.75F);
    expect(I(2, 3) / I(-8, -4), -0.75F, -0.25F);
    expect(I(-3, -2) / I(-8, -4), 0.25F, 0.75F);
    expect(-I(2, 3) - I(4, 8), -11, -6);
}

TEST(Interval, HasNoRootBelowZero) {
    EXPECT_EQ(sqrt(I(0.0F, 4.0F)).lo(), 0.0F);
    EXPECT_EQ(sqrt(I(-1.0F, 4.0F)).lo(), 0.0F);
}

TEST(Interval, ContainsOneThirdBetweenTwoNeighboursOfTheNearestFloat) {
    const I third = I(1) / I(3);
    EXPECT_LT(static_cast<double>(third.lo()) * 3, 1.0);
    EXPECT_GT(static_cast<double>(third.hi()) * 3, 1.0);
    EXPECT_EQ(std::nextafter(std::nextafter(third.lo(), 1.0F), 1.0F), third.hi());
}

template <class T>
void expect_one_step(T x) {
    constexpr T infinity = std::numeric_limits<T>::infinity();
    const auto bits_equal = [](T p, T q) { return p == q && std::signbit(p) == std::signbit(q); };
    const Interval<T> widened = Interval<T>::widened(x, x);
    EXPECT_TRUE(bits_equal(widened.lo(), std::nextafter(x, -infinity))) << x;
    EXPECT_TRUE(bits_equal(widened.hi(), std::nextafter(x, infinity))) << x;
}

template <class T>
void expect_one_step_everywhere() {
    using Limits = std::numeric_limits<T>;
    const T all[] = {0,  Limits::denorm_min(), Limits::min(),     std::nextafter(Limits::min(), T{0}), T{0.1F}, 1, 2,
                     17, Limits::max(),        Limits::infinity()};
    for (const T x : all) {
        expect_one_step(x);
        expect_one_step(-x);
    }
    EXPECT_FALSE(Interval<T>::widened(Limits::quiet_NaN(), 1).is_bounded());
}

TEST(Interval, IsWidenedByOneStepAtEitherEnd) {
    expect_one_step_everywhere<float>();
    expect_one_step_everywhere<double>();
}

TEST(Interval, WidensAWholeNumberThatAFloatCannotHold) {
    EXPECT_TRUE(static_cast<double>(I(16777217).lo()) < 16777217 && 16777217 < static_cast<double>(I(16777217).hi()));
    EXPECT_EQ(I(16777216).lo(), I(16777216).hi());
}

TEST(Interval, HasAnUnorderedSignOnlyAroundZero) {
    EXPECT_EQ(sign_of(I(-1.0F, 1.0F)), std::partial_ordering::unordered);
    EXPECT_EQ(sign_of(I(0.0F, 1.0F)), std::partial_ordering::unordered);
    EXPECT_EQ(sign_of(I(0.0F)), std::partial_ordering::equivalent);
    EXPECT_EQ(sign_of(I(1e-45F, 1.0F)), std::partial_ordering::greater);
    EXPECT_EQ(sign_of(I(-1.0F, -1e-45F)), std::partial_ordering::less);
}

TEST(Interval, IsTheWholeLineWhereNoBoundExists) {
    EXPECT_FALSE((I(1) / I(-1.0F, 1.0F)).is_bounded());
    EXPECT_FALSE((I(1) / I(0)).is_bounded());
    EXPECT_EQ((I(1) / I(0.0F, 1.0F)).lo(), -HUGE_VALF) << "the divisor may be -0";
    EXPECT_EQ((I(1) / I(-1.0F, 0.0F)).hi(), HUGE_VALF);
    EXPECT_FALSE(I(std::nanf("")).is_bounded());
    EXPECT_FALSE(sqrt(I(-1.0F)).is_bounded());
    EXPECT_FALSE((I(3e38F) + I(3e38F)).is_bounded());
    EXPECT_FALSE((I(0.0F, 1.0F) * I::whole()).is_bounded());
    EXPECT_TRUE((I(0) * I::whole()).is_zero());
}

TEST(Interval, ContainsTheSphereHitOfTheHandout) {
    using reference::Vec3;
    const reference::CameraAnswers<I> ray{{}, {}, {}, Vec3<I>(I(0), I(0), I(2)), Vec3<I>(I(0), I(0), I(-1))};
    const reference::Sphere<I> sphere{Vec3<I>(I(1), I(1), I(0)), I(2)};
    const auto answers = answer_object(ray, sphere, reference::Boundary::nonnegative);
    ASSERT_TRUE(answers.t);
    EXPECT_LT(static_cast<double>(answers.t->lo()), 2 - std::sqrt(2.0));
    EXPECT_GT(static_cast<double>(answers.t->hi()), 2 - std::sqrt(2.0));
}

}  // namespace
