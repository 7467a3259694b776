#include "reference/toml/moment.h"

#include <gtest/gtest.h>

#include <chrono>
#include <ctime>

namespace reference {
namespace {

TEST(Moment, IsReadInMinutes) {
    EXPECT_EQ(parse_moment("1970-01-01 00:00").value().minutes, 0);
    EXPECT_EQ(parse_moment("1970-01-02T01:01:59").value().minutes, 24 * 60 + 61);
    EXPECT_EQ(parse_moment("2024-03-01 00:00").value().minutes - parse_moment("2024-02-28 00:00").value().minutes,
              2 * 24 * 60)
        << "a leap year";
    EXPECT_FALSE(parse_moment("1970-01-01 00:00").value().has_zone);
}

TEST(Moment, WithATimeZoneIsInUtc) {
    EXPECT_TRUE(parse_moment("1970-01-01T00:00Z").value().has_zone);
    EXPECT_EQ(parse_moment("1970-01-01T01:30+01:30").value().minutes, 0);
    EXPECT_EQ(parse_moment("1969-12-31T19:00:00.5-05:00").value().minutes, 0);
    EXPECT_EQ(parse_moment("1969-12-31 19:00:00 -0500").value().minutes, 0);
    EXPECT_EQ(parse_moment("1970-01-01 00:00:00 UTC").value().minutes, 0);
}

TEST(Moment, RefusesOtherTexts) {
    for (const char* text :
         {"", "2026-11-05", "23:59", "2026-02-30 10:00", "2026-13-01 10:00", "2026-11-05 24:00", "2026-11-05 23:60",
          "2026-11-05 23:59+1", "5.11.2026 23:59", "2026-11-05 23:59:61", "2026-11-05  3:59", "2026-11-05 23:59Zulu"}) {
        EXPECT_FALSE(parse_moment(text)) << text;
    }
}

TEST(Moment, IsOverWhenItsMinuteHasPassed) {
    using namespace std::chrono_literals;
    const std::chrono::system_clock::time_point begin{};
    const Moment hour = parse_moment("1970-01-01 01:00Z").value();
    EXPECT_FALSE(is_over(hour, begin + 1h + 59s));
    EXPECT_TRUE(is_over(hour, begin + 1h + 1min));
    EXPECT_TRUE(is_over(parse_moment("1970-01-01 02:00+01:00").value(), begin + 1h + 1min));
    const auto by_clock_of_this_machine = [&] {
        const std::time_t time = 100 * 24 * 3600;
        std::tm local{};
        localtime_r(&time, &local);
        return begin + 100 * 24h - std::chrono::seconds(local.tm_gmtoff);
    }();
    const Moment day = parse_moment("1970-04-11 00:00").value();
    EXPECT_FALSE(is_over(day, by_clock_of_this_machine + 59s));
    EXPECT_TRUE(is_over(day, by_clock_of_this_machine + 1min));
}

}  // namespace
}  // namespace reference
