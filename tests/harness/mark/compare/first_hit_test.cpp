#include "harness/mark/compare/first_hit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/given/printed_values.h"

namespace harness {
namespace {

using reference::Boundary;
using reference::FirstObject;
using reference::Subject;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

constexpr FirstObject sphere_first(Subject::sphere);
constexpr FirstObject triangle_first(Subject::triangle);
constexpr FirstObject cylinder_first(Subject::cylinder);

Interval of(std::string_view text) {
    return enclosure_of(printed_number(text), Digits::as_printed);
}

HitValues values(std::string_view sphere_t, std::string_view triangle_t, std::string_view u = "0.25",
                 std::string_view v = "0.25") {
    const auto t = [](std::string_view text) { return text == "none" ? std::nullopt : std::optional(of(text)); };
    return {{{Subject::sphere, t(sphere_t)}, {Subject::triangle, t(triangle_t)}}, of(u), of(v)};
}

std::vector<reference::FirstObject> under(const HitValues& hits, std::initializer_list<Boundary> boundaries) {
    return possible_first_objects(hits, std::vector<Boundary>(boundaries));
}

std::vector<reference::FirstObject> possible(const HitValues& hits) {
    return under(hits, {Boundary::nonnegative, Boundary::positive});
}

TEST(PossibleFirstObjects, NameTheSmallerT) {
    EXPECT_THAT(possible(values("1.59", "0.75")), ElementsAre(triangle_first));
    EXPECT_THAT(possible(values("0.59", "0.75")), ElementsAre(sphere_first));
}

TEST(PossibleFirstObjects, AreAllThreeIfBothTHaveTheSameDigits) {
    EXPECT_THAT(possible(values("1.59", "1.59")), UnorderedElementsAre(sphere_first, triangle_first, FirstObject::tie));
    EXPECT_THAT(possible(values("1.590", "1.5904")),
                UnorderedElementsAre(sphere_first, triangle_first, FirstObject::tie));
    EXPECT_THAT(possible(values("1.590", "1.592")), ElementsAre(sphere_first));
}

/// With a cylinder too.
HitValues three(std::string_view sphere_t, std::string_view triangle_t, std::string_view cylinder_t) {
    HitValues hits = values(sphere_t, triangle_t);
    if (cylinder_t == "none") {
        hits.t[Subject::cylinder] = std::nullopt;
    } else {
        hits.t[Subject::cylinder] = of(cylinder_t);
    }
    return hits;
}

TEST(PossibleFirstObjects, CompareAllObjects) {
    EXPECT_THAT(possible(three("1.59", "2", "1")), ElementsAre(cylinder_first));
    EXPECT_THAT(possible(three("1.59", "0.5", "1")), ElementsAre(triangle_first));
    EXPECT_THAT(possible(three("none", "none", "1")), ElementsAre(cylinder_first));
    EXPECT_THAT(possible(three("1", "2", "none")), ElementsAre(sphere_first));
    EXPECT_THAT(possible(three("1", "2", "1")), UnorderedElementsAre(sphere_first, cylinder_first, FirstObject::tie));
    EXPECT_THAT(possible(three("2", "1", "2")), ElementsAre(triangle_first)) << "a tie behind the first";
    EXPECT_THAT(possible(three("none", "none", "none")), ElementsAre(FirstObject::no_hit));
}

TEST(PossibleFirstObjects, FollowTheBoundaryPolicyIfTIsExactlyZero) {
    EXPECT_THAT(under(values("1.59", "0"), {Boundary::nonnegative}), ElementsAre(triangle_first));
    EXPECT_THAT(under(values("1.59", "0"), {Boundary::positive}), ElementsAre(sphere_first));
    EXPECT_THAT(possible(values("1.59", "0")), UnorderedElementsAre(triangle_first, sphere_first));
}

TEST(PossibleFirstObjects, TakeTheSignOfAPrintedZero) {
    EXPECT_THAT(under(values("1.59", "0.000000"), {Boundary::nonnegative}), ElementsAre(triangle_first));
    EXPECT_THAT(under(values("1.59", "-0.000000"), {Boundary::nonnegative}),
                UnorderedElementsAre(triangle_first, sphere_first));
    EXPECT_THAT(under(values("1.59", "-0"), {Boundary::nonnegative}), ElementsAre(triangle_first)) << "-0 >= 0";
}

TEST(PossibleFirstObjects, ContainNoHitWithoutANumber) {
    EXPECT_THAT(possible(values("none", "0.5")), ElementsAre(triangle_first));
    EXPECT_THAT(possible(values("0.5", "none")), ElementsAre(sphere_first));
    EXPECT_THAT(possible(values("none", "none")), ElementsAre(FirstObject::no_hit));
}

TEST(PossibleFirstObjects, ContainNoHitBehindTheStart) {
    EXPECT_THAT(possible(values("-1.5", "-0.5")), ElementsAre(FirstObject::no_hit));
    EXPECT_THAT(possible(values("-1.5", "0.5")), ElementsAre(triangle_first));
}

TEST(PossibleFirstObjects, ContainNoHitOutsideTheTriangle) {
    EXPECT_THAT(possible(values("1.59", "0.75", "-0.5", "0.25")), ElementsAre(sphere_first));
    EXPECT_THAT(possible(values("1.59", "0.75", "0.75", "0.5")), ElementsAre(sphere_first));
    EXPECT_THAT(possible(values("none", "0.75", "1.5", "-1")), ElementsAre(FirstObject::no_hit));
}

TEST(PossibleFirstObjects, ContainAHitOfTheTrianglesEdge) {
    EXPECT_THAT(possible(values("1.59", "0.75", "0", "0.25")), ElementsAre(triangle_first));
    EXPECT_THAT(possible(values("1.59", "0.75", "0.00", "0.25")), ElementsAre(triangle_first));
}

TEST(PossibleFirstObjects, LeaveTheEdgeOpenIfTheDigitsDo) {
    EXPECT_THAT(possible(values("1.59", "0.75", "-0.00", "0.25")), UnorderedElementsAre(triangle_first, sphere_first));
    EXPECT_THAT(possible(values("1.59", "0.75", "0.500", "0.500")), UnorderedElementsAre(triangle_first, sphere_first));
}

TEST(PossibleFirstObjects, ForgiveAStudentsOwnToleranceUpToTheAllowance) {
    HitValues hits = values("1.59", "0.75", "-1.2e-07", "0.25");
    EXPECT_THAT(possible(hits), ElementsAre(sphere_first));
    hits.uv_allowance = 1e-6;
    EXPECT_THAT(possible(hits), UnorderedElementsAre(triangle_first, sphere_first));
}

TEST(PossibleFirstObjects, ForgiveTheErrorsOfBothUAndVAtTheThirdEdge) {
    HitValues hits{
        {{Subject::sphere, Interval(1.5)}, {Subject::triangle, Interval(0.75)}}, Interval(0.5), Interval(0.5 + 1.5e-6)};
    hits.uv_allowance = 1e-6;
    EXPECT_THAT(possible(hits), UnorderedElementsAre(triangle_first, sphere_first));
    hits.v = Interval(0.5 + 2.5e-6);
    EXPECT_THAT(possible(hits), ElementsAre(sphere_first));
}

TEST(PossibleFirstObjects, ContainTheTriangleIfTheSphereMayBeBehind) {
    EXPECT_THAT(under(values("-0.00", "0.75"), {Boundary::nonnegative}),
                UnorderedElementsAre(sphere_first, triangle_first));
    EXPECT_THAT(under(values("0.75", "-0.00"), {Boundary::nonnegative}),
                UnorderedElementsAre(triangle_first, sphere_first));
}

TEST(PossibleFirstObjects, TakeThePointAsInsideIfUOrVIsUnknown) {
    HitValues hits = values("1.59", "0.75");
    hits.u.reset();
    EXPECT_THAT(possible(hits), ElementsAre(triangle_first));
}

TEST(SmallerT, IgnoresSigns) {
    EXPECT_EQ(smaller_t(values("-3", "0.5", "7", "7")), sphere_first);
    EXPECT_EQ(smaller_t(values("1.59", "1.59")), std::nullopt);
    EXPECT_EQ(smaller_t(values("none", "1.59")), std::nullopt);
}

}  // namespace
}  // namespace harness
