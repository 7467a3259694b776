#include "harness/gradebook/changed_feedback.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/report/text/changed_marks.h"
#include "tests/given/report/graded_samples.h"

namespace harness {
namespace {

using namespace report_samples;
using namespace std::chrono_literals;

std::string told(const FeedbackChanges& changes) {
    return report::feedback_changes_text(changes);
}

std::string told(const Graded& before, const Graded& after, Marks marks = Marks::same) {
    FeedbackChanges changes;
    add_feedback(changes, before, after, marks);
    return told(changes);
}

Graded plain() {
    return graded("ada", output_with_a_mistake());
}

Graded with_all() {
    Graded one = plain();
    one.findings.variants = VariantsReport{};
    one.findings.hard_scenes = HardScenesReport{};
    one.execution.sanitizer = {"runtime error: division by zero"};
    one.findings.flags = {{"nondeterministic", "Question 5 differs."}, {"hard_coded", "Question 5 does not move."}};
    return one;
}

TEST(FeedbackChanges, NameEachAddedOrRemovedPartWithItsOption) {
    EXPECT_EQ(told(plain(), with_all()),
              "Other changes, by number of submissions: other scenes new in 1; hard scenes new in 1; "
              "sanitizers' findings new in 1; "
              "flag hard_coded new in 1; flag nondeterministic new in 1.\n");
    EXPECT_EQ(told(with_all(), plain()),
              "Other changes, by number of submissions: other scenes gone from 1 (see --variants); hard scenes "
              "gone from 1 (see --stress); "
              "sanitizers' findings gone from 1 (see --sanitize); flag hard_coded gone from 1 (see --variants); "
              "flag nondeterministic gone from 1 (see --repeat).\n");
}

TEST(FeedbackChanges, NameEachChangedPart) {
    Graded after = with_all();
    after.findings.variants->moved = 3;
    after.findings.hard_scenes->not_found = {"eye"};
    after.execution.sanitizer = {"runtime error: null pointer"};
    after.findings.flags[1].evidence = "Question 6 does not move.";
    after.score.questions[4].items[0].printed = "1 2 3";
    after.execution.build.diagnostics = "warning";
    after.execution.run.errors = "oops";
    after.submission.notes = {"another file"};
    after.execution.tier = Tier::unsafe;
    after.execution.explanation = "The program ended with exit code 1.";
    EXPECT_EQ(told(with_all(), after),
              "Other changes, by number of submissions: other scenes changed in 1; hard scenes changed in 1; "
              "sanitizers' findings changed in "
              "1; flag hard_coded changed in 1; other feedback changed in 1.\n");
}

TEST(FeedbackChanges, NameOnlyAddedOrRemovedPartsIfTheMarkChanged) {
    Graded after = with_all();
    after.findings.hard_scenes->not_found = {"eye"};
    after.execution.sanitizer.clear();
    after.execution.build.diagnostics = "warning";
    EXPECT_EQ(told(with_all(), after, Marks::moved),
              "Other changes, by number of submissions: sanitizers' findings gone from 1 (see --sanitize).\n");
    EXPECT_EQ(told(plain(), graded("ada", ""), Marks::moved), "");
}

TEST(FeedbackChanges, AreCountedOverAClass) {
    FeedbackChanges changes;
    add_feedback(changes, plain(), with_all(), Marks::same);
    add_feedback(changes, with_all(), plain(), Marks::moved);
    Graded after = with_all();
    after.findings.flags.pop_back();
    add_feedback(changes, with_all(), after, Marks::same);
    Graded slower = plain();
    slower.execution.build.wall += 5ms;
    slower.execution.run.cpu += 5ms;
    slower.execution.run.wall += 5ms;
    slower.execution.run.peak_memory_bytes += 4096;
    add_feedback(changes, plain(), slower, Marks::same);
    EXPECT_EQ(changes.differing, 2U) << "without the one whose marks moved, and the one that was only slower";
    EXPECT_EQ(changes.remeasured, 1U);
    EXPECT_THAT(told(changes), testing::HasSubstr("flag hard_coded new in 1, gone from 2 (see --variants);"));
    EXPECT_THAT(told(changes), testing::EndsWith("; only time and memory changed in 1.\n"));
    EXPECT_EQ(told(FeedbackChanges{}), "");
}

}  // namespace
}  // namespace harness
