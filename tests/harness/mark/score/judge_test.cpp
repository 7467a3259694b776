#include "harness/mark/score/judge.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>

#include "tests/given/printed_values.h"
#include "tests/given/student/printout.h"

namespace harness {
namespace {

using student::Program;
using student::Way;

/// The right output for the handout's scene, with the values of some labels replaced.
std::string handout_output(const std::map<std::string, std::string>& changed = {}) {
    const std::pair<const char*, std::vector<std::pair<const char*, const char*>>> questions[] = {
        {"1", {{"P_VCS", "vec3(0.000000, 0.000000, -2.000000)"}}},
        {"2",
         {{"X_vcs", "vec3(1.000000, 0.000000, 0.000000)"},
          {"Y_vcs", "vec3(0.000000, 1.000000, 0.000000)"},
          {"Z_vcs", "vec3(0.000000, 0.000000, 1.000000)"}}},
        {"3",
         {{"M",
           "mat4x4((1.000000, 0.000000, 0.000000, 0.000000), (0.000000, 1.000000, 0.000000, 0.000000), "
           "(0.000000, 0.000000, 1.000000, 0.000000), (0.000000, 0.000000, 4.000000, 1.000000))"}}},
        {"4", {{"P_WCS", "vec3(0.000000, 0.000000, 2.000000)"}}},
        {"5", {{"V", "vec3(0.000000, 0.000000, -1.000000)"}}},
        {"6",
         {{"a", "1"},
          {"b", "-4"},
          {"c", "2"},
          {"d", "8"},
          {"t", "0.585786"},
          {"P_s", "vec3(0.000000, 0.000000, 1.414214)"}}},
        {"7", {{"N", "vec3(-0.500000, -0.500000, 0.707107)"}}},
        {"8",
         {{"A",
           "mat3x3((0.000000, 0.000000, 1.000000), (2.000000, 4.000000, 0.000000), (-2.000000, 4.000000, 0.000000))"},
          {"rhs", "vec3(0.000000, 2.000000, 0.000000)"},
          {"t8", "0"},
          {"u", "0.25"},
          {"v", "0.25"},
          {"P_t", "vec3(0.000000, 0.000000, 2.000000)"}}},
        {"9", {{"N9", "vec3(0.000000, 0.000000, 1.000000)"}}},
    };
    std::string text;
    for (const auto& [number, lines] : questions) {
        text += fmt::format("Question {}:\n", number);
        for (const auto& [label, value] : lines) {
            const auto other = changed.find(label);
            const std::string shown = std::string(label) == "t8" ? "t" : std::string(label) == "N9" ? "N" : label;
            if (other == changed.end() || !other->second.empty())
                text += fmt::format("{}: {}\n", shown, other == changed.end() ? value : other->second);
        }
    }
    const auto verdict = changed.find("verdict");
    return text + "Question 10:\n" + (verdict == changed.end() ? "ray hits triangle first" : verdict->second) + "\n";
}

std::string verdict_with(const std::map<std::string, std::string>& changed, const ItemId& id) {
    static const student::Marking marking = student::handout_scene();
    return verdict_on(mark(handout_output(changed), marking), id);
}

std::string accepted_with(const std::map<std::string, std::string>& changed, const ItemId& id) {
    static const student::Marking marking = student::handout_scene();
    return item_of(mark(handout_output(changed), marking), id).accepted_as;
}

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

TEST(Judge, CallsNoAcceptedVerdictOneThatOnlyFollows) {
    // At t = 0 the triangle or, behind it, the sphere is accepted. By this u the ray misses the triangle.
    const std::map<std::string, std::string> beside = {{"u", "-0.25"}};
    ASSERT_EQ(verdict_with(beside, reference::item::triangle::u), "wrong");
    const auto verdict = [&](const std::string& said) {
        std::map<std::string, std::string> changed = beside;
        changed["verdict"] = said;
        return verdict_with(changed, reference::item::verdict);
    };
    EXPECT_EQ(verdict("ray hits sphere first"), "right");
    EXPECT_EQ(verdict("ray hits triangle first"), "right") << "its t is smaller";
    EXPECT_EQ(verdict("ray hits nothing"), "wrong");
    EXPECT_EQ(verdict_with({{"u", "-0.25"}, {"t8", "1"}}, reference::item::verdict), "wrong")
        << "the triangle is neither hit nor nearer";
}

TEST(Judge, TakesANanForAMissAndForNoOthersValue) {
    const student::Marking marking = student::off_axis_scene();
    const Program program(marking.assignment, {});
    ASSERT_EQ(program.verdict(), reference::Verdict(reference::Subject::sphere));
    std::string output = print(program);
    for (const auto& [question, label, value] :
         {std::tuple(6, "c", "1000"), std::tuple(6, "d", "-3950"), std::tuple(6, "t", "-nan"),
          std::tuple(6, "Hit point P_s", "vec3(-nan, -nan, -nan)"),
          std::tuple(7, "Sphere normal", "vec3(-nan, -nan, -nan)")})
        output = student::with_line(output, question, label, value);
    output.replace(output.find("sphere first"), std::string("sphere first").size(), "triangle first");
    EXPECT_EQ(verdict_on(mark(output, marking), reference::item::sphere::t), "follow");
    EXPECT_EQ(verdict_on(mark(output, marking), reference::item::verdict), "follow");
}

TEST(Judge, AcceptsMinusZeroForZero) {
    EXPECT_EQ(verdict_with({{"t8", "-0"}}, reference::item::triangle::t), "right");
    EXPECT_EQ(verdict_with({{"X_vcs", "vec3(1.000000, -0.000000, -0.000000)"}}, reference::item::X_vcs), "right");
}

TEST(Judge, AcceptsHalfBOnlyWithItsOwnDiscriminant) {
    EXPECT_EQ(verdict_with({{"b", "-2"}, {"d", "2"}}, reference::item::sphere::b), "right");
    EXPECT_EQ(verdict_with({{"b", "-2"}, {"d", "2"}}, reference::item::sphere::d), "right");
    EXPECT_EQ(accepted_with({{"b", "-2"}, {"d", "2"}}, reference::item::sphere::b),
              "the form with b' = b/2 and d' = b'^2 - ac");
    EXPECT_EQ(verdict_with({{"b", "-2"}}, reference::item::sphere::b), "wrong") << "d = 8 is that of b = -4";
    EXPECT_EQ(verdict_with({{"b", "-2"}, {"d", "-4"}}, reference::item::sphere::b), "wrong")
        << "the factor 2 is missing";
    EXPECT_EQ(verdict_with({{"b", "-2"}, {"d", "-4"}}, reference::item::sphere::d), "follow");
}

TEST(Judge, AcceptsAQuadraticMultipliedAsAWhole) {
    const std::map<std::string, std::string> doubled = {{"a", "2"}, {"b", "-8"}, {"c", "4"}, {"d", "32"}};
    for (const char* name : {"a", "b", "c", "d", "t"})
        EXPECT_EQ(verdict_with(doubled, {reference::Subject::sphere, name}), "right") << name;
    EXPECT_EQ(verdict_with({{"a", "2"}, {"b", "-8"}, {"c", "4"}}, reference::item::sphere::d), "right")
        << "8 is still right by itself";
    EXPECT_EQ(verdict_with({{"a", "2"}, {"b", "-8"}}, reference::item::sphere::a), "wrong");
}

TEST(Judge, ReadsAVectorOfFour) {
    EXPECT_EQ(verdict_with({{"P_WCS", "vec4(0.000000, 0.000000, 2.000000, 1.000000)"}}, reference::item::P_WCS),
              "right");
    EXPECT_EQ(verdict_with({{"V", "vec4(0.000000, 0.000000, -1.000000, 0.000000)"}}, reference::item::V), "right");
    EXPECT_EQ(verdict_with({{"P_WCS", "vec4(0.000000, 0.000000, 2.000000, 3.000000)"}}, reference::item::P_WCS),
              "wrong");
}

TEST(Judge, AcceptsTheSystemWithRowsMultipliedOnBothSides) {
    const char* rows_doubled =
        "mat3x3((0.000000, 0.000000, 1.000000), (2.000000, 8.000000, 0.000000), (-2.000000, 8.000000, 0.000000))";
    EXPECT_EQ(verdict_with({{"A", rows_doubled}, {"rhs", "vec3(0.000000, 4.000000, 0.000000)"}},
                           reference::item::triangle::matrix),
              "right");
    EXPECT_EQ(verdict_with({{"A", rows_doubled}, {"rhs", "vec3(0.000000, 4.000000, 0.000000)"}},
                           reference::item::triangle::rhs),
              "right");
    EXPECT_EQ(verdict_with({{"A", rows_doubled}}, reference::item::triangle::matrix), "wrong")
        << "the right-hand side is not doubled";
}

TEST(Judge, AcceptsTheSystemWithEitherSign) {
    const char* negated =
        "mat3x3((0.000000, 0.000000, -1.000000), (-2.000000, -4.000000, 0.000000), (2.000000, -4.000000, 0.000000))";
    const char* reordered =
        "mat3x3((-2.000000, -4.000000, 0.000000), (2.000000, -4.000000, 0.000000), (0.000000, 0.000000, -1.000000))";
    const char* negated_rhs = "vec3(0.000000, -2.000000, 0.000000)";
    for (const char* matrix : {negated, reordered}) {
        EXPECT_EQ(verdict_with({{"A", matrix}, {"rhs", negated_rhs}}, reference::item::triangle::matrix), "right");
        EXPECT_EQ(verdict_with({{"A", matrix}, {"rhs", negated_rhs}}, reference::item::triangle::rhs), "right");
        EXPECT_EQ(verdict_with({{"A", matrix}, {"rhs", ""}}, reference::item::triangle::matrix), "right") << "alone";
        EXPECT_EQ(verdict_with({{"A", matrix}}, reference::item::triangle::rhs), "wrong")
            << "not the sign of its matrix";
    }
    EXPECT_EQ(verdict_with({{"A", ""}, {"rhs", negated_rhs}}, reference::item::triangle::rhs), "right") << "alone";
    EXPECT_EQ(verdict_with({{"rhs", negated_rhs}}, reference::item::triangle::rhs), "wrong")
        << "not the sign of its matrix";
    EXPECT_EQ(accepted_with({{"A", reordered}, {"rhs", negated_rhs}}, reference::item::triangle::matrix),
              "columns in the order u, v, t, both sides multiplied by -1");
}

TEST(Judge, LetsASystemOfEitherSignFollow) {
    // V is (0, 0.6, -0.8) and P_WCS is (0, 1, 2) by mistake; A is (0, -2, 2).
    const std::map<std::string, std::string> own = {{"V", "vec3(0.000000, 0.600000, -0.800000)"},
                                                    {"P_WCS", "vec3(0.000000, 1.000000, 2.000000)"}};
    const auto verdict = [&](const std::string& matrix, const std::string& rhs, const ItemId& id) {
        auto changed = own;
        changed["A"] = matrix;
        changed["rhs"] = rhs;
        return verdict_with(changed, id);
    };
    const char* matrix =
        "mat3x3((0.000000, -0.600000, 0.800000), (2.000000, 4.000000, 0.000000), (-2.000000, 4.000000, 0.000000))";
    const char* negated =
        "mat3x3((0.000000, 0.600000, -0.800000), (-2.000000, -4.000000, 0.000000), (2.000000, -4.000000, 0.000000))";
    const char* rhs = "vec3(0.000000, 3.000000, 0.000000)";
    const char* negated_rhs = "vec3(0.000000, -3.000000, 0.000000)";
    for (const ItemId& id : {reference::item::triangle::matrix, reference::item::triangle::rhs}) {
        EXPECT_EQ(verdict(matrix, rhs, id), "follow");
        EXPECT_EQ(verdict(negated, negated_rhs, id), "follow");
    }
    EXPECT_EQ(verdict("", negated_rhs, reference::item::triangle::rhs), "follow") << "alone";
    EXPECT_EQ(verdict(matrix, negated_rhs, reference::item::triangle::rhs), "wrong") << "not the sign of its matrix";
}

TEST(Judge, SolvesTheStudentsOwnSystemOfEitherSign) {
    // The right-hand side should be (0, 2, 0) and is (0, 3, 0), with both sides multiplied by -1: u = v = 3/8.
    const char* negated =
        "mat3x3((0.000000, 0.000000, -1.000000), (-2.000000, -4.000000, 0.000000), (2.000000, -4.000000, 0.000000))";
    const std::map<std::string, std::string> own = {
        {"A", negated}, {"rhs", "vec3(0.000000, -3.000000, 0.000000)"}, {"u", "0.375"}, {"v", "0.375"}};
    EXPECT_EQ(verdict_with(own, reference::item::triangle::matrix), "right");
    EXPECT_EQ(verdict_with(own, reference::item::triangle::rhs), "wrong");
    EXPECT_EQ(verdict_with(own, reference::item::triangle::u), "follow");
    EXPECT_EQ(verdict_with(own, reference::item::triangle::v), "follow");
    // The column B - A should be (2, 4, 0) and is (3, 4, 0): u = 1/5 and v = 3/10.
    const char* wrong =
        "mat3x3((0.000000, 0.000000, -1.000000), (-3.000000, -4.000000, 0.000000), (2.000000, -4.000000, 0.000000))";
    const std::map<std::string, std::string> other = {
        {"A", wrong}, {"rhs", "vec3(0.000000, -2.000000, 0.000000)"}, {"u", "0.2"}, {"v", "0.3"}};
    EXPECT_EQ(verdict_with(other, reference::item::triangle::matrix), "wrong");
    EXPECT_EQ(verdict_with(other, reference::item::triangle::u), "follow");
    EXPECT_EQ(verdict_with(other, reference::item::triangle::v), "follow");
}

TEST(Judge, SolvesTheStudentsOwnSystemWhoseSidesHaveOppositeSigns) {
    const char* matrix =
        "mat3x3((0.000000, 0.000000, 1.000000), (2.000000, 4.000000, 0.000000), (-2.000000, 4.000000, 0.000000))";
    const char* negated =
        "mat3x3((0.000000, 0.000000, -1.000000), (-2.000000, -4.000000, 0.000000), (2.000000, -4.000000, 0.000000))";
    for (const auto& [left, right] : {std::pair(matrix, "vec3(0.000000, -2.000000, 0.000000)"),
                                      std::pair(negated, "vec3(0.000000, 2.000000, 0.000000)")}) {
        const Score score = mark(handout_output({{"A", left}, {"rhs", right}, {"u", "-0.25"}, {"v", "-0.25"}}),
                                 student::handout_scene());
        EXPECT_EQ(verdict_on(score, reference::item::triangle::matrix), "right") << left;
        EXPECT_EQ(verdict_on(score, reference::item::triangle::rhs), "wrong") << left;
        EXPECT_EQ(item_of(score, reference::item::triangle::rhs).diagnosis, "right-hand side negated") << left;
        EXPECT_EQ(verdict_on(score, reference::item::triangle::u), "follow") << left;
        EXPECT_EQ(verdict_on(score, reference::item::triangle::v), "follow") << left;
    }
}

TEST(Judge, LetsNanFollowFromAnOwnNegativeDiscriminant) {
    // c is 6 by mistake, so d is -8, and the program takes its root.
    const std::map<std::string, std::string> negative = {
        {"c", "6"}, {"d", "-8"}, {"t", "-nan"}, {"P_s", "vec3(-nan, -nan, -nan)"}, {"N", "vec3(nan, nan, nan)"}};
    for (const char* name : {"d", "t", "hit"})
        EXPECT_EQ(verdict_with(negative, {reference::Subject::sphere, name}), "follow") << name;
    EXPECT_EQ(verdict_with(negative, reference::item::sphere::normal), "follow");
    EXPECT_EQ(verdict_with({{"t", "nan"}}, reference::item::sphere::t), "wrong") << "with the right discriminant";
    EXPECT_EQ(verdict_with({{"t", "nan"}, {"P_s", "vec3(nan, nan, nan)"}}, reference::item::sphere::hit), "wrong");
}

/// The score of a value of the handout's scene if float can't answer its item.
ItemScore score_without_bound(const std::string& label, const std::string& value, const ItemId& id) {
    student::Marking marking = student::handout_scene();
    for (auto& question : marking.key.questions) {
        for (auto& item : question.items) {
            reference::Answer& answer = item.answers.front();
            if (item.spec.id == id) answer.allowance.assign(answer.allowance.size(), HUGE_VAL);
        }
    }
    return item_of(
        mark(student::with_line(print(Program(marking.assignment, {})), question_of(id), label, value), marking), id);
}

std::string verdict_without_bound(const std::string& label, const std::string& value, const ItemId& id) {
    return std::string(to_string(score_without_bound(label, value, id).verdict));
}

TEST(Judge, AcceptsAnyNumberOfASolutionWhereFloatCannotAnswer) {
    EXPECT_EQ(verdict_without_bound("u", "123.5", reference::item::triangle::u), "right");
    EXPECT_EQ(verdict_without_bound("u", "nan", reference::item::triangle::u), "wrong");
    EXPECT_EQ(verdict_without_bound("u", "inf", reference::item::triangle::u), "wrong");
    EXPECT_EQ(verdict_without_bound("u", "none", reference::item::triangle::u), "wrong");
}

TEST(Judge, TellsWhetherAnAnswerThatFloatCannotGiveWasChecked) {
    const auto accepted = [](const std::string& u) {
        return score_without_bound("u", u, reference::item::triangle::u).accepted_as;
    };
    const std::string why = "float has too few digits for this answer here; ";
    EXPECT_EQ(accepted("0.250000"), why + "it agrees with your other answers") << "the solution";
    EXPECT_EQ(accepted("123.5"), why + "it counts unchecked");
}

TEST(Judge, WantsLengthOneWhereFloatCannotTellADirection) {
    EXPECT_EQ(verdict_without_bound("V", "vec3(0.600000, 0.800000, 0.000000)", reference::item::V), "right");
    EXPECT_EQ(verdict_without_bound("V", "vec3(3.000000, 4.000000, 0.000000)", reference::item::V), "wrong");
}

TEST(Judge, SaysWhatIsWrongWithAPointThatFloatCannotGive) {
    const ItemScore score =
        score_without_bound("Hit point P_s", "vec3(0.300000, 0.900000, 1.700000)", reference::item::sphere::hit);
    EXPECT_EQ(score.verdict, ItemVerdict::wrong);
    EXPECT_EQ(score.advice, "This point is not on your own ray.");
    EXPECT_EQ(score.diagnosis, "") << "and not that it has too few decimals";
    EXPECT_EQ(
        verdict_without_bound("Hit point P_s", "vec3(0.000000, 0.000000, 0.900000)", reference::item::sphere::hit),
        "right")
        << "on the ray, at the wrong t";
}

TEST(Judge, DoesNotAcceptATransposedSystem) {
    EXPECT_EQ(verdict_with({{"A",
                             "mat3x3((0.000000, 2.000000, -2.000000), (0.000000, 4.000000, 4.000000), (1.000000, "
                             "0.000000, 0.000000))"}},
                           reference::item::triangle::matrix),
              "wrong");
}

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
    const std::string too_few = "This has too few digits to tell whether it is right: print 2 decimals or more.";
    EXPECT_EQ(advice("t", "0.6"), too_few);
    for (const char* other : {"0.7", "1", "0", "0.58", "0.59"}) EXPECT_NE(advice("t", other), too_few) << other;
}

TEST(Judge, ComparesTheVerdictWithTheStudentsOwnValues) {
    const std::map<std::string, std::string> far = {{"t8", "0.75"}, {"t", "3.414214"}};
    auto says_sphere = far;
    says_sphere["verdict"] = "ray hits sphere first";
    static const student::Marking marking = student::handout_scene();
    const Score score = mark(handout_output(says_sphere), marking);
    EXPECT_EQ(verdict_on(score, reference::item::verdict), "wrong");
    EXPECT_EQ(item_of(score, reference::item::verdict).diagnosis, "verdict against own values");
    EXPECT_EQ(verdict_with({{"verdict", "ray hits nothing"}}, reference::item::verdict), "wrong");
    EXPECT_EQ(verdict_with({{"verdict", "ray hits sphere first"}}, reference::item::verdict), "right")
        << "t = 0 is not positive";
    EXPECT_EQ(verdict_with({{"t8", "5"}, {"verdict", "ray hits sphere first"}}, reference::item::verdict), "right")
        << "right is right";
}

TEST(Judge, AcceptsAVerdictThatFollowsFromWrongValues) {
    student::Marking marking = student::off_axis_scene();
    Program program(marking.assignment, {},
                    Program::Mistake{reference::item::sphere::t, [](const Program&, const auto&) {
                                         return std::optional(student::Floats{77.0F});
                                     }});
    EXPECT_EQ(verdict_on(mark(print(program), marking), reference::item::verdict), "follow");
}

TEST(Judge, LetsNoVerdictFollowFromValuesThatAreRight) {
    // The sphere is met at t = 201.41 and the triangle at 201.43, which 201.4 is too coarse to tell.
    const student::Marking marking =
        student::marking_of(student::camera_on_the_axis(4) +
                                "[[sphere]]\ncenter = [0, 0, -299.41]\nradius = 100\n"
                                "[[triangle]]\nvertices = [[-9, -9, -199.43], [9, -9, -199.43], [0, 9, -199.43]]\n",
                            "close together");
    std::string output = student::with_line(print(Program(marking.assignment, {})), 8, "t", "201.4");
    EXPECT_EQ(verdict_on(mark(output, marking), reference::item::verdict), "right");
    const std::string_view sphere = "ray hits sphere first";
    output.replace(output.rfind(sphere), sphere.size(), "ray hits triangle first");
    EXPECT_EQ(verdict_on(mark(output, marking), reference::item::verdict), "wrong");
}

TEST(Judge, AcceptsEveryPixelConventionOfTheRubricInEveryForm) {
    const student::Marking marking = student::off_axis_scene();
    Way grid;
    grid.convention = reference::PixelConvention::grid;
    grid.half_b = true;
    grid.columns = {2, 0, 1};
    const Score score = mark(print(Program(marking.assignment, grid)), marking);
    EXPECT_EQ(score.points, 100.0);
    EXPECT_EQ(item_of(score, reference::item::P_VCS).accepted_as, "the rubric accepts the grid pixel convention");
    Way corner;
    corner.convention = reference::PixelConvention::corner;
    const Score other = mark(print(Program(marking.assignment, corner)), marking);
    EXPECT_EQ(verdict_on(other, reference::item::P_VCS), "wrong");
    EXPECT_EQ(verdict_on(other, reference::item::P_WCS), "follow");
}

TEST(Judge, AcceptsMultipliedFormsInEveryPixelConvention) {
    const student::Marking marking = student::off_axis_scene();
    Way way;
    way.convention = reference::PixelConvention::grid;
    way.quadratic_factor = -2.5F;
    way.row_factors = {-1, 2, 0.5F};
    const Score score = mark(print(Program(marking.assignment, way)), marking);
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items)
            EXPECT_EQ(item.verdict, ItemVerdict::right) << question.number << item.spec.name << item.printed;
    }
}

TEST(Judge, DistinguishesUnreadableFromMissing) {
    EXPECT_EQ(verdict_with({{"P_s", "12"}}, reference::item::sphere::hit), "unreadable");
    EXPECT_EQ(verdict_with({{"P_s", ""}}, reference::item::sphere::hit), "missing");
}

}  // namespace
}  // namespace harness
