// How past decisions are told: what was undone stays, with who undid it.
#include "harness/review/past.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace harness::review {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

KeptDecision a_decision(std::int64_t number, const std::string& submission, const std::string& text,
                        Decision::Kind kind = Decision::Kind::comment, const std::string& about = "") {
    Decision given;
    given.number = number;
    given.kind = kind;
    given.about = about;
    given.text = text;
    given.by = "bea";
    given.when = "2026-11-24T09:00:00Z";
    return {submission, given};
}

KeptClass kept_class(std::vector<KeptDecision> in_force, std::vector<UndoneDecision> undone) {
    KeptClass kept;
    kept.decisions = std::move(in_force);
    kept.undone = std::move(undone);
    return kept;
}

TEST(PastDecisions, CanBeUndoneForOneStudent) {
    const KeptClass kept = kept_class({a_decision(1, "ben", "one"), a_decision(1, "cleo", "one")},
                                      {{a_decision(1, "ada", "one"), {"dee", "2026-11-24T10:00:00Z"}}});
    const std::vector<PastDecision> past = past_decisions(kept);
    ASSERT_EQ(past.size(), 1);
    EXPECT_THAT(past[0].in_force, ElementsAre("ben", "cleo"));
    EXPECT_THAT(past[0].submissions, testing::UnorderedElementsAre("ada", "ben", "cleo"));
    ASSERT_EQ(past[0].taken_back.size(), 1);
    EXPECT_THAT(past[0].taken_back[0].submissions, ElementsAre("ada"));
    EXPECT_EQ(sentence_of(kept, 1), "Decision 1: Comment added for ben; cleo.");
}

TEST(PastDecisions, NameStudentsByTheirNames) {
    KeptClass kept = kept_class({a_decision(1, "doejane", "one"), a_decision(1, "ben", "one")}, {});
    kept.graded.resize(1);
    kept.graded[0].submission.id = "doejane";
    kept.graded[0].submission.lms.emplace().student = "Doe, Jane";
    EXPECT_EQ(sentence_of(kept, 1), "Decision 1: Comment added for Doe, Jane; ben.");
}

TEST(PastDecisions, AreNamedAfterTheirPointsEvenIfUndone) {
    const Author dee{"dee", "2026-11-24T10:00:00Z"};
    const KeptClass kept =
        kept_class({}, {{a_decision(1, "ada", "half", Decision::Kind::points, "6.t"), dee},
                        {a_decision(1, "ada", "half", Decision::Kind::accepted, "reading_doubtful"), dee}});
    const std::vector<PastDecision> past = past_decisions(kept);
    ASSERT_EQ(past.size(), 1);
    EXPECT_EQ(past[0].what, "Points given (question 6, t)");
    EXPECT_THAT(past[0].taken_back[0].submissions, ElementsAre("ada"));
    EXPECT_EQ(sentence_of(kept, 1), "") << "nothing of it is in force";
}

}  // namespace
}  // namespace harness::review
