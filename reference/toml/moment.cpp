#include "reference/toml/moment.h"

#include <re2/re2.h>

#include <chrono>
#include <ctime>

namespace reference {

std::optional<Moment> parse_moment(std::string_view text) {
    static const RE2 pattern(
        R"((\d{4})-(\d\d)-(\d\d)[ Tt]([01]\d|2[0-3]):([0-5]\d)(?::(?:[0-5]\d|60)(?:\.\d*)?)? ?(.*))");
    static const RE2 offset(R"(([+-])([01]\d|2[0-3]):?([0-5]\d))");
    int year = 0, hours = 0, minutes = 0;
    unsigned month = 0, day = 0;
    std::string zone;
    if (!RE2::FullMatch(re2::StringPiece(text.data(), text.size()), pattern, &year, &month, &day, &hours, &minutes,
                        &zone))
        return std::nullopt;
    const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(month), std::chrono::day(day)};
    if (!date.ok()) return std::nullopt;
    const std::int64_t days = std::chrono::sys_days(date).time_since_epoch().count();
    const Moment moment{(days * 24 + hours) * 60 + minutes, !zone.empty()};
    if (zone.empty() || zone == "Z" || zone == "z" || zone == "UTC") return moment;
    std::string sign;
    if (!RE2::FullMatch(zone, offset, &sign, &hours, &minutes)) return std::nullopt;
    const std::int64_t ahead = (sign == "+" ? 1 : -1) * (60 * hours + minutes);
    return Moment{moment.minutes - ahead, true, ahead};
}

bool is_over(const Moment& moment, std::chrono::system_clock::time_point clock) {
    std::int64_t seconds = std::chrono::floor<std::chrono::seconds>(clock).time_since_epoch().count();
    if (!moment.has_zone) {
        const std::time_t time = seconds;
        std::tm local{};
        localtime_r(&time, &local);
        seconds += local.tm_gmtoff;
    }
    return seconds >= (moment.minutes + 1) * 60;
}

}  // namespace reference
