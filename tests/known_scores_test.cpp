#include "harness/known_scores.h"

#include <gtest/gtest.h>

#include <thread>

#include "tests/student/scenes.h"

namespace harness {
namespace {

Marking marking_with(double points_of_5) {
    student::Marking scene = student::handout_scene();
    scene.assignment.rubric.points[5] = points_of_5;
    return {std::move(scene.assignment), std::move(scene.key)};
}

std::string direction(const std::string& z) {
    return "Question 5\nV = (0, 0, " + z + ")\n";
}

TEST(KnownScores, AreThoseOfTheOutputAndTheMarking) {
    const Marking ten = marking_with(10);
    const Marking twenty = marking_with(20);
    KnownScores scores;
    Timeline timeline;
    for (int time = 0; time < 2; ++time) {
        EXPECT_EQ(scores.score(direction("-1"), ten, timeline, "ada").points, 10);
        EXPECT_EQ(scores.score(direction("1"), ten, timeline, "ben").points, 0);
        EXPECT_EQ(scores.score(direction("-1"), twenty, timeline, "ada").points, 20);
    }
    EXPECT_EQ(timeline.alike, 3U) << "each was marked once";
}

TEST(KnownScores, CountSubmissionsThatPrintedWhatAnotherHad) {
    const Marking marking = marking_with(10);
    KnownScores scores;
    Timeline timeline;
    for (const char* nobody_printed_anything : {"ada", "ben"})
        EXPECT_EQ(scores.score("", marking, timeline, nobody_printed_anything).points, 0);
    EXPECT_EQ(timeline.alike, 0U);
    for (const Turn turn : {Turn::first, Turn::repeated, Turn::repeated})
        EXPECT_EQ(scores.score(direction("-1"), marking, timeline, "ada", turn).points, 10);
    EXPECT_EQ(timeline.alike, 0U);
    for (const Turn turn : {Turn::first, Turn::repeated})
        EXPECT_EQ(scores.score(direction("-1"), marking, timeline, "ben", turn).points, 10);
    EXPECT_EQ(timeline.alike, 1U);
}

TEST(KnownScores, AreRightAlsoWhereMoreOutputsDifferThanAreRemembered) {
    const Marking marking = marking_with(10);
    KnownScores scores;
    Timeline timeline;
    const auto mark_all = [&] {
        for (std::size_t i = 0; i < KnownScores::most + 100; ++i) {
            const Score score = scores.score(direction(std::to_string(i)), marking, timeline, "ada");
            ASSERT_EQ(score.questions.at(4).items.at(0).printed, "(0, 0, " + std::to_string(i) + ")");
        }
    };
    std::vector<std::jthread> threads;
    for (int i = 0; i < 3; ++i) threads.emplace_back(mark_all);
    threads.clear();
    mark_all();
}

}  // namespace
}  // namespace harness
