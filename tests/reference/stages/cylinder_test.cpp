// Compares the stages' decisions and values for a cylinder with a second derivation, in exact fractions. The kernel's
// tests do so for the order of a cylinder's hits and other objects'.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>

#include "reference/accuracy/rays/truth.h"
#include "reference/numbers/certified.h"
#include "reference/numbers/interval.h"
#include "reference/stages/decisions.h"
#include "tests/given/cases.h"
#include "tests/reference/stages/cylinder_cases.h"

namespace {

using namespace reference;
namespace rays = reference::accuracy::truth;

constexpr Boundary boundaries[] = {Boundary::positive, Boundary::nonnegative};

/// Numbers of one field.
class Field {
  public:
    Certified operator()(const Rational& x) const { return Certified(FieldNumber(x, basis_)); }
    Vec3<Certified> operator()(const Vec3<Rational>& p) const { return {(*this)(p.x), (*this)(p.y), (*this)(p.z)}; }
    Cylinder<Certified> operator()(const Cylinder<Rational>& cylinder) const {
        return {(*this)(cylinder.center), (*this)(cylinder.radius), (*this)(cylinder.height)};
    }

  private:
    std::shared_ptr<RootBasis> basis_ = std::make_shared<RootBasis>();
};

CameraAnswers<Certified> camera_of(const CylinderCase& scene, const Field& field) {
    CameraAnswers<Certified> camera;
    camera.P_WCS = field(scene.start);
    camera.V = field(scene.direction);
    return camera;
}

rays::Rational exact(const Rational& x) {
    return rays::Rational(x.get_mpq_t());
}
rays::Point exact(const Vec3<Rational>& p) {
    return {exact(p.x), exact(p.y), exact(p.z)};
}

std::optional<rays::CylinderTruth> true_hit(const CylinderCase& scene, Boundary boundary) {
    const auto& [center, radius, height] = scene.cylinder;
    return rays::cylinder(exact(scene.start), exact(scene.direction), {exact(center), exact(radius), exact(height)},
                          boundary);
}

CylinderPart part_of(const std::optional<rays::CylinderTruth>& hit) {
    if (!hit) return CylinderPart::miss;
    switch (hit->part) {
        case kernel::CylinderPart::top: return CylinderPart::top_cap;
        case kernel::CylinderPart::bottom: return CylinderPart::bottom_cap;
        case kernel::CylinderPart::tube: break;
    }
    return hit->is_tangent || hit->t.y < 0 ? CylinderPart::tube_smaller_root : CylinderPart::tube_larger_root;
}

/// How many cases were of each kind, so that a test can see that its cases are hard.
using Counts = std::map<std::string, std::uint64_t>;

std::string text(const Counts& counts) {
    std::string text;
    for (const auto& [what, count] : counts) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", what, count);
    return text;
}

std::string name_of(CylinderPart part) {
    switch (part) {
        case CylinderPart::miss: return "miss";
        case CylinderPart::tube_smaller_root: return "smaller root";
        case CylinderPart::tube_larger_root: return "larger root";
        case CylinderPart::top_cap: return "top cap";
        case CylinderPart::bottom_cap: return "bottom cap";
        case CylinderPart::unsure: return "unsure";
    }
    return "";
}

TEST(Cylinder, IsHitInThePartThatExactFractionsFind) {
    std::uint64_t wrong = 0, decided = 0;
    Counts counts;
    for (std::uint64_t seed = 0; seed < cases(12'000); ++seed) {
        const CylinderCase scene = cylinder_case(seed);
        const Field field;
        CameraAnswers<Certified> camera = camera_of(scene, field);
        // A unit vector has a root in every component.
        if (seed / 60 % 4 == 0) camera.V = normalized(camera.V);
        const auto equations = cylinder_equations(camera.P_WCS, camera.V, field(scene.cylinder));
        for (const Boundary boundary : boundaries) {
            const auto truth = true_hit(scene, boundary);
            const CylinderPart part = hit_part(equations, boundary);
            ++decided;
            ++counts[name_of(part_of(truth))];
            if (truth && truth->is_tangent) ++counts["tangent"];
            if (truth && truth->is_at_rim) ++counts["rim"];
            if (truth && sign(truth->t) == 0) ++counts["start"];
            const bool at_rim = cap_at_rim(equations, part).has_value();
            if (part == part_of(truth) && at_rim == (truth && truth->is_at_rim)) continue;
            ++wrong;
            ADD_FAILURE() << "seed " << seed << ": " << name_of(part) << " for " << name_of(part_of(truth));
        }
    }
    fmt::print("{} decisions, {} wrong: {}\n", decided, wrong, text(counts));
    for (const char* kind : {"miss", "smaller root", "larger root", "top cap", "bottom cap", "tangent", "rim", "start"})
        EXPECT_GT(counts[kind], decided / 100) << kind;
}

bool is_within(const Certified& x, const rays::Surd& truth) {
    const Enclosure enclosure = x.enclosure();
    const auto from = [&](double end) { return rays::sign({truth.x - rays::Rational(end), truth.y, truth.d}); };
    return from(enclosure.lo) >= 0 && from(enclosure.hi) <= 0;
}

TEST(Cylinder, HasTheExactHitPointAndNormal) {
    std::uint64_t hits = 0;
    for (std::uint64_t seed = 0; seed < cases(1'200); ++seed) {
        SCOPED_TRACE(seed);
        const CylinderCase scene = cylinder_case(seed);
        const Field field;
        const auto answers = answer_object(camera_of(scene, field), field(scene.cylinder), Boundary::nonnegative);
        const auto truth = true_hit(scene, Boundary::nonnegative);
        ASSERT_EQ(answers.t.has_value(), truth.has_value());
        if (!truth) continue;
        ++hits;
        EXPECT_TRUE(is_within(*answers.t, truth->t));
        const bool on_tube = truth->part == kernel::CylinderPart::tube;
        for (int i = 0; i < 3; ++i) {
            const auto V = exact(scene.direction[i]);
            const rays::Surd at{exact(scene.start[i]) + V * truth->t.x, V * truth->t.y, truth->t.d};
            EXPECT_TRUE(is_within((*answers.hit)[i], at)) << "hit " << i;
            rays::Surd normal{0};
            const auto R = exact(scene.cylinder.radius);
            if (on_tube && i != 1) normal = {(at.x - exact(scene.cylinder.center[i])) / R, at.y / R, at.d};
            if (!on_tube && i == 1) normal.x = truth->part == kernel::CylinderPart::top ? 1 : -1;
            EXPECT_TRUE(is_within((*answers.normal)[i], normal)) << "normal " << i;
        }
    }
    EXPECT_GT(hits, cases(1'200) / 3);
}

int sign(std::partial_ordering order) {
    return order < 0 ? -1 : order > 0 ? 1 : order == 0 ? 0 : 9;
}

TEST(HitOrder, KnowsTheSameIrrationalRootOfTwoQuadratics) {
    using enum RootChoice;
    const auto quadratic = [](int a, int b, int c) {
        return Quadratic<Certified>{Certified(a), Certified(b), Certified(c), Certified(b * b - 4 * a * c)};
    };
    // t² - 4t + 2 = 0 has the roots 2 ± √2.
    const auto one = quadratic(1, -4, 2), same = quadratic(3, -12, 6), nearly = quadratic(1'000, -4'000, 1'999);
    for (const RootChoice choice : {smaller, larger}) {
        EXPECT_EQ(sign(order_of(QuadraticRoot<Certified>{one, choice}, QuadraticRoot<Certified>{same, choice})), 0);
        EXPECT_EQ(sign(order_of(QuadraticRoot<Certified>{one, smaller}, QuadraticRoot<Certified>{same, larger})), -1);
        EXPECT_EQ(sign(order_of(QuadraticRoot<Certified>{one, choice}, QuadraticRoot<Certified>{nearly, choice})),
                  choice == smaller ? 1 : -1);
    }
}

TEST(Cylinder, IsDecidedByTheDigitsOfARayParallelToItsCaps) {
    // The scene of 2024 with the ray as printed to six decimals: V.y may be above or below 0.
    const auto printed = [](double x) { return Interval<double>(x - 5e-7, x + 5e-7); };
    const auto exact = [](double x) { return Interval<double>(x); };
    const Vec3<Interval<double>> S(printed(4), printed(1), printed(0)), V(printed(-1), printed(0), printed(0));
    const Cylinder<Interval<double>> cylinder{{exact(2), exact(0), exact(0)}, exact(1), exact(4)};
    for (const Boundary boundary : boundaries)
        EXPECT_EQ(hit_part(cylinder_equations(S, V, cylinder), boundary), CylinderPart::tube_smaller_root);
}

TEST(Cylinder, IsNeverDecidedWronglyInIntervals) {
    const auto interval = [](const Rational& x) {
        const Enclosure doubles = enclose(x);
        return Interval<double>(doubles.lo, doubles.hi);
    };
    const auto vec = [&](const Vec3<Rational>& p) {
        return Vec3<Interval<double>>(interval(p.x), interval(p.y), interval(p.z));
    };
    Counts counts;
    for (std::uint64_t seed = 0; seed < cases(12'000); ++seed) {
        const CylinderCase scene = cylinder_case(seed);
        const auto equations =
            cylinder_equations(vec(scene.start), vec(scene.direction),
                               Cylinder<Interval<double>>{vec(scene.cylinder.center), interval(scene.cylinder.radius),
                                                          interval(scene.cylinder.height)});
        for (const Boundary boundary : boundaries) {
            const CylinderPart part = hit_part(equations, boundary);
            ++counts[part == CylinderPart::unsure ? "unsure" : "sure"];
            if (part == CylinderPart::unsure) continue;
            EXPECT_EQ(part, part_of(true_hit(scene, boundary))) << "seed " << seed;
        }
    }
    EXPECT_GT(counts["sure"], counts["unsure"] / 2);
}

}  // namespace
