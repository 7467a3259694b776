#include "harness/variants/drawing.h"

#include <fmt/format.h>

#include <cmath>

namespace harness::variants {

reference::Vec3<double> rounded(const reference::Vec3<double>& p) {
    return {std::round(p.x) + 0.0, std::round(p.y) + 0.0, std::round(p.z) + 0.0};
}

reference::Scene<double> in_double(const DecimalScene& scene) {
    return reference::convert_scene<double>(scene, [](const reference::Decimal& x) { return x.to_double(); });
}

DecimalScene in_decimal(const reference::Scene<double>& scene) {
    return reference::convert_scene<reference::Decimal>(
        scene, [](double x) { return reference::Decimal::parse(fmt::format("{}", x)).value(); });
}

}  // namespace harness::variants
