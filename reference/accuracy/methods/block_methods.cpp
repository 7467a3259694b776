#include "reference/accuracy/methods/block_methods.h"

#include <memory>
#include <type_traits>

#include "reference/accuracy/methods/sphere_methods.h"
#include "reference/accuracy/methods/triangle_methods.h"

namespace reference::accuracy {
namespace {

/// What a loop writes: whether each ray hits, and t where the method gives it. It is reused from run to run.
template <class Result, class T>
struct Written {
    std::vector<Result> hits;
    std::vector<T> t;

    void resize(std::size_t count) {
        hits.resize(count);
        t.resize(count);
    }
};

bool is_hit(int hit) {
    return hit != 0;
}

template <class T, template <class> class Problem>
const Columns<T>& columns_of(const BlockRays<Problem>& rays) {
    if constexpr (std::is_same_v<T, float>) {
        return rays.floats;
    } else {
        return rays.doubles;
    }
}
template <class T>
Sphere<T> object_for(const BlockRays<SphereProblem>& rays) {
    const Sphere<double>& sphere = rays.problems.front().sphere;
    return {Vec3<T>(sphere.center), static_cast<T>(sphere.radius)};
}
template <class T>
Triangle<T> object_for(const BlockRays<TriangleProblem>& rays) {
    const Triangle<double>& triangle = rays.problems.front().triangle;
    return {Vec3<T>(triangle.A), Vec3<T>(triangle.B), Vec3<T>(triangle.C)};
}

/// loop(rays, object, written) fills `written`.
template <class Result, class T, class OfT, template <class> class Problem, class Loop>
BlockMethod<Problem> block_method(Name name, bool gives_t, Certain certain, Loop loop) {
    const auto written = std::make_shared<Written<Result, OfT>>();
    const auto run = [=](const BlockRays<Problem>& rays) {
        written->resize(rays.problems.size());
        loop(columns_of<T>(rays).rays(), object_for<T>(rays), *written);
        keep(*written->hits.data());
        asm volatile("" : : : "memory");
    };
    const auto judge = [=](const BlockRays<Problem>& rays) {
        run(rays);
        std::vector<Answer> answers;
        for (std::size_t i = 0; i < rays.problems.size(); ++i) {
            answers.push_back(gives_t ? as_answer(Hit<double>{is_hit(written->hits[i]), written->t[i]})
                                      : as_answer(is_hit(written->hits[i])));
        }
        return answers;
    };
    return {name.kernel, name.scalar, name.source, gives_t, certain == Certain::yes, judge, run};
}

template <class T, class F, class Object>
[[gnu::always_inline]] inline void fill(const kernel::Rays<T>& rays, const Object& object, F find, int* __restrict hits,
                                        T* __restrict t) {
    const T* const ox = rays.origin[0].data();
    const T* const oy = rays.origin[1].data();
    const T* const oz = rays.origin[2].data();
    const T* const dx = rays.direction[0].data();
    const T* const dy = rays.direction[1].data();
    const T* const dz = rays.direction[2].data();
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const auto found = find(Ray<T>{Vec3<T>(ox[i], oy[i], oz[i]), Vec3<T>(dx[i], dy[i], dz[i])}, object);
        if constexpr (std::is_same_v<std::decay_t<decltype(found)>, bool>) {
            hits[i] = static_cast<int>(found);
        } else {
            hits[i] = static_cast<int>(found.hit);
            t[i] = found.t;
        }
    }
}
template <class T, class F, class Object>
[[gnu::flatten]] void fill_by_any_processor(const kernel::Rays<T>& rays, const Object& object, F find,
                                            int* __restrict hits, T* __restrict t) {
    fill(rays, object, find, hits, t);
}
#if defined(__x86_64__)
template <class T, class F, class Object>
[[gnu::flatten, gnu::target("avx2")]] void fill_by_long_vectors(const kernel::Rays<T>& rays, const Object& object,
                                                                F find, int* __restrict hits, T* __restrict t) {
    fill(rays, object, find, hits, t);
}
#endif

/// A formula in the vectors that the kernel's blocks use. prepare(object) is called once for all rays.
template <class T, template <class> class Problem, class Prepare, class F>
BlockMethod<Problem> formula_in_blocks(Name name, bool gives_t, Prepare prepare, F find) {
    const auto loop = [=](const kernel::Rays<T>& rays, const auto& object, Written<int, T>& written) {
        const auto prepared = prepare(object);
#if defined(__x86_64__)
        if (__builtin_cpu_supports("avx2") != 0) {
            return fill_by_long_vectors(rays, prepared, find, written.hits.data(), written.t.data());
        }
#endif
        fill_by_any_processor(rays, prepared, find, written.hits.data(), written.t.data());
    };
    return block_method<int, T, T, Problem>(std::move(name), gives_t, Certain::no, loop);
}

template <template <class> class Problem, class Prepare, class F>
void add_formula(std::vector<BlockMethod<Problem>>& methods, const std::string& kernel, const std::string& source,
                 bool gives_t, Prepare prepare, F find) {
    methods.push_back(formula_in_blocks<float, Problem>({kernel, "float", source}, gives_t, prepare, find));
    methods.push_back(formula_in_blocks<double, Problem>({kernel, "double", source}, gives_t, prepare, find));
}

template <class Result, class T, template <class> class Problem>
void add_certified(std::vector<BlockMethod<Problem>>& methods, const std::string& scalar) {
    const std::string source = "this project: the error filter in vector instructions, then whole numbers";
    methods.push_back(block_method<Result, T, double, Problem>(
        {"certified decision", scalar, source}, false, Certain::yes,
        [](const kernel::Rays<T>& rays, const auto& object, Written<Result, double>& written) {
            kernel::decide(rays, object, written.hits);
        }));
    methods.push_back(block_method<Result, T, double, Problem>(
        {"certified with t", scalar, source}, true, Certain::yes,
        [](const kernel::Rays<T>& rays, const auto& object, Written<Result, double>& written) {
            kernel::intersect_to_float(rays, object, written.hits, written.t);
        }));
}

template <template <class> class Problem>
void append(BlockRays<Problem>& rays, const Problem<double>& problem) {
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<int>(i);
        for (const auto& [column, x] :
             {std::pair(i, problem.ray.origin[axis]), std::pair(i + 3, problem.ray.direction[axis])}) {
            rays.doubles.numbers[column].push_back(x);
            rays.floats.numbers[column].push_back(static_cast<float>(x));
        }
    }
    rays.problems.push_back(problem);
}

const auto as_it_is = [](const auto& object) { return object; };
const auto for_cramer = []<class T>(const Triangle<T>& triangle) { return CramerTriangle<T>(triangle); };

}  // namespace

BlockRays<SphereProblem> rays_at_a_sphere(std::uint64_t seed, std::uint64_t count) {
    BlockRays<SphereProblem> rays;
    Random seeds(seed);
    const auto benign = sphere_distributions().front();
    const Sphere<double> sphere = benign.make_in_floats(seeds.bits()).sphere;
    for (std::uint64_t i = 0; i < count; ++i) {
        const SphereCase drawn = benign.make_in_floats(seeds.bits());
        // Aimed as at its own sphere, in that sphere's size.
        const double size = sphere.radius / drawn.sphere.radius;
        const P origin = as_float(sphere.center + scaled(P(drawn.ray.origin - drawn.sphere.center), size));
        append(rays, {{origin, drawn.ray.direction}, sphere});
    }
    return rays;
}

BlockRays<TriangleProblem> rays_at_a_triangle(std::uint64_t seed, std::uint64_t count) {
    BlockRays<TriangleProblem> rays;
    Random random(seed, Inputs::floats);
    const Triangle<double> triangle = triangle_distributions().front().make_in_floats(random.bits()).triangle;
    for (std::uint64_t i = 0; i < count; ++i) {
        // As the benign distribution aims: near and beside the triangle.
        const P target = triangle.A + scaled(P(triangle.B - triangle.A), random.between(-0.5, 1.5)) +
                         scaled(P(triangle.C - triangle.A), random.between(-0.5, 1.5));
        const P origin = as_float(target + scaled(random.direction(), 8.0));
        append(rays, {{origin, as_float(P(target - origin))}, triangle});
    }
    return rays;
}

std::vector<BlockMethod<SphereProblem>> sphere_block_methods() {
    std::vector<BlockMethod<SphereProblem>> methods;
    add_formula(methods, "half-b decision", "the textbook's, without t", false, as_it_is,
                [](const auto& ray, const auto& sphere) { return half_b_decision(ray, sphere); });
    add_formula(methods, "half-b branch-free", "Shirley, Black and Hollasch, Ray Tracing in One Weekend, 6.2", true,
                as_it_is, [](const auto& ray, const auto& sphere) { return half_b_branch_free(ray, sphere); });
    add_formula(methods, "stable branch-free", "Press et al., Numerical Recipes, 5.6", true, as_it_is,
                [](const auto& ray, const auto& sphere) { return stable_branch_free(ray, sphere); });
    add_certified<kernel::SphereResult, float>(methods, "float");
    add_certified<kernel::SphereResult, double>(methods, "double");
    return methods;
}

std::vector<BlockMethod<TriangleProblem>> triangle_block_methods() {
    std::vector<BlockMethod<TriangleProblem>> methods;
    add_formula(methods, "Cramer decision", "the textbook's, without t", false, for_cramer,
                [](const auto& ray, const auto& triangle) { return cramer_decision(ray, triangle); });
    add_formula(methods, "Cramer branch-free", "Shirley and Marschner, Fundamentals of Computer Graphics, 4.4.2", true,
                for_cramer, [](const auto& ray, const auto& triangle) { return cramer_branch_free(ray, triangle); });
    add_formula(methods, "Möller-Trumbore branch-free", "Möller and Trumbore (1997)", true, as_it_is,
                [](const auto& ray, const auto& triangle) { return moller_trumbore_branch_free(ray, triangle); });
    add_certified<kernel::TriangleResult, float>(methods, "float");
    add_certified<kernel::TriangleResult, double>(methods, "double");
    return methods;
}

}  // namespace reference::accuracy
