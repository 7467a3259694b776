// Computes every sign that decides what the ray hits. One template runs over each scalar type: exactly, in float,
// double and long double, and over intervals, which contain whatever float and double arithmetic might find.
#include <fmt/format.h>

#include "reference/accuracy/measure/assignment_accuracy.h"
#include "reference/accuracy/measure/read_scalar.h"
#include "reference/stages/scene_numbers.h"

namespace reference::accuracy {
namespace {

template <class S>
struct Sign {
    std::string what;
    std::string asks;
    std::partial_ordering sign;
    std::optional<S> value;  ///< empty for an order
};
template <class S>
using Signs = std::vector<Sign<S>>;

/// What the exact run found. It tells which signs are needed.
struct Truth {
    std::vector<SphereAnswers<Certified>> spheres;
    std::vector<TriangleAnswers<Certified>> triangles;
    std::vector<bool> surely_missed;  ///< by triangle: one of its signs makes it a miss in any float arithmetic
    SceneAnswers<Certified> scene;
};

std::string name_of(std::string_view kind, std::size_t index, std::size_t count) {
    return count == 1 ? std::string(kind) : fmt::format("{} {}", kind, index + 1);
}

template <class S>
void add_sphere(Signs<S>& signs, const std::string& name, const Quadratic<S>& quadratic,
                const Quadratic<Certified>& truth) {
    const auto add = [&](const char* letter, const std::string& asks, const S& value) {
        signs.push_back({name + ": " + letter, asks, sign_of(value), value});
    };
    add("d", "whether the ray's line meets the " + name, quadratic.d);
    if (sign_of(truth.d) < 0) return;
    add("c", "whether the ray starts outside the " + name, quadratic.c);
    if (sign_of(truth.c) < 0) return;
    add("b", "whether the " + name + " lies ahead of the ray's start", quadratic.b);
}

template <class S>
void add_triangle(Signs<S>& signs, const std::string& name, const CramerSolution<S>& solution,
                  const CramerSolution<Certified>& truth, bool surely_missed) {
    const auto det = sign_of(solution.det);
    const auto add = [&](const char* letter, const std::string& asks, const S& numerator,
                         const Certified& true_numerator) {
        const bool makes_the_miss = (sign_of(true_numerator) < 0) != (sign_of(truth.det) < 0);
        if (surely_missed && !makes_the_miss) return;
        const S upright = det < 0 ? S(-numerator) : numerator;
        const bool is_known = det < 0 || det > 0;
        signs.push_back({name + ": " + letter, asks, is_known ? sign_of(upright) : std::partial_ordering::unordered,
                         is_known ? std::optional<S>(numerator / solution.det) : std::nullopt});
    };
    if (!surely_missed)
        signs.push_back({name + ": det", "whether the ray is parallel to the " + name + "'s plane", det, solution.det});
    if (sign_of(truth.det) == 0) {
        signs.push_back({name + ": start", "whether the ray starts in the " + name + "'s plane",
                         sign_of(solution.t_numerator), solution.t_numerator});
        return;
    }
    add("t", "whether the " + name + " lies ahead of the ray's start", solution.t_numerator, truth.t_numerator);
    add("u", "on which side of the edge from A to C the ray passes", solution.u_numerator, truth.u_numerator);
    add("v", "on which side of the edge from A to B the ray passes", solution.v_numerator, truth.v_numerator);
    add("1 - u - v", "on which side of the edge from B to C the ray passes",
        solution.det - solution.u_numerator - solution.v_numerator, truth.det - truth.u_numerator - truth.v_numerator);
}

template <class S>
void add_orders(Signs<S>& signs, const std::vector<SphereAnswers<S>>& spheres,
                const std::vector<TriangleAnswers<S>>& triangles, const Truth& truth, Boundary boundary) {
    const std::size_t first_sphere = truth.scene.sphere_index;
    const std::size_t first_triangle = truth.scene.triangle_index;
    const auto add = [&](const std::string& one, const std::string& other, std::partial_ordering order) {
        signs.push_back({"order: " + one + ", " + other, fmt::format("whether {} or {} is hit first", one, other),
                         order, std::nullopt});
    };
    const auto sphere = [&](std::size_t i) { return name_of("sphere", i, spheres.size()); };
    const auto triangle = [&](std::size_t i) { return name_of("triangle", i, triangles.size()); };
    const auto is_hit = [&](std::size_t i) { return hit_distance(truth.triangles[i], boundary).has_value(); };
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        if (i == first_sphere || !truth.spheres[i].t) continue;
        add(sphere(first_sphere), sphere(i),
            order_of(spheres[first_sphere].quadratic, truth.spheres[first_sphere].choice, spheres[i].quadratic,
                     truth.spheres[i].choice));
    }
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (i == first_triangle || !is_hit(i)) continue;
        add(triangle(first_triangle), triangle(i), order_of(triangles[first_triangle].solution, triangles[i].solution));
    }
    if (spheres.empty() || triangles.empty()) return;
    if (!truth.spheres[first_sphere].t || !is_hit(first_triangle)) return;
    add(sphere(first_sphere), triangle(first_triangle),
        order_of(spheres[first_sphere].quadratic, truth.spheres[first_sphere].choice,
                 triangles[first_triangle].solution));
}

template <class S>
Signs<S> signs_in(const Scene<S>& scene, const Reading& reading, const Truth& truth) {
    const CameraAnswers<S> camera = answer_camera(scene, reading.convention);
    std::vector<SphereAnswers<S>> spheres;
    std::vector<TriangleAnswers<S>> triangles;
    Signs<S> signs;
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        spheres.push_back(answer_sphere(camera, scene.spheres[i], reading.boundary));
        add_sphere(signs, name_of("sphere", i, scene.spheres.size()), spheres[i].quadratic, truth.spheres[i].quadratic);
    }
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        triangles.push_back(answer_triangle(camera, scene.triangles[i]));
        add_triangle(signs, name_of("triangle", i, scene.triangles.size()), triangles[i].solution,
                     truth.triangles[i].solution, truth.surely_missed[i]);
    }
    add_orders(signs, spheres, triangles, truth, reading.boundary);
    return signs;
}

Truth truth_of(const Scene<Certified>& scene, const Scene<Interval<float>>& floats, const Reading& reading) {
    const CameraAnswers<Certified> camera = answer_camera(scene, reading.convention);
    const CameraAnswers<Interval<float>> float_camera = answer_camera(floats, reading.convention);
    Truth truth{{}, {}, {}, answer_scene(scene, reading.convention, reading.boundary)};
    for (const Sphere<Certified>& sphere : scene.spheres)
        truth.spheres.push_back(answer_sphere(camera, sphere, reading.boundary));
    for (const Triangle<Certified>& triangle : scene.triangles)
        truth.triangles.push_back(answer_triangle(camera, triangle));
    for (const Triangle<Interval<float>>& triangle : floats.triangles)
        truth.surely_missed.push_back(answer_triangle(float_camera, triangle).classification == TriangleHit::miss);
    return truth;
}

int number_of(std::partial_ordering sign) {
    return sign < 0 ? -1 : sign > 0 ? 1 : 0;
}

template <class S>
void note_wrong(std::vector<Decision>& decisions, const Signs<Certified>& exact, const std::string& scalar,
                const Signs<S>& found) {
    for (std::size_t i = 0; i < decisions.size(); ++i) {
        if (found[i].sign != exact[i].sign) decisions[i].wrong.push_back(scalar);
    }
}

}  // namespace

std::vector<Decision> decisions_of(const Assignment& assignment, const Reading& reading) {
    const auto floats = scene_in<Interval<float>>(assignment);
    const Scene<Certified> scene = certified_scene(rational_scene(assignment.scene));
    const Truth truth = truth_of(scene, floats, reading);
    const Signs<Certified> exact = signs_in(scene, reading, truth);
    const Signs<Interval<float>> float_bounds = signs_in(floats, reading, truth);
    const Signs<Interval<double>> double_bounds = signs_in(scene_in<Interval<double>>(assignment), reading, truth);
    std::vector<Decision> decisions;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const int sign = number_of(exact[i].sign);
        decisions.push_back({exact[i].what,
                             exact[i].asks,
                             sign,
                             exact[i].value ? exact[i].value->enclosure().nearest : sign,
                             float_bounds[i].sign == exact[i].sign,
                             double_bounds[i].sign == exact[i].sign,
                             {}});
    }
    note_wrong(decisions, exact, "float", signs_in(scene_in<float>(assignment), reading, truth));
    note_wrong(decisions, exact, "double", signs_in(scene_in<double>(assignment), reading, truth));
    note_wrong(decisions, exact, "long double", signs_in(scene_in<long double>(assignment), reading, truth));
    return decisions;
}

}  // namespace reference::accuracy
