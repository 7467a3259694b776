// Checks the geometry of a picture, read from the SVG and not from the code that drew it.
#include "harness/report/accuracy/panels.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <regex>

#include "harness/report/accuracy/report.h"
#include "harness/report/plot/scatter_drawing.h"
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

struct Named {
    std::string name;
    Rectangle box;
};

std::vector<std::smatch> all(const std::string& text, const std::regex& pattern) {
    return {std::sregex_iterator(text.begin(), text.end(), pattern), {}};
}

/// A line of text of size 13 reaches from 10 above its baseline to 3 below it.
std::vector<Named> names_in(const std::string& svg) {
    static const std::regex pattern(
        "<text class=\"name\" x=\"([0-9.]+)\" y=\"([0-9.]+)\" textLength=\"([0-9.]+)\"[^>]*>([^<]*)</text>");
    std::vector<Named> names;
    for (const std::smatch& match : all(svg, pattern)) {
        const double x = std::stod(match[1]);
        const double y = std::stod(match[2]);
        names.push_back({match[4], {x, y - 10, x + std::stod(match[3]), y + 3}});
    }
    return names;
}

/// The centres of the marks, in drawing order.
std::vector<std::pair<double, double>> marks_in(const std::string& svg) {
    static const std::regex group("<g class=\"point\".*?</title><([a-z]+) (.*?)/></g>");
    static const std::regex number("(-?[0-9.]+)");
    std::vector<std::pair<double, double>> marks;
    for (const std::smatch& match : all(svg, group)) {
        const std::string values = match[2];
        const auto numbers = all(values, number);
        const double x = std::stod(numbers.at(0)[1]);
        const double y = std::stod(numbers.at(1)[1]);
        const std::string shape = match[1];
        if (shape == "circle") marks.emplace_back(x, y);
        if (shape == "rect") marks.emplace_back(x + 4.2, y + 4.2);
        if (shape == "path") marks.emplace_back(x, y + 5.8);
    }
    return marks;
}

Rectangle band_in(const std::string& svg) {
    static const std::regex pattern(
        "class=\"band\"|<rect x=\"([0-9.]+)\" y=\"([0-9.]+)\" width=\"([0-9.]+)\" height=\"([0-9.]+)\" class=\"band\"");
    for (const std::smatch& match : all(svg, pattern)) {
        if (!match[1].matched) continue;
        const double x = std::stod(match[1]);
        const double y = std::stod(match[2]);
        return {x, y, x + std::stod(match[3]), y + std::stod(match[4])};
    }
    ADD_FAILURE() << "no band";
    return {};
}

void expect_readable(const std::string& svg, std::size_t points) {
    const std::vector<Named> names = names_in(svg);
    const auto marks = marks_in(svg);
    EXPECT_EQ(names.size(), points);
    EXPECT_EQ(marks.size(), points);
    for (std::size_t i = 0; i < names.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_FALSE(names[i].box.touches(names[j].box)) << names[i].name << " over " << names[j].name;
        for (const auto& [x, y] : marks)
            EXPECT_FALSE(names[i].box.touches({x - 4, y - 4, x + 4, y + 4})) << names[i].name << " hides a mark";
    }
}

TEST(Pictures, KeepTheNamesOfAllMethodsApart) {
    const auto measured = samples::ladder();
    for (const Panel& panel : panels_of(measured)) {
        SCOPED_TRACE(panel.distribution);
        const Scatter wrong = wrong_scatter(panel, "w");
        expect_readable(draw(wrong).svg, panel.rows.size());
        const Scatter errors = error_scatter(panel, "e");
        expect_readable(draw(errors).svg, errors.points.size());
    }
    for (const PrimitiveSummary& summary : summarise(measured))
        expect_readable(draw(summary_scatter(summary)).svg, summary.methods.size());
}

// Thirty methods with the same time and the same rate: the picture grows until their names have room.
TEST(Pictures, KeepNamesApartIfAllPointsCoincide) {
    auto measured = samples::two_methods();
    const auto row = measured.rows[1];
    measured.rows.clear();
    for (int i = 0; i < 30; ++i) {
        measured.rows.push_back(row);
        measured.rows.back().kernel = "a method with a rather long name, number " + std::to_string(i);
    }
    expect_readable(draw(wrong_scatter(panels_of(measured).front(), "w")).svg, 30);
}

TEST(Pictures, NameEveryPointByItsMethod) {
    const auto measured = samples::ladder();
    const Panel panel = panels_of(measured).front();
    const std::vector<Named> names = names_in(draw(wrong_scatter(panel, "w")).svg);
    ASSERT_EQ(names.size(), panel.rows.size());
    std::map<std::string, int> count;
    for (const Named& one : names) ++count[one.name];
    for (const char* name : {"half-b float", "half-b double", "naive quad", "naive 100 digits", "double-double",
                             "float interval", "certified, with t double"})
        EXPECT_EQ(count[name], 1) << name;
}

TEST(Pictures, PutANameNearItsPointOrLinkItByALine) {
    const auto measured = samples::ladder();
    const std::string svg = draw(wrong_scatter(panels_of(measured)[1], "w")).svg;
    const auto names = names_in(svg);
    const auto marks = marks_in(svg);
    static const std::regex leader(
        "<line x1=\"([0-9.]+)\" y1=\"([0-9.]+)\" x2=\"([0-9.]+)\" y2=\"([0-9.]+)\" class=\"leader\"");
    const auto leaders = all(svg, leader);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const Rectangle& box = names[i].box;
        const auto [x, y] = marks[i];
        const double dx = std::max({box.left - x, x - box.right, 0.0});
        const double dy = std::max({box.top - y, y - box.bottom, 0.0});
        bool is_linked = dx * dx + dy * dy < 12 * 12;
        for (const std::smatch& line : leaders) {
            const double to_x = std::stod(line[3]);
            const double to_y = std::stod(line[4]);
            const bool starts = std::abs(std::stod(line[1]) - x) < 0.2 && std::abs(std::stod(line[2]) - y) < 0.2;
            const bool ends =
                to_x > box.left - 1 && to_x < box.right + 1 && to_y > box.top - 3 && to_y < box.bottom + 3;
            is_linked = is_linked || (starts && ends);
        }
        EXPECT_TRUE(is_linked) << names[i].name;
    }
}

TEST(Pictures, ShowMethodsWithoutErrorsInTheBandAndOthersAboveIt) {
    const auto measured = samples::two_methods();
    const std::string svg = draw(wrong_scatter(panels_of(measured).front(), "w")).svg;
    const Rectangle band = band_in(svg);
    const auto marks = marks_in(svg);
    ASSERT_EQ(marks.size(), 2U);
    EXPECT_GT(marks[0].second, band.top);
    EXPECT_LT(marks[0].second, band.bottom);
    EXPECT_LT(marks[1].second, band.top);
    EXPECT_GT(marks[0].first, marks[1].first) << "10.5 ns is to the right of 8 ns";
    EXPECT_THAT(svg, HasSubstr(">none</text>"));
    EXPECT_THAT(svg, HasSubstr(">wrong</text>"));
}

TEST(Pictures, DrawTheIntervalOfZeroErrorsUpwardsFromTheBand) {
    const auto measured = samples::two_methods();
    const std::string svg = draw(wrong_scatter(panels_of(measured).front(), "w")).svg;
    const double x = marks_in(svg).front().first;
    static const std::regex bar(
        "<line x1=\"([0-9.]+)\" y1=\"([0-9.]+)\" x2=\"([0-9.]+)\" y2=\"([0-9.]+)\" class=\"interval\"");
    bool found = false;
    for (const std::smatch& line : all(svg, bar)) {
        if (std::abs(std::stod(line[1]) - x) > 0.2 || std::abs(std::stod(line[3]) - x) > 0.2) continue;
        found = true;
        EXPECT_NEAR(std::stod(line[2]), band_in(svg).top, 0.2);
        EXPECT_LT(std::stod(line[4]), band_in(svg).top);
    }
    EXPECT_TRUE(found);
}

TEST(Pictures, DrawTheFrontierAsStepsThroughItsPoints) {
    const auto measured = samples::two_methods();
    const std::string svg = draw(wrong_scatter(panels_of(measured).front(), "w")).svg;
    const auto marks = marks_in(svg);
    const auto at = [](const std::pair<double, double>& mark) {
        return fmt::format("{:.1f} {:.1f}", mark.first, mark.second);
    };
    const std::pair<double, double> corner{marks[0].first, marks[1].second};
    EXPECT_THAT(svg, HasSubstr(fmt::format("L{} L{} L{}\"", at(marks[1]), at(corner), at(marks[0]))));
}

TEST(Pictures, HaveTextAlternatives) {
    const auto measured = samples::two_methods();
    const std::string svg = draw(wrong_scatter(panels_of(measured).front(), "p1")).svg;
    EXPECT_THAT(svg, HasSubstr("role=\"img\" aria-labelledby=\"p1-t p1-d\""));
    EXPECT_THAT(svg, HasSubstr("<title id=\"p1-t\">Ray and sphere, grazing: decisions</title>"));
    EXPECT_THAT(svg,
                HasSubstr("<desc id=\"p1-d\">2 methods by time and wrong decisions. On the frontier: certified double: "
                          "10.5 ns, 0 wrong per million (95 % interval 0 to 3,830); naive float: 8.00 ns, 12,000"));
    EXPECT_THAT(svg, HasSubstr("time for one ray, ns (logarithmic)"));
}

TEST(Pictures, DistinguishScalarsByShape) {
    const auto measured = samples::ladder();
    const std::string svg = draw(wrong_scatter(panels_of(measured).front(), "w")).svg;
    static const std::regex group("<g class=\"point\".*?<title>([^<]*?): .*?</title><([a-z]+)");
    for (const std::smatch& match : all(svg, group)) {
        const std::string name = match[1];
        const bool is_float = name.size() > 6 && name.substr(name.size() - 6) == " float";
        const bool is_double = name.size() > 7 && name.substr(name.size() - 7) == " double";
        EXPECT_EQ(match[2], is_float ? "circle" : is_double ? "rect" : "path") << name;
    }
}

TEST(Pictures, HandleUnboundedErrors) {
    auto measured = samples::two_methods();
    measured.rows[0].t_error->mean_ulp = HUGE_VAL;
    measured.rows[1].t_error = reference::accuracy::TError{0, 0, std::nan("")};
    const std::string svg = draw(error_scatter(panels_of(measured).front(), "e")).svg;
    expect_readable(svg, 2);
    EXPECT_THAT(svg, testing::Not(testing::ContainsRegex("\"-?(nan|inf)")));
}

TEST(Pictures, AreTheSameEveryTime) {
    EXPECT_EQ(accuracy_svg(samples::ladder()), accuracy_svg(samples::ladder()));
}

}  // namespace
