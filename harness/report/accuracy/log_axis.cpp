#include "harness/report/accuracy/log_axis.h"

#include <algorithm>
#include <cmath>

#include "harness/report/accuracy/numbers.h"

namespace harness::report {

LogAxis::LogAxis(double least, double most, double from, double to, double band)
    : least_(least), most_(most), from_(from), to_(to), start_(from < to ? from + band : from - band), band_(band) {}

double LogAxis::place(double value) const {
    if (is_in_band(value)) return (from_ + start_) / 2;
    if (std::isnan(value)) return to_;
    const double share = std::log(std::clamp(value, least_, most_) / least_) / std::log(most_ / least_);
    return start_ + share * (to_ - start_);
}

std::vector<Tick> LogAxis::ticks() const {
    constexpr double room = 34;  // between two labels
    const double decade = std::abs(to_ - start_) / std::log10(most_ / least_);
    const int first = static_cast<int>(std::floor(std::log10(least_)));
    const int last = static_cast<int>(std::ceil(std::log10(most_)));
    const bool is_label_for_each_step = decade >= 4 * room;
    const int stride = std::max(1, static_cast<int>(std::ceil(room / decade)));
    constexpr double slack = 1e-9;  // of the logarithm's rounding
    std::vector<Tick> ticks;
    for (int exponent = first; exponent <= last; ++exponent) {
        for (const int step : {1, 2, 5}) {
            const double value = step * std::pow(10.0, exponent);
            if (value < least_ * (1 - slack) || value > most_ * (1 + slack)) continue;
            if (step > 1 && stride > 1) continue;
            Tick tick{place(value), ""};
            if (step == 1 && exponent % stride == 0) tick.label = power_text(exponent);
            if (is_label_for_each_step && exponent >= 0 && exponent <= 2)
                tick.label = three_digits(value).substr(0, three_digits(value).find('.'));
            ticks.push_back(tick);
        }
    }
    return ticks;
}

double decade_below(double value) {
    return std::pow(10.0, std::floor(std::log10(value) + 1e-9));
}

double decade_above(double value) {
    return std::pow(10.0, std::ceil(std::log10(value) - 1e-9));
}

}  // namespace harness::report
