#include "harness/scenes/run/run_rewritten.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>
#include <memory>
#include <stdexcept>

#include "harness/grade/marking.h"
#include "harness/machine/errors.h"
#include "harness/run/runner.h"
#include "harness/run/timeline.h"
#include "reference/toml/assignment.h"

namespace harness::scenes {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const DecimalScene& scene() {
    static const DecimalScene a6 = reference::load_assignment("a6-2021", RAYGRADE_ASSIGNMENTS).scene;
    return a6;
}

/// Four submissions. All have a right answer except the second.
std::vector<Graded> four() {
    std::vector<Graded> all(4);
    for (Graded& one : all) {
        one.outcome = Outcome::graded;
        one.score.questions = {{5, "", ItemVerdict::right, 10, 10, {ItemScore{}}}};
        one.score.questions[0].items[0].verdict = ItemVerdict::right;
        one.score.questions[0].items[0].printed = "1";
    }
    all[1].score.questions.clear();
    return all;
}

/// Runs the class without any scene, so nothing is compiled. Returns the submissions that were concluded.
template <class ForOne, class Conclude>
std::vector<std::size_t> concluded(std::vector<Graded>& graded, ForOne for_one, Conclude conclude) {
    const std::vector<std::string> sources(graded.size());
    const std::vector<MarkedScene> none;
    std::vector<std::size_t> indices;
    Timeline timeline;
    run_rewritten(
        graded, sources, scene(), Runner{}, 1, timeline,
        [&](std::size_t index, const PartSet&) -> const auto& {
            for_one(index);
            return none;
        },
        [&](const Rewritten& one) {
            conclude(one.index);
            indices.push_back(one.index);
        });
    return indices;
}

void nothing(std::size_t /*index*/) {}

/// Throws for the first submission.
template <class Error>
void fail_for_first(std::size_t index) {
    if (index == 0) throw Error("stoi\x1b");
}

TEST(RunRewritten, TriesEverySubmissionWithARightAnswer) {
    std::vector<Graded> graded = four();
    EXPECT_THAT(concluded(graded, nothing, nothing), ElementsAre(0, 2, 3));
    for (const Graded& one : graded) {
        EXPECT_FALSE(one.our_fault);
        EXPECT_THAT(one.submission.notes, IsEmpty());
    }
}

TEST(RunRewritten, NotesAFaultOfRaygradeOnOneSubmission) {
    for (const bool while_drawing : {true, false}) {
        std::vector<Graded> graded = four();
        const auto fail = fail_for_first<std::out_of_range>;
        const auto tried = while_drawing ? concluded(graded, fail, nothing) : concluded(graded, nothing, fail);
        EXPECT_THAT(tried, ElementsAre(2, 3));
        EXPECT_TRUE(graded[0].our_fault);
        EXPECT_EQ(graded[0].outcome, Outcome::graded) << "it has its marks";
        EXPECT_THAT(graded[0].submission.notes,
                    ElementsAre("Other scenes: A fault of raygrade: stoi\\x1b. Please report it with the submission."));
        for (std::size_t i = 1; i < graded.size(); ++i) {
            EXPECT_FALSE(graded[i].our_fault) << i;
            EXPECT_THAT(graded[i].submission.notes, IsEmpty()) << i;
        }
    }
}

TEST(RunRewritten, DistinguishesTheMachinesFailureFromItsOwnFault) {
    std::vector<Graded> graded = four();
    EXPECT_THAT(concluded(graded, fail_for_first<HarnessError>, nothing), ElementsAre(2, 3));
    EXPECT_FALSE(graded[0].our_fault);
    EXPECT_THAT(graded[0].submission.notes,
                ElementsAre("It was not run on other scenes: something went wrong here, not in it."));
}

}  // namespace
}  // namespace harness::scenes
