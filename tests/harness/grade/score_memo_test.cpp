#include "harness/grade/score_memo.h"

#include <gtest/gtest.h>

#include <thread>

namespace harness {
namespace {

std::shared_ptr<const Score> worth(double points) {
    Score score;
    score.points = points;
    return std::make_shared<const Score>(std::move(score));
}

TEST(ScoreMemo, FindsTheScoreOfTheSameOutputOnly) {
    ScoreMemo memo;
    memo.keep("t = 1", worth(1));
    memo.keep("t = 2", worth(2));
    EXPECT_EQ(memo.find("t = 1")->points, 1);
    EXPECT_EQ(memo.find("t = 2")->points, 2);
    EXPECT_FALSE(memo.find("t = 3"));
    EXPECT_FALSE(memo.find(""));
}

TEST(ScoreMemo, ForgetsTheOldestBeyondItsBound) {
    ScoreMemo memo;
    for (std::size_t i = 0; i < ScoreMemo::most + 2; ++i) memo.keep(std::to_string(i), worth(static_cast<double>(i)));
    EXPECT_FALSE(memo.find("0"));
    EXPECT_FALSE(memo.find("1"));
    EXPECT_EQ(memo.find("2")->points, 2);
}

TEST(ScoreMemo, IsRightForSeveralThreads) {
    ScoreMemo memo;
    const auto use = [&] {
        for (std::size_t i = 0; i < ScoreMemo::most + 100; ++i) {
            const std::string output = std::to_string(i);
            if (!memo.find(output)) memo.keep(output, worth(static_cast<double>(i)));
            if (const auto score = memo.find(output)) {
                ASSERT_EQ(score->points, static_cast<double>(i));
            }
        }
    };
    std::vector<std::jthread> threads;
    for (int i = 0; i < 3; ++i) threads.emplace_back(use);
    threads.clear();
    use();
}

TEST(ScoreMemo, MakesTheMarkingOfASceneOnceAlsoWhereThereIsNone) {
    ScoreMemo memo;
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
