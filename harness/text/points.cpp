#include "harness/text/points.h"

#include <fmt/format.h>

#include <cmath>

namespace harness {

std::string points_text(double points) {
    std::string text = fmt::format("{:.2f}", points);
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

double tidy(double points) {
    return std::round(points * 1e6) / 1e6;
}

}  // namespace harness
