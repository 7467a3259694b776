#include "harness/record/override_place.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/machine/errors.h"
#include "tests/given/message_of.h"
#include "tests/given/report/graded_samples.h"

namespace harness {
namespace {

using namespace report_samples;
using testing::AllOf;
using testing::HasSubstr;
using testing::SizeIs;

template <class Work>
std::string refusal(const Work& work) {
    return message_of<UsageError>(work, "(taken)");
}

std::string refused_place(std::string_view text, const Graded& one) {
    return refusal([&] { read_place(text, one); });
}

TEST(OverridePlace, IsAnItemAQuestionOrTheTotal) {
    const Graded one = graded("zoe", output_with_a_mistake());
    for (const char* text : {"6.t", "6", "total", "10.verdict", "3.M_VCS_to_WCS"})
        EXPECT_EQ(to_string(read_place(text, one)), text);
    const OverridePlace item = read_place("10.verdict", one);
    EXPECT_EQ(item.question, 10);
    EXPECT_EQ(item.item, "verdict");
    EXPECT_EQ(read_place("6", one).item, "");
    EXPECT_EQ(read_place("total", one).question, 0);
}

TEST(OverridePlace, IsRefusedWithSimilarNamesIfUnknown) {
    const Graded one = graded("zoe", output_with_a_mistake());
    EXPECT_THAT(refused_place("6.T", one), HasSubstr("did you mean 6.t"));
    EXPECT_THAT(refused_place("Total", one), HasSubstr("did you mean total?"));
    EXPECT_THAT(refused_place("11", one), HasSubstr("did you mean 1 or 10"));
    for (const char* text : {"", "6.", ".t", "06.t", "6.t ", "6t", "0", "-1", "6.t.t"})
        EXPECT_THAT(refused_place(text, one), HasSubstr("there is no item")) << text;
    EXPECT_THAT(refused_place("nonsense", one), AllOf(HasSubstr("there are total, 1, 1.P_VCS"), HasSubstr("6.t")));
    EXPECT_THAT(refused_place("6.\x1b", one), AllOf(HasSubstr("\\x1b"), testing::Not(HasSubstr("\x1b"))));
}

TEST(OverridePlace, CanOnlyBeTheTotalOfAnUngradedSubmission) {
    EXPECT_THAT(refused_place("6.t", not_graded("bob")), AllOf(HasSubstr("not graded"), HasSubstr("total")));
    EXPECT_THAT(refused_place("6", not_graded("bob")), HasSubstr("total"));
    EXPECT_EQ(read_place("total", not_graded("bob")).question, 0);
}

TEST(ItemPlace, IsRefusedForAQuestionWithAnItemOfIt) {
    const Graded one = graded("zoe", output_with_a_mistake());
    const auto refused = [&](std::string_view text) { return refusal([&] { read_item_place(text, one); }); };
    EXPECT_EQ(to_string(read_item_place("6.t", one)), "6.t");
    EXPECT_EQ(refused("7"), "\"7\" is not a single item; choose 7.normal");
    EXPECT_EQ(refused("8"), "\"8\" is not a single item; choose one, such as 8.matrix");
    EXPECT_EQ(refused("total"), "\"total\" is not a single item; choose one, such as 1.P_VCS");
}

TEST(OverridePoints, AreExactIfWrittenAsReportsPrintThem) {
    const PlacePoints there{5.0 / 6, 5.0 / 3};
    EXPECT_EQ(read_override_points("1.67", there), 5.0 / 3);
    EXPECT_EQ(read_override_points("0.83", there), 5.0 / 6);
    EXPECT_EQ(read_override_points("1.670", there), 5.0 / 3);
    EXPECT_EQ(read_override_points("1.666", there), 1.666);
    EXPECT_EQ(read_override_points("1.68", there), 1.68);
    EXPECT_EQ(read_override_points("2", {0, 2}), 2);
}

TEST(OverridePoints, MustBeANumberFromZeroToAMillion) {
    EXPECT_EQ(read_override_points("0", {0, 10}), 0);
    EXPECT_EQ(read_override_points("1.25", {0, 10}), 1.25);
    EXPECT_EQ(read_override_points("1000000", {0, 10}), 1e6);
    EXPECT_FALSE(std::signbit(read_override_points("-0", {0, 10})));
    for (const char* text : {"", "x", "-1", "1000000.5", "1e7", "nan", "inf", "1,5", "1.5 ", " 1", "+1", "0x10"})
        EXPECT_THAT(refusal([&] { read_override_points(text, {0, 10}); }), HasSubstr("not a number of points")) << text;
}

TEST(OverrideReason, MustBeOneLineAndNotBlank) {
    EXPECT_EQ(read_line("  right\nidea\t\x1b ", "--why"), "right idea \\x1b");
    for (const char* text : {"", " ", "\n\t "})
        EXPECT_THAT(refusal([&] { read_line(text, "--why"); }), HasSubstr("--why is empty")) << text;
    EXPECT_EQ(read_line(std::string(2000, 'x'), "--why").size(), 2000U);
    EXPECT_THAT(refusal([&] { read_line(std::string(2001, 'x'), "--why"); }), HasSubstr("2001 bytes"));
}

TEST(PointsAt, GivesThePointsOfThePlace) {
    const Graded one = graded("zoe", output_with_a_mistake());
    EXPECT_EQ(points_at(one.score, {6, "t", 0, "", "", ""})->automatic, 0);
    EXPECT_NEAR(points_at(one.score, {6, "t", 0, "", "", ""})->most, 10.0 / 6, 1e-9);
    EXPECT_NEAR(points_at(one.score, {6, "", 0, "", "", ""})->automatic, 50.0 / 6, 1e-9);
    EXPECT_EQ(points_at(one.score, {0, "", 0, "", "", ""})->most, 100);
    EXPECT_FALSE(points_at(one.score, {6, "normal", 0, "", "", ""}));
    EXPECT_FALSE(points_at(one.score, {11, "", 0, "", "", ""}));
}

TEST(Attach, GivesEachSubmissionItsOverridesAndReportsTheRest) {
    std::vector<Graded> all = {graded("ada", output_with_a_mistake()), graded("zoe", "")};
    const std::vector<KeptOverride> kept = {{"zoe", {6, "t", 1, "why", "me", ""}},
                                            {"gone", {6, "t", 1, "why", "me", ""}},
                                            {"ada", {0, "", 70, "why", "me", ""}},
                                            {"ada", {12, "", 7, "why", "me", ""}}};
    const auto unmatched = attach(kept, all);
    ASSERT_THAT(unmatched, SizeIs(2));
    EXPECT_EQ(unmatched[0].submission, "gone");
    EXPECT_EQ(unmatched[1].given.question, 12);
    ASSERT_THAT(all[1].review.overrides, SizeIs(1));
    EXPECT_EQ(all[1].review.overrides[0].item, "t");
    EXPECT_EQ(all[0].review.overrides.front().points, 70);
}

}  // namespace
}  // namespace harness
