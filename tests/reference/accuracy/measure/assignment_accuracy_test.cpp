// Compares the errors of each scalar on a scene with errors computed by other means: the roundings of each formula by
// hand, in Python's decimals with 60 digits.
#include "reference/accuracy/measure/assignment_accuracy.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <iterator>

#include "tests/given/bytes_of.h"

namespace reference::accuracy {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Assignment assignment_2021() {
    return load_assignment("a6-2021", RAYGRADE_ASSIGNMENTS);
}

/// The 2021 assignment with some of its text replaced.
Assignment changed(const std::vector<std::pair<std::string, std::string>>& changes) {
    std::string text = bytes_of(std::string(RAYGRADE_ASSIGNMENTS) + "/a6-2021.toml");
    for (const auto& [from, to] : changes) {
        const std::size_t at = text.find(from);
        if (at == std::string::npos) throw std::logic_error("not in the assignment: " + from);
        text.replace(at, from.size(), to);
    }
    return parse_assignment(text, "changed.toml");
}

ItemError error_in(const std::vector<ItemAccuracy>& items, int question, std::string_view name,
                   std::string_view scalar) {
    for (const ItemAccuracy& item : items) {
        if (item.spec.question != question || item.spec.name != name) continue;
        for (const ItemError& error : item.errors) {
            if (error.scalar == scalar) return error;
        }
    }
    throw std::logic_error("no such item");
}

std::vector<ItemAccuracy> items_of(const Assignment& assignment) {
    return item_accuracies(assignment, make_key(assignment, Precision::certified));
}

std::vector<Decision> decisions_in(const Assignment& assignment) {
    return decisions_of(assignment, make_key(assignment, Precision::certified).canonical);
}

Decision decision(const std::vector<Decision>& decisions, std::string_view what) {
    const auto found =
        std::find_if(decisions.begin(), decisions.end(), [&](const Decision& one) { return one.what == what; });
    if (found == decisions.end()) throw std::logic_error("no such decision");
    return *found;
}

std::vector<std::string> hanging(const std::vector<Decision>& decisions) {
    std::vector<std::string> names;
    for (const Decision& one : decisions) {
        if (one.hangs_on_rounding()) names.push_back(one.what);
    }
    return names;
}

// d = 8 is exact, so t = (4 - √8) / 2 is off by what the root's rounding leaves; t lies in [1/2, 1), where a float's
// unit in the last place is 2^-24.
TEST(ItemErrors, EqualTheRootsRoundingErrors) {
    const std::vector<ItemAccuracy> items = items_of(assignment_2021());
    EXPECT_DOUBLE_EQ(error_in(items, 6, "t", "float").absolute, 2.420323420895794e-08);
    EXPECT_DOUBLE_EQ(error_in(items, 6, "t", "float").ulp, 0.4060628882222765);
    EXPECT_DOUBLE_EQ(error_in(items, 6, "t", "double").absolute, 9.667293313452913e-17);
    EXPECT_DOUBLE_EQ(error_in(items, 6, "hit", "float").absolute, 2.420323420895794e-08);
    EXPECT_DOUBLE_EQ(error_in(items, 7, "normal", "float").absolute, 1.210161710447897e-08);
    EXPECT_DOUBLE_EQ(error_in(items, 7, "normal", "double").absolute, 4.833646656726457e-17);
}

TEST(ItemErrors, AreZeroWhereEveryStepIsExact) {
    const std::vector<ItemAccuracy> items = items_of(assignment_2021());
    for (const char* scalar : {"float", "double"}) {
        EXPECT_EQ(error_in(items, 1, "P_VCS", scalar).absolute, 0) << scalar;
        EXPECT_EQ(error_in(items, 6, "d", scalar).absolute, 0) << scalar;
        EXPECT_EQ(error_in(items, 8, "t", scalar).absolute, 0) << scalar;
        EXPECT_EQ(error_in(items, 8, "t", scalar).ulp, 0) << scalar;
    }
}

TEST(ItemErrors, StayWithinWhatMarkingForgivesAFloatProgram) {
    for (const ItemAccuracy& item : items_of(assignment_2021())) {
        for (const ItemError& error : item.errors) {
            EXPECT_FALSE(error.otherwise) << item.spec.name;
            EXPECT_LE(error.of_allowance, 1) << item.spec.question << " " << item.spec.name << " " << error.scalar;
        }
    }
}

TEST(ItemErrors, AreComparedWithTheRubricsTolerance) {
    const auto items = items_of(changed({{"min_decimals = 2", "min_decimals = 2\n[rubric.tolerance]\n6 = {t = 0.5}"}}));
    const auto item = std::find_if(items.begin(), items.end(), [](const ItemAccuracy& one) {
        return one.spec.question == 6 && one.spec.name == "t";
    });
    EXPECT_EQ(item->allowance, 0.5);
    EXPECT_DOUBLE_EQ(item->errors.front().of_allowance, item->errors.front().absolute / 0.5);
}

// Float cannot represent one tenth: the sphere's radius 2.1 is read as 2.099999904632568359375.
TEST(ItemErrors, IncludeTheErrorOfReadingANumber) {
    const auto items = items_of(changed({{"radius = 2", "radius = 2.1"}}));
    EXPECT_GT(error_in(items, 6, "c", "float").absolute, 1e-8);
    EXPECT_GT(error_in(items, 6, "c", "double").absolute, 0);
    EXPECT_LT(error_in(items, 6, "c", "double").absolute, 1e-14);
}

TEST(NearDecisions, IncludeARayThatStartsInTheTrianglesPlane) {
    const std::vector<Decision> decisions = decisions_in(assignment_2021());
    EXPECT_THAT(hanging(decisions), ElementsAre("triangle: t"));
    const Decision t = decision(decisions, "triangle: t");
    EXPECT_EQ(t.sign, 0);
    EXPECT_EQ(t.value, 0);
    EXPECT_FALSE(t.float_is_sure);
    EXPECT_FALSE(t.double_is_sure);
    EXPECT_THAT(t.wrong, IsEmpty()) << "every number of the scene is a small whole one";
}

TEST(NearDecisions, ReportOtherDecisionsAsSure) {
    const Decision d = decision(decisions_in(assignment_2021()), "sphere: d");
    EXPECT_EQ(d.sign, 1);
    EXPECT_EQ(d.value, 8);
    EXPECT_TRUE(d.float_is_sure);
    EXPECT_TRUE(d.double_is_sure);
}

// The camera and the plane are moved up by 0.1, so that computing a value that is exactly 0 involves roundings.
TEST(NearDecisions, SayWhichScalarDecidesWrongly) {
    const Assignment tilted =
        changed({{"eye = [0, 0, 4]", "eye = [0.1, 0.3, 4.7]"},
                 {"lookat = [0, 0, 0]", "lookat = [0.1, 0.3, 0.7]"},
                 {"[[0, -2, 2], [2, 2, 2], [-2, 2, 2]]", "[[0, -2, 2.7], [2, 2, 2.7], [-2, 2, 2.7]]"}});
    const Decision t = decision(decisions_in(tilted), "triangle: t");
    EXPECT_EQ(t.sign, 0);
    EXPECT_FALSE(t.double_is_sure);
    EXPECT_THAT(t.wrong, testing::Not(IsEmpty()));
}

// The ray runs along x = y = 0. It would touch a sphere around (1, 1, 0) of radius √2; this sphere is 3e-12 too small.
TEST(NearDecisions, DistinguishFloatFromDouble) {
    const Assignment grazing = changed({{"radius = 2", "radius = 1.41421356237"}});
    const Decision d = decision(decisions_in(grazing), "sphere: d");
    EXPECT_EQ(d.sign, -1);
    EXPECT_FALSE(d.float_is_sure);
    EXPECT_TRUE(d.double_is_sure);
    EXPECT_TRUE(d.hangs_on_rounding());
}

TEST(NearDecisions, LeaveOutSignsThatDecideNothing) {
    // The ray passes far from the triangle, so it does not matter that it starts in the triangle's plane.
    const Assignment aside = changed({{"[[0, -2, 2], [2, 2, 2], [-2, 2, 2]]", "[[10, -2, 2], [12, 2, 2], [8, 2, 2]]"}});
    EXPECT_THAT(hanging(decisions_in(aside)), IsEmpty());
}

TEST(NearDecisions, IncludeTheOrderOfTwoHits) {
    // 2 - √2 = 0.5857864376269...
    const Assignment near = changed({{"[[0, -2, 2], [2, 2, 2], [-2, 2, 2]]",
                                      "[[0, -2, 1.41421356237], [2, 2, 1.41421356237], [-2, 2, 1.41421356237]]"}});
    const Decision order = decision(decisions_in(near), "order: sphere, triangle");
    EXPECT_EQ(order.sign, -1);
    EXPECT_FALSE(order.float_is_sure);
}

}  // namespace
}  // namespace reference::accuracy
