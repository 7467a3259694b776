#include "harness/report/exchange/late_days.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>

#include "tests/harness/report/exchange/refusal.h"

namespace harness::report {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;
using testing::UnorderedElementsAre;

std::string refusal_of_days(std::string_view csv, const std::optional<reference::Moment>& due = {}) {
    return refusal([&] { read_late_days(csv, due); });
}

TEST(LateDays, AreReadWithExtensions) {
    EXPECT_THAT(read_late_days("id,days_late,extension_days\nada,2,\nben,3,2\n\ncy,0.5,1\n", {}),
                UnorderedElementsAre(Pair("ada", 2), Pair("ben", 1), Pair("cy", -0.5)));
    EXPECT_THAT(read_late_days("days_late,id\n1,ada\n", {}), UnorderedElementsAre(Pair("ada", 1)));
    EXPECT_THAT(read_late_days("\xef\xbb\xbfid;days_late\r\nada;0,5\r\n", {}), UnorderedElementsAre(Pair("ada", 0.5)));
}

TEST(LateDays, CountFromTheMomentTheAssignmentIsDue) {
    const auto due = reference::parse_moment("2026-02-28 23:59");
    EXPECT_THAT(read_late_days("id,handed_in\nada,2026-03-01 23:59\nben,2026-02-28T11:59:30\n", due),
                UnorderedElementsAre(Pair("ada", 1), Pair("ben", -0.5)));
    EXPECT_THAT(read_late_days("id,handed_in,extension_days\nada,2026-03-01 11:59,1\n", due),
                UnorderedElementsAre(Pair("ada", -0.5)));
    EXPECT_THAT(read_late_days("id,handed_in\nada,2026-03-01T00:59+01:00\nben,2026-03-01T11:59:00.123Z\n",
                               reference::parse_moment("2026-02-28T23:59Z")),
                UnorderedElementsAre(Pair("ada", 0), Pair("ben", 0.5)));
}

/// Sets the zone of this machine's clock; null for the machine's own.
void set_zone(const char* zone) {
    if (zone == nullptr) {
        unsetenv("TZ");
    } else {
        setenv("TZ", zone, 1);
    }
    tzset();
}

TEST(LateDays, AreCountedOnTheClockOfTheDueDateAcrossAClockChange) {
    const auto late = [](const char* due, const std::string& handed_in) {
        return read_late_days("id,handed_in\nada," + handed_in + "\n", reference::parse_moment(due)).at("ada");
    };
    set_zone("UTC");
    EXPECT_EQ(late("2026-10-31T20:00-04:00", "2026-11-01T20:00-05:00"), 1) << "25 hours";
    EXPECT_EQ(late("2026-03-07T20:00-05:00", "2026-03-08T20:00-04:00"), 1) << "23 hours";
    EXPECT_EQ(late("2026-10-31T20:00-04:00", "2026-11-02T00:00Z"), 1) << "a zone that says nothing of the clock";
    set_zone("America/New_York");
    EXPECT_EQ(late("2026-10-31T20:00-04:00", "2026-11-02T01:00Z"), 1) << "this machine's clock is the one";
    set_zone(nullptr);
}

TEST(LateDays, RefuseAMomentIfThereIsNoDueDate) {
    const auto due = reference::parse_moment("2026-02-28 23:59");
    EXPECT_THAT(refusal_of_days("id,handed_in\nada,2026-03-01 23:59\n"), HasSubstr("add due to its [rubric]"));
    EXPECT_THAT(refusal_of_days("id,handed_in\nada,yesterday\n", due),
                HasSubstr("line 2: handed_in is not a date with a time"));
    EXPECT_THAT(refusal_of_days("id,handed_in\nada,2026-03-01 23:59Z\n", due),
                HasSubstr("line 2: handed_in has a time zone, but due in [rubric] does not"));
    EXPECT_THAT(refusal_of_days("id,handed_in,days_late\nada,2026-03-01 23:59,1\n", due),
                HasSubstr("keep one of them"));
}

TEST(LateDays, RefuseInvalidCells) {
    EXPECT_THAT(refusal_of_days(""), HasSubstr("needs the columns id and days_late"));
    EXPECT_THAT(refusal_of_days("id,days\nada,2\n"), HasSubstr("needs the columns id and days_late"));
    EXPECT_THAT(refusal_of_days("id,days_late\nada,two\n"), HasSubstr("line 2: days_late is not a number"));
    EXPECT_THAT(refusal_of_days("id,days_late\n,2\n"), HasSubstr("line 2: the column \"id\" is empty"));
    EXPECT_THAT(refusal_of_days("id,days_late\nada,1\nada,2\n"), HasSubstr("line 3: ada appears twice"));
}

/// The schedule of 2024, with ten minutes of grace.
reference::Rubric schedule() {
    reference::Rubric rubric;
    rubric.late = {{1, 0.05}, {2, 1.0}};
    rubric.grace_minutes = 10;
    return rubric;
}

Graded handed_in_at(const char* when) {
    Graded one;
    one.submission.id = when;
    one.submission.lms = LmsName{};
    one.submission.lms->handed_in = when;
    return one;
}

TEST(LateSchedule, UsesTheTimeOfTheLms) {
    set_zone("UTC");
    std::vector<Graded> all{handed_in_at("2026-11-06 00:10:00.123456000 Z"), handed_in_at("2026-11-05 23:59"),
                            handed_in_at("2026-11-07 18:00:00 -07:00"), handed_in_at(""), handed_in_at("soon")};
    reference::Rubric rubric = schedule();
    apply_late_schedule(all, rubric, {});
    EXPECT_EQ(all[0].late_share, 0) << "the rubric says nothing of when it was due";
    rubric.due = reference::parse_moment("2026-11-05 23:59");
    apply_late_schedule(all, rubric, {{"2026-11-05 23:59", 1.0}});
    EXPECT_EQ(all[0].late_share, 0.05);
    EXPECT_EQ(all[1].late_share, 0.05) << "the instructor's list goes before it";
    EXPECT_EQ(all[2].late_share, 1);
    EXPECT_EQ(all[3].late_share, 0);
    EXPECT_EQ(all[4].late_share, 0);
    set_zone(nullptr);
}

TEST(LateShare, CountsStartedDaysAfterTheGrace) {
    constexpr double minute = 1.0 / (24 * 60);
    EXPECT_EQ(late_share(schedule(), -1), 0);
    EXPECT_EQ(late_share(schedule(), 9 * minute), 0);
    EXPECT_EQ(late_share(schedule(), 11 * minute), 0.05);
    EXPECT_EQ(late_share(schedule(), 1), 0.05);
    EXPECT_EQ(late_share(schedule(), 1.5), 1);
    EXPECT_EQ(late_share(schedule(), 30), 1);
    EXPECT_EQ(late_share(reference::Rubric(), 30), 0);
}

TEST(LateShare, IsZeroAtTheLastMinuteOfAnyExtension) {
    reference::Rubric rubric;
    rubric.late = {{1, 0.05}, {2, 1.0}};
    const auto due = reference::parse_moment("2026-11-05 23:59");
    const auto share = [&](int minutes_after, int days) {
        const int since = 24 * 60 - 1 + minutes_after;
        const std::string row = fmt::format("id,handed_in,extension_days\nada,2026-11-{:02} {:02}:{:02},{}\n",
                                            5 + days + since / (24 * 60), since / 60 % 24, since % 60, days);
        return late_share(rubric, read_late_days(row, due).at("ada"));
    };
    for (int days = 0; days <= 10; ++days) {
        for (int grace = 0; grace <= 60; ++grace) {
            rubric.grace_minutes = grace;
            EXPECT_EQ(share(grace, days), 0) << grace << " minutes of grace, " << days << " days of extension";
            EXPECT_EQ(share(grace + 1, days), 0.05) << grace << " minutes of grace, " << days << " days of extension";
        }
    }
}

TEST(LateShare, RoundsDecimalsToTheNearestSecond) {
    reference::Rubric rubric;
    rubric.late = {{1, 0.05}, {2, 1.0}};
    const auto share = [&](std::string_view late, std::string_view extension) {
        const std::string row = fmt::format("id,days_late,extension_days\nada,{},{}\n", late, extension);
        return late_share(rubric, read_late_days(row, {}).at("ada"));
    };
    EXPECT_EQ(share("2.2", "2.2"), 0);
    EXPECT_EQ(share("2.2", "1.2"), 0.05);
    EXPECT_EQ(share("1.0001", "0"), 1);
    rubric.grace_minutes = 5;
    EXPECT_EQ(share("1.0034723", "0"), 0.05) << "five minutes as a spreadsheet has them";
}

/// Two submissions from Canvas, the second late.
std::vector<Graded> class_of_two() {
    std::vector<Graded> all(2);
    all[0].submission.id = "ada";
    all[1].submission.id = "ben";
    for (Graded& one : all) one.submission.lms = LmsName{};
    all[1].submission.lms->late = true;
    return all;
}

TEST(LateSchedule, NeedsNoDateIfItHasOneStep) {
    std::vector<Graded> all = class_of_two();
    reference::Rubric rubric;
    rubric.late = {{1, 0.25}};
    apply_late_schedule(all, rubric, {});
    EXPECT_EQ(all[0].late_share, 0);
    EXPECT_EQ(all[1].late_share, 0.25);
    EXPECT_THAT(all[1].findings.flags, IsEmpty());
}

TEST(LateSchedule, FlagsALateSubmissionWithoutADateIfItHasSeveralSteps) {
    std::vector<Graded> all = class_of_two();
    apply_late_schedule(all, schedule(), {});
    EXPECT_EQ(all[1].late_share, 0);
    ASSERT_EQ(all[1].findings.flags.size(), 1U);
    EXPECT_EQ(all[1].findings.flags.front().kind, "late_without_date");
    EXPECT_THAT(all[1].findings.flags.front().evidence, HasSubstr("nothing has been taken off yet"));
    EXPECT_THAT(all[0].findings.flags, IsEmpty());
}

TEST(LateSchedule, UsesTheDaysThatTheInstructorGives) {
    std::vector<Graded> all = class_of_two();
    apply_late_schedule(all, schedule(), {{"ada", 3}, {"ben", 0}});
    EXPECT_EQ(all[0].late_share, 1) << "although Canvas does not call it late";
    EXPECT_EQ(all[1].late_share, 0);
    EXPECT_THAT(all[1].findings.flags, IsEmpty());
}

TEST(LateSchedule, MatchesByTheNumberOfTheLmsFirst) {
    std::vector<Graded> all = class_of_two();
    all[0].submission.id = "4711";  // as a student may call herself
    all[1].submission.lms->id = "4711";
    apply_late_schedule(all, schedule(), {{"4711", 1}});
    EXPECT_EQ(all[0].late_share, 0);
    EXPECT_EQ(all[1].late_share, 0.05);
    EXPECT_EQ(id_in(LateDays{{"4711", 1}}, all[1].submission), "4711");
    EXPECT_EQ(id_in(LateDays{{"ben", 1}}, all[1].submission), "ben");
}

}  // namespace
}  // namespace harness::report
