#include "harness/report/class/charts.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/text/points.h"

namespace harness::report {
namespace {

constexpr double width = 440;
constexpr double height = 208;
constexpr double left = 14;
constexpr double right = width - 14;
constexpr double top = 22;
constexpr double ground = height - 40;
constexpr double gap = 3;

/// The picture's x of a number of points. The axis ends with the last bin.
double x_of(const ClassStatistics& statistics, double points) {
    const double most = statistics.bin_width * static_cast<double>(statistics.distribution.size());
    return left + (right - left) * points / most;
}

std::string bar(const ClassStatistics& statistics, std::size_t bin, std::size_t tallest) {
    const std::size_t count = statistics.distribution.at(bin);
    const double step = statistics.bin_width;
    const double from = step * static_cast<double>(bin);
    const double x = x_of(statistics, from), width_of_bin = x_of(statistics, from + step) - x;
    const double share = static_cast<double>(count) / static_cast<double>(tallest);
    const double bar_height = count == 0 ? 0 : std::max(2.0, share * (ground - top));
    const bool is_last = bin + 1 == statistics.distribution.size();
    std::string svg;
    if (count > 0) {
        svg = fmt::format(
            "<rect class=\"bin\" data-bin=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
            "rx=\"2\">",
            bin, x + gap / 2, ground - bar_height, width_of_bin - gap, bar_height);
        const std::string range = points_text(from) + (is_last ? " or more" : " to below " + points_text(from + step));
        svg += fmt::format("<title>{} {} {} points</title></rect>\n", count, count == 1 ? "has" : "have", range);
        svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x + width_of_bin / 2, ground - bar_height - 5,
                           count);
    }
    return svg +
           fmt::format("<text class=\"axis\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x, ground + 16, points_text(from));
}

std::string described(const ClassStatistics& statistics) {
    std::string text;
    const double step = statistics.bin_width;
    for (std::size_t bin = 0; bin < statistics.distribution.size(); ++bin) {
        if (statistics.distribution.at(bin) == 0) continue;
        text += fmt::format("{}{} from {}", text.empty() ? "" : ", ", statistics.distribution.at(bin),
                            points_text(step * static_cast<double>(bin)));
    }
    return text;
}

}  // namespace

std::string distribution_picture(const ClassStatistics& statistics) {
    if (statistics.distribution.empty()) return "<p class=\"facts\">Nobody has points.</p>\n";
    const std::size_t tallest =
        std::max<std::size_t>(1, *std::max_element(statistics.distribution.begin(), statistics.distribution.end()));
    std::string svg = fmt::format(
        "<svg class=\"histogram\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" "
        "aria-labelledby=\"points-t points-d\">\n<title id=\"points-t\">How many students have how many "
        "points</title>\n"
        "<desc id=\"points-d\">By steps of {}: {}.</desc>\n",
        width, height, points_text(statistics.bin_width), described(statistics));
    for (std::size_t bin = 0; bin < statistics.distribution.size(); ++bin) svg += bar(statistics, bin, tallest);
    svg += fmt::format("<path class=\"ground\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>\n", left, ground, right);
    svg += fmt::format("<text class=\"axis\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", right, ground + 16,
                       points_text(statistics.bin_width * static_cast<double>(statistics.distribution.size())));
    svg += fmt::format("<text class=\"axis\" x=\"{:.1f}\" y=\"{:.1f}\">points</text>\n", width / 2, ground + 33);
    return svg + "</svg>\n";
}

}  // namespace harness::report
