#include "harness/mark/diagnose/difference.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/given/printed_values.h"
#include "tests/given/student/items.h"
#include "tests/given/student/mistake_parts.h"
#include "tests/given/student/printout.h"

namespace harness {
namespace {

using student::Floats;
using student::Program;

/// What differs in a program that changes the right value of one item.
std::string difference_by(const ItemId& id, void (*change)(Floats&)) {
    const student::Marking marking = student::off_axis_scene();
    const Program program(marking.assignment, {}, student::changed("", id, change).mistake);
    return item_of(mark(print(program), marking), id).difference;
}

TEST(Difference, OfAVectorIsItsSignLengthOrderOrCoordinates) {
    EXPECT_EQ(difference_by(student::V, student::negate), "Only its sign is wrong: it points the opposite way.");
    EXPECT_EQ(difference_by(student::V,
                            [](Floats& p) {
                                for (float& x : p) x *= 3;
                            }),
              "Its direction is right, but its length is wrong.");
    EXPECT_EQ(difference_by(student::P_VCS, [](Floats& p) { p[1] = -p[1]; }), "Only the sign of its y is wrong.");
    EXPECT_EQ(difference_by(student::P_VCS, [](Floats& p) { p[0] += 0.25F; }),
              "Its x is wrong; the other two are right.");
    EXPECT_EQ(difference_by(student::P_VCS, [](Floats& p) { p[0] += 0.25F, p[2] = 7; }),
              "Its x and z are wrong; the third is right.");
    EXPECT_EQ(difference_by(student::rhs, [](Floats& p) { std::swap(p[0], p[2]); }),
              "Its numbers are right, but their order or signs are wrong.");
    EXPECT_EQ(difference_by(student::V,
                            [](Floats& p) {
                                p = {0.6F, 0, 0.8F};
                            }),
              "Its length is 1, but its direction is wrong.");
    EXPECT_EQ(difference_by(student::hit_s, [](Floats& p) { p = {9, 8, 7}; }), "It is not on your ray S + tV.");
}

TEST(Difference, OfAPointIsNoDirection) {
    const auto thrice = [](Floats& p) {
        for (float& x : p) x *= 3;
    };
    EXPECT_EQ(difference_by(student::P_VCS, thrice), "None of its three numbers is right.");
    EXPECT_EQ(difference_by(student::P_VCS, student::negate), "Only the sign of its x, y and z is wrong.");
    EXPECT_EQ(difference_by(student::hit_s, thrice), "It is not on your ray S + tV.");
}

TEST(Difference, OfAHitPointOnTheRayIsItsT) {
    const student::Marking marking = student::scene_named("handout");
    for (const char* point : {"vec3(0, 0, 3)", "vec3(0, 0, -1.4142136)"}) {
        const std::string output =
            student::with_line(print(Program(marking.assignment, {})), 6, "Hit point P_s", point);
        EXPECT_EQ(item_of(mark(output, marking), student::hit_s).difference, "It is on your ray, but not at your t.");
    }
}

TEST(Difference, OfANumberIsItsSignScaleOrSize) {
    EXPECT_EQ(difference_by(student::c, student::negate), "Its size is right, but it has the wrong sign.");
    EXPECT_EQ(difference_by(student::c, [](Floats& x) { x[0] *= 2; }), "It is a simple multiple of the right value.");
    EXPECT_EQ(difference_by(student::d, [](Floats& x) { x[0] *= 1.3F; }),
              "Its sign is right, but its size is too large. It is not b^2 - 4ac for your a, b and c.");
    EXPECT_EQ(difference_by(student::d, [](Floats& x) { x[0] = 0; }),
              "It must not be 0. It is not b^2 - 4ac for your a, b and c.");
    EXPECT_EQ(difference_by(student::d, [](Floats& x) { x[0] *= -1.3F; }),
              "It has the wrong sign, and its size is wrong too. It is not b^2 - 4ac for your a, b and c.");
    EXPECT_EQ(difference_by(student::t_s, [](Floats& x) { x[0] *= -1.3F; }),
              "It has the wrong sign, and its size is wrong too. It does not solve the equation for your a, b and c.");
}

TEST(Difference, OfARootIsNotThatItSolvesNothing) {
    const student::Marking marking = student::off_axis_scene();
    const Program program(marking.assignment, {});
    const float far = (-program.scalar(student::b) + std::sqrt(program.scalar(student::d))) / 2;
    const std::string output = student::with_line(print(program), 6, "t", std::to_string(far));
    EXPECT_EQ(item_of(mark(output, marking), student::t_s).difference, "Its sign is right, but its size is too large.");
}

TEST(Difference, OfAMatrixIsItsEntryRowOrColumns) {
    EXPECT_EQ(difference_by(student::M, [](Floats& m) { m[6] += 1; }),
              "Only one of its numbers is wrong, in column 2 and row 3.");
    EXPECT_EQ(difference_by(student::M, [](Floats& m) { m[4] += 1, m[5] += 1; }), "Only its second column is wrong.");
    EXPECT_EQ(difference_by(student::M, [](Floats& m) { m[0] = -m[0], m[1] = -m[1], m[2] = -m[2]; }),
              "Only signs are wrong, in its first column.");
    EXPECT_EQ(difference_by(student::matrix, [](Floats& m) { m[3] += 1; }), "Its u column is wrong.");
    EXPECT_EQ(difference_by(student::matrix, [](Floats& m) { m[6] = -m[6], m[7] = -m[7], m[8] = -m[8]; }),
              "Its columns are right except for a sign: compare the sign of v with the others.");
}

TEST(Difference, ComparesWithTheValueThatFollowsFromEarlierMistakes) {
    const student::Marking marking = student::off_axis_scene();
    const Program program(marking.assignment, {}, student::changed("", student::c, student::negate).mistake);
    const float d = program.scalar(student::d);
    const std::string output = student::with_line(print(program), 6, "d", std::to_string(-d));
    EXPECT_EQ(item_of(mark(output, marking), student::d).difference, "Its size is right, but it has the wrong sign.");
}

TEST(Difference, IsInTheFormOfTheStudentsQuadratic) {
    const student::Marking marking = student::off_axis_scene();
    student::Way way;
    way.half_b = true;
    const Program program(marking.assignment, way);
    const std::string output = student::with_line(print(program), 6, "d", std::to_string(-program.scalar(student::d)));
    EXPECT_EQ(item_of(mark(output, marking), student::d).difference, "Its size is right, but it has the wrong sign.");
    EXPECT_EQ(item_of(mark(student::with_line(output, 6, "d", "1000"), marking), student::d).difference,
              "Its sign is right, but its size is too large. It is not b^2 - ac for your a, b and c.");
}

TEST(Difference, OfARightHandSideIsInTheSignOfItsMatrix) {
    const student::Marking marking = student::off_axis_scene();
    student::Way way;
    way.row_factors = {-1, -1, -1};
    const Program program(marking.assignment, way);
    const glm::vec3 rhs = program.vector(student::rhs);
    const std::string output = student::with_line(print(program), 8, "Right-hand side",
                                                  fmt::format("vec3({:f}, {:f}, {:f})", rhs.x, rhs.y, rhs.z + 3));
    EXPECT_EQ(item_of(mark(output, marking), student::rhs).difference, "Its z is wrong; the other two are right.");
}

TEST(Difference, IsEmptyForARightAnswer) {
    const student::Marking marking = student::off_axis_scene();
    for_each_item(mark(print(Program(marking.assignment, {})), marking),
                  [](const ItemScore& item) { EXPECT_EQ(item.difference, "") << item.spec.name; });
}

}  // namespace
}  // namespace harness
