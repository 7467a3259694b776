#include "harness/prepare/shown_mistakes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/given/student/scenes.h"
#include "tests/harness/prepare/named.h"

namespace harness::prepare {
namespace {

using testing::Contains;
using testing::Not;
using testing::UnorderedElementsAre;

ShownMistakes of(const reference::Assignment& assignment) {
    return shown_mistakes(assignment, reference::make_key(assignment, reference::Precision::certified));
}

TEST(ShownMistakes, AreNotThoseThatTheHandoutsPixelHides) {
    for (const char* name : {"a6-2021", "a6-2024"}) {
        const ShownMistakes mistakes = of(named(name));
        EXPECT_THAT(mistakes.hidden, Contains(NamedMistake{item::P_VCS, "y counted from the top"})) << name;
    }
}

TEST(ShownMistakes, AreNotThoseOfACenterOnTheNormal) {
    const ShownMistakes mistakes = of(named("a6-2024"));
    EXPECT_THAT(mistakes.hidden, Contains(NamedMistake{item::cylinder::normal, "center forgotten"}));
    EXPECT_THAT(mistakes.shown, Contains(NamedMistake{item::cylinder::normal, "points inward"}));
    reference::Assignment moved = named("a6-2024");
    moved.scene.cylinders.front().center.z = reference::Decimal::parse("0.5").value();
    EXPECT_THAT(of(moved).shown, Contains(NamedMistake{item::cylinder::normal, "center forgotten"}));
}

TEST(ShownMistakes, AreToldApartUnlessTheyGiveTheSameNumber) {
    // a = 1, b = -4, c = 3, d = 4: the eye is two units before the start, so its t is 3, the larger root.
    const ShownMistakes mistakes = of(named("a6-2024"));
    const auto group = std::ranges::find_if(mistakes.alike, [](const std::vector<NamedMistake>& each) {
        return std::ranges::find(each, NamedMistake{item::cylinder::t, "larger root"}) != each.end();
    });
    ASSERT_NE(group, mistakes.alike.end());
    EXPECT_THAT(*group, Contains(NamedMistake{item::cylinder::t, "ray starts at the eye"}));
    EXPECT_THAT(*group, Not(Contains(NamedMistake{item::cylinder::t, "not divided by 2"})));
}

TEST(ShownMistakes, AreOnlyOfItemsThatAreAsked) {
    reference::Assignment assignment = named("a6-2024");
    assignment.questions = {{1, "the ray", {item::V}}};
    const ShownMistakes mistakes = of(assignment);
    for (const auto* list : {&mistakes.shown, &mistakes.hidden}) {
        for (const NamedMistake& mistake : *list) EXPECT_EQ(mistake.item, item::V) << mistake.name;
    }
}

}  // namespace
}  // namespace harness::prepare
