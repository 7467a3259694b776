#include "reference/accuracy/methods/cast_methods.h"
#include "reference/accuracy/methods/method.h"

namespace reference::accuracy {

std::vector<Method<OrderProblem>> cast_methods() {
    const std::string naive = "the handout's questions 6, 8 and 10, by the textbook's quadratic and Cramer's rule";
    const std::string certified = "this project: both decisions exact, and their order";
    const auto in_own_scalar = [](const auto& c) { return naive_cast(c.ray, c.sphere, c.triangle); };
    const auto certify = [](const auto& c) { return certified_cast(c.ray, c.sphere, c.triangle); };
    const std::string branch_free = "the stable quadratic and Cramer's rule without a branch";
    const auto without_branch = [](const auto& c) { return branch_free_cast(c.ray, c.sphere, c.triangle); };
    return {
        method<float, OrderProblem>({"naive", "float", naive}, in_own_scalar),
        method<double, OrderProblem>({"naive", "double", naive}, in_own_scalar),
        method<double, OrderProblem>({"naive", "long double", naive},
                                     [](const OrderCase& c) {
                                         using kernel::over;
                                         using S = long double;
                                         return naive_cast(Ray<S>{over<S>(c.ray.origin), over<S>(c.ray.direction)},
                                                           Sphere<S>{over<S>(c.sphere.center), S{c.sphere.radius}},
                                                           Triangle<S>{over<S>(c.triangle.A), over<S>(c.triangle.B),
                                                                       over<S>(c.triangle.C)});
                                     }),
        method<float, OrderProblem>({"branch-free", "float", branch_free}, without_branch),
        method<double, OrderProblem>({"branch-free", "double", branch_free}, without_branch),
        method<float, OrderProblem>({"certified", "float", certified}, certify, Certain::yes),
        method<double, OrderProblem>({"certified", "double", certified}, certify, Certain::yes),
        method<double, OrderProblem>(
            {"certified to the last place", "double", "this project: every t to one unit in the last place of double"},
            [cast = CertifiedCast()](const OrderCase& c) mutable { return cast(c); }, Certain::yes)};
}

}  // namespace reference::accuracy
