#include "harness/variants/random/draw.h"

#include <fmt/format.h>

#include <cmath>

namespace harness::variants {

reference::Vec3<double> rounded(const reference::Vec3<double>& p) {
    return {std::round(p.x) + 0.0, std::round(p.y) + 0.0, std::round(p.z) + 0.0};
}

reference::Vec3<double> across(const reference::Vec3<double>& V, Draw& draw) {
    // Keep this order, z before y before x: classes have been graded on scenes drawn this way.
    const double z = draw.between(-1, 1);
    const double y = draw.between(-1, 1);
    const double x = draw.between(-1, 1);
    return reference::normalized(reference::cross(V, {x, y, z}));
}

source::DecimalScene in_decimal(const reference::Scene<double>& scene) {
    return reference::convert_scene<reference::Decimal>(
        scene, [](double x) { return reference::Decimal::parse(fmt::format("{}", x)).value(); });
}

}  // namespace harness::variants
