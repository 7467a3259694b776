#include "harness/mark/compare/quadratic_form.h"

#include <gtest/gtest.h>

#include "tests/given/printed_values.h"

namespace harness {
namespace {

constexpr ItemId a = reference::item::sphere::a, b = reference::item::sphere::b, c = reference::item::sphere::c,
                 d = reference::item::sphere::d;

/// t^2 - 4.5 t + 3 = 0: d = 8.25, d' = 2.0625.
std::vector<ItemTargets> quadratic_key() {
    ItemTargets key;
    key.set(a, {false, {Interval(1.0)}, {0.0}});
    key.set(b, {false, {Interval(-4.5)}, {0.0}});
    key.set(c, {false, {Interval(3.0)}, {0.0}});
    key.set(d, {false, {Interval(8.25)}, {0.0}});
    return {key};
}

QuadraticScale scale_of(std::string_view pa, std::string_view pb, std::string_view pc, std::string_view pd,
                        std::string_view pt = "") {
    const MatchedItem ia = printed_item(a, pa), ib = printed_item(b, pb), ic = printed_item(c, pc),
                      id = printed_item(d, pd), it = printed_item(reference::item::sphere::t, pt);
    const auto keys = quadratic_key();
    return find_quadratic_scale(
        {reference::Subject::sphere, &ia, &ib, &ic, pd.empty() ? nullptr : &id, pt.empty() ? nullptr : &it}, keys, 2);
}

TEST(QuadraticScale, IsOneForTheHandoutsForm) {
    const QuadraticScale scale = scale_of("1", "-4.5", "3", "8.25");
    EXPECT_EQ(scale.form, QuadraticForm::full);
    EXPECT_TRUE(is_one(scale.factor));
}

TEST(QuadraticScale, IsHalfBIfTheDiscriminantFits) {
    EXPECT_EQ(scale_of("1", "-2.25", "3", "2.0625").form, QuadraticForm::half_b);
    EXPECT_EQ(scale_of("1.000000e+00", "-2.250000e+00", "3.000000e+00", "2.062500e+00").form, QuadraticForm::half_b);
}

TEST(QuadraticScale, IsNotHalfBWithTheFullDiscriminant) {
    EXPECT_EQ(scale_of("1", "-2.25", "3", "-6.9375").form, QuadraticForm::full)
        << "b'^2 - 4ac: the factor 2 is missing";
    EXPECT_EQ(scale_of("1", "-2.25", "3", "8.25").form, QuadraticForm::full);
    EXPECT_EQ(scale_of("1", "-2.25", "3", "").form, QuadraticForm::full) << "no discriminant";
}

TEST(QuadraticScale, IsFoundFromBIfDFitsNeitherForm) {
    EXPECT_EQ(scale_of("1", "-2.25", "3", "8.0625").form, QuadraticForm::half_b) << "b'^2 + ac";
    EXPECT_EQ(scale_of("1", "-4.5", "3", "32.25").form, QuadraticForm::full);
}

// V is twice as long, which makes b' = b/2 the key's b: 4 t^2 + 2 (-4.5) t + 3 = 0.
TEST(QuadraticScale, IsFoundFromTheRootIfBIsTheKeys) {
    EXPECT_EQ(scale_of("4", "-4.5", "3", "8.25", "0.406930").form, QuadraticForm::half_b);
    EXPECT_EQ(scale_of("4", "-4.5", "3", "8.25", "0.203465").form, QuadraticForm::full) << "the factor 4 is missing";
    EXPECT_EQ(scale_of("4", "-4.5", "3", "8.25").form, QuadraticForm::full);
}

TEST(QuadraticScale, IsFoundFromBIfCIsZero) {
    // t^2 - 4.5 t = 0: the discriminant is b^2 in both forms.
    ItemTargets key = quadratic_key().front();
    key.set(c, {false, {Interval(0.0)}, {0.0}});
    const auto form_of = [&](std::string_view pb, std::string_view pd) {
        const MatchedItem ia = printed_item(a, "1"), ib = printed_item(b, pb), ic = printed_item(c, "0"),
                          id = printed_item(d, pd);
        return find_quadratic_scale({reference::Subject::sphere, &ia, &ib, &ic, &id}, std::vector{key}, 2).form;
    };
    EXPECT_EQ(form_of("-4.5", "20.25"), QuadraticForm::full);
    EXPECT_EQ(form_of("-2.25", "5.0625"), QuadraticForm::half_b);
    EXPECT_EQ(form_of("-3", "9"), QuadraticForm::full) << "a wrong b tells nothing";
}

TEST(QuadraticScale, FindsACommonFactorOfAllCoefficients) {
    EXPECT_TRUE(scale_of("2", "-9", "6", "33").factor.contains(2.0));
    EXPECT_TRUE(scale_of("-1", "4.5", "-3", "8.25").factor.contains(-1.0));
    EXPECT_TRUE(is_one(scale_of("2", "-9", "3", "57").factor)) << "c is not multiplied";
    EXPECT_TRUE(is_one(scale_of("2", "-4.5", "3", "-3.75").factor)) << "a alone is wrong";
}

TEST(QuadraticScale, IgnoresZerosNanAndATinyA) {
    EXPECT_TRUE(is_one(scale_of("0", "0", "0", "0").factor));
    EXPECT_TRUE(is_one(scale_of("nan", "nan", "nan", "nan").factor));
    EXPECT_TRUE(is_one(scale_of("0.001", "0", "0", "0").factor));
}

}  // namespace
}  // namespace harness
