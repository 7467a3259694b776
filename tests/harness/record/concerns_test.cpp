// What needs a person, and what a person has accepted.
#include "harness/record/concerns.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/given/report/graded_samples.h"

namespace harness {
namespace {

using report_samples::graded;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> kinds(const std::vector<Flag>& concerns) {
    std::vector<std::string> all;
    for (const Flag& each : concerns) all.push_back(each.kind);
    return all;
}

/// Accepts the concern as the review does.
void accept(Graded& one, const Flag& concern) {
    Decision decision;
    decision.about = concern.kind;
    decision.seen = seen_in(one, concern);
    one.review.decisions.push_back(decision);
}

/// A submission whose answer to 5.V, read from line 2, is doubtful.
Graded doubtful() {
    Graded one = graded("ada", "Question 5:\nV: 1 2 3\n0 0 -1\n");
    ItemScore& item = one.score.questions.at(4).items.at(0);
    item.doubt = Doubt{Doubt::Why::right_elsewhere, 3};
    one.findings.flags = {{"reading_doubtful", "5.V: line 3 has numbers that were not understood"}};
    return one;
}

TEST(Concerns, BeginWithReadingsAndEndWithLateness) {
    Graded one = graded("ada", "");
    one.findings.flags = {{"late_without_date", ""}, {"hard_coded", ""}, {"reading_doubtful", ""}};
    one.execution.outcome = Outcome::not_graded;
    one.execution.explanation = "No room on the disk.";
    EXPECT_THAT(kinds(concerns_of(one)),
                ElementsAre("reading_doubtful", "hard_coded", "not_graded", "late_without_date"));
    EXPECT_EQ(concerns_of(one)[2].evidence, "No room on the disk.");
}

TEST(Concerns, AreInTheOrderOfTheReviewsChapters) {
    Graded one = graded("ada", "");
    one.findings.flags = {{"of_a_newer_raygrade", ""}, {"nondeterministic", ""}, {"hard_coded", ""}};
    EXPECT_THAT(kinds(concerns_of(one)), ElementsAre("hard_coded", "nondeterministic", "of_a_newer_raygrade"));
}

TEST(Concerns, AreHiddenFromStudentsIfTheyAreSuspicionsOrCostNothing) {
    Graded one = graded("ada", "Question 5:\nV: 1 2 3\n0 0 -1\n");
    for (QuestionScore& question : one.score.questions) {
        for (ItemScore& scored : question.items) scored.doubt.reset();
    }
    ItemScore& item = one.score.questions.at(4).items.at(0);
    item.doubt = Doubt{Doubt::Why::numbers_left, 3};
    item.max_points = 10;
    for (const char* kind : {"reading_doubtful", "hard_coded", "mostly_following", "nondeterministic"})
        one.findings.flags.push_back({kind, "evidence"});
    EXPECT_THAT(kinds(flags_for_student(one)), ElementsAre("reading_doubtful", "nondeterministic"));
    item.points = item.max_points;
    EXPECT_THAT(kinds(flags_for_student(one)), ElementsAre("nondeterministic"));
}

TEST(Concerns, AreOpenUntilTheyAreAccepted) {
    Graded one = doubtful();
    one.findings.flags.push_back({"hard_coded", "6.t"});
    accept(one, one.findings.flags[0]);
    EXPECT_THAT(kinds(open_concerns(one)), ElementsAre("hard_coded"));
    EXPECT_THAT(kinds(open_flags(one)), ElementsAre("hard_coded"));
    accept(one, one.findings.flags[1]);
    EXPECT_THAT(open_concerns(one), IsEmpty());
}

TEST(Concerns, AreOpenAgainWhenSomethingElseIsDoubtful) {
    Graded one = doubtful();
    accept(one, one.findings.flags[0]);
    Graded again = one;
    EXPECT_THAT(open_concerns(again), IsEmpty());
    again.findings.flags[0].evidence = "5.V: line 4 has numbers that were not understood";
    EXPECT_THAT(kinds(open_concerns(again)), ElementsAre("reading_doubtful"));
    again = one;
    again.score.questions.at(4).items.at(0).printed = "vec3(1, 2, 4)";
    EXPECT_THAT(kinds(open_concerns(again)), ElementsAre("reading_doubtful")) << "another value was read";
    again = one;
    again.score.questions.at(4).items.at(0).line = 7;
    EXPECT_THAT(kinds(open_concerns(again)), ElementsAre("reading_doubtful")) << "it was read elsewhere";
}

TEST(Concerns, AreNotAcceptedByACommentNorForAnotherSubmission) {
    std::vector<Graded> all{doubtful(), doubtful()};
    all[1].submission.id = "ben";
    Decision decision;
    decision.about = "reading_doubtful";
    decision.seen = seen_in(all[0], all[0].findings.flags[0]);
    Decision comment = decision;
    comment.kind = Decision::Kind::comment;
    attach({{"ben", decision}, {"ada", comment}, {"gone", decision}}, all);
    EXPECT_THAT(kinds(open_concerns(all[0])), ElementsAre("reading_doubtful"));
    EXPECT_THAT(open_concerns(all[1]), IsEmpty());
    EXPECT_EQ(comments_of(all[0]).size(), 1U);
    EXPECT_THAT(comments_of(all[1]), IsEmpty());
}

}  // namespace
}  // namespace harness
