// Every decision and value of the kernel against fractions, on random rays of every distribution. RC_PARAMS sets how
// many, and repeats a failure; RapidCheck prints its seed.
#include <gtest/gtest.h>
// gtest comes first: RapidCheck's printers look for it.
#include <rapidcheck/gtest.h>

#include <cstdlib>

#include "reference/kernel/first.h"
#include "tests/kernel/distributions.h"
#include "tests/kernel/oracle.h"

namespace {

using namespace reference::kernel;

/// Rays per distribution, unless RC_PARAMS says otherwise.
constexpr const char* rays_in_ci = "max_success=20000";

template <class Case>
class Kernel : public testing::TestWithParam<distributions::Distribution<Case>> {
  protected:
    template <class Check>
    void check_all(Check check) {
        setenv("RC_PARAMS", rays_in_ci, 0);
        const auto seeds = rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
        EXPECT_TRUE(rc::check(std::string(this->GetParam().name), [&] { check(this->GetParam().make(*seeds)); }));
    }
};

void check_t(double given, const oracle::Real& truth) {
    RC_ASSERT(oracle::is_within_one_ulp(given, truth));
}

using KernelSphere = Kernel<distributions::SphereCase>;
TEST_P(KernelSphere, DecidesAsFractionsDo) {
    Cast cast;
    check_all([&](const distributions::SphereCase& c) {
        cast_ray(c.ray, {c.sphere}, {}, cast);
        const oracle::SphereTruth truth = oracle::sphere(c.ray, c.sphere);
        RC_ASSERT(cast.spheres[0].result == truth.result);
        const bool hit = truth.result != SphereResult::miss;
        RC_ASSERT(cast.first.kind == (hit ? First::Kind::sphere : First::Kind::none));
        if (hit) check_t(cast.spheres[0].t, truth.t());
    });
}

using KernelTriangle = Kernel<distributions::TriangleCase>;
TEST_P(KernelTriangle, DecidesAsFractionsDo) {
    Cast cast;
    check_all([&](const distributions::TriangleCase& c) {
        cast_ray(c.ray, {}, {c.triangle}, cast);
        const oracle::TriangleTruth truth = oracle::triangle(c.ray, c.triangle);
        RC_ASSERT(cast.triangles[0].result == truth.result);
        if (truth.result != TriangleResult::hit) return;
        check_t(cast.triangles[0].t, oracle::real(truth.t));
        check_t(cast.triangles[0].u, oracle::real(truth.u));
        check_t(cast.triangles[0].v, oracle::real(truth.v));
    });
}

First::Kind true_first(const distributions::OrderCase& c) {
    const oracle::SphereTruth sphere = oracle::sphere(c.ray, c.sphere);
    const oracle::TriangleTruth triangle = oracle::triangle(c.ray, c.triangle);
    const bool in_triangle = triangle.result == TriangleResult::hit;
    if (sphere.result == SphereResult::miss) return in_triangle ? First::Kind::triangle : First::Kind::none;
    if (!in_triangle) return First::Kind::sphere;
    const int order = oracle::order(sphere, triangle.t);
    if (order == 0) return First::Kind::tie;
    return order < 0 ? First::Kind::sphere : First::Kind::triangle;
}

using KernelOrder = Kernel<distributions::OrderCase>;
TEST_P(KernelOrder, DecidesAsFractionsDo) {
    Cast cast;
    check_all([&](const distributions::OrderCase& c) {
        cast_ray(c.ray, {c.sphere}, {c.triangle}, cast);
        RC_ASSERT(cast.first.kind == true_first(c));
    });
}

/// 1,000 digits tell apart what is not equal: numbers of these heights that differ do so in the first 200.
First true_first(const distributions::SpherePairCase& c) {
    const oracle::SphereTruth one = oracle::sphere(c.ray, c.one);
    const oracle::SphereTruth other = oracle::sphere(c.ray, c.other);
    if (one.result == SphereResult::miss && other.result == SphereResult::miss) return {First::Kind::none, 0};
    if (one.result == SphereResult::miss) return {First::Kind::sphere, 1};
    if (other.result == SphereResult::miss) return {First::Kind::sphere, 0};
    const oracle::Real difference = one.t() - other.t();
    if (abs(difference) < oracle::Real("1e-900")) return {First::Kind::tie, 0};
    return {First::Kind::sphere, difference < 0 ? std::size_t{0} : std::size_t{1}};
}

using KernelSpherePair = Kernel<distributions::SpherePairCase>;
TEST_P(KernelSpherePair, DecidesAsAThousandDigitsDo) {
    Cast cast;
    check_all([&](const distributions::SpherePairCase& c) {
        cast_ray(c.ray, {c.one, c.other}, {}, cast);
        const First truth = true_first(c);
        RC_ASSERT(cast.first.kind == truth.kind);
        RC_ASSERT(cast.first.index == truth.index);
    });
}

template <class Case>
std::string name_of(const testing::TestParamInfo<distributions::Distribution<Case>>& info) {
    std::string name;
    for (const char c : info.param.name) name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(, KernelSphere, testing::ValuesIn(distributions::spheres()),
                         name_of<distributions::SphereCase>);
INSTANTIATE_TEST_SUITE_P(, KernelTriangle, testing::ValuesIn(distributions::triangles()),
                         name_of<distributions::TriangleCase>);
INSTANTIATE_TEST_SUITE_P(, KernelOrder, testing::ValuesIn(distributions::orders()), name_of<distributions::OrderCase>);
INSTANTIATE_TEST_SUITE_P(, KernelSpherePair, testing::ValuesIn(distributions::sphere_pairs()),
                         name_of<distributions::SpherePairCase>);

}  // namespace
