#include "harness/mark/diagnose/close_call.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/given/printed_values.h"
#include "tests/given/student/printout.h"
#include "tests/given/student/scenes.h"

namespace harness {
namespace {

using reference::Boundary;
using student::Program;
using student::Way;
using student::with_line;

std::string right_output(const student::Marking& marking, bool true_hits_only = false) {
    Way way;
    way.true_hits_only = true_hits_only;
    return print(Program(marking.assignment, way));
}

TEST(CloseCall, AcceptsBothDecisionsForATangent) {
    for (const char* scene : {"barely hit", "barely missed"}) {
        const student::Marking marking = student::scene_named(scene);
        std::string miss = right_output(marking);
        miss = with_line(miss, 6, "d", "-0.000004");
        miss = with_line(miss, 6, "t", "no hit");
        miss = with_line(miss, 6, "Hit point P_s", "no hit");
        miss = with_line(miss, 7, "Sphere normal", "none");
        const Score score = mark(miss, marking);
        for (const ItemId& id :
             {reference::item::sphere::t, reference::item::sphere::hit, reference::item::sphere::normal})
            EXPECT_EQ(verdict_on(score, id), "right") << scene << id.name;
        std::string hit = with_line(miss, 6, "d", "0.000001");
        hit = with_line(hit, 6, "t", "4.999500");
        EXPECT_EQ(verdict_on(mark(hit, marking), reference::item::sphere::t), "right") << scene;
    }
}

TEST(CloseCall, AcceptsAMissBesideAPositiveDiscriminant) {
    // The root may come from the ray's point nearest to the center, which does not use d.
    const student::Marking marking = student::scene_named("barely hit");
    std::string output = with_line(right_output(marking), 6, "d", "0.000004");
    output = with_line(output, 6, "t", "no hit");
    EXPECT_EQ(verdict_on(mark(output, marking), reference::item::sphere::t), "right");
}

TEST(CloseCall, DoesNotAcceptARootAgainstTheStudentsOwnDiscriminant) {
    const student::Marking marking = student::scene_named("barely missed");
    std::string output = with_line(right_output(marking), 6, "d", "-0.000004");
    output = with_line(output, 6, "t", "4.999500");
    EXPECT_EQ(verdict_on(mark(output, marking), reference::item::sphere::t), "wrong");
}

TEST(CloseCall, DoesNotApplyIfTheRayClearlyHits) {
    const student::Marking marking = student::off_axis_scene();
    const Score score = mark(with_line(right_output(marking), 6, "t", "no hit"), marking);
    EXPECT_EQ(verdict_on(score, reference::item::sphere::t), "wrong");
}

TEST(CloseCall, AcceptsAMissWithAndWithoutAHitPoint) {
    const student::Marking marking = student::scene_named("triangle missed");
    EXPECT_EQ(verdict_on(mark(right_output(marking, true), marking), reference::item::triangle::hit), "right");
    EXPECT_EQ(verdict_on(mark(right_output(marking, false), marking), reference::item::triangle::hit), "right");
}

TEST(CloseCall, IsAMatterOfFollowThroughAfterAWrongValue) {
    // Rounding may take the ray past the triangle here, but this program's u is wrong, and misses it clearly.
    const student::Marking marking = student::scene_named("barely inside");
    std::string output = with_line(right_output(marking), 8, "u", "-0.500000");
    output = with_line(output, 8, "Hit point P_t", "no hit");
    const Score score = mark(output, marking);
    EXPECT_EQ(verdict_on(score, reference::item::triangle::u), "wrong");
    EXPECT_EQ(verdict_on(score, reference::item::triangle::hit), "follow");
}

TEST(CloseCall, FollowsTheRubricsPolicyIfTIsExactlyZero) {
    const std::string toml = student::camera_on_the_axis(4) + R"(
[[sphere]]
center = [1, 1, 0]
radius = 2
[[triangle]]
vertices = [[0, -2, 2], [2, 2, 2], [-2, 2, 2]]
[rubric]
boundary = )";
    const auto marks = [&](const std::string& policy, Boundary boundary) {
        const student::Marking marking = student::marking_of(toml + "\"" + policy + "\"", "policy");
        Way way;
        way.boundary = boundary;
        way.true_hits_only = true;
        student::Layout exact_zeros;
        exact_zeros.format = student::NumberFormat::stream;
        const Score score = mark(print(Program(marking.assignment, way), exact_zeros), marking);
        return verdict_on(score, reference::item::triangle::hit) + " " +
               verdict_on(score, reference::item::first_object);
    };
    EXPECT_EQ(marks("either", Boundary::positive), "right right");
    EXPECT_EQ(marks("either", Boundary::nonnegative), "right right");
    EXPECT_EQ(marks("nonnegative", Boundary::nonnegative), "right right");
    EXPECT_EQ(marks("nonnegative", Boundary::positive), "wrong wrong");
    EXPECT_EQ(marks("positive", Boundary::positive), "right right");
    EXPECT_EQ(marks("positive", Boundary::nonnegative), "right wrong")
        << "the point of the plane may be printed all the same";
}

TEST(CloseVerdicts, IncludeAllThatATieMayRoundTo) {
    for (const char* scene : {"tie", "almost a tie"}) {
        const student::Marking marking = student::scene_named(scene);
        const std::string output = right_output(marking);
        for (const char* verdict :
             {"ray hits sphere first", "ray hits triangle first", "ray hits two objects at the same t"}) {
            std::string claimed = output;
            const std::size_t line = claimed.rfind("ray hits");
            claimed.replace(line, claimed.find('\n', line) - line, verdict);
            EXPECT_EQ(verdict_on(mark(claimed, marking), reference::item::first_object), "right")
                << scene << ": " << verdict;
        }
        std::string nothing = output;
        const std::size_t line = nothing.rfind("ray hits");
        nothing.replace(line, nothing.find('\n', line) - line, "ray hits nothing");
        EXPECT_EQ(verdict_on(mark(nothing, marking), reference::item::first_object), "wrong") << scene;
    }
}

}  // namespace
}  // namespace harness
