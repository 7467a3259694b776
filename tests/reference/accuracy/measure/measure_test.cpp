// Tests of measure(). No test depends on a measured time.
#include "reference/accuracy/measure/measure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

#include "reference/kernel/sphere.h"
#include "reference/kernel/triangle.h"

namespace reference::accuracy {
namespace {

using testing::HasSubstr;

MeasureOptions few_rays(std::uint64_t rays, std::vector<std::string> kernels = {}) {
    MeasureOptions options;
    options.quick = true;
    options.rays = rays;
    options.kernels = std::move(kernels);
    return options;
}

bool is_lie(const Ray<double>& ray) {
    const double mixed = ray.origin.x + 3 * ray.origin.y + 7 * ray.direction.z + 13 * ray.direction.y;
    return Random(std::bit_cast<std::uint64_t>(mixed)).whole(0, 63) == 0;
}

/// The certified kernel, except for one wrong ray in 64.
Ladder broken_kernels() {
    Ladder ladder;
    ladder.spheres.push_back(method<double, SphereProblem>({"broken", "double", "this test"}, [](const SphereCase& c) {
        const bool hit = reference::kernel::decide(c.ray, c.sphere) != reference::kernel::SphereResult::miss;
        return hit != is_lie(c.ray);
    }));
    ladder.triangles.push_back(
        method<double, TriangleProblem>({"broken", "double", "this test"}, [](const TriangleCase& c) {
            const auto found = reference::kernel::intersect(c.ray, c.triangle);
            return Hit<double>{(found.result == reference::kernel::TriangleResult::hit) != is_lie(c.ray), found.t};
        }));
    return ladder;
}

TEST(Measure, CountsEveryWrongAnswerOfABrokenKernel) {
    constexpr std::uint64_t rays = 8'192;
    const double sigma = std::sqrt(rays / 64.0);
    const Measurement measurement = measure(few_rays(rays), broken_kernels());
    EXPECT_EQ(measurement.rows.size(), 20U);
    for (const Row& row : measurement.rows) {
        EXPECT_EQ(row.rays, rays);
        EXPECT_NEAR(static_cast<double>(row.wrong), rays / 64.0, 4 * sigma) << row.distribution;
        EXPECT_LT(row.wrong_low, row.wrong_per_million);
        EXPECT_LT(row.wrong_per_million, row.wrong_high);
        EXPECT_EQ(row.t_error.has_value(), row.primitive == Primitive::triangle);
    }
}

TEST(Measure, FindsTheCertifiedKernelNeverWrong) {
    const Measurement measurement = measure(few_rays(4'096, {"certified"}));
    EXPECT_EQ(measurement.rows.size(), 4 * 10U + 4 * 10U + 2 * 3U);
    for (const Row& row : measurement.rows) {
        SCOPED_TRACE(row.kernel + ", " + row.distribution);
        EXPECT_TRUE(row.certain);
        EXPECT_EQ(row.wrong, 0U);
        // A quarter of a unit of float, plus the error of a tiny t.
        if (!row.t_error) continue;
        EXPECT_LT(row.t_error->max_ulp, 0.26);
    }
}

TEST(Measure, FindsThatAMethodWithoutProofIsNotCertain) {
    for (const Row& row : measure(few_rays(2'048, {"half-b", "Möller", "Cramer"})).rows) {
        EXPECT_FALSE(row.certain) << row.kernel;
    }
}

/// The formulas as they are taught. On benign rays all are right, and t is as exact as their scalar allows.
TEST(Measure, FindsEveryMethodRightOnBenignRays) {
    for (const Row& row : measure(few_rays(1'024)).rows) {
        if (row.hard) continue;
        SCOPED_TRACE(row.kernel + " " + row.scalar);
        EXPECT_EQ(row.wrong, 0U);
        if (!row.t_error) continue;
        EXPECT_LT(row.t_error->mean_ulp, row.scalar == "float" ? 10 : 1e-7);
    }
}

TEST(Measure, FindsFloatsWrongOrFarOffOnEveryHardDistributionOfSpheres) {
    const Measurement measurement = measure(few_rays(1'024, {"naive quadratic float"}));
    for (const Row& row : measurement.rows) {
        if (!row.hard) continue;
        EXPECT_TRUE(row.wrong > 10 || row.t_error->mean_ulp > 1'000) << row.distribution;
    }
}

std::vector<std::uint64_t> wrong_counts(const Measurement& measurement) {
    std::vector<std::uint64_t> counts;
    for (const Row& row : measurement.rows) counts.push_back(row.wrong);
    return counts;
}

TEST(Measure, GivesTheSameCountsForTheSameSeed) {
    MeasureOptions options = few_rays(512, {"naive", "Möller"});
    const auto counts = wrong_counts(measure(options));
    EXPECT_EQ(wrong_counts(measure(options)), counts);
    options.seed = 2;
    EXPECT_NE(wrong_counts(measure(options)), counts);
}

TEST(Measure, MeasuresOnlyTheRequestedMethods) {
    const Measurement measurement = measure(few_rays(64, {"Haines"}));
    EXPECT_EQ(measurement.rows.size(), 20U);
    for (const Row& row : measurement.rows) EXPECT_EQ(row.kernel, "Haines");
}

TEST(Measure, RefusesAnUnknownMethod) {
    EXPECT_THROW(measure(few_rays(64, {"Haines", "magic"})), std::invalid_argument);
}

TEST(Measure, ReportsItsProgressUpToTheEnd) {
    std::vector<double> told;
    MeasureOptions options = few_rays(64, {"certified"});
    options.progress = [&](double done) { told.push_back(done); };
    measure(options);
    ASSERT_FALSE(told.empty());
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_GE(told.front(), 0);
    EXPECT_EQ(told.back(), 1);
}

TEST(Measure, SaysWhatItWasCompiledWith) {
    const Measurement measurement = measure(few_rays(64, {"Haines float"}));
    EXPECT_THAT(measurement.flags, HasSubstr("-ffp-contract=off"));
    EXPECT_THAT(measurement.compiler, HasSubstr("++ "));
    EXPECT_EQ(measurement.seed, 1U);
}

template <template <class> class Problem>
void expect_unique_names(const std::vector<Method<Problem>>& methods) {
    std::set<std::string> names;
    for (const auto& method : methods) EXPECT_TRUE(names.insert(method.name()).second) << method.name();
}

TEST(Methods, HaveUniqueNamesWithinAPrimitive) {
    expect_unique_names(sphere_methods());
    expect_unique_names(triangle_methods());
    expect_unique_names(cast_methods());
}

}  // namespace
}  // namespace reference::accuracy
