#include "harness/mark/diagnose/mistakes.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <set>

#include "tests/given/cases.h"
#include "tests/given/printed_values.h"
#include "tests/given/student/mistakes.h"
#include "tests/given/student/printout.h"

namespace harness {
namespace {

using student::NamedMistake;
using student::Program;

bool differs(const std::optional<student::Floats>& one, const std::optional<student::Floats>& other,
             double slack = 1e-4) {
    if (!one || !other) return one.has_value() != other.has_value();
    double largest = 0;
    for (std::size_t i = 0; i < one->size(); ++i)
        largest = std::max(largest, std::abs(static_cast<double>((*one)[i] - (*other)[i])));
    return largest > slack;
}

/// The program with the mistake; empty if it needs a value that the scene does not have.
std::optional<Program> make_mistake(const NamedMistake& mistake, const student::Marking& marking) {
    try {
        return Program(marking.assignment, {}, mistake.mistake);
    } catch (const std::bad_optional_access&) {
        return std::nullopt;
    }
}

bool is_finite(const std::optional<student::Floats>& value) {
    return value && std::ranges::all_of(*value, [](float x) { return std::isfinite(x); });
}

/// The names of the mistakes that give this value for the item, as far as its allowance tells.
std::set<std::string_view> names_of(const ItemScore& item, const student::Floats& value,
                                    const student::Marking& marking) {
    const ItemId& id = item.spec.id;
    std::set<std::string_view> names;
    for (const NamedMistake& mistake : student::named_mistakes()) {
        if (mistake.mistake.item != id) continue;
        const auto program = make_mistake(mistake, marking);
        if (program && program->has(id) &&
            !differs(program->values().at(id), value, std::max(1e-4, 2 * item.allowance.value_or(0))))
            names.insert(mistake.name);
    }
    return names;
}

TEST(Mistakes, AreNamedWhereverTheyShow) {
    // Some mistakes give the same number on a scene: where a ray enters by a cap and leaves by the tube, a program
    // without caps gives the larger root. Then either name is right.
    for (const NamedMistake& mistake : student::named_mistakes()) {
        const ItemId& id = mistake.mistake.item;
        bool is_named = false;
        for (const std::string_view scene : student::scenes_to_err_on(id.subject)) {
            if (student::rounding_decides(scene)) continue;
            const student::Marking marking = student::scene_named(scene);
            const Program right(marking.assignment, {});
            const auto wrong = make_mistake(mistake, marking);
            if (!wrong || !right.has(id) || !is_finite(wrong->values().at(id)) ||
                std::ranges::find(wrong->asked(), id, &reference::ItemSpec::id) == wrong->asked().end() ||
                !differs(wrong->values().at(id), right.values().at(id)))
                continue;
            const Score score = mark(print(*wrong), marking);
            const ItemScore& item = item_of(score, id);
            const std::string where = fmt::format("{} in {}.{} of '{}': {}", mistake.name, to_string(id.subject),
                                                  id.name, scene, item.printed);
            EXPECT_EQ(item.verdict, ItemVerdict::wrong) << where;
            EXPECT_NE(item.advice, "") << where;
            EXPECT_THAT(names_of(item, *wrong->values().at(id), marking),
                        testing::Contains(item.diagnosis.substr(0, item.diagnosis.find(" or "))))
                << where;
            is_named = is_named || (" or " + item.diagnosis + " or ").find(fmt::format(" or {} or ", mistake.name)) !=
                                       std::string::npos;
        }
        EXPECT_TRUE(is_named) << mistake.name << " in " << to_string(id.subject) << "." << id.name
                              << " is named on no scene";
    }
}

TEST(Mistakes, EachHaveATest) {
    std::set<std::pair<ItemId, std::string_view>> tested;
    for (const NamedMistake& mistake : student::named_mistakes()) tested.insert({mistake.mistake.item, mistake.name});
    for (const Mistake& mistake : all_mistakes()) {
        EXPECT_TRUE(tested.contains({mistake.item, mistake.name}))
            << mistake.name << " in " << to_string(mistake.item.subject) << "." << mistake.item.name;
    }
    EXPECT_GE(all_mistakes().size(), 25U);
}

TEST(Mistakes, AreNeverNamedInARightOrFollowingAnswer) {
    for (const std::string_view scene : student::scene_names()) {
        const student::Marking marking = student::scene_named(scene);
        for (std::uint64_t seed = 1; seed <= cases(40); ++seed) {
            const student::Layout layout = student::random_layout(seed, 2);
            const Score score = mark(print(Program(marking.assignment, {}), layout), marking);
            for (const QuestionScore& question : score.questions) {
                for (const ItemScore& item : question.items)
                    EXPECT_EQ(item.diagnosis, "") << question.number << item.spec.name << layout.describe();
            }
        }
    }
}

TEST(Mistakes, HaveShortNamesAndAdviceWithoutValues) {
    for (const Mistake& mistake : all_mistakes()) {
        EXPECT_LE(mistake.name.size(), 40U) << mistake.name;
        EXPECT_TRUE(mistake.advice.ends_with(".")) << mistake.advice;
        EXPECT_EQ(mistake.advice.find_first_of("35679"), std::string_view::npos)
            << "a number of the scene? " << mistake.advice;
    }
}

/// The camera's part of a printout whose question 2 is a table.
std::string with_table_of_axes(const glm::mat3& rows, const student::Marking& marking) {
    std::string output = print(Program(marking.assignment, {}));
    const std::size_t begin = output.find("Question 2"), end = output.find("Question 3");
    const std::size_t first = output.find('\n', begin) + 1;
    std::string table;
    for (int i = 0; i < 3; ++i) table += fmt::format("{:f} {:f} {:f}\n", rows[i][0], rows[i][1], rows[i][2]);
    return output.replace(first, end - first, table + "\n");
}

TEST(Mistakes, OfATableWhoseColumnsAreTheAxesAreNamed) {
    const student::Marking marking = student::off_axis_scene();
    const Program program(marking.assignment, {});
    const auto& camera = program.scene().camera;
    // The view matrix has the axes in its rows, which are the columns of its transpose.
    const glm::mat3 view(glm::lookAt(camera.eye, camera.lookat, camera.vup));
    const Score across = mark(with_table_of_axes(view, marking), marking);
    const Score along = mark(with_table_of_axes(glm::transpose(view), marking), marking);
    for (const ItemId& axis : {reference::item::X_vcs, reference::item::Z_vcs}) {
        EXPECT_EQ(verdict_on(across, axis), "wrong");
        EXPECT_EQ(item_of(across, axis).diagnosis, "coordinates of different axes");
        EXPECT_EQ(verdict_on(along, axis), "right") << "each row is an axis";
        EXPECT_EQ(item_of(along, axis).diagnosis, "");
    }
}

TEST(Mistakes, AreFoundAfterAnEarlierMistakeToo) {
    // V is not normalised, and then the program takes the far root of the quadratic.
    const student::Marking marking = student::off_axis_scene();
    const Program program(marking.assignment, {},
                          Program::Mistake{reference::item::V, [](const Program& p, const auto&) {
                                               return std::optional(student::floats(p.vector(reference::item::P_WCS) -
                                                                                    p.scene().camera.eye));
                                           }});
    const float a = program.scalar(reference::item::sphere::a), b = program.scalar(reference::item::sphere::b),
                d = program.scalar(reference::item::sphere::d);
    std::string output = print(program);
    const std::size_t t = output.find("\nt: ");
    output.replace(t, output.find('\n', t + 1) - t, fmt::format("\nt: {:f}", (-b + std::sqrt(d)) / (2 * a)));
    const Score score = mark(output, marking);
    EXPECT_EQ(item_of(score, reference::item::V).diagnosis, "not normalized");
    EXPECT_EQ(item_of(score, reference::item::sphere::t).diagnosis, "far root");
}

TEST(Mistakes, AreFoundInTheFormOfTheStudentsQuadratic) {
    const student::Marking marking = student::off_axis_scene();
    student::Way way;
    way.half_b = true;
    const Program program(marking.assignment, way,
                          Program::Mistake{reference::item::P_VCS, [](const Program&, const auto& right) {
                                               student::Floats p = *right;
                                               p[0] += 0.125F;
                                               return std::optional(p);
                                           }});
    const float a = program.scalar(reference::item::sphere::a), b = program.scalar(reference::item::sphere::b),
                d = program.scalar(reference::item::sphere::d);
    const auto named = [&](float t, float own_b) {
        std::string output = student::with_line(print(program), 6, "t", std::to_string(t));
        output = student::with_line(output, 6, "b", std::to_string(own_b));
        return item_of(mark(output, marking), reference::item::sphere::t).diagnosis;
    };
    EXPECT_EQ(named((-b + std::sqrt(d)) / a, b), "far root");
    EXPECT_EQ(named((b - std::sqrt(d)) / a, -b), "root behind the start");
}

TEST(Mistakes, AreNotNamedForArbitraryNumbers) {
    const student::Marking marking = student::off_axis_scene();
    for (const reference::ItemSpec& spec : reference::default_items()) {
        if (spec.shape == reference::Shape::first_object) continue;
        const ItemId& id = spec.id;
        const Program program(marking.assignment, {}, Program::Mistake{id, [](const Program&, const auto& right) {
                                                                           auto value = right;
                                                                           for (float& x : *value)
                                                                               x = 0.75F * x + 3.1875F;
                                                                           return value;
                                                                       }});
        EXPECT_EQ(item_of(mark(print(program), marking), id).diagnosis, "") << spec.question << spec.name;
    }
}

TEST(Mistakes, AreNotNamedWhereTheAllowanceIsAsWideAsTheirEffect) {
    student::Marking marking = student::off_axis_scene();
    const ItemId normal = reference::item::sphere::normal;
    std::string output = student::with_line(print(Program(marking.assignment, {})), 7, "Sphere normal", "(0, 0, -1)");
    EXPECT_EQ(item_of(mark(output, marking), normal).diagnosis, "") << "neither the normal nor its opposite";
    // With 1.2 for each component, (0, 0, -1) is near the opposite of the normal, which marking could hardly tell from
    // it.
    for (auto& question : marking.key.questions) {
        for (auto& item : question.items) {
            if (item.spec.id == normal) item.answers.front().allowance = {1.2, 1.2, 1.2};
        }
    }
    const Score score = mark(output, marking);
    EXPECT_EQ(verdict_on(score, normal), "wrong");
    EXPECT_EQ(item_of(score, normal).diagnosis, "");
}

}  // namespace
}  // namespace harness
