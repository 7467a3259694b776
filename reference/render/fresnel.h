// How glass reflects and refracts light at its surface.
#pragma once

#include <algorithm>
#include <cmath>

#include "reference/numbers/vector.h"

namespace reference::render {

/// At a surface between refractive indices `from` and `into`: the share of unpolarised light that is reflected, after
/// Fresnel's equations, and the cosine of the refracted ray with the normal. Beyond the critical angle all of it is
/// reflected, and the cosine is 0.
struct Fresnel {
    double reflected;
    double cos_refracted;
    bool is_total;
};

/// cos_incident is from 0 to 1.
inline Fresnel fresnel(double cos_incident, double from, double into) {
    if (from == into) return {0, cos_incident, false};
    const double ratio = from / into;
    const double sin_squared = ratio * ratio * (1 - cos_incident * cos_incident);
    if (sin_squared >= 1) return {1, 0, true};
    const double cos_refracted = std::sqrt(1 - sin_squared);
    const double across = (from * cos_incident - into * cos_refracted) / (from * cos_incident + into * cos_refracted);
    const double along = (into * cos_incident - from * cos_refracted) / (into * cos_incident + from * cos_refracted);
    return {(across * across + along * along) / 2, cos_refracted, false};
}

/// V mirrored at a plane with the unit normal N.
inline Vec3<double> mirrored(const Vec3<double>& V, const Vec3<double>& N) {
    return V - scaled(N, 2 * dot(V, N));
}

/// V bent at a plane with the unit normal N, which points to where V comes from; V has unit length.
inline Vec3<double> refracted(const Vec3<double>& V, const Vec3<double>& N, double cos_incident, double cos_refracted,
                              double ratio) {
    return scaled(V, ratio) + scaled(N, ratio * cos_incident - cos_refracted);
}

}  // namespace reference::render
