// Compares every decision about a cylinder with the handout's own words in fractions. RC_PARAMS sets the number of
// rays.
#include "reference/kernel/cylinder.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <iostream>
#include <map>
#include <optional>

#include "reference/accuracy/rays/distributions.h"
#include "reference/accuracy/rays/truth.h"
#include "reference/kernel/first.h"
#include "tests/given/ulp.h"
#include "tests/reference/kernel/random_cases.h"

namespace {

namespace truth = reference::accuracy::truth;

using namespace reference::kernel;
using reference::Boundary;
using reference::Cylinder;
using reference::FirstObject;
using reference::scaled;
using reference::Sphere;
using reference::Subject;
using reference::Triangle;
using reference::accuracy::CylinderCase;
using reference::accuracy::Inputs;
using reference::accuracy::P;
using reference::accuracy::Random;

/// Rays of each kind, unless RC_PARAMS says otherwise.
constexpr int cylinder_rays_in_ci = 5000;

/// Small whole numbers: rays through the rim, along the caps and the axis, from the surface, tangents.
CylinderCase lattice(std::uint64_t seed, Inputs /*inputs*/) {
    Random random(seed);
    const Cylinder<double> cylinder{random.whole_point(2), static_cast<double>(random.whole(1, 5)),
                                    static_cast<double>(random.whole(1, 6))};
    P direction(0, 0, 0);
    while (direction == P(0, 0, 0)) direction = random.whole_point(3);
    return {{random.whole_point(6), direction}, cylinder};
}

/// With lengths and directions multiplied by powers of two from 2^-60 to 2^60.
CylinderCase scaled_by_powers(std::uint64_t seed, Inputs /*inputs*/) {
    Random random(seed + 1);
    static const auto kinds = reference::accuracy::cylinder_distributions();
    CylinderCase c = kinds.at(static_cast<std::size_t>(random.whole(0, static_cast<int>(kinds.size()) - 1))).make(seed);
    const double length = std::exp2(random.whole(-60, 60));
    c = {{scaled(c.ray.origin, length), scaled(c.ray.direction, std::exp2(random.whole(-60, 60)))},
         {scaled(c.cylinder.center, length), c.cylinder.radius * length, c.cylinder.height * length}};
    return c;
}

/// Flat discs and thin poles, met from far or near: sizes that differ by up to 2^120.
CylinderCase mixed_scales(std::uint64_t seed, Inputs /*inputs*/) {
    Random random(seed);
    const double radius = std::exp2(random.whole(-60, 60)) * random.whole(1, 3);
    const double height = std::exp2(random.whole(-60, 60)) * random.whole(1, 3);
    const P center = random.whole(0, 1) == 0 ? P(0, 0, 0) : scaled(random.point(1), std::exp2(random.whole(-60, 60)));
    const P target = center + P(random.whole(-2, 2) * radius / 2, random.whole(-2, 2) * height / 2,
                                random.whole(0, 1) == 0 ? 0 : random.number() * radius);
    const P way =
        scaled(random.whole(0, 1) == 0 ? random.direction() : random.whole_point(2), std::exp2(random.whole(-60, 60)));
    const P direction = way == P(0, 0, 0) ? P(0, 0x1p-60, 0x1p60) : way;
    return {{target - direction, direction}, {center, radius, height}};
}

/// Sizes at which products leave the range of doubles, entirely or in part.
CylinderCase at_the_ends_of_doubles(std::uint64_t seed, Inputs inputs) {
    const CylinderCase c =
        seed % 2 == 0 ? lattice(seed, inputs) : reference::accuracy::cylinder_distributions().at(4).make(seed);
    const double length = reference::accuracy::to_the_ends(seed);
    const double step = reference::accuracy::to_the_ends(seed + 1);
    return {{scaled(c.ray.origin, length), scaled(c.ray.direction, step)},
            {scaled(c.cylinder.center, length), c.cylinder.radius * length, c.cylinder.height * length}};
}

using Kind = reference::accuracy::Distribution<CylinderCase>;
std::vector<Kind> kinds() {
    std::vector<Kind> all = reference::accuracy::cylinder_distributions();
    all.insert(all.end(), {{"lattice", lattice},
                           {"scaled by powers", scaled_by_powers},
                           {"mixed scales", mixed_scales},
                           {"at the ends of doubles", at_the_ends_of_doubles}});
    return all;
}

class KernelCylinder : public testing::TestWithParam<Kind> {};

TEST_P(KernelCylinder, DecidesAsTheHandoutsPartsDo) {
    std::array<int, 5> met{};  // misses, tubes, caps, tangents, starts on it
    random_cases::for_seeds(GetParam().name, cylinder_rays_in_ci, [&](std::uint64_t seed) {
        const auto [ray, cylinder] = GetParam().make(seed);
        const auto first = truth::cylinder(ray, cylinder);
        const CylinderHit given = intersect(ray, cylinder);
        const auto result = !first               ? CylinderResult::miss
                            : !first->is_tangent ? CylinderResult::hit
                                                 : CylinderResult::tangent;
        RC_ASSERT(given.result == result);
        const auto to_float = intersect_to_float(ray, cylinder);
        RC_ASSERT(is_hit(to_float.result) == first.has_value());
        const truth::Real t = first ? first->t.value() : truth::Real(0);
        RC_ASSERT(truth::is_within_one_ulp(to_float.t, t) || abs(t - to_float.t) <= t * truth::Real(0x1p-26));
        Cast cast;
        cast_ray(ray, {{}, {}, {cylinder}}, cast);
        RC_ASSERT(cast.first.object == (first ? FirstObject(Subject::cylinder) : FirstObject::no_hit));
        ++met[first ? (first->part == CylinderPart::tube ? 1 : 2) : 0];
        if (!first) return;
        met[3] += first->is_tangent ? 1 : 0;
        met[4] += truth::sign(first->t) == 0 ? 1 : 0;
        RC_ASSERT(given.part == first->part);
        RC_ASSERT(truth::is_within_one_ulp(given.t, t));
        RC_ASSERT(!(given.t == 0 && std::signbit(given.t)));
    });
    std::cout << GetParam().name << ": " << met[0] << " missed, " << met[1] << " hit the tube, " << met[2] << " a cap; "
              << met[3] << " tangents, " << met[4] << " started on it\n";
    EXPECT_TRUE(met[0] > 100 && met[1] > 100);
}

INSTANTIATE_TEST_SUITE_P(, KernelCylinder, testing::ValuesIn(kinds()), [](const auto& kind) {
    std::string name(kind.param.name);
    std::ranges::replace_if(
        name, [](char c) { return !std::isalpha(c); }, '_');
    return name;
});

/// A thousand digits tell unequal numbers apart. That two are equal is told by x² = (y√d + z√e)², squared once more.
int order(const truth::Surd& one, const truth::Surd& other) {
    using truth::Rational, truth::Real;
    const Real difference = one.value() - other.value();
    if (abs(difference) > Real("1e-300") * (abs(one.value()) + Real("1e-300"))) return difference.sign();
    const Rational x = one.x - other.x;
    const Rational y_square = one.y * one.y * one.d;
    const Rational z_square = other.y * other.y * other.d;
    const Rational mixed = x * x - y_square - z_square;
    return mixed * mixed == 4 * y_square * z_square ? 0 : difference.sign();
}

std::optional<truth::Surd> first_t(const Ray<double>& ray, const Sphere<double>& sphere) {
    const truth::SphereTruth truth = truth::sphere(ray, sphere);
    if (truth.result == SphereResult::miss) return std::nullopt;
    return truth::Surd{-truth.h / truth.a, (truth.smaller ? -1 : 1) / truth.a, truth.h * truth.h - truth.a * truth.c};
}
std::optional<truth::Surd> first_t(const Ray<double>& ray, const Triangle<double>& triangle) {
    const truth::TriangleTruth truth = truth::triangle(ray, triangle);
    if (truth.result != TriangleResult::hit) return std::nullopt;
    return truth::Surd{truth.t};
}
std::optional<truth::Surd> first_t(const Ray<double>& ray, const Cylinder<double>& cylinder) {
    const auto hit = truth::cylinder(ray, cylinder);
    return hit ? std::optional(hit->t) : std::nullopt;
}

/// Some sphere, triangle or cylinder near the ray's start, in small whole numbers; the last is nudged now and then.
struct OrderCase {
    Ray<double> ray;
    Objects objects;

    explicit OrderCase(std::uint64_t seed) {
        Random random(seed);
        P direction(0, 0, 0);
        while (direction == P(0, 0, 0)) direction = random.whole_point(2);
        ray = {random.whole_point(4), direction};
        const auto length = [&] { return static_cast<double>(random.whole(1, 5)); };
        objects.cylinders.push_back({random.whole_point(4), length(), length()});
        const auto first = first_t(ray, objects.cylinders.front());
        const P at = first ? ray.origin + scaled(direction, static_cast<double>(first->value())) : P(0, 0, 0);
        const bool meets_there = first && random.whole(0, 1) == 0;
        switch (random.whole(0, 2)) {
            case 0: {
                // Often a sphere through the cylinder's hit: the same root of another quadratic.
                const P center = meets_there ? at + random.whole_point(3) : random.whole_point(4);
                const double far = length_of(at - center);
                objects.spheres.push_back({center, meets_there && far > 0 ? random.nudged(far) : length()});
                break;
            }
            case 1: {
                const P near = meets_there ? at : random.whole_point(3);
                const P one = random.whole_point(4);
                const P other = random.whole_point(4);
                objects.triangles.push_back({near + one, near + other, near - one - other});
                break;
            }
            case 2: {
                Cylinder<double> other{random.whole_point(4), length(), length()};
                if (meets_there) other.center.y = random.nudged(2 * at.y - other.center.y);
                if (random.whole(0, 3) == 0) other.center = objects.cylinders.front().center;
                if (random.whole(0, 3) == 0) other.radius = random.nudged(other.radius);
                objects.cylinders.push_back(other);
                break;
            }
        }
    }

  private:
    static double length_of(const P& p) { return std::sqrt(dot(p, p)); }
};

struct TrueFirst {
    FirstObject object = FirstObject::no_hit;
    std::size_t index = 0;
    std::optional<truth::Surd> t;

    template <class Object>
    void meet(const Ray<double>& ray, const std::vector<Object>& objects, Subject kind) {
        for (std::size_t i = 0; i < objects.size(); ++i) {
            const auto other = first_t(ray, objects[i]);
            if (!other) continue;
            const int compared = t ? order(*other, *t) : -1;
            if (compared == 0) object = FirstObject::tie, index = 0;
            if (compared < 0) object = FirstObject(kind), index = i, t = other;
        }
    }
};

TEST(KernelCylinderOrder, IsThatOfFractionsAndAThousandDigits) {
    std::map<std::optional<Subject>, int> met;
    int ties = 0;
    random_cases::for_seeds("order", 4 * cylinder_rays_in_ci, [&](std::uint64_t seed) {
        const OrderCase c(seed);
        TrueFirst first;
        first.meet(c.ray, c.objects.spheres, Subject::sphere);
        first.meet(c.ray, c.objects.triangles, Subject::triangle);
        first.meet(c.ray, c.objects.cylinders, Subject::cylinder);
        Cast cast;
        cast_ray(c.ray, c.objects, cast);
        ++met[first.object.kind()];
        if (first.object == FirstObject::tie) ++ties;
        RC_ASSERT(cast.first.object == first.object);
        RC_ASSERT(cast.first.index == first.index);
    });
    std::cout << "order: " << met[Subject::sphere] << " spheres first, " << met[Subject::triangle] << " triangles, "
              << met[Subject::cylinder] << " cylinders, " << ties << " ties\n";
    EXPECT_GT(ties, 100);
}

// What follows was derived by hand: a tube x² + z² = 25 around the origin, with the caps at y = -2 and y = 2.
const Cylinder<double> can{P(0, 0, 0), 5, 4};

struct ByHand {
    std::string_view what;
    P start, direction;
    CylinderResult result;
    CylinderPart part;
    double t;
};

TEST(CylinderByHand, IsDecidedAndMeasured) {
    using enum CylinderResult;
    using enum CylinderPart;
    for (const ByHand& c : {
             ByHand{"across", P(-9, 1, 0), P(1, 0, 0), hit, tube, 4},
             ByHand{"from above", P(3, 6, 1), P(0, -2, 0), hit, top, 2},
             ByHand{"from below", P(3, -6, 1), P(0, 1, 0), hit, bottom, 4},
             ByHand{"along the tube's side", P(3, 6, 4), P(0, -1, 0), miss, tube, 0},
             ByHand{"along the axis outside", P(4, 6, 4), P(0, -1, 0), miss, tube, 0},
             ByHand{"over the rim into the cap", P(-9, 6, 0), P(2, -1, 0), hit, top, 4},
             ByHand{"through the rim from above", P(-9, 6, 0), P(1, -1, 0), hit, tube, 4},
             ByHand{"touches the rim from outside", P(-7, 0, 0), P(1, 1, 0), hit, tube, 2},
             ByHand{"in through the rim", P(9, 6, 0), P(-1, -1, 0), hit, tube, 4},
             ByHand{"passes the rim by", P(-7, 0.5, 0), P(1, 1, 0), miss, tube, 0},
             ByHand{"in the top's plane", P(-9, 2, 3), P(1, 0, 0), hit, tube, 5},
             ByHand{"in the top's plane from inside", P(0, 2, 3), P(1, 0, 0), hit, tube, 4},
             ByHand{"above the top's plane", P(-9, std::nextafter(2.0, 3.0), 3), P(1, 0, 0), miss, tube, 0},
             ByHand{"tangent", P(5, 1, -3), P(0, 0, 1), tangent, tube, 3},
             ByHand{"tangent at the rim", P(5, 5, -3), P(0, -1, 1), tangent, tube, 3},
             ByHand{"tangent above the top", P(5, 5, -3), P(0, 0, 1), miss, tube, 0},
             ByHand{"tangent behind", P(5, 1, 3), P(0, 0, 1), miss, tube, 0},
             ByHand{"a tangent's start", P(5, 1, 0), P(0, 0, 1), tangent, tube, 0},
             ByHand{"from inside up", P(1, 1, 1), P(0, 1, 0), hit, top, 1},
             ByHand{"from inside down", P(1, 1, 1), P(0, -1, 0), hit, bottom, 3},
             ByHand{"from inside aside", P(-3, 1, 0), P(1, 0, 0), hit, tube, 8},
             ByHand{"from the top up", P(1, 2, 1), P(0, 1, 0), hit, top, 0},
             ByHand{"from the top down", P(1, 2, 1), P(0, -1, 0), hit, top, 0},
             ByHand{"from the tube out", P(5, 0, 0), P(1, 0, 0), hit, tube, 0},
             ByHand{"from the rim along the cap", P(5, 2, 0), P(-1, 0, 0), hit, tube, 0},
             ByHand{"from under it away", P(1, -3, 1), P(0, -1, 0), miss, tube, 0},
             ByHand{"from above it away", P(1, 3, 1), P(1, 0, 1), miss, tube, 0},
             ByHand{"no direction", P(1, 3, 1), P(0, 0, 0), invalid, tube, 0},
         }) {
        SCOPED_TRACE(c.what);
        for (const double scale : {1.0, 0x1p-60, 0x1p60, 0x1p-1000, 0x1p900}) {
            const Ray<double> ray{scaled(c.start, scale), c.direction};
            const CylinderHit given = intersect(ray, Cylinder<double>{P(0, 0, 0), 5 * scale, 4 * scale});
            EXPECT_EQ(given.result, c.result) << scale;
            EXPECT_EQ(given.part, c.part) << scale;
            EXPECT_EQ(given.t, c.t * scale) << scale;
        }
    }
    for (const double wrong : {0.0, -1.0, HUGE_VAL, -HUGE_VAL, static_cast<double>(NAN)}) {
        const Ray<double> ray{P(-9, 1, 0), P(1, 0.125, 0)};
        for (const auto& [radius, height] : {std::pair(wrong, 4.0), {5.0, wrong}}) {
            const Cylinder<double> cylinder{P(0, 0, 0), radius, height};
            EXPECT_EQ(intersect(ray, cylinder).result, CylinderResult::invalid) << radius << ' ' << height;
            EXPECT_EQ(intersect_to_float(ray, cylinder).result, CylinderResult::invalid) << radius << ' ' << height;
        }
    }
    for (const double wrong : {HUGE_VAL, -HUGE_VAL, static_cast<double>(NAN)}) {
        for (const int axis : {0, 1, 2}) {
            Ray<double> from{P(-9, 1, 0), P(1, 0.125, 0)}, along = from;
            from.origin[axis] = along.direction[axis] = wrong;
            Cylinder<double> moved = can;
            moved.center[axis] = wrong;
            EXPECT_EQ(intersect_to_float(from, can).result, CylinderResult::invalid) << axis << wrong;
            EXPECT_EQ(intersect_to_float(along, can).result, CylinderResult::invalid) << axis << wrong;
            EXPECT_EQ(intersect_to_float({P(-9, 1, 0), P(1, 0.125, 0)}, moved).result, CylinderResult::invalid);
        }
    }
}

// 2^-1074 is the smallest double: half this height is none.
TEST(CylinderByHand, HalvesTheSmallestHeight) {
    const Cylinder<double> flat{P(0, 0, 0), 1, 0x1p-1074};
    EXPECT_EQ(intersect(Ray<double>{P(-3, 0, 0), P(1, 0, 0)}, flat).part, CylinderPart::tube);
    EXPECT_EQ(intersect(Ray<double>{P(-3, 0x1p-1074, 0), P(1, 0, 0)}, flat).result, CylinderResult::miss);
    EXPECT_EQ(intersect(Ray<double>{P(0, 0x1p-1074, 0), P(0, -1, 0)}, flat).part, CylinderPart::top);
}

// The ray from (-9, 0, 0) along x meets the tube at t = 4 and, through its own root, a sphere there.
TEST(CylinderByHand, IsOrderedAmongTheOthers) {
    const auto first = [](const Objects& objects) {
        Cast cast;
        cast_ray({P(-9, 0, 0), P(1, 0, 0)}, objects, cast);
        return cast.first.object;
    };
    const auto wall = [](double x) { return Triangle<double>{P(x, -9, -9), P(x, 9, -9), P(x, 0, 9)}; };
    const double nearer = std::nextafter(-5.0, -6), farther = std::nextafter(-5.0, -4);
    EXPECT_EQ(first({{{P(0, 0, 0), 5}}, {}, {can}}), FirstObject::tie);
    EXPECT_EQ(first({{{P(0, 0, 0), std::nextafter(5.0, 6)}}, {}, {can}}), FirstObject(Subject::sphere));
    EXPECT_EQ(first({{{P(0, 0, 0), std::nextafter(5.0, 4)}}, {}, {can}}), FirstObject(Subject::cylinder));
    EXPECT_EQ(first({{}, {wall(-5)}, {can}}), FirstObject::tie);
    EXPECT_EQ(first({{}, {wall(nearer)}, {can}}), FirstObject(Subject::triangle));
    EXPECT_EQ(first({{}, {wall(farther)}, {can}}), FirstObject(Subject::cylinder));
    EXPECT_EQ(first({{}, {}, {can, can}}), FirstObject::tie);
    EXPECT_EQ(first({{}, {}, {can, {P(0x1p-60, 0, 0), 5, 4}}}), FirstObject(Subject::cylinder));
}

}  // namespace
