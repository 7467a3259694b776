#include "reference/toml/moment.h"

#include <chrono>
#include <ctime>

namespace reference {
namespace {

/// Reads a text from its left to its right.
class Scanner {
  public:
    explicit Scanner(std::string_view text) : rest_(text) {}

    /// The number of exactly so many digits.
    std::optional<int> number(std::size_t digits) {
        if (rest_.size() < digits) return std::nullopt;
        int value = 0;
        for (const char c : rest_.substr(0, digits)) {
            if (c < '0' || c > '9') return std::nullopt;
            value = 10 * value + (c - '0');
        }
        rest_.remove_prefix(digits);
        return value;
    }
    /// The next character if it is one of these.
    std::optional<char> any_of(std::string_view characters) {
        if (rest_.empty() || characters.find(rest_.front()) == std::string_view::npos) return std::nullopt;
        const char found = rest_.front();
        rest_.remove_prefix(1);
        return found;
    }
    bool is_at_end() const { return rest_.empty(); }

  private:
    std::string_view rest_;
};

std::optional<std::int64_t> minutes_of_day(Scanner& scanner) {
    const auto hours = scanner.number(2);
    if (!hours || !scanner.any_of(":")) return std::nullopt;
    const auto minutes = scanner.number(2);
    if (!minutes || *hours > 23 || *minutes > 59) return std::nullopt;
    return 60 * *hours + *minutes;
}

std::optional<std::int64_t> days_since_1970(Scanner& scanner) {
    const auto year = scanner.number(4);
    if (!year || !scanner.any_of("-")) return std::nullopt;
    const auto month = scanner.number(2);
    if (!month || !scanner.any_of("-")) return std::nullopt;
    const auto day = scanner.number(2);
    if (!day) return std::nullopt;
    const std::chrono::year_month_day date(std::chrono::year(*year), std::chrono::month(static_cast<unsigned>(*month)),
                                           std::chrono::day(static_cast<unsigned>(*day)));
    if (!date.ok()) return std::nullopt;
    return std::chrono::sys_days(date).time_since_epoch().count();
}

}  // namespace

std::optional<Moment> parse_moment(std::string_view text) {
    Scanner scanner(text);
    const auto days = days_since_1970(scanner);
    if (!days || !scanner.any_of(" Tt")) return std::nullopt;
    const auto time = minutes_of_day(scanner);
    if (!time) return std::nullopt;
    if (scanner.any_of(":")) {
        const auto seconds = scanner.number(2);
        if (!seconds || *seconds > 60) return std::nullopt;
        if (scanner.any_of(".")) {
            while (scanner.number(1)) continue;
        }
    }
    Moment moment{*days * 24 * 60 + *time, false};
    if (const auto zone = scanner.any_of("Zz+-")) {
        moment.has_zone = true;
        if (*zone == '+' || *zone == '-') {
            const auto offset = minutes_of_day(scanner);
            if (!offset) return std::nullopt;
            moment.minutes += *zone == '+' ? -*offset : *offset;
        }
    }
    return scanner.is_at_end() ? std::optional(moment) : std::nullopt;
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
