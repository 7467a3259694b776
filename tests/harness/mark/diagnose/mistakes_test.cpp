#include "harness/mark/diagnose/mistakes.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/given/cases.h"
#include "tests/given/printed_values.h"
#include "tests/given/student/mistakes.h"
#include "tests/given/student/printout.h"

namespace harness {
namespace {

using student::NamedMistake;
using student::Program;

bool differs(const std::optional<student::Floats>& one, const std::optional<student::Floats>& other) {
    if (!one || !other) return one.has_value() != other.has_value();
    double largest = 0;
    for (std::size_t i = 0; i < one->size(); ++i)
        largest = std::max(largest, std::abs(static_cast<double>((*one)[i] - (*other)[i])));
    return largest > 1e-4;
}

/// Marks the program with the mistake on the first off-axis scene on which the mistake changes the answer.
const ItemScore* find_marked(const NamedMistake& mistake, Score& score) {
    for (const char* scene : {"off axis", "inside", "triangle first"}) {
        const student::Marking marking = student::scene_named(scene);
        try {
            const Program wrong(marking.assignment, {}, mistake.mistake);
            if (!differs(wrong.values().at(mistake.mistake.item),
                         Program(marking.assignment, {}).values().at(mistake.mistake.item)))
                continue;
            score = mark(print(wrong), marking);
            return &item_of(score, mistake.mistake.item);
        } catch (const std::bad_optional_access&) {
            continue;
        }
    }
    return nullptr;
}

TEST(Misconceptions, AreNamedOnScenesOffTheAxes) {
    for (const NamedMistake& mistake : student::named_mistakes()) {
        const auto& [question, name] = mistake.mistake.item;
        Score score;
        const ItemScore* item = find_marked(mistake, score);
        ASSERT_NE(item, nullptr) << mistake.name << " in " << question << "." << name << " shows on no scene";
        EXPECT_EQ(item->verdict, ItemVerdict::wrong) << mistake.name << " in " << question << "." << name;
        EXPECT_EQ(item->diagnosis, mistake.name) << "in " << question << "." << name << ": " << item->printed;
        EXPECT_NE(item->advice, "") << mistake.name;
    }
}

TEST(Misconceptions, EachHaveATest) {
    std::set<std::pair<ItemId, std::string_view>> tested;
    for (const NamedMistake& mistake : student::named_mistakes()) tested.insert({mistake.mistake.item, mistake.name});
    for (const Mistake& mistake : all_mistakes()) {
        EXPECT_TRUE(tested.contains({mistake.item, mistake.name}))
            << mistake.name << " in " << mistake.item.first << "." << mistake.item.second;
    }
    EXPECT_GE(all_mistakes().size(), 25U);
}

TEST(Misconceptions, AreNeverNamedInARightOrFollowingAnswer) {
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

TEST(Misconceptions, HaveShortNamesAndAdviceWithoutValues) {
    for (const Mistake& mistake : all_mistakes()) {
        EXPECT_LE(mistake.name.size(), 40U) << mistake.name;
        EXPECT_TRUE(mistake.advice.ends_with(".")) << mistake.advice;
        EXPECT_EQ(mistake.advice.find_first_of("35679"), std::string_view::npos)
            << "a number of the scene? " << mistake.advice;
    }
}

TEST(Misconceptions, AreFoundAfterAnEarlierMistakeToo) {
    // V is not normalised, and then the program takes the far root of the quadratic.
    const student::Marking marking = student::off_axis_scene();
    const Program program(
        marking.assignment, {},
        Program::Mistake{{5, "V"}, [](const Program& p, const auto&) {
                             return std::optional(student::floats(p.vector({4, "P_WCS"}) - p.scene().camera.eye));
                         }});
    const float a = program.scalar({6, "a"}), b = program.scalar({6, "b"}), d = program.scalar({6, "d"});
    std::string output = print(program);
    const std::size_t t = output.find("\nt: ");
    output.replace(t, output.find('\n', t + 1) - t, fmt::format("\nt: {:f}", (-b + std::sqrt(d)) / (2 * a)));
    const Score score = mark(output, marking);
    EXPECT_EQ(item_of(score, {5, "V"}).diagnosis, "not normalised");
    EXPECT_EQ(item_of(score, {6, "t"}).diagnosis, "far root");
}

TEST(Misconceptions, AreNotNamedForArbitraryNumbers) {
    const student::Marking marking = student::off_axis_scene();
    for (const reference::ItemSpec& spec : reference::all_items()) {
        if (spec.shape == reference::Shape::verdict) continue;
        const ItemId id{spec.question, spec.name};
        const Program program(marking.assignment, {}, Program::Mistake{id, [](const Program&, const auto& right) {
                                                                           auto value = right;
                                                                           for (float& x : *value)
                                                                               x = 0.75F * x + 3.1875F;
                                                                           return value;
                                                                       }});
        EXPECT_EQ(item_of(mark(print(program), marking), id).diagnosis, "") << spec.question << spec.name;
    }
}

TEST(Misconceptions, AreNotNamedWhereTheAllowanceIsAsWideAsTheirEffect) {
    student::Marking marking = student::off_axis_scene();
    const ItemId normal = reference::item::sphere::normal;
    std::string output = student::with_line(print(Program(marking.assignment, {})), 7, "Sphere normal", "(0, 0, -1)");
    EXPECT_EQ(item_of(mark(output, marking), normal).diagnosis, "") << "neither the normal nor its opposite";
    // With 1.2 for each component, (0, 0, -1) is near the opposite of the normal, which marking could hardly tell from
    // it.
    for (auto& question : marking.key.questions) {
        for (auto& item : question.items) {
            if (id_of(item.spec) == normal) item.answers.front().allowance = {1.2, 1.2, 1.2};
        }
    }
    const Score score = mark(output, marking);
    EXPECT_EQ(verdict_on(score, normal), "wrong");
    EXPECT_EQ(item_of(score, normal).diagnosis, "");
}

}  // namespace
}  // namespace harness
