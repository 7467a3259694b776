#include "reference/hard_cases/cases.h"

#include <cmath>
#include <limits>

namespace reference::hard_cases {
namespace {

using P = Vec3<double>;
using R = kernel::Ray<double>;
using S = Sphere<double>;
using T = Triangle<double>;
using C = Cylinder<double>;

const P down(0, 0, -1);
const P origin(0, 0, 0);
const R negative{P(-0.0F, -0.0F, 2), P(-0.0F, -0.0F, -1)};
const float inf = std::numeric_limits<float>::infinity();
const float nan = std::numeric_limits<float>::quiet_NaN();

/// The handout's triangle, "base tri".
const T base{P(0, -2, 2), P(2, 2, 2), P(-2, 2, 2)};
const T unit{P(0, 0, 0), P(1, 0, 0), P(0, 1, 0)};

T corner_at(const P& A, float edge) {
    const auto beside = [&](double coordinate) { return static_cast<float>(coordinate) + edge; };
    return {A, P(beside(A.x), A.y, A.z), P(A.x, beside(A.y), A.z)};
}

std::vector<Case> sphere_cases() {
    const S five{origin, 5};
    const S one{origin, 1};
    const S planet{origin, 6371000};
    const P on_planet(0, 6371000.5F, 0);
    const S ground{P(0, -1e6F, 0), 1e6F};
    return {
        {"H1", "plain", R{P(0, 0, 2), down}, S{P(1, 1, 0), 2}, "hit", {"0.585786437626905"}},
        {"H6", "tangent", R{P(3, 4, 100), down}, five, "tangent", {"100"}},
        {"H7", "grazing", R{P(3, 4, 100), down}, S{origin, std::nextafter(5.0F, 0.0F)}, "miss"},
        {"H8", "grazing", R{P(3, 4, 100), down}, S{origin, std::nextafter(5.0F, 9.0F)}, "hit", {"99.99781634"}},
        {"D1", "grazing", R{P(3, 4, 100), down}, S{origin, std::nextafter(5.0, 0.0)}, "miss"},
        {"H9", "tangent", R{P(3, 4, 1e6F), down}, five, "tangent", {"1000000"}},
        {"H10", "tangent", R{P(-5675739, 544428, 4736878), P(189, -18, -158)}, S{origin, 7410}, "tangent", {"30011"}},
        {"H12", "far and small", R{P(.005F, 0, 1e5F), down}, S{origin, .01F}, "hit", {"99999.99133974615"}},
        {"H13", "far and small", R{P(.0101F, 0, 1e5F), down}, S{origin, .01F}, "miss"},
        {"H14", "huge", R{on_planet, P(0, -1, 0)}, planet, "hit", {"0.5"}},
        {"H15", "huge", R{on_planet, P(1, -.001F, 0)}, planet, "hit", {"521.32981142865"}},
        {"D2", "huge", R{P(0, 1e12 + .5, 0), P(1, -.001F, 0)}, S{origin, 1e12}, "hit", {"500.0001012513"}},
        {"H16", "huge", R{P(0, .1F, 0), P(.6F, -.8F, 0)}, ground, "hit", {"0.12500000351562543"}},
        {"H17", "from inside", R{origin, down}, S{P(0, 0, .5F), 2}, "hit", {"1.5"}},
        {"H18", "on the surface", R{P(0, 0, 2), down}, S{origin, 2}, "hit", {"0"}},
        {"H19", "on the surface", R{P(0, 0, 2), P(0, 0, 1)}, S{origin, 2}, "hit", {"0"}},
        {"H20", "on the surface", R{P(0, 0, 2), P(1, 0, 0)}, S{origin, 2}, "tangent", {"0"}},
        {"H21", "on the surface", R{P(.6F, .8F, 0), P(.6F, .8F, 0)}, one, "miss"},
        {"H22", "huge", R{P(0, 0, 1e4F), down}, S{origin, 9999.9F}, "hit", {"0.099609375"}},
        {"H23", "long direction", R{P(0, 0, 10), P(0, 0, -3)}, one, "hit", {"3"}},
        {"H24", "short direction", R{P(0, 0, 10), P(0, 0, -1e-20F)}, one, "hit", {"9.00000028561e20"}},
        {"H25", "scale 1e20", R{P(0, 0, 1e21F), down}, S{origin, 1e20F}, "hit", {"9.0000001803679e20"}},
        {"H26", "scale 1e-20", R{P(0, 0, 1e-19F), down}, S{origin, 1e-20F}, "hit", {"8.99999971439e-20"}},
        {"H27", "scale 1e38", R{P(0, 0, 3e38F), down}, S{origin, 1e38F}, "hit", {"2.0000000374691865e38"}},
        {"H28", "scale 1e-38", R{P(0, 0, 1e-37F), down}, S{origin, 1e-38F}, "hit", {"8.99999997593e-38"}},
        {"H30", "behind", R{P(0, 0, 5), P(0, 0, 1)}, one, "miss"},
        {"H31 R=0", "invalid", R{P(0, 0, 1), down}, S{origin, 0}, "invalid"},
        {"H31 R<0", "invalid", R{P(0, 0, 2), down}, S{origin, -1}, "invalid"},
        {"H31 R=inf", "invalid", R{P(0, 0, 2), down}, S{origin, inf}, "invalid"},
        {"H32", "invalid", R{P(0, 0, 2), origin}, one, "invalid"},
        {"H33 o.x=NaN", "invalid", R{P(nan, 0, 2), down}, one, "invalid"},
        {"H33 o.z=inf", "invalid", R{P(0, 0, inf), down}, one, "invalid"},
        {"H33 d.y=NaN", "invalid", R{P(0, 0, 2), P(0, nan, -1)}, one, "invalid"},
        {"H33 d.z=-inf", "invalid", R{P(0, 0, 2), P(0, 0, -inf)}, one, "invalid"},
        {"H33 C.x=NaN", "invalid", R{P(0, 0, 2), down}, S{P(nan, 0, 0), 1}, "invalid"},
        {"H33 R=NaN", "invalid", R{P(0, 0, 2), down}, S{origin, nan}, "invalid"},
        {"H34 hit", "negative zero", negative, S{P(1, 1, 0), 2}, "hit", {"0.585786437626905"}},
        {"H34 surface", "negative zero", negative, S{origin, 2}, "hit", {"0"}},
    };
}

std::vector<Case> triangle_cases() {
    const float above_2 = std::nextafter(2.0F, 3.0F);
    const R crack{P(-1.421875F, 6.453125F, -13.703125F), P(-5.86123657F, 4.35157776F, 25.611557F)};
    const P q0(-13.078125F, 15.4375F, 13.53125F);
    const P q1(-13.515625F, -6.875F, 11.75F);
    const P q2(3.828125F, 1.921875F, 8.796875F);
    const P q3(5.5F, 5.9375F, .640625F);
    const T sliver{origin, P(1, 0, 0), P(.5F, 1e-7F, 0)};
    const R seam{P(0, 0, 10), P(.30458447F, .30458447F, -.9024725F)};
    const R tiny{P(1e-21F, 1e-21F, 1e-19F), down}, huge{P(1e19F, 1e19F, 1e20F), down};
    const R far{P(10000001, 10000001, 50), down};
    const R pbrt{P(-1081.47925F, 99.9999542F, 87.7701111F), P(-32.1072998F, -183.355865F, -144.607635F)};
    const T pbrt_bad{P(-1113.45459F, -79.049614F, -56.2431908F), P(-1113.45459F, -87.0922699F, -56.2431908F),
                     P(-1113.45459F, -79.2090149F, -56.2431908F)};
    return {
        {"H2", "on the surface", R{P(0, 0, 2), down}, base, "hit", {"0", "0.25", "0.25"}},
        {"H3", "on the surface", R{P(0, 0, above_2), down}, base, "hit", {"2.38418579e-7"}},
        {"H4", "on the surface", R{P(0, 0, std::nextafter(2.0F, 1.0F)), down}, base, "miss"},
        {"H33 o.y=NaN", "invalid", R{P(0, nan, 2), down}, base, "invalid"},
        {"H33 A.x=inf", "invalid", R{P(0, 0, 2), down}, T{P(inf, 0, 0), P(1, 0, 0), P(0, 1, 0)}, "invalid"},
        {"H32 triangle", "invalid", R{P(0, 0, 2), origin}, base, "invalid"},
        {"H34 triangle", "negative zero", negative, unit, "hit", {"2", "0", "0"}},
        {"H35", "vertex", R{P(0, -2, 5), down}, base, "hit", {"3", "0", "0"}},
        {"H36", "edge", R{P(.3F, 2, 5), down}, base, "hit", {"3"}},
        {"H37", "edge", R{P(.3F, above_2, 5), down}, base, "miss"},
        {"D3", "edge", R{P(.3F, std::nextafter(2.0, 3.0), 5), down}, base, "miss"},
        {"H38 012", "edge", crack, T{q0, q1, q2}, "hit", {"1", "0"}},
        {"H38 023", "edge", crack, T{q0, q2, q3}, "hit", {"1", "", "0"}},
        {"H39 below", "edge", seam, T{P(-5, -5, 0), P(5, -5, 0), P(5, 5, 0)}, "hit", {"11.0806700968"}},
        {"H39 above", "edge", seam, T{P(-5, -5, 0), P(5, 5, 0), P(-5, 5, 0)}, "hit", {"11.0806700968"}},
        {"H40", "parallel", R{P(-5, 0, 2), P(1, 0, 0)}, base, "coplanar"},
        {"H41", "parallel", R{P(-5, 0, 3), P(1, 0, 0)}, base, "miss"},
        {"H42", "parallel", R{P(-5, 0, 2.0000005F), P(1, 0, -1e-7F)}, base, "hit", {"4.76837152631"}},
        {"H43 collinear", "no area", R{P(0, 0, 1), down}, T{P(-1, 0, 0), P(0, 0, 0), P(1, 0, 0)}, "degenerate"},
        {"H43 point", "no area", R{P(0, 0, 1), down}, T{origin, origin, origin}, "degenerate"},
        {"H43 pbrt", "no area", pbrt, pbrt_bad, "degenerate"},
        {"H44", "sliver", R{P(.5F, 5e-8F, 1), down}, sliver, "hit", {"1", "0.25", "0.5"}},
        {"H45 1e-4", "tiny", R{P(1e-5F, 1e-5F, 1), down}, corner_at(origin, 1e-4F), "hit", {"1", "0.1", "0.1"}},
        {"H45 1e-20", "tiny", tiny, corner_at(origin, 1e-20F), "hit", {"9.9999997e-20", "0.1", "0.1"}},
        {"H46", "scale 1e20", huge, corner_at(origin, 1e20F), "hit", {"1.00000002e20", ".1", ".1"}},
        {"H47", "huge offset", far, corner_at(P(1e7F, 1e7F, 0), 4), "hit", {"50", "0.25", "0.25"}},
        {"H48", "edge", R{P(-0x1p-149F, .25F, 1), down}, unit, "miss"},
    };
}

/// The axis is parallel to y.
std::vector<Case> cylinder_cases() {
    const C five{origin, 5, 10};
    const R beside{P(5, 0, 100), down};
    const float below_5 = std::nextafter(5.0F, 0.0F), above_5 = std::nextafter(5.0F, 9.0F);
    return {
        {"C1", "tangent", beside, five, "tangent", {"100"}},
        {"C14", "grazing", beside, C{origin, std::nextafter(5.0, 0.0), 10}, "miss"},
        {"C2", "grazing", beside, C{origin, below_5, 10}, "miss"},
        {"C3", "grazing", beside, C{origin, above_5, 10}, "hit", {"99.99781634"}},
        {"C4", "far and small", R{P(.005F, 0, 1e5F), down}, C{origin, .01F, .01F}, "hit", {"99999.99133974615"}},
        {"C5", "edge", R{P(0, 5, 100), down}, five, "hit", {"95"}},
        {"C6", "edge", R{P(0, above_5, 100), down}, five, "miss"},
        {"C7", "edge", R{P(0, 10, 10), P(0, -1, -1)}, five, "hit", {"5"}},
        {"C8", "parallel", R{P(3, 20, 0), P(0, -1, 0)}, five, "hit", {"15"}},
        {"C9", "parallel", R{P(5, 20, 0), P(0, -1, 0)}, five, "miss"},
        {"C10", "parallel", R{P(-8, above_5, 0), P(1, -1e-7F, 0)}, five, "hit", {"4.76837152631"}},
        {"C11", "on the surface", R{P(5, 0, 0), P(-1, 0, 0)}, five, "hit", {"0"}},
        {"C12", "on the surface", R{P(5, 0, 0), P(1, 0, 0)}, five, "hit", {"0"}},
        {"C13", "huge", R{P(6371000.5F, 0, 0), P(-.001F, 0, 1)}, C{origin, 6371000, 10}, "hit", {"521.32981142865"}},
    };
}

/// A sphere of radius 5 is met at t = 20/3, and a triangle in the plane z = 4 too.
std::vector<Case> order_cases() {
    const auto at = [](double height) {
        return SphereAndTriangle{{origin, 5}, {P(-4, -4, height), P(10, -4, height), P(3, 8, height)}};
    };
    const R ray{P(3, 0, 24), P(0, 0, -3)};
    return {
        {"H50", "first of two", ray, at(4), "tie", {"6.66666666666666"}},
        {"H51", "first of two", ray, at(4 - 0x1p-22), "sphere", {"6.6666666666"}},
        {"H52", "first of two", ray, at(4 + 0x1p-21), "triangle", {"6.66666650772"}},
        {"D4", "first of two", ray, at(std::nextafter(4.0, 3.0)), "sphere", {"6.66666666666"}},
        {"D5", "first of two", ray, at(std::nextafter(4.0, 5.0)), "triangle", {"6.66666666666"}},
    };
}

std::vector<Case> camera_cases() {
    const R none{origin, origin};
    const P up(0, 1, 0);
    using Eye = Camera<double>;
    const Eye along{P(1, 2, 3), origin, P(1 + 0x1p-22, 2, 3)};
    return {
        {"H53", "invalid", none, Eye{P(0, 0, 4), origin, P(0, 0, 1)}, "invalid"},
        {"H54", "vup along view", none, along, "axis", {"0", "-0.8320502943", "0.5547001962"}},
        {"H55", "invalid", none, Eye{P(1, 2, 3), P(1, 2, 3), up}, "invalid"},
        {"H56 1e8", "huge offset", none, Eye{P(1e8, 0, 1e8 + 1), P(1e8, 0, 1e8), up}, "axis", {"1", "0", "0"}},
        {"H56 2^24", "huge offset", none, Eye{P(16777217, 0, 0), P(16777216, 0, 0), up}, "axis", {"0", "0", "-1"}},
        {"H57 vup 1e-30", "scale 1e-30", none, Eye{P(0, 0, 4), origin, P(0, 1e-30F, 0)}, "axis", {"1", "0", "0"}},
        {"H57 vup 1e30", "scale 1e30", none, Eye{P(0, 0, 4), origin, P(0, 1e30F, 0)}, "axis", {"1", "0", "0"}},
        {"H57 eye 1e20", "scale 1e20", none, Eye{P(0, 0, 1e20F), origin, up}, "axis", {"1", "0", "0"}},
        {"H57 eye 1e-25", "scale 1e-25", none, Eye{P(0, 0, 1e-25F), origin, up}, "axis", {"1", "0", "0"}},
    };
}

}  // namespace

const std::vector<Case>& cases() {
    static const std::vector<Case> all = [] {
        std::vector<Case> list;
        for (const auto& part : {sphere_cases(), triangle_cases(), cylinder_cases(), order_cases(), camera_cases()})
            list.insert(list.end(), part.begin(), part.end());
        return list;
    }();
    return all;
}

}  // namespace reference::hard_cases
