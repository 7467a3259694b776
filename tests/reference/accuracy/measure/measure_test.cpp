// Tests of measure(). No test depends on a measured time.
#include "reference/accuracy/measure/measure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

#include "reference/kernel/cylinder.h"
#include "reference/kernel/sphere.h"
#include "reference/kernel/triangle.h"

namespace reference::accuracy {
namespace {

using testing::HasSubstr;

MeasureOptions few_rays(std::uint64_t rays) {
    MeasureOptions options;
    options.quick = true;
    options.rays = rays;
    return options;
}

/// The methods whose names hold one of these words.
Ladder only(const std::vector<std::string>& words) {
    Ladder ladder{sphere_methods(), triangle_methods(), cylinder_methods(), cast_methods()};
    const auto is_other = [&](const auto& method) {
        return std::ranges::none_of(
            words, [&](const std::string& word) { return method.name().find(word) != std::string::npos; });
    };
    std::erase_if(ladder.spheres, is_other);
    std::erase_if(ladder.triangles, is_other);
    std::erase_if(ladder.cylinders, is_other);
    std::erase_if(ladder.casts, is_other);
    return ladder;
}

bool is_lie(const Ray<double>& ray) {
    const double mixed = ray.origin.x + 3 * ray.origin.y + 7 * ray.direction.z + 13 * ray.direction.y;
    return Random(std::bit_cast<std::uint64_t>(mixed)).whole(0, 63) == 0;
}

/// The certified kernel, except for one wrong ray in 64.
Ladder broken_kernels() {
    Ladder ladder;
    ladder.spheres.push_back(method<double, SphereProblem>({"broken", "double", "this test"}, [](const SphereCase& c) {
        const auto found = reference::kernel::intersect(c.ray, c.sphere);
        return Hit<double>{(found.result != reference::kernel::SphereResult::miss) != is_lie(c.ray), found.t};
    }));
    ladder.triangles.push_back(
        method<double, TriangleProblem>({"broken", "double", "this test"}, [](const TriangleCase& c) {
            const auto found = reference::kernel::intersect(c.ray, c.triangle);
            return Hit<double>{(found.result == reference::kernel::TriangleResult::hit) != is_lie(c.ray), found.t};
        }));
    ladder.cylinders.push_back(
        method<double, CylinderProblem>({"broken", "double", "this test"}, [](const CylinderCase& c) {
            const auto found = reference::kernel::intersect(c.ray, c.cylinder);
            return Hit<double>{is_hit(found.result) != is_lie(c.ray), found.t};
        }));
    return ladder;
}

TEST(Measure, CountsEveryWrongAnswerOfABrokenKernel) {
    constexpr std::uint64_t rays = 4'096;
    const double sigma = std::sqrt(rays / 64.0);
    const Measurement measurement = measure(few_rays(rays), broken_kernels());
    EXPECT_EQ(measurement.rows.size(), 27U);
    for (const Row& row : measurement.rows) {
        EXPECT_EQ(row.rays, rays);
        EXPECT_NEAR(static_cast<double>(row.wrong), rays / 64.0, 4 * sigma) << row.distribution;
        EXPECT_LT(row.wrong_low, row.wrong_per_million);
        EXPECT_LT(row.wrong_per_million, row.wrong_high);
    }
}

TEST(Measure, FindsTheCertifiedKernelNeverWrong) {
    const Measurement measurement = measure(few_rays(4'096), only({"certified"}));
    EXPECT_EQ(measurement.rows.size(), 10U + 10U + 7U + 3U);
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
    for (const Row& row : measure(few_rays(2'048), only({"half-b", "Möller", "Cramer"})).rows) {
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

TEST(Measure, FindsFloatsWrongOrFarOffOnEveryHardDistributionOfRoundObjects) {
    const Measurement measurement = measure(few_rays(1'024), only({"naive quadratic float", "textbook float"}));
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
    MeasureOptions options = few_rays(512);
    const Ladder some = only({"naive", "Möller"});
    const auto counts = wrong_counts(measure(options, some));
    EXPECT_EQ(wrong_counts(measure(options, some)), counts);
    options.seed = 2;
    EXPECT_NE(wrong_counts(measure(options, some)), counts);
}

TEST(Measure, TimesAKeyInEachPrecision) {
    const Assignment assignment = load_assignment("a6-2021", RAYGRADE_ASSIGNMENTS);
    MeasureOptions options = few_rays(64);
    options.assignment = &assignment;
    for (const Quartiles& ms : measure(options, {}).key_ms) {
        EXPECT_GT(ms.low, 0);
        EXPECT_LE(ms.low, ms.median);
        EXPECT_LE(ms.median, ms.high);
    }
    EXPECT_EQ(measure(few_rays(64), {}).key_ms.front().median, 0);
}

TEST(Measure, ReportsItsProgressUpToTheEnd) {
    std::vector<double> told;
    MeasureOptions options = few_rays(64);
    options.progress = [&](double done) { told.push_back(done); };
    measure(options, only({"certified"}));
    ASSERT_FALSE(told.empty());
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_GE(told.front(), 0);
    EXPECT_EQ(told.back(), 1);
}

TEST(Measure, SaysWhatItWasCompiledWith) {
    const Measurement measurement = measure(few_rays(64), only({"Haines float"}));
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
    expect_unique_names(cylinder_methods());
    expect_unique_names(cast_methods());
}

}  // namespace
}  // namespace reference::accuracy
