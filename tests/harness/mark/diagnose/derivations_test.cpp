#include "harness/mark/diagnose/derivations.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "harness/mark/compare/key_targets.h"
#include "tests/given/printed_values.h"
#include "tests/given/student/scenes.h"

namespace harness {
namespace {

constexpr ItemId X = reference::item::X_vcs, Y = reference::item::Y_vcs, Z = reference::item::Z_vcs,
                 M = reference::item::M_VCS_to_WCS, P_VCS = reference::item::P_VCS, P_WCS = reference::item::P_WCS,
                 V = reference::item::V;
constexpr ItemId a = reference::item::sphere::a, b = reference::item::sphere::b, c = reference::item::sphere::c,
                 d = reference::item::sphere::d, t_s = reference::item::sphere::t, hit_s = reference::item::sphere::hit,
                 normal_s = reference::item::sphere::normal;
constexpr ItemId matrix = reference::item::triangle::matrix, rhs = reference::item::triangle::rhs,
                 t_t = reference::item::triangle::t, u = reference::item::triangle::u, v = reference::item::triangle::v,
                 hit_t = reference::item::triangle::hit;

class Derivations : public testing::Test {
  protected:
    explicit Derivations(std::string_view name = "handout")
        : marking(student::scene_named(name)),
          scene(real_scene(marking.assignment, marking.key.canonical)),
          known(keys_by_convention(marking.key, marking.assignment.rubric).front()) {}

    void print(const ItemId& id, std::string_view text) {
        known.set(id, printed_target(printed_item(id, text), Digits::as_printed));
    }

    std::vector<Target> results(const ItemId& id, QuadraticForm form = QuadraticForm::full) const {
        std::vector<Target> all;
        for (const Derivation& derivation : all_derivations()) {
            if (derivation.item != id) continue;
            for (const Target& target : derivation.compute(known, scene, form)) all.push_back(target);
        }
        return all;
    }

    bool gives(const ItemId& id, std::string_view text, QuadraticForm form = QuadraticForm::full) const {
        const auto all = results(id, form);
        return std::any_of(all.begin(), all.end(), [&](const Target& target) {
            return compare(printed_item(id, text), target, 1e-6, 2).within;
        });
    }

    /// Whether every result is unbounded, i.e. unknown.
    bool gives_nothing(const ItemId& id) const {
        const auto all = results(id);
        return std::all_of(all.begin(), all.end(), [](const Target& target) {
            return !target.no_value && std::any_of(target.components.begin(), target.components.end(),
                                                   [](const Interval& x) { return !x.is_bounded(); });
        });
    }

    student::Marking marking;
    IntervalScene scene;
    ItemTargets known;
};

bool holds(const Target& target, const Target& key) {
    if (target.no_value || key.no_value) return target.no_value == key.no_value;
    if (target.components.size() != key.components.size()) return false;
    for (std::size_t i = 0; i < key.components.size(); ++i) {
        if (target.components[i].lo() > key.components[i].hi() + 1e-9 ||
            target.components[i].hi() < key.components[i].lo() - 1e-9)
            return false;
    }
    return true;
}

TEST(DerivationsOfAll, ReproduceTheKeyFromTheKey) {
    std::set<ItemId> derived;
    for (const std::string_view name :
         {"handout", "tube and bottom", "top and tube", "bottom and tube", "in the cylinder", "cylinder missed"}) {
        const student::Marking marking = student::scene_named(name);
        const IntervalScene scene = real_scene(marking.assignment, marking.key.canonical);
        const ItemTargets known = keys_by_convention(marking.key, marking.assignment.rubric).front();
        for (const Derivation& derivation : all_derivations()) {
            const auto key = known.targets().find(derivation.item);
            if (key == known.targets().end()) continue;
            const ItemId hit{derivation.item.subject, "hit"};
            const bool is_of_a_miss = derivation.item.name == "t" && std::ranges::count(derivation.inputs, hit) > 0;
            if (is_of_a_miss) continue;
            derived.insert(derivation.item);
            const std::string item =
                fmt::format("{}.{} of '{}'", reference::to_string(derivation.item.subject), derivation.item.name, name);
            const auto targets = derivation.compute(known, scene, QuadraticForm::full);
            ASSERT_FALSE(targets.empty()) << item;
            EXPECT_TRUE(std::ranges::any_of(targets, [&](const Target& t) { return holds(t, key->second); })) << item;
        }
    }
    EXPECT_EQ(derived.size(), 26U) << "all but P_VCS, Z_vcs and the verdict, which depend on the scene alone";
}

TEST_F(Derivations, GiveTheRootForTheStudentsOwnCoefficients) {
    print(c, "0");
    print(d, "16");
    EXPECT_TRUE(gives(t_s, "4"));
    EXPECT_TRUE(gives(t_s, "0")) << "t = 0 counts where the rubric says either";
}

TEST_F(Derivations, GiveTheRootForHalfB) {
    print(b, "-2");
    print(d, "2");
    EXPECT_TRUE(gives(t_s, "0.585786", QuadraticForm::half_b));
    EXPECT_FALSE(gives(t_s, "0.585786", QuadraticForm::full));
}

TEST_F(Derivations, GiveTheDiscriminantOfEitherForm) {
    print(b, "-2");
    print(c, "3");
    EXPECT_TRUE(gives(d, "1", QuadraticForm::half_b));
    EXPECT_TRUE(gives(d, "-8", QuadraticForm::full));
    EXPECT_FALSE(gives(d, "-8", QuadraticForm::half_b));
}

TEST_F(Derivations, GiveTheRootWhereAIsNegative) {
    // -t^2 + 4t + 2 = 0 has the roots 2 + √6 and 2 - √6.
    print(a, "-1");
    print(b, "4");
    print(c, "2");
    print(d, "24");
    EXPECT_TRUE(gives(t_s, "4.449490"));
    EXPECT_FALSE(gives(t_s, "none"));
}

TEST_F(Derivations, GiveTheDiscriminantWhereAIsZero) {
    print(a, "0");
    print(b, "3");
    EXPECT_TRUE(gives(d, "9"));
    print(b, "0");
    EXPECT_FALSE(gives(d, "0")) << "a program gets no marks for printing zeros";
}

TEST_F(Derivations, GiveNoHitForANegativeDiscriminant) {
    print(d, "-1");
    EXPECT_TRUE(gives(t_s, "none"));
    EXPECT_FALSE(gives(t_s, "nan"));
}

TEST_F(Derivations, LeaveOpenWhatADiscriminantOfZeroDigitsMeans) {
    print(d, "-0.000001");
    EXPECT_TRUE(gives(t_s, "none"));
    print(b, "-4");
    print(d, "0.000000");
    EXPECT_TRUE(gives(t_s, "2"));
}

TEST_F(Derivations, GiveNoPointAndNoNormalWithoutAHit) {
    known.set(t_s, no_value());
    EXPECT_TRUE(gives(hit_s, "none"));
    known.set(hit_s, no_value());
    EXPECT_TRUE(gives(normal_s, "none"));
}

TEST_F(Derivations, AllowNoPointWhereTIsNegative) {
    print(t_s, "1.5");
    EXPECT_FALSE(gives(hit_s, "none"));
    print(t_s, "-1.5");
    EXPECT_TRUE(gives(hit_s, "none"));
}

TEST_F(Derivations, AllowNoPointOnlyOutsideTheTriangle) {
    print(t_t, "1.5");
    EXPECT_FALSE(gives(hit_t, "none"));
    print(u, "-0.5");
    EXPECT_TRUE(gives(hit_t, "none"));
}

TEST_F(Derivations, FollowTheRubricsBoundaryIfTIsZero) {
    EXPECT_TRUE(gives(hit_t, "none")) << "either";
    scene.boundaries = {reference::Boundary::nonnegative};
    EXPECT_FALSE(gives(hit_t, "none"));
    scene.boundaries = {reference::Boundary::positive};
    EXPECT_TRUE(gives(hit_t, "none"));
}

TEST_F(Derivations, GiveNothingForADirectionWithoutLength) {
    for (const char* zero : {"0 0 0", "0.000000 0.000000 0.000000", "-0.00 0.00 0.00"}) {
        print(V, zero);
        EXPECT_TRUE(results(a).empty()) << zero;
        EXPECT_TRUE(results(b).empty()) << zero;
        EXPECT_TRUE(results(matrix).empty()) << zero;
    }
}

TEST_F(Derivations, GiveNoValueForASingularSystem) {
    print(matrix, "0 0 0 0 0 0 0 0 0");
    known.set(V, no_value());
    EXPECT_TRUE(results(t_t).front().no_value);
    print(matrix, "1 2 3 1 2 3 0 0 1");
    EXPECT_TRUE(results(u).front().no_value);
}

TEST_F(Derivations, GiveNothingForANormalAtTheCentre) {
    print(hit_s, "1 1 0");
    EXPECT_TRUE(gives_nothing(normal_s));
    print(hit_s, "1.000000 1.000000 0.000000");
    EXPECT_TRUE(gives_nothing(normal_s));
    EXPECT_FALSE(gives(normal_s, "0 0 0"));
}

TEST_F(Derivations, GiveNothingForAxesThatAreAllZeroOrParallel) {
    print(X, "0 0 0");
    EXPECT_FALSE(gives(Y, "0 0 0"));
    EXPECT_FALSE(results(M).empty()) << "Y and Z span a plane";
    print(Y, "0 0 0");
    EXPECT_TRUE(results(M).empty());
    for (const ItemId& axis : {X, Y, Z}) print(axis, "1 1 1");
    EXPECT_TRUE(results(M).empty());
}

TEST_F(Derivations, GiveNothingForASingularMatrix) {
    print(M, "0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0");
    EXPECT_FALSE(gives(P_WCS, "0 0 0"));
}

TEST_F(Derivations, GiveNothingForAVanishingQuadratic) {
    print(a, "0");
    print(b, "0");
    print(c, "0");
    EXPECT_TRUE(results(d).empty());
    EXPECT_TRUE(results(t_s).empty());
    print(a, "1");
    EXPECT_FALSE(gives(d, "0")) << "0 would follow from two zeros";
}

TEST_F(Derivations, AllowBothReadingsOfAMatrixWithAnUnusualLastRow) {
    print(M, "1 0 0 0 0 1 0 0 0 0 1 1 0 0 0 1");  // transposed: w is z + 1
    print(P_VCS, "0.5 0 -3");
    EXPECT_TRUE(gives(P_WCS, "0.5 0 -3"));
    EXPECT_TRUE(gives(P_WCS, "-0.25 0 1.5")) << "divided by w";
}

namespace tube = reference::item::cylinder;

class DerivationsOfATop : public Derivations {
  protected:
    DerivationsOfATop() : Derivations("top and tube") {}
};

TEST_F(DerivationsOfATop, GiveTheNormalOfThePartThatTheHitIsOn) {
    EXPECT_TRUE(gives(tube::normal, "0 1 0"));
    EXPECT_FALSE(gives(tube::normal, "0.268063 0 0.963401")) << "the tube's";
    print(tube::hit, "2.500000 -1.000000 0.600000");
    EXPECT_TRUE(gives(tube::normal, "1 0 0"));
    EXPECT_FALSE(gives(tube::normal, "0 1 0"));
    print(tube::hit, "1.200000 -2.500000 0.600000");
    EXPECT_TRUE(gives(tube::normal, "0 -1 0"));
}

TEST_F(DerivationsOfATop, GiveTheTubesAndTheNearerCapsNormalForAPointInside) {
    print(tube::hit, "1.700000 0.000000 0.600000");
    EXPECT_TRUE(gives(tube::normal, "1 0 0"));
    EXPECT_TRUE(gives(tube::normal, "0 1 0"));
    EXPECT_FALSE(gives(tube::normal, "0 -1 0"));
}

class DerivationsPassingAbove : public Derivations {
  protected:
    DerivationsPassingAbove() : Derivations("passed above") {}
};

TEST_F(DerivationsPassingAbove, GiveTheHitsOfATubeWithWrongCoefficients) {
    // With this d the ray meets the tube above the top at t = 0.443910, and at 6.200297 between the caps' planes. The
    // plane of the top is met at 5.956214, which is inside the wrong tube, but not nearer to the axis than the radius.
    EXPECT_TRUE(gives(tube::t, "none"));
    EXPECT_FALSE(gives(tube::t, "6.200000"));
    print(tube::d, "26.940000");
    EXPECT_TRUE(gives(tube::t, "6.200297")) << "by a program that tries both roots";
    EXPECT_TRUE(gives(tube::t, "none")) << "by a program that tries the smallest positive root";
    EXPECT_TRUE(gives(tube::t, "5.956214")) << "by a program that bounds the caps with its own quadratic";
    EXPECT_FALSE(gives(tube::t, "0.443910")) << "above the top";
}

class DerivationsBelowTheRim : public Derivations {
  protected:
    DerivationsBelowTheRim() : Derivations("below the rim") {}
};

TEST_F(DerivationsBelowTheRim, GiveAMissIfOnlyTheSmallerRootIsTried) {
    // With this d the ray meets the tube above the top at t = 1.963800, and at 4.680407 between the caps' planes.
    EXPECT_TRUE(gives(tube::t, "2.375694"));
    print(tube::d, "6.000000");
    EXPECT_TRUE(gives(tube::t, "4.680407")) << "by a program that tries both roots";
    EXPECT_TRUE(gives(tube::t, "none")) << "by a program that tries the smallest positive root";
}

TEST(IntervalScene, ListsTheObjectOfTheQuestionsFirst) {
    const student::Marking marking = student::marking_of(student::camera_on_the_axis(8) + R"(
[[sphere]]
center = [0, 0, -9]
radius = 1
[[sphere]]
center = [0, 0, 0]
radius = 2
)",
                                                         "two");
    EXPECT_EQ(real_scene(marking.assignment, marking.key.canonical).spheres.front().radius.lo(), 2.0);
}

}  // namespace
}  // namespace harness
