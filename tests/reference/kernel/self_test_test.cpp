#include "reference/kernel/self_test.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <set>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

#include "reference/accuracy/rays/truth.h"

namespace reference::kernel {
namespace {

TEST(SelfTest, FindsNothingWrongWithThisProgram) {
    EXPECT_EQ(arithmetic_trouble(), "");
}

TEST(SelfTest, KnowsTheTrueDecisions) {
    std::uint64_t hash = no_decision;
    std::set<int> of_spheres, of_triangles, of_cylinders, parts;
    for (std::uint64_t seed = 0; seed < self_test_cases; ++seed) {
        const auto [ray, sphere, triangle, cylinder] = narrow_case(seed);
        const int at_sphere = static_cast<int>(accuracy::truth::sphere(ray, sphere).result);
        const int at_triangle = static_cast<int>(accuracy::truth::triangle(ray, triangle).result);
        const auto hit = accuracy::truth::cylinder(ray, cylinder);
        const auto at_cylinder = static_cast<int>(!hit              ? CylinderResult::miss
                                                  : hit->is_tangent ? CylinderResult::tangent
                                                                    : CylinderResult::hit);
        const auto part = static_cast<int>(hit ? hit->part : CylinderPart::tube);
        hash = hashed(hashed(hashed(hashed(hash, at_sphere), at_triangle), at_cylinder), part);
        of_spheres.insert(at_sphere), of_triangles.insert(at_triangle), of_cylinders.insert(at_cylinder);
        parts.insert(part);
    }
    EXPECT_EQ(hash, self_test_hash) << std::hex << hash;
    EXPECT_GE(of_spheres.size(), 2U);
    EXPECT_GE(of_triangles.size(), 2U);
    EXPECT_GE(of_cylinders.size(), 2U);
    EXPECT_GE(parts.size(), 2U);
}

TEST(SelfTest, SeesAnotherRoundingMode) {
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        std::fesetround(mode);
        const std::string trouble = arithmetic_trouble();
        std::fesetround(FE_TONEAREST);
        EXPECT_NE(trouble.find("rounding mode"), std::string::npos) << mode << trouble;
    }
}

#ifdef __SSE2__
TEST(SelfTest, SeesThatSmallNumbersBecomeZero) {
    for (const unsigned flag : {0x8000U, 0x0040U}) {  // of results, of operands
        const unsigned before = _mm_getcsr();
        _mm_setcsr(before | flag);
        const std::string trouble = arithmetic_trouble();
        _mm_setcsr(before);
        EXPECT_NE(trouble.find("become zero"), std::string::npos) << flag << trouble;
    }
}
#endif

}  // namespace
}  // namespace reference::kernel
