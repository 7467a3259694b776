// The marks of programs that cast a ray at a sphere, a triangle and a cylinder.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "harness/mark/score/score.h"
#include "tests/given/cases.h"
#include "tests/given/printed_values.h"
#include "tests/given/student/printout.h"

namespace harness {
namespace {

using reference::ItemId;
using student::Floats;
using student::Program;
using student::Way;
namespace tube = reference::item::cylinder;

/// A program that has this t for the object.
Program::Mistake wrong_t(reference::Subject object, float t) {
    return {{object, "t"}, [=](const Program&, const auto&) { return std::optional(Floats{t}); }};
}

std::string with_verdict(std::string output, std::string_view verdict) {
    const std::size_t line = output.rfind("ray hits");
    return output.replace(line, output.find('\n', line) - line, verdict);
}

/// Question 4's t in an output in the handout's layout.
std::string with_cylinder_t(const std::string& output, const std::string& t) {
    return student::with_line(output, 4, "t", t);
}

/// What loses points, one item per line.
std::string lost_items(const Score& score) {
    std::string text;
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) {
            if (item.verdict == ItemVerdict::right) continue;
            text += fmt::format("{}.{} is {}: {}\n", question.number, item.spec.name, to_string(item.verdict),
                                item.printed);
        }
    }
    return text;
}

TEST(CylinderMarks, AreFullForRightPrograms) {
    // Where rounding decides what is hit, a correct program may go either way.
    for (const std::string_view scene : student::cylinder_scene_names()) {
        const student::Marking marking = student::scene_named(scene);
        for (const auto arithmetic : {Way::Arithmetic::stages, Way::Arithmetic::glm}) {
            for (const auto boundary : {reference::Boundary::positive, reference::Boundary::nonnegative}) {
                for (const bool half_b : {false, true}) {
                    Way way;
                    way.arithmetic = arithmetic;
                    way.boundary = boundary;
                    way.half_b = half_b;
                    const std::string output = print(Program(marking.assignment, way));
                    EXPECT_EQ(lost_items(mark(output, marking)), "") << scene << (half_b ? ", half b" : "") << "\n"
                                                                     << output;
                }
            }
        }
    }
}

TEST(CylinderMarks, AcceptHalfBOnlyWithItsOwnDiscriminant) {
    const student::Marking marking = student::scene_named("tube and bottom");
    Way half;
    half.half_b = true;
    const Program program(marking.assignment, half);
    const Score score = mark(print(program), marking);
    for (const ItemId& id : {tube::b, tube::d}) {
        EXPECT_EQ(verdict_on(score, id), "right") << id.name;
        EXPECT_EQ(item_of(score, id).accepted_as, "the form with b' = b/2 and d' = b'^2 - ac") << id.name;
    }
    const std::string whole_d = fmt::format("{:f}", Program(marking.assignment, {}).scalar(tube::d));
    const Score mixed = mark(student::with_line(print(program), 4, "d", whole_d), marking);
    EXPECT_EQ(verdict_on(mixed, tube::b), "wrong");
    EXPECT_EQ(item_of(mixed, tube::b).diagnosis, "factor 2 missing");
}

TEST(CylinderMarks, AcceptAnEquationMultipliedAsAWhole) {
    const student::Marking marking = student::scene_named("through the tube");
    Way twice;
    twice.quadratic_factor = -2;
    const Score score = mark(print(Program(marking.assignment, twice)), marking);
    EXPECT_EQ(lost_items(score), "");
    EXPECT_EQ(item_of(score, tube::c).accepted_as, "the whole equation multiplied by a number");
}

TEST(CylinderMarks, DoNotTakeAMissedCapForAMissedCylinder) {
    for (const char* cap : {"tampa", "tappo", "coperchio", "disco", "couvercle", "cap", "tubo"}) {
        const std::string missed = fmt::format("{0} superior: no hit\n{0} inferior: no hit\n", cap);
        const student::Marking met = student::scene_named("tube and bottom");
        std::string right = print(Program(met.assignment, {}));
        right.insert(right.find("\nt: ", right.find("Question 4")) + 1, missed);
        EXPECT_EQ(lost_items(mark(right, met)), "") << cap;
    }
}

TEST(CylinderMarks, LetTheVerdictOfThreeObjectsFollow) {
    const student::Marking marking = student::scene_named("top and tube");
    const auto verdict_after = [&](const Program::Mistake& mistake) {
        return verdict_on(mark(print(Program(marking.assignment, {}, mistake)), marking),
                          reference::item::first_object);
    };
    using enum reference::Subject;
    EXPECT_EQ(verdict_after(wrong_t(cylinder, 99)), "follow") << "the sphere is first then";
    EXPECT_EQ(verdict_after(wrong_t(sphere, 0.5)), "follow");
    EXPECT_EQ(verdict_after(wrong_t(triangle, 0.5)), "follow");
    EXPECT_EQ(verdict_after(wrong_t(triangle, 99)), "right") << "the cylinder is first all the same";
}

TEST(CylinderMarks, ReportAVerdictThatContradictsTheStudentsValues) {
    const student::Marking marking = student::scene_named("top and tube");
    const std::string output = print(Program(marking.assignment, {}, wrong_t(reference::Subject::cylinder, 99)));
    const Score score = mark(with_verdict(output, "ray hits triangle first"), marking);
    EXPECT_EQ(verdict_on(score, reference::item::first_object), "wrong");
    EXPECT_EQ(item_of(score, reference::item::first_object).diagnosis, "verdict against own values");
    EXPECT_EQ(verdict_on(mark(with_verdict(output, "ray hits sphere first"), marking), reference::item::first_object),
              "follow");
}

TEST(CylinderMarks, DoNotLetAVerdictFollowFromOneWrongTOfTwoObjects) {
    // The sphere's t is printed for the cylinder too. It decides nothing, unless the triangle is nearer.
    const student::Marking marking = student::scene_named("top and tube");
    const Program right(marking.assignment, {});
    const std::string same_t = fmt::format("{:f}", right.scalar(reference::item::sphere::t));
    std::string output = with_cylinder_t(print(right), same_t);
    EXPECT_EQ(verdict_on(mark(with_verdict(output, "ray hits sphere first"), marking), reference::item::first_object),
              "wrong");
    output = student::with_line(output, 3, "t", "0.500000");
    EXPECT_EQ(verdict_on(mark(with_verdict(output, "ray hits triangle first"), marking), reference::item::first_object),
              "follow");
}

TEST(CylinderMarks, AcceptEitherDecisionThatRoundingMakesAtARim) {
    const auto verdicts = [](std::string_view scene, const std::string& t, const std::string& normal) {
        const student::Marking marking = student::scene_named(scene);
        std::string output = with_cylinder_t(print(Program(marking.assignment, {})), t);
        const std::string point = t == "no hit" ? "no hit" : "vec3(1.553397, 0.754977, 1.518373)";
        output = student::with_line(output, 4, "Hit point P_c", point);
        const Score score = mark(student::with_line(output, 4, "Cylinder normal", normal), marking);
        return verdict_on(score, tube::t) + " " + verdict_on(score, tube::hit) + " " + verdict_on(score, tube::normal);
    };
    constexpr const char *of_tube = "vec3(0.348767, 0.000000, 0.937209)", *up = "vec3(0.000000, 1.000000, 0.000000)",
                         *down = "vec3(0.000000, -1.000000, 0.000000)";
    for (const char* scene : {"near rim, tube", "near rim, cap"}) {
        EXPECT_EQ(verdicts(scene, "1.954019", of_tube), "right right right") << scene;
        EXPECT_EQ(verdicts(scene, "1.954019", up), "right right right") << scene;
        EXPECT_EQ(verdicts(scene, "1.954019", down), "right right wrong") << scene;
    }
    for (const char* scene : {"near bottom rim, hit", "near bottom rim, missed"}) {
        EXPECT_EQ(verdicts(scene, "1.954019", of_tube), "right right right") << scene;
        EXPECT_EQ(verdicts(scene, "1.954019", down), "right right right") << scene;
        EXPECT_EQ(verdicts(scene, "no hit", "none"), "right right right") << scene;
        EXPECT_EQ(verdicts(scene, "1.254019", of_tube).substr(0, 5), "wrong") << scene;
    }
    EXPECT_EQ(verdicts("tube and bottom", "no hit", "none"), "wrong wrong wrong") << "that is no close call";
    EXPECT_EQ(verdicts("tube and bottom", "1.954019", up), "right right wrong");
}

TEST(CylinderMarks, AcceptEitherDecisionWhereTheRayTouchesTheTube) {
    for (const char* scene : {"tube touched", "tube barely missed"}) {
        const student::Marking marking = student::scene_named(scene);
        const std::string output = print(Program(marking.assignment, {}));
        std::string miss = with_cylinder_t(student::with_line(output, 4, "d", "-0.000001"), "no hit");
        miss = student::with_line(miss, 4, "Hit point P_c", "no hit");
        miss = student::with_line(miss, 4, "Cylinder normal", "none");
        EXPECT_EQ(lost_items(mark(with_verdict(miss, "ray hits sphere first"), marking)), "") << scene;
        std::string hit = with_cylinder_t(student::with_line(output, 4, "d", "0.000001"), "3.685700");
        EXPECT_EQ(verdict_on(mark(hit, marking), tube::t), "right") << scene;
        hit = with_cylinder_t(hit, "3.785700");
        EXPECT_EQ(verdict_on(mark(hit, marking), tube::t), "wrong") << scene;
    }
}

}  // namespace
}  // namespace harness
