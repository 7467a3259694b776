#include "reference/accuracy/methods/cast_methods.h"

namespace reference::accuracy {

std::vector<Method<OrderProblem>> cast_methods() {
    const std::string naive = "the handout's questions 6, 8 and 10, by the textbook's quadratic and Cramer's rule";
    const std::string branch_free = "the quadratic and Cramer's rule without a branch";
    const auto in_own_scalar = [](const auto& c) { return naive_cast(c.ray, c.sphere, c.triangle); };
    const auto without_branch = [](const auto& c) { return branch_free_cast(c.ray, c.sphere, c.triangle); };
    std::vector<Method<OrderProblem>> methods{
        method<float, OrderProblem>({"naive", "float", naive}, in_own_scalar),
        method<double, OrderProblem>({"naive", "double", naive}, in_own_scalar),
        method<float, OrderProblem>({"branch-free", "float", branch_free}, without_branch),
        method<double, OrderProblem>({"branch-free", "double", branch_free}, without_branch)};
    add_certain(methods, "certified", "this project: both decisions exact, and their order", certified_cast);
    return methods;
}

}  // namespace reference::accuracy
