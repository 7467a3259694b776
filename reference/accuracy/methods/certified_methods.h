// The methods of this project's kernel, which are never wrong, for any object that it knows.
#pragma once

#include "reference/accuracy/methods/method.h"
#include "reference/kernel/sphere.h"
#include "reference/kernel/triangle.h"

namespace reference::accuracy {

template <template <class> class Problem>
void add_certified(std::vector<Method<Problem>>& methods) {
    methods.push_back(method<double, Problem>(
        {"exact without a filter", "double", "this project: whole numbers for every ray"},
        [](const auto& c) { return kernel::is_hit(kernel::decide_exactly(c.ray, object_of(c))); }, Certain::yes));
    add_both(
        methods, "certified decision", "this project: an error filter, then whole numbers",
        [](const auto& ray, const auto& object) { return kernel::is_hit(kernel::decide(ray, object)); }, Certain::yes);
    add_both(
        methods, "certified with t", "this project: t to 2^-26, a quarter of a unit in the last place of float",
        [](const auto& ray, const auto& object) {
            const auto found = kernel::intersect_to_float(ray, object);
            return Hit<double>{kernel::is_hit(found.result), found.t};
        },
        Certain::yes);
    methods.push_back(method<double, Problem>(
        {"certified to the last place", "double", "this project: t to one unit in the last place of double"},
        [](const auto& c) {
            const auto found = kernel::intersect(c.ray, object_of(c));
            return Hit<double>{kernel::is_hit(found.result), found.t};
        },
        Certain::yes));
}

}  // namespace reference::accuracy
