// A method of the ladder: its name and its loops over a block of rays. Each loop is compiled with the method inlined.
#pragma once

#include <cmath>
#include <functional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "reference/accuracy/rays/distributions.h"

namespace reference::accuracy {

/// The same rays in both precisions: every number is a float.
template <template <class> class Problem>
struct Rays {
    std::vector<Problem<float>> floats;
    std::vector<Problem<double>> doubles;
};

inline SphereProblem<float> in_floats(const SphereCase& c) {
    return {kernel::over<float>(c.ray), kernel::over<float>(c.sphere)};
}
inline TriangleProblem<float> in_floats(const TriangleCase& c) {
    return {kernel::over<float>(c.ray), kernel::over<float>(c.triangle)};
}
inline CylinderProblem<float> in_floats(const CylinderCase& c) {
    return {kernel::over<float>(c.ray), kernel::over<float>(c.cylinder)};
}
inline OrderProblem<float> in_floats(const OrderCase& c) {
    return {kernel::over<float>(c.ray), kernel::over<float>(c.sphere), kernel::over<float>(c.triangle)};
}

/// `judge` and `run` call the method once for each of the first `count` rays.
template <template <class> class Problem>
struct Method {
    std::string kernel;
    std::string scalar;
    std::string source;
    bool certain = false;  ///< its decisions are proven to be right
    std::function<std::vector<Answer>(const Rays<Problem>& rays, std::size_t count)> judge{};  ///< returns the answers
    std::function<void(const Rays<Problem>& rays, std::size_t count)> run{};                   ///< to be timed

    std::string name() const { return kernel + " " + scalar; }
};

std::vector<Method<SphereProblem>> sphere_methods();
std::vector<Method<TriangleProblem>> triangle_methods();
std::vector<Method<CylinderProblem>> cylinder_methods();
std::vector<Method<OrderProblem>> cast_methods();

/// All methods, each list in the order of its rows.
struct Ladder {
    std::vector<Method<SphereProblem>> spheres{};
    std::vector<Method<TriangleProblem>> triangles{};
    std::vector<Method<CylinderProblem>> cylinders{};
    std::vector<Method<OrderProblem>> casts{};
};

/// Converts a method's result to a cast's result.
template <class S>
FirstHit<S> as_first_hit(const Hit<S>& found) {
    return {found.hit ? Outcome::hit : Outcome::miss, found.t};
}
template <class S>
FirstHit<S> as_first_hit(const FirstHit<S>& found) {
    return found;
}

template <class Found>
Answer as_answer(const Found& found) {
    const auto first = as_first_hit(found);
    const auto t = static_cast<double>(first.t);
    if (first.outcome == Outcome::miss || !std::isfinite(t)) return {};
    return {first.outcome, t};
}

/// Makes the compiler believe that x is used.
template <class X>
void keep(const X& x) {
    asm volatile("" : : "m"(x));
}

template <class Problem, class F>
std::vector<Answer> answers_of(std::span<const Problem> problems, F method) {
    std::vector<Answer> answers;
    answers.reserve(problems.size());
    for (const Problem& problem : problems) answers.push_back(as_answer(method(problem)));
    return answers;
}

/// Flattened: every function that the method calls is inlined, where its definition is visible.
template <class Problem, class F>
[[gnu::flatten]] void run_flat(std::span<const Problem> problems, F method) {
    for (const Problem& problem : problems) keep(method(problem));
}

template <class T, template <class> class Problem>
std::span<const Problem<T>> first_of(const Rays<Problem>& rays, std::size_t count) {
    if constexpr (std::is_same_v<T, float>) {
        return std::span(rays.floats).first(count);
    } else {
        return std::span(rays.doubles).first(count);
    }
}

enum class Certain { no, yes };

struct Name {
    std::string kernel;
    std::string scalar;
    std::string source;
};

/// `decide` takes a Problem<T> and gives a Hit or a FirstHit.
template <class T, template <class> class Problem, class F>
Method<Problem> method(Name name, F decide, Certain certain = Certain::no) {
    Method<Problem> result{std::move(name.kernel), std::move(name.scalar), std::move(name.source),
                           certain == Certain::yes};
    result.judge = [decide](const Rays<Problem>& rays, std::size_t count) {
        return answers_of(first_of<T>(rays, count), decide);
    };
    result.run = [decide](const Rays<Problem>& rays, std::size_t count) { run_flat(first_of<T>(rays, count), decide); };
    return result;
}

template <class T>
const Sphere<T>& object_of(const SphereProblem<T>& problem) {
    return problem.sphere;
}
template <class T>
const Triangle<T>& object_of(const TriangleProblem<T>& problem) {
    return problem.triangle;
}
template <class T>
const Cylinder<T>& object_of(const CylinderProblem<T>& problem) {
    return problem.cylinder;
}

/// Adds a formula of a ray and an object, in float and in double.
template <template <class> class Problem, class F>
void add_both(std::vector<Method<Problem>>& methods, const std::string& kernel, const std::string& source, F formula) {
    const auto on = [formula](const auto& problem) { return formula(problem.ray, object_of(problem)); };
    methods.push_back(method<float, Problem>({kernel, "float", source}, on));
    methods.push_back(method<double, Problem>({kernel, "double", source}, on));
}

}  // namespace reference::accuracy
