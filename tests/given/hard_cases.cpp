#include "tests/given/hard_cases.h"

#include <cmath>
#include <limits>

namespace hard_cases {
namespace {

using P = reference::Vec3<double>;
using R = reference::kernel::Ray<double>;
using S = reference::Sphere<double>;
using T = reference::Triangle<double>;
using enum reference::kernel::SphereResult;
using TR = reference::kernel::TriangleResult;

const P down(0, 0, -1);
const P origin(0, 0, 0);
const float inf = std::numeric_limits<float>::infinity();
const float nan = std::numeric_limits<float>::quiet_NaN();

/// The handout's triangle, "base tri".
const T base{P(0, -2, 2), P(2, 2, 2), P(-2, 2, 2)};
const T unit{P(0, 0, 0), P(1, 0, 0), P(0, 1, 0)};

T corner_at(const P& A, float edge) {
    const auto beside = [&](double coordinate) { return static_cast<float>(coordinate) + edge; };
    return {A, P(beside(A.x), A.y, A.z), P(A.x, beside(A.y), A.z)};
}

}  // namespace

std::vector<SphereCase> sphere_cases() {
    const S five{origin, 5};
    const S one{origin, 1};
    return {
        {"H1", {P(0, 0, 2), down}, {P(1, 1, 0), 2}, hit, "0.585786437626905"},
        {"H6", {P(3, 4, 100), down}, five, tangent, "100"},
        {"H7", {P(3, 4, 100), down}, {origin, std::nextafter(5.0F, 0.0F)}, miss},
        {"H8", {P(3, 4, 100), down}, {origin, std::nextafter(5.0F, 9.0F)}, hit, "99.99781634"},
        {"H9", {P(3, 4, 1e6F), down}, five, tangent, "1000000"},
        {"H10", {P(-5675739, 544428, 4736878), P(189, -18, -158)}, {origin, 7410}, tangent, "30011"},
        {"H12", {P(.005F, 0, 1e5F), down}, {origin, .01F}, hit, "99999.99133974615"},
        {"H13", {P(.0101F, 0, 1e5F), down}, {origin, .01F}, miss},
        {"H14", {P(0, 6371000.5F, 0), P(0, -1, 0)}, {origin, 6371000}, hit, "0.5"},
        {"H15", {P(0, 6371000.5F, 0), P(1, -.001F, 0)}, {origin, 6371000}, hit, "521.32981142865"},
        {"H16", {P(0, .1F, 0), P(.6F, -.8F, 0)}, {P(0, -1e6F, 0), 1e6F}, hit, "0.12500000351562543"},
        {"H17", {origin, down}, {P(0, 0, .5F), 2}, hit, "1.5"},
        {"H18", {P(0, 0, 2), down}, {origin, 2}, hit, "0"},
        {"H19", {P(0, 0, 2), P(0, 0, 1)}, {origin, 2}, hit, "0"},
        {"H20", {P(0, 0, 2), P(1, 0, 0)}, {origin, 2}, tangent, "0"},
        {"H21", {P(.6F, .8F, 0), P(.6F, .8F, 0)}, one, miss},
        {"H22", {P(0, 0, 1e4F), down}, {origin, 9999.9F}, hit, "0.099609375"},
        {"H23", {P(0, 0, 10), P(0, 0, -3)}, one, hit, "3"},
        {"H24", {P(0, 0, 10), P(0, 0, -1e-20F)}, one, hit, "9.00000028561e20"},
        {"H25", {P(0, 0, 1e21F), down}, {origin, 1e20F}, hit, "9.0000001803679e20"},
        {"H26", {P(0, 0, 1e-19F), down}, {origin, 1e-20F}, hit, "8.99999971439e-20"},
        {"H27", {P(0, 0, 3e38F), down}, {origin, 1e38F}, hit, "2.0000000374691865e38"},
        {"H28", {P(0, 0, 1e-37F), down}, {origin, 1e-38F}, hit, "8.99999997593e-38"},
        {"H30", {P(0, 0, 5), P(0, 0, 1)}, one, miss},
        {"H31 R=0", {P(0, 0, 1), down}, {origin, 0}, invalid},
        {"H31 R<0", {P(0, 0, 2), down}, {origin, -1}, invalid},
        {"H31 R=inf", {P(0, 0, 2), down}, {origin, inf}, invalid},
        {"H32", {P(0, 0, 2), origin}, one, invalid},
        {"H33 o.x=NaN", {P(nan, 0, 2), down}, one, invalid},
        {"H33 o.z=inf", {P(0, 0, inf), down}, one, invalid},
        {"H33 d.y=NaN", {P(0, 0, 2), P(0, nan, -1)}, one, invalid},
        {"H33 d.z=-inf", {P(0, 0, 2), P(0, 0, -inf)}, one, invalid},
        {"H33 C.x=NaN", {P(0, 0, 2), down}, {P(nan, 0, 0), 1}, invalid},
        {"H33 R=NaN", {P(0, 0, 2), down}, {origin, nan}, invalid},
        {"H34 hit", {P(-0.0F, -0.0F, 2), P(-0.0F, -0.0F, -1)}, {P(1, 1, 0), 2}, hit, "0.585786437626905"},
        {"H34 on the surface", {P(-0.0F, 0, 2), P(-0.0F, -0.0F, -1)}, {origin, 2}, hit, "0"},
    };
}

std::vector<TriangleCase> triangle_cases() {
    const float above_2 = std::nextafter(2.0F, 3.0F);
    const R crack{P(-1.421875F, 6.453125F, -13.703125F), P(-5.86123657F, 4.35157776F, 25.611557F)};
    const P q0(-13.078125F, 15.4375F, 13.53125F);
    const P q1(-13.515625F, -6.875F, 11.75F);
    const P q2(3.828125F, 1.921875F, 8.796875F);
    const P q3(5.5F, 5.9375F, .640625F);
    const R seam{P(0, 0, 10), P(.30458447F, .30458447F, -.9024725F)};
    const R pbrt{P(-1081.47925F, 99.9999542F, 87.7701111F), P(-32.1072998F, -183.355865F, -144.607635F)};
    const T pbrt_bad{P(-1113.45459F, -79.049614F, -56.2431908F), P(-1113.45459F, -87.0922699F, -56.2431908F),
                     P(-1113.45459F, -79.2090149F, -56.2431908F)};
    return {
        {"H2", {P(0, 0, 2), down}, base, TR::hit, "0", "0.25", "0.25"},
        {"H3", {P(0, 0, above_2), down}, base, TR::hit, "2.38418579e-7", "", ""},
        {"H4", {P(0, 0, std::nextafter(2.0F, 1.0F)), down}, base, TR::miss},
        {"H33", {P(0, nan, 2), down}, base, TR::invalid},
        {"H33 vertex", {P(0, 0, 2), down}, {P(inf, 0, 0), P(1, 0, 0), P(0, 1, 0)}, TR::invalid},
        {"H32", {P(0, 0, 2), origin}, base, TR::invalid},
        {"H34", {P(-0.0F, -0.0F, 2), P(-0.0F, -0.0F, -1)}, unit, TR::hit, "2", "0", "0"},
        {"H35", {P(0, -2, 5), down}, base, TR::hit, "3", "0", "0"},
        {"H36", {P(.3F, 2, 5), down}, base, TR::hit, "3", "", ""},
        {"H37", {P(.3F, above_2, 5), down}, base, TR::miss},
        {"H38 012", crack, {q0, q1, q2}, TR::hit, "1", "0", ""},
        {"H38 023", crack, {q0, q2, q3}, TR::hit, "1", "", "0"},
        {"H39 below", seam, {P(-5, -5, 0), P(5, -5, 0), P(5, 5, 0)}, TR::hit, "11.0806700968", "", ""},
        {"H39 above", seam, {P(-5, -5, 0), P(5, 5, 0), P(-5, 5, 0)}, TR::hit, "11.0806700968", "", ""},
        {"H40", {P(-5, 0, 2), P(1, 0, 0)}, base, TR::coplanar},
        {"H41", {P(-5, 0, 3), P(1, 0, 0)}, base, TR::miss},
        {"H42", {P(-5, 0, 2.0000005F), P(1, 0, -1e-7F)}, base, TR::hit, "4.76837152631", "", ""},
        {"H43 collinear", {P(0, 0, 1), down}, {P(-1, 0, 0), P(0, 0, 0), P(1, 0, 0)}, TR::degenerate},
        {"H43 point", {P(0, 0, 1), down}, {origin, origin, origin}, TR::degenerate},
        {"H43 pbrt", pbrt, pbrt_bad, TR::degenerate},
        {"H44", {P(.5F, 5e-8F, 1), down}, {origin, P(1, 0, 0), P(.5F, 1e-7F, 0)}, TR::hit, "1", "0.25", "0.5"},
        {"H45 1e-4", {P(1e-5F, 1e-5F, 1), down}, corner_at(origin, 1e-4F), TR::hit, "1", "0.1", "0.1"},
        {"H45 1e-20", {P(1e-21F, 1e-21F, 1e-19F), down}, corner_at(origin, 1e-20F), TR::hit, "", "0.1", "0.1"},
        {"H46", {P(1e19F, 1e19F, 1e20F), down}, corner_at(origin, 1e20F), TR::hit, "1.00000002e20", "0.1", "0.1"},
        {"H47", {P(10000001, 10000001, 50), down}, corner_at(P(1e7F, 1e7F, 0), 4), TR::hit, "50", "0.25", "0.25"},
        {"H48", {P(-0x1p-149F, .25F, 1), down}, unit, TR::miss},
    };
}

}  // namespace hard_cases
