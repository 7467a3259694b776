#include "harness/grade/scene_memo.h"

#include <gtest/gtest.h>

namespace harness {
namespace {

TEST(SceneMemo, MakesTheMarkingOfASceneOnceEvenIfThereIsNone) {
    SceneMemo memo;
    reference::Scene<reference::Decimal> one, other;
    other.pixel = {7, 8};
    int made = 0;
    const auto make = [&] {
        ++made;
        return made == 1 ? std::make_shared<const Marking>() : nullptr;
    };
    const auto marking = memo.on_scene(one, make);
    EXPECT_TRUE(marking);
    EXPECT_FALSE(memo.on_scene(other, make));
    EXPECT_EQ(memo.on_scene(one, make), marking);
    EXPECT_FALSE(memo.on_scene(other, make));
    EXPECT_EQ(made, 2);
}

}  // namespace
}  // namespace harness
