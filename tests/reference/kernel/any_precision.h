// Draws random cases in floats or doubles and checks each.
#pragma once

#include <gtest/gtest.h>
// gtest must come first: RapidCheck's printers depend on it.
#include <rapidcheck/detail/Configuration.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>

#include "reference/kernel/ray.h"

namespace any_precision {

using reference::Sphere;
using reference::Triangle;
using reference::Vec3;
using reference::kernel::Ray;

/// Checks as many seeds, unless RC_PARAMS says how many. RapidCheck reads that variable once for the whole program, so
/// no test may set it.
template <class Check>
void for_seeds(std::string_view name, int rays, Check check) {
    rc::detail::TestParams params = rc::detail::configuration().testParams;
    if (std::getenv("RC_PARAMS") == nullptr) params.maxSuccess = rays;
    const auto seeds = rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
    rc::detail::TestMetadata metadata;
    metadata.description = std::string(name);
    const auto result = rc::detail::checkTestable([&] { check(*seeds); }, metadata, params);
    std::ostringstream told;
    rc::detail::printResultMessage(result, told);
    EXPECT_TRUE(result.template is<rc::detail::SuccessResult>()) << name << told.str();
    if (std::getenv("RC_PARAMS") == nullptr) {
        EXPECT_EQ(result.template get<rc::detail::SuccessResult>().numSuccess, rays) << name;
    }
}
// Never inlined: where g++ 12 sees two doubles at a time converted to float and back, it omits the rounding.
#define ROUNDED __attribute__((noinline))
template <class T>
ROUNDED Ray<T> ray_of(const Ray<double>& ray) {
    return {Vec3<T>(ray.origin), Vec3<T>(ray.direction)};
}
template <class T>
ROUNDED Sphere<T> object_of(const Sphere<double>& sphere) {
    return {Vec3<T>(sphere.center), static_cast<T>(sphere.radius)};
}
template <class T>
ROUNDED Triangle<T> object_of(const Triangle<double>& triangle) {
    return {Vec3<T>(triangle.A), Vec3<T>(triangle.B), Vec3<T>(triangle.C)};
}

}  // namespace any_precision
