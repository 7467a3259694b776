#include "harness/mark/score/judge.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "tests/given/printed_values.h"
#include "tests/given/student/printout.h"
#include "tests/harness/mark/score/handout_output.h"

namespace harness {
namespace {

using student::Program;

TEST(Judge, FindsEveryItemOfAPlainOutputRight) {
    const Score score = mark(handout_output(), student::handout_scene());
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items)
            EXPECT_EQ(item.verdict, ItemVerdict::right) << question.number << item.spec.name;
    }
}

TEST(Judge, NeverFindsNanOrInfinityRight) {
    for (const char* text : {"nan", "-nan", "inf", "-inf"}) {
        EXPECT_EQ(verdict_with({{"t", text}}, reference::item::sphere::t), "wrong") << text;
        EXPECT_EQ(verdict_with({{"P_s", fmt::format("vec3({0}, {0}, {0})", text)}}, reference::item::sphere::hit),
                  "wrong")
            << text;
    }
}

TEST(Judge, DoesNotCallAnAcceptedVerdictConsistent) {
    // At t = 0 the triangle or, behind it, the sphere is accepted. By this u the ray misses the triangle.
    const std::map<std::string, std::string> beside = {{"u", "-0.25"}};
    ASSERT_EQ(verdict_with(beside, reference::item::triangle::u), "wrong");
    const auto verdict = [&](const std::string& said) {
        std::map<std::string, std::string> changed = beside;
        changed["verdict"] = said;
        return verdict_with(changed, reference::item::first_object);
    };
    EXPECT_EQ(verdict("ray hits sphere first"), "right");
    EXPECT_EQ(verdict("ray hits triangle first"), "right") << "its t is smaller";
    EXPECT_EQ(verdict("ray hits nothing"), "wrong");
    EXPECT_EQ(verdict_with({{"u", "-0.25"}, {"t8", "1"}}, reference::item::first_object), "wrong")
        << "the triangle is neither hit nor nearer";
}

TEST(Judge, NamesAVerdictThatOnlyComparesT) {
    // The triangle's plane is nearer than the sphere, but the ray passes the triangle.
    const student::Marking marking = student::scene_named("triangle missed");
    std::string output = print(Program(marking.assignment, {}));
    const std::string right = "ray hits sphere first";
    ASSERT_NE(output.find(right), std::string::npos) << output;
    output.replace(output.find(right), right.size(), "ray hits triangle first");
    const ItemScore verdict = item_of(mark(output, marking), reference::item::first_object);
    EXPECT_EQ(verdict.verdict, ItemVerdict::wrong);
    EXPECT_EQ(verdict.diagnosis, "hit not tested");
}

TEST(Judge, DoubtsAMistakeOnlyIfOthersGiveTheSameValue) {
    const auto judged = [](const std::string& label, const std::string& value, const reference::ItemId& id) {
        return item_of(mark(handout_output({{label, value}}), student::handout_scene()), id);
    };
    const ItemScore clear = judged("t", "3.41421", reference::item::sphere::t);
    EXPECT_EQ(clear.diagnosis, "far root");
    EXPECT_FALSE(clear.may_be_chance);
    const ItemScore simple = judged("b", "4", reference::item::sphere::b);
    EXPECT_EQ(simple.diagnosis, "sign of b");
    EXPECT_TRUE(simple.may_be_chance);
}

TEST(Judge, SaysThatAnEarlierMistakeMadeASlipVisible) {
    const std::string visible = " This shows only because of your earlier mistake.";
    const student::Marking marking = student::off_axis_scene();
    const Program program(marking.assignment, {});
    // With b negated, both roots are behind the start; the sphere is named all the same.
    const float b = -program.scalar(reference::item::sphere::b), d = program.scalar(reference::item::sphere::d);
    std::string output = student::with_line(print(program), 6, "b", std::to_string(b));
    output = student::with_line(output, 6, "t", std::to_string((-b - std::sqrt(d)) / 2));
    const Score score = mark(output, marking);
    EXPECT_EQ(item_of(score, reference::item::sphere::t).diagnosis, "root behind the start");
    EXPECT_TRUE(item_of(score, reference::item::sphere::t).advice.ends_with(visible));
}

TEST(Judge, SaysThatTheNamedObjectIsMissedByOwnValues) {
    const student::Marking marking = student::scene_named("handout");
    std::string output = print(Program(marking.assignment, {}));
    output = student::with_line(student::with_line(output, 6, "d", "-7"), 6, "t", "none");
    output.replace(output.find("triangle first"), std::string("triangle first").size(), "sphere first");
    const ItemScore verdict = item_of(mark(output, marking), reference::item::first_object);
    EXPECT_EQ(verdict.diagnosis, "verdict against own values");
    EXPECT_EQ(verdict.advice,
              "According to your own values, the ray does not hit that object; test this before you compare t. This "
              "shows only because of your earlier mistake.");
}

TEST(Judge, TakesNanForAMiss) {
    const student::Marking marking = student::off_axis_scene();
    const Program program(marking.assignment, {});
    ASSERT_EQ(program.first_object(), reference::FirstObject(reference::Subject::sphere));
    std::string output = print(program);
    for (const auto& [question, label, value] :
         {std::tuple(6, "c", "1000"), std::tuple(6, "d", "-3950"), std::tuple(6, "t", "-nan"),
          std::tuple(6, "Hit point P_s", "vec3(-nan, -nan, -nan)"),
          std::tuple(7, "Sphere normal", "vec3(-nan, -nan, -nan)")})
        output = student::with_line(output, question, label, value);
    output.replace(output.find("sphere first"), std::string("sphere first").size(), "triangle first");
    EXPECT_EQ(verdict_on(mark(output, marking), reference::item::sphere::t), "follow");
    EXPECT_EQ(verdict_on(mark(output, marking), reference::item::first_object), "follow");
}

TEST(Judge, ExpectsTheOtherObjectFirstIfOneIsWronglyCalledMissed) {
    const student::Marking marking = student::off_axis_scene();
    const Program program(marking.assignment, {});
    ASSERT_EQ(program.first_object(), reference::FirstObject(reference::Subject::sphere));
    const auto verdict_behind = [&](const std::vector<std::string>& missed, const std::string& said) {
        std::string output = print(program);
        for (const std::string& label : missed) output = student::with_line(output, 6, label, "none");
        output.replace(output.find("ray hits sphere first"), std::string("ray hits sphere first").size(), said);
        return verdict_on(mark(output, marking), reference::item::first_object);
    };
    EXPECT_EQ(verdict_behind({"t"}, "ray hits triangle first"), "follow");
    EXPECT_EQ(verdict_behind({"Hit point P_s"}, "ray hits triangle first"), "follow");
    EXPECT_EQ(verdict_behind({"t"}, "ray hits nothing"), "wrong");
    EXPECT_EQ(verdict_behind({}, "ray hits triangle first"), "wrong");
}

TEST(Judge, AcceptsMinusZeroForZero) {
    EXPECT_EQ(verdict_with({{"t8", "-0"}}, reference::item::triangle::t), "right");
    EXPECT_EQ(verdict_with({{"X_vcs", "vec3(1.000000, -0.000000, -0.000000)"}}, reference::item::X_vcs), "right");
}

TEST(Judge, LetsNanFollowFromAnOwnNegativeDiscriminant) {
    // c is 6 by mistake, so d is -8, and the program takes its root.
    const std::map<std::string, std::string> negative = {
        {"c", "6"}, {"d", "-8"}, {"t", "-nan"}, {"P_s", "vec3(-nan, -nan, -nan)"}, {"N", "vec3(nan, nan, nan)"}};
    for (const char* name : {"d", "t", "hit"})
        EXPECT_EQ(verdict_with(negative, {reference::Subject::sphere, name}), "follow") << name;
    EXPECT_EQ(verdict_with(negative, reference::item::sphere::normal), "follow");
    EXPECT_EQ(verdict_with({{"t", "nan"}}, reference::item::sphere::t), "wrong") << "with the right discriminant";
    EXPECT_EQ(verdict_with({{"t", "nan"}, {"P_s", "vec3(nan, nan, nan)"}}, reference::item::sphere::hit), "follow");
}

/// The score of a value of the handout's scene if float can't answer its item.

TEST(Judge, AppliesTheRubricsDecimals) {
    EXPECT_EQ(verdict_with({{"t", "0.59"}}, reference::item::sphere::t), "right");
    EXPECT_EQ(verdict_with({{"t", "0.58"}}, reference::item::sphere::t), "wrong") << "cut off, not rounded";
    EXPECT_EQ(verdict_with({{"t", "0.6"}}, reference::item::sphere::t), "wrong") << "one decimal";
    EXPECT_EQ(verdict_with({{"t", "1"}}, reference::item::sphere::t), "wrong") << "an integer";
}

TEST(Judge, SaysThatAnAnswerHasTooFewDigitsToTell) {
    static const student::Marking marking = student::handout_scene();
    const auto advice = [](const std::string& label, const std::string& printed) {
        return item_of(mark(handout_output({{label, printed}}), marking), reference::item::sphere::t).advice;
    };
    const std::string too_few = "This has too few digits to tell whether it is right; print at least 2 decimals.";
    EXPECT_EQ(advice("t", "0.6"), too_few);
    for (const char* other : {"0.7", "1", "0", "0.58", "0.59"}) EXPECT_NE(advice("t", other), too_few) << other;
}

TEST(Judge, InfersAMissFromTheStudentsDIfTIsMissing) {
    const student::Marking marking = student::off_axis_scene();
    const student::Program program(marking.assignment, {},
                                   student::Program::Mistake{reference::item::sphere::c, [](const auto&, const auto&) {
                                                                 return std::optional(student::Floats{1000});
                                                             }});
    const std::string output = print(program, student::Layout{}, [](const ItemId& id) {
        return id != reference::item::sphere::t && id != reference::item::sphere::hit &&
               id != reference::item::sphere::normal;
    });
    EXPECT_EQ(verdict_on(mark(output, marking), reference::item::sphere::t), "missing");
    EXPECT_EQ(verdict_on(mark(output, marking), reference::item::first_object), "follow");
}

TEST(Judge, ComparesTheVerdictWithTheStudentsOwnValues) {
    const std::map<std::string, std::string> far = {{"t8", "0.75"}, {"t", "3.414214"}};
    auto says_sphere = far;
    says_sphere["verdict"] = "ray hits sphere first";
    static const student::Marking marking = student::handout_scene();
    const Score score = mark(handout_output(says_sphere), marking);
    EXPECT_EQ(verdict_on(score, reference::item::first_object), "wrong");
    EXPECT_EQ(item_of(score, reference::item::first_object).diagnosis, "verdict against own values");
    EXPECT_EQ(verdict_with({{"verdict", "ray hits nothing"}}, reference::item::first_object), "wrong");
    EXPECT_EQ(verdict_with({{"verdict", "ray hits sphere first"}}, reference::item::first_object), "right")
        << "t = 0 is not positive";
    EXPECT_EQ(verdict_with({{"t8", "5"}, {"verdict", "ray hits sphere first"}}, reference::item::first_object), "right")
        << "right is right";
}

TEST(Judge, AcceptsAVerdictThatFollowsFromWrongValues) {
    student::Marking marking = student::off_axis_scene();
    Program program(marking.assignment, {},
                    Program::Mistake{reference::item::sphere::t, [](const Program&, const auto&) {
                                         return std::optional(student::Floats{77.0F});
                                     }});
    EXPECT_EQ(verdict_on(mark(print(program), marking), reference::item::first_object), "follow");
}

TEST(Judge, DoesNotLetAVerdictFollowFromRightValues) {
    // The sphere is met at t = 201.41 and the triangle at 201.43, which 201.4 is too coarse to tell.
    const student::Marking marking =
        student::marking_of(student::camera_on_the_axis(4) +
                                "[[sphere]]\ncenter = [0, 0, -299.41]\nradius = 100\n"
                                "[[triangle]]\nvertices = [[-9, -9, -199.43], [9, -9, -199.43], [0, 9, -199.43]]\n",
                            "close together");
    std::string output = student::with_line(print(Program(marking.assignment, {})), 8, "t", "201.4");
    EXPECT_EQ(verdict_on(mark(output, marking), reference::item::first_object), "right");
    const std::string_view sphere = "ray hits sphere first";
    output.replace(output.rfind(sphere), sphere.size(), "ray hits triangle first");
    EXPECT_EQ(verdict_on(mark(output, marking), reference::item::first_object), "wrong");
}

TEST(Judge, DistinguishesUnreadableFromMissing) {
    EXPECT_EQ(verdict_with({{"P_s", "12"}}, reference::item::sphere::hit), "unreadable");
    EXPECT_EQ(verdict_with({{"P_s", ""}}, reference::item::sphere::hit), "missing");
}

}  // namespace
}  // namespace harness
