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

template <class S, class T>
SphereProblem<S> in_scalar(const SphereProblem<T>& c) {
    return {{Vec3<S>(c.ray.origin), Vec3<S>(c.ray.direction)},
            {Vec3<S>(c.sphere.center), static_cast<S>(c.sphere.radius)}};
}
template <class S, class T>
TriangleProblem<S> in_scalar(const TriangleProblem<T>& c) {
    return {{Vec3<S>(c.ray.origin), Vec3<S>(c.ray.direction)},
            {Vec3<S>(c.triangle.A), Vec3<S>(c.triangle.B), Vec3<S>(c.triangle.C)}};
}
template <class S, class T>
OrderProblem<S> in_scalar(const OrderProblem<T>& c) {
    const SphereProblem<S> round = in_scalar<S>(SphereProblem<T>{c.ray, c.sphere});
    return {round.ray, round.sphere, in_scalar<S>(TriangleProblem<T>{c.ray, c.triangle}).triangle};
}

/// `count` cases of a distribution that exists in floats.
template <template <class> class Problem>
Rays<Problem> draw_rays(const Distribution<Problem<double>>& distribution, std::uint64_t seed, std::uint64_t count) {
    Rays<Problem> rays;
    Random seeds(seed);
    for (std::uint64_t i = 0; i < count; ++i) {
        rays.doubles.push_back(distribution.make_in_floats(seeds.bits()));
        rays.floats.push_back(in_scalar<float>(rays.doubles.back()));
    }
    return rays;
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
std::vector<Method<OrderProblem>> cast_methods();

/// All methods, each list in the order of its rows.
struct Ladder {
    std::vector<Method<SphereProblem>> spheres{};
    std::vector<Method<TriangleProblem>> triangles{};
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

/// Adds a formula of a ray and an object, in float and in double.
template <template <class> class Problem, class F>
void add_both(std::vector<Method<Problem>>& methods, const std::string& kernel, const std::string& source, F formula) {
    const auto on = [formula](const auto& problem) { return formula(problem.ray, object_of(problem)); };
    methods.push_back(method<float, Problem>({kernel, "float", source}, on));
    methods.push_back(method<double, Problem>({kernel, "double", source}, on));
}

}  // namespace reference::accuracy
