#include "harness/mark/diagnose/follow.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

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
    const Score score = mark_with(reference::item::sphere::c, {12.5F});
    EXPECT_EQ(verdict_on(score, reference::item::sphere::c), "wrong");
    EXPECT_EQ(verdict_on(score, reference::item::sphere::d), "follow");
    EXPECT_EQ(verdict_on(score, reference::item::sphere::b), "right") << "b does not depend on c";
}

TEST(Follow, IsGivenAlongTheWholeChainAndForTheVerdict) {
    const Score score = mark_with(reference::item::sphere::t, {9.5F});
    for (const ItemId& id :
         {reference::item::sphere::hit, reference::item::sphere::normal, reference::item::first_object})
        EXPECT_EQ(verdict_on(score, id), "follow") << id.name;
    EXPECT_EQ(verdict_on(score, reference::item::triangle::t), "right");
}

// A pixel 100,000 units away: float can't tell the discriminant, nor a hit point near the origin.
TEST(Follow, IsGivenWhereFloatCantAnswerForOwnValues) {
    for (const std::string_view scene : {"off axis", "handout"}) {
        const Score score = mark_with(reference::item::P_VCS, {144598.5F, -0.25F, -2}, scene);
        for_each_item(score, [&](const ItemScore& item) {
            const bool is_first = item.spec.id == reference::item::P_VCS;
            EXPECT_EQ(item.verdict == ItemVerdict::wrong, is_first)
                << scene << ' ' << item.spec.question << '.' << item.spec.name << " = " << item.printed;
        });
    }
}

TEST(Follow, IsGivenForNanThatComesFromOwnValues) {
    const float nan = std::nanf("");
    const Score score = mark_with(reference::item::X_vcs, {nan, nan, nan});
    EXPECT_EQ(verdict_on(score, reference::item::X_vcs), "wrong");
    for (const ItemId& id : {reference::item::Y_vcs, reference::item::M_VCS_to_WCS, reference::item::P_WCS,
                             reference::item::V, reference::item::sphere::b, reference::item::triangle::u})
        EXPECT_EQ(verdict_on(score, id), "follow") << id.name;
}

TEST(Follow, IsGivenForAMatrixOfAxesThatSpanNoSpaceOrAreNoBasis) {
    for (const Floats& axis : {Floats{0.5F, 0.5F, 0}, Floats{0, 0, 0}}) {
        const Score score = mark_with(reference::item::Y_vcs, axis);
        EXPECT_EQ(verdict_on(score, reference::item::M_VCS_to_WCS), "follow");
        EXPECT_EQ(verdict_on(score, reference::item::P_WCS), "follow");
    }
}

TEST(Follow, IsGivenForTheInverseOfTheViewMatrixOfOwnAxes) {
    const student::Marking marking = student::off_axis_scene();
    const Program program(marking.assignment, {},
                          Program::Mistake{reference::item::Y_vcs, [](const Program&, const auto&) {
                                               return std::optional(Floats{0.25F, 2, 0.5F});
                                           }});
    const glm::vec3 eye = program.scene().camera.eye;
    const glm::mat3 axes(program.vector(reference::item::X_vcs), program.vector(reference::item::Y_vcs),
                         program.vector(reference::item::Z_vcs));
    glm::mat4 view(glm::transpose(axes));
    view[3] = glm::vec4(-(glm::transpose(axes) * eye), 1);
    const glm::mat4 M = glm::inverse(view);
    std::string matrix = "mat4x4(";
    for (int column = 0; column < 4; ++column)
        matrix += fmt::format("{}({:f}, {:f}, {:f}, {:f})", column == 0 ? "" : ", ", M[column][0], M[column][1],
                              M[column][2], M[column][3]);
    const Score score = mark(student::with_line(print(program), 3, "M_VCS_to_WCS", matrix + ")"), marking);
    EXPECT_EQ(verdict_on(score, reference::item::M_VCS_to_WCS), "follow");
}

TEST(Follow, IsGivenForThePointWithTheWOfATransposedMatrix) {
    // The rows of the handout's matrix as columns: times (0, 0, -2, 1) it is (0, 0, -2, -7).
    const student::Marking marking = student::handout_scene();
    std::string output = print(Program(marking.assignment, {}));
    output = student::with_line(output, 3, "M_VCS_to_WCS",
                                "mat4x4((1.000000, 0.000000, 0.000000, 0.000000), (0.000000, 1.000000, "
                                "0.000000, 0.000000), (0.000000, 0.000000, 1.000000, 4.000000), "
                                "(0.000000, 0.000000, 0.000000, 1.000000))");
    const auto verdict = [&](const char* point) {
        return verdict_on(mark(student::with_line(output, 4, "Pixel in WCS", point), marking), reference::item::P_WCS);
    };
    EXPECT_EQ(verdict("vec4(0.000000, 0.000000, -2.000000, -7.000000)"), "follow");
    EXPECT_EQ(verdict("vec3(0.000000, 0.000000, -2.000000)"), "follow");
    EXPECT_EQ(verdict("vec4(0.000000, 0.000000, -2.000000, -6.000000)"), "wrong");
}

TEST(Follow, IsNotGivenToASecondMistake) {
    const student::Marking marking = student::off_axis_scene();
    const Program program(marking.assignment, {},
                          Program::Mistake{reference::item::sphere::c,
                                           [](const Program&, const auto&) { return std::optional(Floats{9.0F}); }});
    std::string output = print(program);
    const std::size_t d = output.find("\nd: ");
    output.replace(d, output.find('\n', d + 1) - d, "\nd: 3.25");
    EXPECT_EQ(verdict_on(mark(output, marking), reference::item::sphere::d), "wrong");
}

TEST(Follow, IsNotGivenForAValueBesideWhichTheSceneIsLost) {
    // The right-hand side is P_WCS - A, which is P_WCS itself in float.
    const Score score = mark_with(reference::item::P_WCS, {1e15F, 1e15F, 1e15F});
    EXPECT_EQ(item_of(score, reference::item::triangle::rhs).printed, item_of(score, reference::item::P_WCS).printed);
    EXPECT_EQ(verdict_on(score, reference::item::triangle::rhs), "wrong");
    EXPECT_EQ(verdict_on(mark_with(reference::item::P_WCS, {100, 100, 100}), reference::item::triangle::rhs), "follow");
}

TEST(Follow, IsNotGivenForAResultThatDigitsLeaveOpen) {
    // c is 7 for P_WCS = (0, 0, 3), and anything from 6.5 to 7.3 for what rounds to it.
    const student::Marking marking = student::handout_scene();
    std::string output = print(Program(marking.assignment, {}));
    output = student::with_line(output, 4, "Pixel in WCS", "vec3(0.0, 0.0, 3.0)");
    EXPECT_EQ(verdict_on(mark(student::with_line(output, 6, "c", "7.000000"), marking), reference::item::sphere::c),
              "follow");
    EXPECT_EQ(verdict_on(mark(student::with_line(output, 6, "c", "7.250000"), marking), reference::item::sphere::c),
              "wrong");
}

TEST(Follow, IsNotGivenAfterAnAnswerThatIsOnlyCoarse) {
    // c is printed with three digits, which are right. So it is no mistake from which another d follows.
    const student::Marking marking = student::off_axis_scene();
    const Program program(marking.assignment, {},
                          Program::Mistake{reference::item::sphere::c,
                                           [](const Program&, const auto&) { return std::optional(Floats{10.2F}); }});
    const Score score = mark(student::with_line(print(program), 6, "c", "10.2"), marking);
    EXPECT_EQ(item_of(score, reference::item::sphere::c).diagnosis, "too few decimals");
    EXPECT_EQ(verdict_on(score, reference::item::sphere::d), "wrong");
}

TEST(Follow, IsNotGivenForADirectionOfZero) {
    const Score score = mark_with(reference::item::V, {0, 0, 0});
    for (const ItemId& id : {reference::item::sphere::a, reference::item::sphere::b, reference::item::sphere::d,
                             reference::item::triangle::matrix})
        EXPECT_EQ(verdict_on(score, id), "wrong") << id.name;
}

TEST(Follow, IsGivenForNanOfASingularSystem) {
    const Score score = mark_with(reference::item::triangle::matrix, {0, 0, 0, 0, 0, 0, 0, 0, 0});
    EXPECT_EQ(verdict_on(score, reference::item::triangle::t), "follow") << "nan";
}

TEST(Follow, IsGivenForNanAsTheNormalAtTheCentre) {
    const Score score = mark_with(reference::item::sphere::hit, {3.9F, -0.6F, 0});
    EXPECT_EQ(verdict_on(score, reference::item::sphere::normal), "follow");
}

TEST(Follow, IsNotGivenForAMissAfterAWrongNone) {
    const student::Marking marking = student::off_axis_scene();
    const Program program(marking.assignment, {},
                          Program::Mistake{reference::item::sphere::t,
                                           [](const Program&, const auto&) { return std::optional<Floats>(); }});
    const Score score = mark(print(program), marking);
    EXPECT_EQ(verdict_on(score, reference::item::sphere::t), "wrong");
    EXPECT_EQ(verdict_on(score, reference::item::sphere::hit), "wrong");
    EXPECT_EQ(verdict_on(score, reference::item::sphere::normal), "wrong");
    EXPECT_EQ(verdict_on(score, reference::item::first_object), "follow") << "the triangle is the first of the others";
}

TEST(Follow, IsGivenForAMissAfterANegativeDiscriminant) {
    const Score score = mark_with(reference::item::sphere::c, {25.0F});
    for (const ItemId& id : {reference::item::sphere::d, reference::item::sphere::t, reference::item::sphere::hit,
                             reference::item::sphere::normal, reference::item::first_object}) {
        EXPECT_EQ(verdict_on(score, id), "follow") << id.name;
    }
}

TEST(Follow, IsGivenForARootBehindTheStartOnlyWhereNothingIsHit) {
    // On the handout's scene, with the pixel behind the camera.
    const std::string before =
        "Question 1\nP_VCS = (0, 0, 2)\nQuestion 4\nP_WCS = (0, 0, 6)\nQuestion 5\nV = (0, 0, 1)\n"
        "Question 6\na = 1\nb = 12\nc = 34\nd = 8\n";
    const student::Marking marking = student::scene_named("handout");
    for (const char* t : {"-4.58579", "-7.41421"}) {
        const Score score = mark(before + "t = " + t + "\nhit point: none, both roots are negative\n", marking);
        EXPECT_EQ(verdict_on(score, reference::item::sphere::t), "follow") << t;
        EXPECT_EQ(verdict_on(score, reference::item::sphere::hit), "follow") << t;
    }
    const Score other = mark(before + "t = -6.5\nhit point: none, both roots are negative\n", marking);
    EXPECT_EQ(verdict_on(other, reference::item::sphere::t), "wrong") << "is no root";
    const Score taken = mark(before + "t = -4.58579\nhit point: (0, 0, 1.41421)\n", marking);
    EXPECT_EQ(verdict_on(taken, reference::item::sphere::t), "wrong") << "is taken for a hit";
}

TEST(Follow, UsesTheStudentsOwnLayoutOfTheSystem) {
    const student::Marking marking = student::off_axis_scene();
    student::Way way;
    way.columns = {2, 0, 1};
    const Program program(marking.assignment, way,
                          Program::Mistake{reference::item::V, [](const Program&, const auto&) {
                                               return std::optional(Floats{0.6F, 0, -0.8F});
                                           }});
    const Score score = mark(print(program), marking);
    for (const ItemId& id : {reference::item::triangle::matrix, reference::item::triangle::t,
                             reference::item::triangle::u, reference::item::triangle::v})
        EXPECT_EQ(verdict_on(score, id), "follow") << id.name;
}

TEST(Follow, IsGivenForCoarselyPrintedValues) {
    // c is right but printed with only three digits. Answers computed with the exact c must still be accepted.
    const student::Marking marking = student::off_axis_scene();
    std::string output = print(Program(marking.assignment, {}));
    const std::size_t c = output.find("\nc: ");
    output.replace(c, output.find('\n', c + 1) - c, "\nc: 10.2");
    const Score score = mark(output, marking);
    EXPECT_EQ(verdict_on(score, reference::item::sphere::c), "wrong") << "the rubric asks for two decimals";
    for (const ItemId& id : {reference::item::sphere::d, reference::item::sphere::t, reference::item::sphere::hit,
                             reference::item::sphere::normal})
        EXPECT_EQ(verdict_on(score, id), "right") << id.name;
}

/// Mistakes in the items that the cylinder's depend on, and in its own: the named ones, and each number changed.
std::vector<student::NamedMistake> mistakes_before_the_cylinder() {
    using reference::Subject;
    std::vector<student::NamedMistake> all;
    for (const student::NamedMistake& named : student::named_mistakes()) {
        const Subject subject = named.mistake.item.subject;
        if (subject == Subject::camera || subject == Subject::cylinder) all.push_back(named);
    }
    for (const reference::Item& item : reference::known_items()) {
        if (item.id.subject != Subject::camera && item.id.subject != Subject::cylinder) continue;
        for (int i = 0; i < component_count(item.shape); ++i) {
            all.push_back({"altered", {item.id, [=](const Program&, const auto& right) {
                                           std::optional<Floats> value = right;
                                           if (value) value->at(static_cast<std::size_t>(i)) += 0.0625F;
                                           return value;
                                       }}});
        }
    }
    return all;
}

bool is_finite(const Program& program) {
    return std::ranges::all_of(program.values(), [](const auto& entry) {
        return !entry.second || std::ranges::all_of(*entry.second, [](float x) { return std::isfinite(x); });
    });
}

/// Whether so many digits of the tube's discriminant cancel that the other coefficients do not tell it.
bool cancels(const Program& program) {
    const float b = program.scalar(reference::item::cylinder::b), d = program.scalar(reference::item::cylinder::d);
    return d != 0 && std::abs(d) < 1e-4F * b * b;
}

/// The program with the mistake; empty if it prints no such value, or if not every value is a number.
std::optional<Program> make_mistake(const student::Marking& marking, const Program::Mistake& mistake) {
    try {
        Program program(marking.assignment, {}, mistake);
        const bool is_asked =
            std::ranges::find(program.asked(), mistake.item, &reference::ItemSpec::id) != program.asked().end();
        return is_asked && program.has(mistake.item) && is_finite(program) && !cancels(program)
                   ? std::optional(std::move(program))
                   : std::nullopt;
    } catch (const std::bad_optional_access&) {
        return std::nullopt;
    }
}

TEST(Follow, IsGivenForTheCylinderAfterAnyEarlierMistake) {
    student::Layout all_digits;
    all_digits.format = student::NumberFormat::scientific;
    all_digits.digits = 8;
    all_digits.vectors = student::VectorLayout::spaced;
    all_digits.matrices = student::MatrixLayout::rows;
    std::size_t tried = 0;
    for (const std::string_view scene : student::cylinder_scene_names()) {
        if (student::rounding_decides(scene)) continue;
        const student::Marking marking = student::scene_named(scene);
        for (const auto& [name, mistake] : mistakes_before_the_cylinder()) {
            const auto program = make_mistake(marking, mistake);
            if (!program) continue;
            ++tried;
            const Score score = mark(print(*program, all_digits), marking);
            for (const QuestionScore& question : score.questions) {
                for (const ItemScore& item : question.items) {
                    const auto subject = item.spec.id.subject;
                    const bool is_concerned =
                        subject == reference::Subject::cylinder || subject == reference::Subject::first_hit;
                    if (!is_concerned || item.spec.id == mistake.item) continue;
                    EXPECT_NE(item.verdict, ItemVerdict::wrong)
                        << fmt::format("'{}', {} in {}: {}.{} = {}", scene, name, mistake.item.name, to_string(subject),
                                       item.spec.id.name, item.printed);
                }
            }
        }
    }
    EXPECT_GT(tried, 1000U);
}

}  // namespace
}  // namespace harness
