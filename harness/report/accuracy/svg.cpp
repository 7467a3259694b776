#include <fmt/format.h>

#include <algorithm>

#include "harness/report/accuracy/panels.h"
#include "harness/report/accuracy/report.h"
#include "harness/report/plot/scatter_drawing.h"
#include "harness/text/markup.h"

namespace harness::report {

std::string accuracy_svg(const reference::accuracy::Measurement& measured) {
    constexpr double head = 66;
    constexpr double foot = 30;
    constexpr double gap = 16;
    double width = gap;
    double height = 0;
    std::string pictures;
    for (const PrimitiveSummary& summary : summarise(measured)) {
        const Drawing drawing = draw(summary_scatter(summary));
        pictures += fmt::format("<g transform=\"translate({:.0f} {:.0f})\">\n{}</g>\n", width, head, drawing.svg);
        width += drawing.width + gap;
        height = std::max(height, drawing.height);
    }
    height += head + foot;
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-labelledby=\"accuracy-t accuracy-d\" "
        "width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\">\n"
        "<title id=\"accuracy-t\">What accuracy costs in time</title>\n"
        "<desc id=\"accuracy-d\">For each primitive, methods by their time on benign rays and their wrong decisions on "
        "hard ones.</desc>\n<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#ffffff\"/>\n",
        width, height);
    svg += fmt::format(
        "<g font-family=\"{}\" fill=\"#111111\">\n<text x=\"24\" y=\"30\" font-size=\"22\" font-weight=\"bold\">What "
        "accuracy costs in time</text>\n<text x=\"24\" y=\"52\" font-size=\"14\" fill=\"#444444\">Left is faster, down "
        "is "
        "wrong less often. ● float, ■ double, ◆ other. Bold, on the line: none beats it in both. Bars: 95 % intervals "
        "and "
        "quartiles.</text>\n",
        font_family);
    const std::string machine =
        fmt::format("seed {}, {} rays of each distribution; {}; {}{}", measured.seed, measured.rays, measured.compiler,
                    measured.flags, measured.processor.empty() ? "" : "; " + measured.processor);
    svg += fmt::format("<text x=\"24\" y=\"{:.0f}\" font-size=\"12\" fill=\"#555555\">{}</text>\n</g>\n", height - 12,
                       escape_markup(machine));
    return svg + pictures + "</svg>\n";
}

}  // namespace harness::report
