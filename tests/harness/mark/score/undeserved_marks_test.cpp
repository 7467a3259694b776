// Outputs that try to get marks without computing answers.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>

#include "tests/given/printed_values.h"
#include "tests/given/student/printout.h"

namespace harness {
namespace {

using reference::ItemId;
using student::Program;

/// The handout's layout with the same text for every number. If the text is no number, it replaces every answer.
std::string everywhere(std::string_view number, const std::string& verdict) {
    std::string text;
    int question = 0;
    for (const reference::ItemSpec& spec : reference::default_items()) {
        if (spec.question != question) text += fmt::format("Question {}:\n", question = spec.question);
        if (spec.shape == reference::Shape::first_object) {
            text += verdict + "\n";
            continue;
        }
        std::string numbers(number);
        for (int i = 1; i < reference::component_count(spec.shape); ++i) numbers += fmt::format(" {}", number);
        const bool is_word =
            number.find_first_of("0123456789") == std::string_view::npos && number != "nan" && number != "inf";
        text += fmt::format("{}: {}\n", spec.label, is_word ? std::string(number) : numbers);
    }
    return text;
}

/// The most points that an output earns on any scene that float can decide.
double most_points(const std::function<std::string()>& output) {
    double most = 0;
    for (const char* scene : {"handout", "edge", "off axis", "triangle first", "inside", "large"}) {
        const Score score = mark(output(), student::scene_named(scene));
        for (const QuestionScore& question : score.questions) {
            for (const ItemScore& item : question.items) {
                if (item.points > 0)
                    fmt::print("{}: {}.{} is {}: {}\n", scene, question.number, item.spec.name, to_string(item.verdict),
                               item.printed);
            }
        }
        most = std::max(most, score.points);
    }
    return most;
}

TEST(UndeservedMarks, AreNotEarnedByZeros) {
    for (const char* zero : {"0", "0.0", "0.00", "0.000000", "-0.000000", "0e0"}) {
        EXPECT_LT(most_points([&] { return everywhere(zero, "ray hits nothing"); }), 5) << zero;
    }
}

TEST(UndeservedMarks, AreNotEarnedByNanAndInfinity) {
    for (const char* text : {"nan", "inf"})
        EXPECT_EQ(most_points([&] { return everywhere(text, "ray hits nothing"); }), 0) << text;
}

TEST(UndeservedMarks, AreNotEarnedByNoneEverywhere) {
    // On the handout's scene, with the policy "t is positive", the ray has no true hit of the triangle. There "no hit
    // point" is a right answer.
    for (const char* word : {"none", "no hit"})
        EXPECT_LT(most_points([&] { return everywhere(word, "ray hits nothing"); }), 1.7) << word;
}

TEST(UndeservedMarks, AreNotEarnedByOnesOrHugeNumbers) {
    for (const char* number : {"1", "1e30", "-1e30", "1e308"}) {
        EXPECT_LE(most_points([&] { return everywhere(number, "ray hits nothing"); }), 7) << number;
    }
}

TEST(UndeservedMarks, AreNotEarnedByPrintingFewDigits) {
    // Every number is printed as a whole number, so only values near a whole number are right.
    const student::Marking marking = student::off_axis_scene();
    student::Layout layout;
    layout.format = student::NumberFormat::fixed;
    layout.digits = 0;
    layout.vectors = student::VectorLayout::bracketed;
    layout.matrices = student::MatrixLayout::labelled_columns;
    const Score score = mark(print(Program(marking.assignment, {}), layout), marking);
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) {
            if (item.verdict != ItemVerdict::right || item.spec.shape == reference::Shape::first_object) continue;
            EXPECT_LE(item.error.value_or(0), 0.005 + item.allowance.value_or(0))
                << question.number << item.spec.name << item.printed;
        }
    }
    EXPECT_LT(score.points, 30);
}

TEST(UndeservedMarks, AreNotEarnedByARightValueAmongSeveral) {
    const student::Marking marking = student::off_axis_scene();
    for (const char* line : {"t: 2.29988 or 3.41", "t could be 2.29988, 3.4 or 5.6", "t = +-2.29988",
                             "t: 2.29988 (wrong, should be 3.41)"})
        EXPECT_NE(verdict_on(mark("Question 6:\n" + std::string(line) + "\n", marking), reference::item::sphere::t),
                  "right")
            << line;
    EXPECT_EQ(
        verdict_on(mark("Question 6:\nt = 2.29988 or 3.41, so we take 2.29988\n", marking), reference::item::sphere::t),
        "right");
}

TEST(UndeservedMarks, AreNotEarnedByBothVerdicts) {
    const student::Marking marking = student::off_axis_scene();
    std::string output = print(Program(marking.assignment, {}));
    output += "ray hits triangle first / ray hits sphere first\nray hits triangle first\n";
    EXPECT_EQ(verdict_on(mark(output, marking), reference::item::first_object), "missing");
}

TEST(UndeservedMarks, AreNotEarnedByASystemOfZeros) {
    for (const char* scene : {"handout", "off axis"}) {
        const student::Marking marking = student::scene_named(scene);
        std::string output = print(Program(marking.assignment, {}));
        const std::size_t matrix = output.find("\nMatrix A: ");
        output.replace(matrix, output.find('\n', matrix + 1) - matrix,
                       "\nMatrix A: mat3x3((0.000000, 0.000000, 0.000000), (0.000000, 0.000000, 0.000000), (0.000000, "
                       "0.000000, 0.000000))");
        const std::size_t rhs = output.find("\nRight-hand side: ");
        output.replace(rhs, output.find('\n', rhs + 1) - rhs, "\nRight-hand side: vec3(0.000000, 0.000000, 0.000000)");
        const Score score = mark(output, marking);
        EXPECT_EQ(verdict_on(score, reference::item::triangle::matrix), "wrong") << scene;
        EXPECT_EQ(verdict_on(score, reference::item::triangle::rhs), "wrong") << scene;
        EXPECT_EQ(verdict_on(score, reference::item::triangle::t), "right") << "what is right stays right";
    }
}

}  // namespace
}  // namespace harness
