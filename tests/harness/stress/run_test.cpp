// Failures while hard scenes are made or reported.
#include "harness/stress/run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "harness/run/runner.h"
#include "harness/run/timeline.h"
#include "tests/given/hard_scenes/held.h"
#include "tests/given/printed_values.h"

namespace harness::stress {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Runner workshop_without_sandbox() {
    const auto [compile, run] = read_limits({}, {});
    return {std::make_unique<Sandbox>(Tier::unsafe), {}, default_build_settings(compile), run};
}

/// A graded submission with all answers right.
Graded graded_right(const student::Marking& marking) {
    Graded graded;
    graded.execution.outcome = Outcome::graded;
    graded.score = ::mark(right_printout(marking), marking);
    return graded;
}

// raygrade never reads an assignment with this camera, so the camera stands for a fault of raygrade.
TEST(RunHardScenes, KeepsTheMarksOfAClassIfItFailsItself) {
    student::Marking marking = held(student::handout_scene());
    std::vector<Graded> graded{graded_right(marking), graded_right(marking), Graded()};
    const double points = graded[0].score.points;
    marking.assignment.scene.camera.lookat = marking.assignment.scene.camera.eye;
    Timeline timeline;
    const std::vector<std::string> sources{"int main() {}", "int main() {}", ""};
    const Marking held_to{marking.assignment, marking.key};
    variants::run_rewritten(graded, sources, held_to.assignment.scene, workshop_without_sandbox(), 1, timeline,
                            {on_hard_scenes(graded, held_to)});
    for (const std::size_t i : {0U, 1U}) {
        EXPECT_EQ(graded[i].execution.outcome, Outcome::graded);
        EXPECT_EQ(graded[i].score.points, points);
        EXPECT_TRUE(graded[i].execution.our_fault) << "raygrade ends with 3";
        EXPECT_THAT(graded[i].submission.notes, ElementsAre(HasSubstr("a fault of raygrade: division by zero")));
        EXPECT_FALSE(graded[i].findings.hard_scenes.has_value());
    }
    EXPECT_FALSE(graded[2].execution.our_fault) << "nothing to try";
}

}  // namespace
}  // namespace harness::stress
