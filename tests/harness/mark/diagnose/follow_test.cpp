#include "harness/mark/diagnose/follow.h"

#include <gtest/gtest.h>

#include "tests/given/printed_values.h"
#include "tests/given/student/mistakes.h"
#include "tests/given/student/printout.h"

namespace harness {
namespace {

using student::Floats;
using student::Program;

/// The marks of a program that has `value` for `id` and computes all later answers from it.
Score mark_with(const ItemId& id, const Floats& value, std::string_view scene = "off axis") {
    const student::Marking marking = student::scene_named(scene);
    const Program program(marking.assignment, {},
                          Program::Mistake{id, [=](const Program&, const auto&) { return std::optional(value); }});
    return mark(print(program), marking);
}

TEST(Follow, IsGivenForARightStageOnAWrongValue) {
    const Score score = mark_with({6, "c"}, {12.5F});
    EXPECT_EQ(verdict_on(score, {6, "c"}), "wrong");
    EXPECT_EQ(verdict_on(score, {6, "d"}), "follow");
    EXPECT_EQ(verdict_on(score, {6, "b"}), "right") << "b does not depend on c";
}

TEST(Follow, IsGivenAlongTheWholeChainAndForTheVerdict) {
    const Score score = mark_with({6, "t"}, {9.5F});
    for (const ItemId& id : {ItemId{6, "hit"}, ItemId{7, "normal"}, ItemId{10, "verdict"}})
        EXPECT_EQ(verdict_on(score, id), "follow") << id.second;
    EXPECT_EQ(verdict_on(score, {8, "t"}), "right");
}

TEST(Follow, IsNotGivenToASecondMistake) {
    const student::Marking marking = student::off_axis_scene();
    const Program program(marking.assignment, {}, Program::Mistake{{6, "c"}, [](const Program&, const auto&) {
                                                                       return std::optional(Floats{9.0F});
                                                                   }});
    std::string output = print(program);
    const std::size_t d = output.find("\nd: ");
    output.replace(d, output.find('\n', d + 1) - d, "\nd: 3.25");
    EXPECT_EQ(verdict_on(mark(output, marking), {6, "d"}), "wrong");
}

TEST(Follow, IsNotGivenForAValueBesideWhichTheSceneIsLost) {
    // The right-hand side is P_WCS - A, which is P_WCS itself in float.
    const Score score = mark_with({4, "P_WCS"}, {1e15F, 1e15F, 1e15F});
    EXPECT_EQ(item_of(score, {8, "rhs"}).printed, item_of(score, {4, "P_WCS"}).printed);
    EXPECT_EQ(verdict_on(score, {8, "rhs"}), "wrong");
    EXPECT_EQ(verdict_on(mark_with({4, "P_WCS"}, {100, 100, 100}), {8, "rhs"}), "follow");
}

TEST(Follow, IsNotGivenForAResultThatDigitsLeaveOpen) {
    // c is 7 for P_WCS = (0, 0, 3), and anything from 6.5 to 7.3 for what rounds to it.
    const student::Marking marking = student::handout_scene();
    std::string output = print(Program(marking.assignment, {}));
    output = student::with_line(output, 4, "Pixel in WCS", "vec3(0.0, 0.0, 3.0)");
    EXPECT_EQ(verdict_on(mark(student::with_line(output, 6, "c", "7.000000"), marking), {6, "c"}), "follow");
    EXPECT_EQ(verdict_on(mark(student::with_line(output, 6, "c", "7.250000"), marking), {6, "c"}), "wrong");
}

TEST(Follow, IsNotGivenAfterAnAnswerThatIsOnlyCoarse) {
    // c is printed with three digits, which are right. So it is no mistake from which another d follows.
    const student::Marking marking = student::off_axis_scene();
    const Program program(marking.assignment, {}, Program::Mistake{{6, "c"}, [](const Program&, const auto&) {
                                                                       return std::optional(Floats{10.2F});
                                                                   }});
    const Score score = mark(student::with_line(print(program), 6, "c", "10.2"), marking);
    EXPECT_EQ(item_of(score, {6, "c"}).diagnosis, "too few decimals");
    EXPECT_EQ(verdict_on(score, {6, "d"}), "wrong");
}

TEST(Follow, IsNotGivenForADirectionOfZero) {
    const Score score = mark_with({5, "V"}, {0, 0, 0});
    for (const ItemId& id : {ItemId{6, "a"}, ItemId{6, "b"}, ItemId{6, "d"}, ItemId{8, "matrix"}})
        EXPECT_EQ(verdict_on(score, id), "wrong") << id.second;
}

TEST(Follow, IsNotGivenForASingularSystem) {
    const Score score = mark_with({8, "matrix"}, {0, 0, 0, 0, 0, 0, 0, 0, 0});
    EXPECT_EQ(verdict_on(score, {8, "t"}), "wrong") << "nan";
}

TEST(Follow, IsNotGivenForANormalAtTheCentre) {
    const Score score = mark_with({6, "hit"}, {3.9F, -0.6F, 0});
    EXPECT_EQ(verdict_on(score, {7, "normal"}), "wrong");
}

TEST(Follow, IsNotGivenForAMissAfterAWrongNone) {
    const student::Marking marking = student::off_axis_scene();
    const Program program(marking.assignment, {}, Program::Mistake{{6, "t"}, [](const Program&, const auto&) {
                                                                       return std::optional<Floats>();
                                                                   }});
    const Score score = mark(print(program), marking);
    EXPECT_EQ(verdict_on(score, {6, "t"}), "wrong");
    EXPECT_EQ(verdict_on(score, {6, "hit"}), "wrong");
    EXPECT_EQ(verdict_on(score, {7, "normal"}), "wrong");
    EXPECT_EQ(verdict_on(score, {10, "verdict"}), "wrong");
}

TEST(Follow, IsGivenForAMissAfterANegativeDiscriminant) {
    const Score score = mark_with({6, "c"}, {25.0F});
    for (const ItemId& id :
         {ItemId{6, "d"}, ItemId{6, "t"}, ItemId{6, "hit"}, ItemId{7, "normal"}, ItemId{10, "verdict"}}) {
        EXPECT_EQ(verdict_on(score, id), "follow") << id.second;
    }
}

TEST(Follow, UsesTheStudentsOwnLayoutOfTheSystem) {
    const student::Marking marking = student::off_axis_scene();
    student::Way way;
    way.columns = {2, 0, 1};
    const Program program(marking.assignment, way, Program::Mistake{{5, "V"}, [](const Program&, const auto&) {
                                                                        return std::optional(Floats{0.6F, 0, -0.8F});
                                                                    }});
    const Score score = mark(print(program), marking);
    for (const ItemId& id : {ItemId{8, "matrix"}, ItemId{8, "t"}, ItemId{8, "u"}, ItemId{8, "v"}})
        EXPECT_EQ(verdict_on(score, id), "follow") << id.second;
}

TEST(Follow, IsGivenForCoarselyPrintedValues) {
    // c is right but printed with only three digits. Answers computed with the exact c must still be accepted.
    const student::Marking marking = student::off_axis_scene();
    std::string output = print(Program(marking.assignment, {}));
    const std::size_t c = output.find("\nc: ");
    output.replace(c, output.find('\n', c + 1) - c, "\nc: 10.2");
    const Score score = mark(output, marking);
    EXPECT_EQ(verdict_on(score, {6, "c"}), "wrong") << "the rubric asks for two decimals";
    for (const ItemId& id : {ItemId{6, "d"}, ItemId{6, "t"}, ItemId{6, "hit"}, ItemId{7, "normal"}})
        EXPECT_EQ(verdict_on(score, id), "right") << id.second;
}

}  // namespace
}  // namespace harness
