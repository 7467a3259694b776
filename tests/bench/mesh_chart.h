// A chart of meshes, in the style of `raygrade accuracy`: rays a second against rays that slip through.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "harness/report/plot/numbers.h"
#include "harness/report/plot/scatter_drawing.h"
#include "reference/accuracy/measure/statistics.h"

/// One contestant on one mesh.
struct MeshFigure {
    std::string contestant;
    std::size_t triangles = 0;
    double rays_a_second = 0;  ///< the median, with quartiles
    double least_a_second = 0;
    double most_a_second = 0;
    std::size_t slipped = 0;
    std::size_t aimed = 0;  ///< rays, of which none should slip
};

/// The figures of one kind of mesh.
struct MeshPanel {
    std::string mesh;
    std::vector<MeshFigure> figures;
};

inline harness::report::Mark mark_of(const std::string& contestant) {
    using harness::report::Mark;
    if (contestant == "certified") return Mark::square;
    return contestant == "Embree, fast" ? Mark::circle : Mark::diamond;
}

inline harness::report::Scatter scatter_of(const MeshPanel& panel, std::size_t number) {
    constexpr double million = 1e6;
    harness::report::Scatter scatter{fmt::format("mesh-{}", number),
                                     panel.mesh,
                                     "Rays a second against rays that slip through.",
                                     "million scattered rays a second (logarithmic)",
                                     "rays that slip through per million aimed rays",
                                     "none slips",
                                     1,
                                     million,
                                     million,
                                     {}};
    for (const MeshFigure& figure : panel.figures) {
        const auto share = reference::accuracy::wilson_interval(figure.slipped, figure.aimed);
        const double rate = million * static_cast<double>(figure.slipped) / static_cast<double>(figure.aimed);
        const int exponent = static_cast<int>(std::lround(std::log10(figure.triangles)));
        const double speed = figure.rays_a_second / million;
        scatter.points.push_back({fmt::format("{}, {}", figure.contestant, harness::report::power_text(exponent)),
                                  fmt::format("{}, {} triangles: {:.2f} million rays a second, {} of {} slip through",
                                              figure.contestant, figure.triangles, speed, figure.slipped, figure.aimed),
                                  mark_of(figure.contestant), speed, figure.least_a_second / million,
                                  figure.most_a_second / million, rate, million * share.low, million * share.high});
    }
    return scatter;
}

/// Two panels a row. `machine` is its processor, the date and its load.
inline std::string mesh_chart(const std::vector<MeshPanel>& panels, const std::string& machine) {
    constexpr double head = 66;
    constexpr double foot = 30;
    constexpr double gap = 16;
    std::string pictures;
    double width = 0;
    double top = head;
    double row_height = 0;
    double left = gap;
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const harness::report::Drawing drawing = harness::report::draw(scatter_of(panels[i], i + 1));
        pictures += fmt::format("<g transform=\"translate({:.0f} {:.0f})\">\n{}</g>\n", left, top, drawing.svg);
        row_height = std::max(row_height, drawing.height);
        left += drawing.width + gap;
        width = std::max(width, left);
        if (i % 2 == 0 && i + 1 < panels.size()) continue;
        left = gap;
        top += row_height + gap;
        row_height = 0;
    }
    const double height = top + foot;
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-labelledby=\"mesh-t\" width=\"{0:.0f}\" "
               "height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\">\n<title id=\"mesh-t\">First hits in meshes: rays a "
               "second against rays that slip through</title>\n<rect width=\"{0:.0f}\" height=\"{1:.0f}\" "
               "fill=\"#ffffff\"/>\n<g font-family=\"{2}\" fill=\"#111111\">\n<text x=\"24\" y=\"30\" "
               "font-size=\"22\" font-weight=\"bold\">First hits in meshes of 10,000 to 1,000,000 triangles</text>\n"
               "<text x=\"24\" y=\"52\" font-size=\"14\" fill=\"#444444\">Right is faster, down lets fewer rays slip "
               "through. ■ certified, ● Embree fast, ◆ Embree robust. Bars: 95 % intervals and quartiles.</text>\n"
               "<text x=\"24\" y=\"{3:.0f}\" font-size=\"12\" fill=\"#555555\">{4}</text>\n</g>\n",
               width, height, harness::report::font_family, height - 12, machine) +
           pictures + "</svg>\n";
}
