// Why a doubt remains after a program ran on other scenes.
#include "harness/record/experiment.h"

#include <gtest/gtest.h>

namespace harness {
namespace {

Score with_doubt(Doubt::Why why) {
    ItemScore t;
    t.spec.name = "t";
    t.doubt = Doubt{why, 12};
    Score score;
    score.questions = {{.number = 6, .verdict = ItemVerdict::missing, .items = {t}}};
    return score;
}

TEST(DoubtsEvidence, SaysWhyOtherScenesDoNotSettleIt) {
    const Score score = with_doubt(Doubt::Why::numbers_left);
    EXPECT_EQ(doubts_evidence(score, std::nullopt, Audience::student), "question 6 (t): the answer may be on line 12");
    ExperimentReport report;
    EXPECT_EQ(doubts_evidence(score, report, Audience::student), "question 6 (t): the answer may be on line 12");
    report.unsettled = "the program prints the same numbers on every scene";
    EXPECT_EQ(doubts_evidence(score, report, Audience::student),
              "question 6 (t): the answer may be on line 12. Runs on other scenes did not settle this: the program "
              "prints the same numbers on every scene.");
}

TEST(DoubtsEvidence, IsEmptyForAStudentWhoSeesNoDoubt) {
    ExperimentReport report;
    report.unsettled = "the program prints the same numbers on every scene";
    const Score score = with_doubt(Doubt::Why::right_elsewhere);
    EXPECT_EQ(doubts_evidence(score, report, Audience::student), "");
    EXPECT_NE(doubts_evidence(score, report, Audience::instructor), "");
}

}  // namespace
}  // namespace harness
