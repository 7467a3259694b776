// Draws random cases in floats or doubles and checks each.
#pragma once

#include <gtest/gtest.h>
// gtest must come first: RapidCheck's printers depend on it.
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <string>
#include <string_view>

#include "reference/kernel/ray.h"

namespace any_precision {

using reference::Sphere;
using reference::Triangle;
using reference::Vec3;
using reference::kernel::Ray;

template <class Check>
void for_seeds(std::string_view name, const char* rays, Check check) {
    setenv("RC_PARAMS", rays, 0);
    const auto seeds = rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
    EXPECT_TRUE(rc::check(std::string(name), [&] { check(*seeds); }));
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
