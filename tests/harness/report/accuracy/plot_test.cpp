// The geometry of the plots, read from the SVG and not from the code that drew it.
#include "harness/report/accuracy/plot.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <regex>

#include "harness/text/markup.h"
#include "tests/given/sample_measurement.h"

namespace {

using namespace harness::report;
using testing::ContainsRegex;
using testing::HasSubstr;

std::vector<std::smatch> all(const std::string& text, const std::string& pattern) {
    static std::map<std::string, std::regex> patterns;
    return {std::sregex_iterator(text.begin(), text.end(), patterns.try_emplace(pattern, pattern).first->second), {}};
}

struct Mark {
    std::string name;
    std::string shape;
    double x, y;              ///< of the mark's center
    double label_x, label_y;  ///< where the label begins
    std::string label;
};

/// In drawing order.
std::vector<Mark> marks_in(const std::string& svg) {
    std::vector<Mark> marks;
    for (const auto& match :
         all(svg,
             "<g class=\"point\".*?<title>([^<]*?): .*?</title><([a-z]+) [^0-9-]*(-?[0-9.]+)[^0-9-]+"
             "(-?[0-9.]+)[^>]*>\\s*<text x=\"([0-9.]+)\" y=\"([0-9.]+)\"[^>]*class=\"name\"[^>]*>([^<]*)<")) {
        const std::string shape = match[2];
        const double to_center = shape == "rect" ? 4.2 : 0;
        marks.push_back({match[1], shape, std::stod(match[3]) + to_center, std::stod(match[4]) + to_center,
                         std::stod(match[5]), std::stod(match[6]), match[7]});
    }
    return marks;
}

/// Every point has its name beside the plot, and no name covers another or leaves the picture.
void expect_readable(const std::string& svg, std::size_t points) {
    const auto marks = marks_in(svg);
    EXPECT_EQ(marks.size(), points);
    for (std::size_t i = 0; i < marks.size(); ++i) {
        EXPECT_EQ(marks[i].name, marks[i].label);
        EXPECT_GT(marks[i].label_x, marks[i].x + 5);
        EXPECT_LT(marks[i].label_x + harness::text_width(marks[i].label, 12), 600) << marks[i].label;
        EXPECT_GT(marks[i].label_y, 30);
        EXPECT_LT(marks[i].label_y, 420);
        if (i > 0) {
            EXPECT_GE(marks[i].label_y, marks[i - 1].label_y + 12);
        }
    }
}

std::string plot(const PrimitiveSummary& summary) {
    return plots({summary});
}

std::string wrong_plot(const reference::accuracy::Measurement& measured) {
    return plot(summarize(measured).front());
}

TEST(Plots, NameEveryPointWithoutCoveringAnother) {
    for (const PrimitiveSummary& summary : summarize(samples::ladder())) {
        SCOPED_TRACE(name_of(summary.primitive));
        expect_readable(plot(summary), summary.methods.size());
    }
    auto measured = samples::two_methods();
    measured.rows.assign(14, measured.rows[1]);
    for (std::size_t i = 0; i < 14; ++i) measured.rows[i].kernel += std::to_string(i);
    expect_readable(wrong_plot(measured), 14);
}

TEST(Plots, ShowMethodsWithoutErrorsInTheBandAndOthersAboveIt) {
    const std::string svg = wrong_plot(samples::two_methods());
    const auto band = all(svg, "y=\"([0-9.]+)\" width=\"[0-9.]+\" height=\"([0-9.]+)\" class=\"band\"");
    const double top = std::stod(band.at(0)[1]);
    const auto marks = marks_in(svg);
    ASSERT_EQ(marks.size(), 2U);
    EXPECT_LT(marks[0].y, top);
    EXPECT_GT(marks[1].y, top);
    EXPECT_LT(marks[1].y, top + std::stod(band.at(0)[2]));
    EXPECT_GT(marks[1].x, marks[0].x) << "10.5 ns is to the right of 8 ns";
}

TEST(Plots, DrawTheFrontierAsStepsThroughItsPoints) {
    const std::string svg = wrong_plot(samples::two_methods());
    const auto marks = marks_in(svg);
    EXPECT_THAT(svg, HasSubstr(fmt::format("L{0:.1f} {1:.1f} L{2:.1f} {1:.1f} L{2:.1f} {3:.1f}\"", marks[0].x,
                                           marks[0].y, marks[1].x, marks[1].y)));
}

TEST(Plots, HaveTextAlternatives) {
    const std::string svg = wrong_plot(samples::two_methods());
    EXPECT_THAT(svg, HasSubstr("role=\"img\" aria-labelledby=\"plots-t\""));
    EXPECT_THAT(svg, ContainsRegex("<title>certified double: 10.5 ns \\(10.2 to 11.0\\), 0 wrong per million"));
}

TEST(Plots, DistinguishScalarsByShape) {
    for (const Mark& mark : marks_in(wrong_plot(samples::ladder())))
        EXPECT_EQ(mark.shape, mark.name.ends_with("float") ? "circle" : "rect") << mark.name;
}

TEST(Plots, HandleAMethodThatWasNotTimed) {
    auto measured = samples::two_methods();
    measured.rows[0].ns_per_ray = 0;
    const std::string svg = wrong_plot(measured);
    expect_readable(svg, 2);
    EXPECT_THAT(svg, testing::Not(ContainsRegex("\"-?(nan|inf)")));
}

}  // namespace
