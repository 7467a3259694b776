// Compares every decision and value of the kernel with fractions, on random rays of every distribution. RC_PARAMS sets
// the number of rays, and repeats a failure whose seed RapidCheck printed.
#include <gtest/gtest.h>
// gtest must come first: RapidCheck's printers depend on it.
#include <rapidcheck/gtest.h>

#include <cstdlib>

#include "reference/accuracy/rays/distributions.h"
#include "reference/accuracy/rays/truth.h"
#include "reference/kernel/first.h"
#include "tests/reference/kernel/random_cases.h"

namespace {

namespace accuracy = reference::accuracy;
namespace truth = reference::accuracy::truth;

using namespace reference::kernel;
using reference::FirstObject;
using reference::Subject;

/// Rays per distribution, unless RC_PARAMS says otherwise.
constexpr int rays_of_each_in_ci = 20000;

template <class Case>
class Kernel : public testing::TestWithParam<accuracy::Distribution<Case>> {
  protected:
    template <class Check>
    void check_all(Check check) {
        random_cases::for_seeds(this->GetParam().name, rays_of_each_in_ci,
                                [&](std::uint64_t seed) { check(this->GetParam().make(seed)); });
    }
};

void check_t(double given, const truth::Real& truth) {
    RC_ASSERT(truth::is_within_one_ulp(given, truth));
}

using KernelSphere = Kernel<accuracy::SphereCase>;
TEST_P(KernelSphere, DecidesAsFractionsDo) {
    Cast cast;
    check_all([&](const accuracy::SphereCase& c) {
        cast_ray(c.ray, {{c.sphere}}, cast);
        const truth::SphereTruth truth = truth::sphere(c.ray, c.sphere);
        RC_ASSERT(cast.spheres[0].result == truth.result);
        const bool hit = truth.result != SphereResult::miss;
        RC_ASSERT(cast.first.object == (hit ? FirstObject(Subject::sphere) : FirstObject::no_hit));
        if (hit) check_t(cast.spheres[0].t, truth.t());
    });
}

using KernelTriangle = Kernel<accuracy::TriangleCase>;
TEST_P(KernelTriangle, DecidesAsFractionsDo) {
    Cast cast;
    check_all([&](const accuracy::TriangleCase& c) {
        cast_ray(c.ray, {{}, {c.triangle}}, cast);
        const truth::TriangleTruth truth = truth::triangle(c.ray, c.triangle);
        RC_ASSERT(cast.triangles[0].result == truth.result);
        if (truth.result != TriangleResult::hit) return;
        check_t(cast.triangles[0].t, truth::real(truth.t));
        check_t(cast.triangles[0].u, truth::real(truth.u));
        check_t(cast.triangles[0].v, truth::real(truth.v));
    });
}

FirstObject true_first(const accuracy::OrderCase& c) {
    const truth::SphereTruth sphere = truth::sphere(c.ray, c.sphere);
    const truth::TriangleTruth triangle = truth::triangle(c.ray, c.triangle);
    const bool in_triangle = triangle.result == TriangleResult::hit;
    if (sphere.result == SphereResult::miss) return in_triangle ? FirstObject(Subject::triangle) : FirstObject::no_hit;
    if (!in_triangle) return FirstObject(Subject::sphere);
    const int order = truth::order(sphere, triangle.t);
    if (order == 0) return FirstObject::tie;
    return order < 0 ? FirstObject(Subject::sphere) : FirstObject(Subject::triangle);
}

using KernelOrder = Kernel<accuracy::OrderCase>;
TEST_P(KernelOrder, DecidesAsFractionsDo) {
    Cast cast;
    check_all([&](const accuracy::OrderCase& c) {
        cast_ray(c.ray, {{c.sphere}, {c.triangle}}, cast);
        RC_ASSERT(cast.first.object == true_first(c));
    });
}

/// 1,000 digits suffice to tell unequal numbers apart: numbers of these heights that differ do so in the first 200
/// digits.
First true_first(const accuracy::SpherePairCase& c) {
    const truth::SphereTruth one = truth::sphere(c.ray, c.one);
    const truth::SphereTruth other = truth::sphere(c.ray, c.other);
    if (one.result == SphereResult::miss && other.result == SphereResult::miss) return {FirstObject::no_hit, 0};
    if (one.result == SphereResult::miss) return {FirstObject(Subject::sphere), 1};
    if (other.result == SphereResult::miss) return {FirstObject(Subject::sphere), 0};
    const truth::Real difference = one.t() - other.t();
    if (abs(difference) < truth::Real("1e-900")) return {FirstObject::tie, 0};
    return {FirstObject(Subject::sphere), difference < 0 ? std::size_t{0} : std::size_t{1}};
}

using KernelSpherePair = Kernel<accuracy::SpherePairCase>;
TEST_P(KernelSpherePair, DecidesAsAThousandDigitsDo) {
    Cast cast;
    check_all([&](const accuracy::SpherePairCase& c) {
        cast_ray(c.ray, {{c.one, c.other}}, cast);
        const First truth = true_first(c);
        RC_ASSERT(cast.first.object == truth.object);
        RC_ASSERT(cast.first.index == truth.index);
    });
}

template <class Case>
std::string name_of(const testing::TestParamInfo<accuracy::Distribution<Case>>& info) {
    std::string name;
    for (const char c : info.param.name) name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(, KernelSphere, testing::ValuesIn(accuracy::sphere_distributions()),
                         name_of<accuracy::SphereCase>);
INSTANTIATE_TEST_SUITE_P(, KernelTriangle, testing::ValuesIn(accuracy::triangle_distributions()),
                         name_of<accuracy::TriangleCase>);
INSTANTIATE_TEST_SUITE_P(, KernelOrder, testing::ValuesIn(accuracy::order_distributions()),
                         name_of<accuracy::OrderCase>);
INSTANTIATE_TEST_SUITE_P(, KernelSpherePair, testing::ValuesIn(accuracy::sphere_pair_distributions()),
                         name_of<accuracy::SpherePairCase>);

}  // namespace
