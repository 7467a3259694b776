// The methods of this project's kernel, which are never wrong, for any object that it knows.
#pragma once

#include "reference/accuracy/methods/method.h"
#include "reference/kernel/sphere.h"
#include "reference/kernel/triangle.h"

namespace reference::accuracy {

/// Adds a method that computes in doubles, for the same rays in float and in double.
template <template <class> class Problem, class F>
void add_certain(std::vector<Method<Problem>>& methods, const std::string& kernel, const std::string& source,
                 F decide) {
    const auto on = [decide](const auto& problem) { return decide(in_scalar<double>(problem)); };
    methods.push_back(method<float, Problem>({kernel, "float", source}, on, Certain::yes));
    methods.push_back(method<double, Problem>({kernel, "double", source}, decide, Certain::yes));
}

template <template <class> class Problem>
void add_certified(std::vector<Method<Problem>>& methods) {
    add_certain(methods, "certified decision", "this project: an error filter, then whole numbers",
                [](const Problem<double>& c) { return kernel::is_hit(kernel::decide(c.ray, object_of(c))); });
    add_certain(methods, "certified with t", "this project: t to 2^-26, a quarter of a unit in the last place of float",
                [](const Problem<double>& c) {
                    const auto found = kernel::intersect_to_float(c.ray, object_of(c));
                    return Hit<double>{kernel::is_hit(found.result), found.t};
                });
}

}  // namespace reference::accuracy
