#include "harness/prepare/proposal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reference/accuracy/measure/assignment_accuracy.h"
#include "reference/toml/scene_toml.h"
#include "tests/harness/prepare/named.h"

namespace harness::prepare {
namespace {

TEST(Proposal, ShowsMoreMistakesWithoutABoundaryCase) {
    for (const auto& [name, steps] : {std::pair{"a6-2021", 40}, {"a6-2024", 12}}) {
        const reference::Assignment assignment = named(name);
        const auto before = shown_mistakes(assignment, make_key(assignment, reference::Precision::certified));
        const Proposal proposal = propose(assignment, {.steps = steps});
        EXPECT_GT(proposal.mistakes.shown.size(), before.shown.size()) << name;
        EXPECT_THAT(proposal.changes, testing::Not(testing::IsEmpty()));
        reference::Assignment proposed = assignment;
        proposed.scene = proposal.scene;
        const auto key = make_key(proposed, reference::Precision::certified);
        EXPECT_EQ(key.decisions.of(reference::Subject::sphere), "hit");
        EXPECT_EQ(key.decisions.of(reference::Subject::triangle), "hit");
        EXPECT_TRUE(key.decisions.policy.empty() || key.decisions.policy.front() != "boundary");
        for (const auto& decision : reference::accuracy::decisions_of(proposed, key.canonical))
            EXPECT_FALSE(decision.hangs_on_rounding()) << decision.what;
    }
}

TEST(Proposal, IsTheSameForTheSameSeed) {
    const reference::Assignment assignment = named("a6-2024");
    const auto scene = [&](std::uint64_t seed) {
        return reference::scene_toml(propose(assignment, {.steps = 4, .seed = seed}).scene);
    };
    EXPECT_EQ(scene(3), scene(3));
    EXPECT_NE(scene(3), scene(4));
}

}  // namespace
}  // namespace harness::prepare
