// Items that float can't answer are judged by what they must satisfy.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/given/printed_values.h"
#include "tests/given/student/printout.h"
#include "tests/harness/mark/score/handout_output.h"

namespace harness {
namespace {

using student::Program;

ItemScore score_without_bound(const std::string& label, const std::string& value, const reference::ItemId& id) {
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

std::string verdict_without_bound(const std::string& label, const std::string& value, const reference::ItemId& id) {
    return std::string(to_string(score_without_bound(label, value, id).verdict));
}

TEST(Judge, AcceptsAnyNumberOfASolutionWhereFloatCannotAnswer) {
    EXPECT_EQ(verdict_without_bound("u", "123.5", reference::item::triangle::u), "right");
    EXPECT_EQ(verdict_without_bound("u", "nan", reference::item::triangle::u), "wrong");
    EXPECT_EQ(verdict_without_bound("u", "inf", reference::item::triangle::u), "wrong");
    EXPECT_EQ(verdict_without_bound("u", "none", reference::item::triangle::u), "wrong");
}

TEST(Judge, SaysWhetherAnAnswerThatFloatCannotGiveWasChecked) {
    const auto accepted = [](const std::string& u) {
        return score_without_bound("u", u, reference::item::triangle::u).accepted_as;
    };
    const std::string why = "float has too few digits for this answer here; ";
    EXPECT_EQ(accepted("0.250000"), why + "it agrees with your other answers") << "the solution";
    EXPECT_EQ(accepted("123.5"), why + "it counts unchecked");
}

TEST(Judge, RequiresLengthOneIfFloatCannotGiveADirection) {
    EXPECT_EQ(verdict_without_bound("V", "vec3(0.600000, 0.800000, 0.000000)", reference::item::V), "right");
    EXPECT_EQ(verdict_without_bound("V", "vec3(3.000000, 4.000000, 0.000000)", reference::item::V), "wrong");
}

TEST(Judge, SaysWhatIsWrongWithAPointThatFloatCannotGive) {
    const ItemScore score =
        score_without_bound("Hit point P_s", "vec3(0.300000, 0.900000, 1.700000)", reference::item::sphere::hit);
    EXPECT_EQ(score.verdict, ItemVerdict::wrong);
    EXPECT_EQ(score.advice, "This point is not on your ray.");
    EXPECT_EQ(score.diagnosis, "") << "and not that it has too few decimals";
    EXPECT_EQ(
        verdict_without_bound("Hit point P_s", "vec3(0.000000, 0.000000, 0.900000)", reference::item::sphere::hit),
        "right")
        << "on the ray, at the wrong t";
}

}  // namespace
}  // namespace harness
