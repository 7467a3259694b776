// The geometry of a plot, read from the SVG and not from the code that drew it.
#include "harness/report/accuracy/plot.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <regex>
#include <set>

#include "harness/text/markup.h"
#include "tests/given/sample_measurement.h"

namespace {

using namespace harness::report;
using testing::HasSubstr;

struct Rectangle {
    double left, top, right, bottom;
    bool touches(const Rectangle& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

std::vector<std::smatch> all(const std::string& text, const std::string& pattern) {
    static std::map<std::string, std::regex> patterns;
    return {std::sregex_iterator(text.begin(), text.end(), patterns.try_emplace(pattern, pattern).first->second), {}};
}

/// The labels beside the points.
std::map<std::string, Rectangle> labels_in(const std::string& svg) {
    std::map<std::string, Rectangle> labels;
    for (const auto& match : all(svg, "<text x=\"([0-9.]+)\" y=\"([0-9.]+)\"[^>]*class=\"number\">([^<]*)<")) {
        const double x = std::stod(match[1]);
        const double y = std::stod(match[2]);
        labels[match[3]] = {x, y - 9, x + harness::text_width(std::string(match[3]), 12), y};
    }
    return labels;
}

/// The numbers and names of the legend.
std::map<int, std::string> legend_in(const std::string& svg) {
    std::map<int, std::string> legend;
    for (const auto& match : all(svg, "class=\"name\"[^>]*>([0-9]+) ([^<]*)<")) legend[std::stoi(match[1])] = match[2];
    return legend;
}

struct Mark {
    std::string name;
    std::string shape;
    double x, y;
};

/// In drawing order.
std::vector<Mark> marks_in(const std::string& svg) {
    std::vector<Mark> marks;
    for (const auto& match :
         all(svg,
             "<g class=\"point\".*?<title>([^<]*?): .*?</title><([a-z]+) [^0-9-]*(-?[0-9.]+)[^0-9-]+(-?[0-9.]+)")) {
        const std::string shape = match[2];
        const double to_center = shape == "rect" ? 4.2 : 0;
        marks.push_back({match[1], shape, std::stod(match[3]) + to_center, std::stod(match[4]) + to_center});
    }
    return marks;
}

/// Every point is numbered once, and no label covers another or a mark.
void expect_readable(const std::string& svg, std::size_t points) {
    const auto marks = marks_in(svg);
    const auto labels = labels_in(svg);
    const auto legend = legend_in(svg);
    EXPECT_EQ(marks.size(), points);
    EXPECT_EQ(legend.size(), points);
    std::multiset<int> numbered;
    for (const auto& [label, box] : labels) {
        for (const auto& number : all(label, "[0-9]+")) numbered.insert(std::stoi(number[0]));
        for (const auto& [other, other_box] : labels)
            EXPECT_TRUE(label == other || !box.touches(other_box)) << label << " over " << other;
        for (const Mark& mark : marks)
            EXPECT_FALSE(box.touches({mark.x - 4, mark.y - 4, mark.x + 4, mark.y + 4})) << label << " hides a mark";
        EXPECT_LT(box.right, 480 - 14) << label;
    }
    std::multiset<int> expected;
    for (const auto& [number, name] : legend) expected.insert(number);
    EXPECT_EQ(numbered, expected);
}

std::string wrong_plot(const reference::accuracy::Measurement& measured) {
    return plot(summarize(measured).front());
}

TEST(Plots, NumberEveryPointWithoutCoveringAnother) {
    for (const PrimitiveSummary& summary : summarize(samples::ladder())) {
        SCOPED_TRACE(name_of(summary.primitive));
        expect_readable(plot(summary), summary.methods.size());
    }
}

TEST(Plots, GivePointsAtOnePlaceOneLabel) {
    auto measured = samples::two_methods();
    measured.rows.assign(4, measured.rows[1]);
    for (std::size_t i = 0; i < 4; ++i) measured.rows[i].kernel += std::to_string(i);
    const std::string svg = wrong_plot(measured);
    expect_readable(svg, 4);
    EXPECT_TRUE(labels_in(svg).contains("1, 2, 3, 4"));
}

TEST(Plots, ShowMethodsWithoutErrorsInTheBandAndOthersAboveIt) {
    const std::string svg = wrong_plot(samples::two_methods());
    const auto band = all(svg, "y=\"([0-9.]+)\" width=\"[0-9.]+\" height=\"([0-9.]+)\" class=\"band\"");
    const double top = std::stod(band.at(0)[1]);
    const auto marks = marks_in(svg);
    ASSERT_EQ(marks.size(), 2U);
    EXPECT_GT(marks[0].y, top);
    EXPECT_LT(marks[0].y, top + std::stod(band.at(0)[2]));
    EXPECT_LT(marks[1].y, top);
    EXPECT_GT(marks[0].x, marks[1].x) << "10.5 ns is to the right of 8 ns";
}

TEST(Plots, DrawTheFrontierAsStepsThroughItsPoints) {
    const std::string svg = wrong_plot(samples::two_methods());
    const auto marks = marks_in(svg);
    EXPECT_THAT(svg, HasSubstr(fmt::format("L{0:.1f} {1:.1f} L{2:.1f} {1:.1f} L{2:.1f} {3:.1f}\"", marks[1].x,
                                           marks[1].y, marks[0].x, marks[0].y)));
}

TEST(Plots, HaveTextAlternatives) {
    const std::string svg = wrong_plot(samples::two_methods());
    EXPECT_THAT(svg, HasSubstr("role=\"img\" aria-labelledby=\"wrong-sphere-t wrong-sphere-d\""));
    EXPECT_THAT(svg, HasSubstr("<title id=\"wrong-sphere-t\">Ray and sphere</title>"));
    EXPECT_THAT(svg,
                testing::ContainsRegex("<desc id=\"wrong-sphere-d\">.*certified double: 10.5 ns, 0 wrong per million"));
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
    EXPECT_THAT(svg, testing::Not(testing::ContainsRegex("\"-?(nan|inf)")));
}

}  // namespace
