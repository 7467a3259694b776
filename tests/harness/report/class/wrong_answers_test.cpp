#include "harness/report/class/wrong_answers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/report/class/statistics.h"
#include "tests/given/report/graded_samples.h"

namespace harness::report {
namespace {

using namespace report_samples;
using testing::ElementsAre;

/// A submission with this verdict, text and diagnosis for item c of question 6, and all else right.
Graded with_c(ItemVerdict verdict, const std::string& printed, const std::string& diagnosis = "") {
    Graded one = graded("s", wrong_everywhere());
    for (QuestionScore& question : one.score.questions) {
        for (ItemScore& item : question.items) item.verdict = ItemVerdict::right;
    }
    ItemScore& c = one.score.questions[5].items[2];
    c.verdict = verdict;
    c.printed = printed;
    c.diagnosis = diagnosis;
    return one;
}

const std::vector<WrongAnswer>& of_question_6(const std::vector<QuestionMistakes>& mistakes) {
    return mistakes.at(5).answers;
}

TEST(GistOf, IsTheSameForTheSameNumbers) {
    EXPECT_EQ(gist_of("vec3(1.0000, -0.500001, 2)"), gist_of("( 1 -.5 2.00 )"));
    EXPECT_EQ(gist_of("-0.0"), gist_of("0"));
    EXPECT_NE(gist_of("1.001"), gist_of("1.002"));
    EXPECT_NE(gist_of("x1 2"), gist_of("1 2"));
    EXPECT_EQ(gist_of("No Hit!"), gist_of("no  hit"));
}

TEST(WrongAnswers, AreGroupedByDiagnosisOrElseByNumbers) {
    const auto wrong = ItemVerdict::wrong;
    const auto mistakes = mistakes_by_question({with_c(wrong, "5.0"), with_c(wrong, "7", "radius not squared"),
                                                with_c(wrong, "5.00001"), with_c(wrong, "8", "radius not squared"),
                                                with_c(wrong, "5"), with_c(ItemVerdict::right, "1")});
    const auto& answers = of_question_6(mistakes);
    ASSERT_EQ(answers.size(), 2U);
    EXPECT_THAT(answers[0].who, ElementsAre(0, 2, 4));
    EXPECT_EQ(answers[0].printed, "5.0");
    EXPECT_THAT(answers[1].who, ElementsAre(1, 3));
    EXPECT_EQ(answers[1].diagnosis, "radius not squared");
    EXPECT_THAT(mistakes[0].answers, testing::IsEmpty());
}

TEST(WrongAnswers, AreOneEntryAtTheEndIfUnshared) {
    const auto wrong = ItemVerdict::wrong;
    const auto mistakes =
        mistakes_by_question({with_c(wrong, "5"), with_c(wrong, "6"), with_c(ItemVerdict::unreadable, "a word"),
                              with_c(wrong, "9", "named"), with_c(wrong, "1"), with_c(wrong, "1")});
    const auto& answers = of_question_6(mistakes);
    ASSERT_EQ(answers.size(), 3U);
    EXPECT_THAT(answers[0].who, ElementsAre(4, 5));
    EXPECT_EQ(answers[1].diagnosis, "named");
    EXPECT_TRUE(answers[2].differing);
    EXPECT_THAT(answers[2].who, ElementsAre(0, 1, 2));
}

TEST(WrongAnswers, AreOneEntryForAQuestionWithoutAnswers) {
    Graded one = with_c(ItemVerdict::right, "");
    for (ItemScore& item : one.score.questions[5].items) item.verdict = ItemVerdict::missing;
    const auto mistakes = mistakes_by_question({one});
    ASSERT_EQ(of_question_6(mistakes).size(), 1U);
    EXPECT_TRUE(of_question_6(mistakes)[0].whole_question);
}

TEST(WrongAnswers, AreSeparateForProgramsThatCrashed) {
    Graded crashed = with_c(ItemVerdict::missing, "");
    crashed.execution.outcome = Outcome::crashed;
    Graded stopped = crashed;
    stopped.execution.outcome = Outcome::timed_out;
    auto mistakes = mistakes_by_question({with_c(ItemVerdict::missing, ""), crashed, stopped});
    ASSERT_EQ(of_question_6(mistakes).size(), 2U);
    EXPECT_THAT(of_question_6(mistakes)[0].who, ElementsAre(1, 2));
    EXPECT_EQ(of_question_6(mistakes)[0].sentence, "Not printed before the program ended.");
    EXPECT_THAT(of_question_6(mistakes)[1].who, ElementsAre(0));

    Graded short_one = with_c(ItemVerdict::right, "1");
    for (ItemScore& item : short_one.score.questions[5].items) item.verdict = ItemVerdict::missing;
    Graded cut = short_one;
    cut.execution.outcome = Outcome::crashed;
    mistakes = mistakes_by_question({cut, short_one, cut});
    ASSERT_EQ(of_question_6(mistakes).size(), 2U);
    EXPECT_THAT(of_question_6(mistakes)[0].who, ElementsAre(0, 2));
    EXPECT_EQ(of_question_6(mistakes)[0].sentence, "The program ended before it printed them.");
    EXPECT_EQ(of_question_6(mistakes)[1].sentence, "Not found in the output.");
}

TEST(WrongAnswers, LeaveOutStudentsWhoPrintedNothing) {
    EXPECT_THAT(mistakes_by_question({graded("nil", ""), not_graded("bob")}), testing::IsEmpty());
}

TEST(ClassStatistics, CountsFinalPointsAndPutsTheHardestItemFirst) {
    Graded all = with_c(ItemVerdict::wrong, "5");
    all.score.points = 100;
    Graded late = with_c(ItemVerdict::follow, "5");
    late.score.points = 100;
    late.late_share = 0.5;
    Graded more = with_c(ItemVerdict::right, "5");
    more.review.overrides = {{0, "", 120, "extra", "prof", ""}};
    const ClassStatistics statistics = class_statistics({all, late, more, not_graded("bob")});
    EXPECT_EQ(statistics.handed_in, 4U);
    EXPECT_EQ(statistics.marked, 3U);
    EXPECT_EQ(statistics.median, 100);
    EXPECT_EQ(statistics.mean, 90);
    EXPECT_THAT(statistics.distribution, ElementsAre(0, 0, 0, 0, 0, 1, 0, 0, 0, 2));
    EXPECT_EQ(statistics.printed, 3U);
    EXPECT_EQ(statistics.items.front().spec.name, "c");
    EXPECT_EQ(statistics.items.front().wrong, 1U);
    EXPECT_EQ(statistics.items.front().follow, 1U);
    EXPECT_EQ(statistics.items.front().right, 1U);
    EXPECT_EQ(statistics.overridden, 1U);
}

TEST(ClassStatistics, HaveBinsOfARoundWidth) {
    const auto width_and_bins = [](double max_points) {
        Graded one = with_c(ItemVerdict::right, "1");
        one.score.points = one.score.max_points = max_points;
        const ClassStatistics statistics = class_statistics({one});
        EXPECT_EQ(statistics.distribution.back(), 1U);
        return std::pair(statistics.bin_width, statistics.distribution.size());
    };
    EXPECT_EQ(width_and_bins(100), (std::pair<double, std::size_t>(10, 10)));
    EXPECT_EQ(width_and_bins(95), (std::pair<double, std::size_t>(10, 10)));
    EXPECT_EQ(width_and_bins(110), (std::pair<double, std::size_t>(10, 11)));
    EXPECT_EQ(width_and_bins(30), (std::pair<double, std::size_t>(5, 6)));
    EXPECT_EQ(width_and_bins(8), (std::pair<double, std::size_t>(1, 8)));
}

TEST(ClassStatistics, CountStudentsWhoAreLateInTheLms) {
    std::vector<Graded> all(4, with_c(ItemVerdict::right, "5"));
    for (std::size_t i = 1; i < all.size(); ++i) all[i].submission.lms = LmsName{};
    all[1].submission.lms->late = std::nullopt;
    all[2].submission.lms->late = false;
    all[3].submission.lms->late = true;
    EXPECT_EQ(class_statistics(all).late, 1U);
}

TEST(ClassStatistics, CountSubmissionsToReview) {
    Graded unsound = with_c(ItemVerdict::right, "5"), flagged = unsound, not_graded = unsound;
    unsound.execution.sanitizer = {"ray_cast.cpp:7:9: runtime error: division by zero"};
    not_graded.execution.outcome = Outcome::not_graded;
    flagged.findings.flags = {{"nondeterministic", "Question 1: run 1 printed 1"}};
    EXPECT_EQ(class_statistics({unsound, flagged, not_graded, with_c(ItemVerdict::right, "5")}).to_review, 2U);
}

}  // namespace
}  // namespace harness::report
