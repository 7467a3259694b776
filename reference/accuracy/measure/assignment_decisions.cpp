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
    std::vector<CylinderAnswers<Certified>> cylinders;
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

/// The signs that hit_part reads on its way to the true hit, from the caps' and the tube's entrances to their exits.
template <class S>
class CylinderSigns {
  public:
    CylinderSigns(Signs<S>& signs, std::string name, const CylinderEquations<S>& equations,
                  const CylinderEquations<Certified>& truth, Boundary boundary)
        : signs_(signs), name_(std::move(name)), equations_(equations), truth_(truth), boundary_(boundary) {}

    void add() {
        add("a", "whether the ray is parallel to the axis of the " + name_, equations_.tube.a);
        const bool is_upright = sign_of(truth_.tube.a) == 0;
        if (is_upright) {
            add("c", "whether the ray runs within the tube of the " + name_, equations_.tube.c);
            if (sign_of(truth_.tube.c) >= 0) return;
        } else {
            add("d", "whether the ray's line meets the tube of the " + name_ + ", were it endless", equations_.tube.d);
            if (sign_of(truth_.tube.d) < 0) return;
        }
        add("V.y", "whether the ray is parallel to the caps of the " + name_, equations_.top.denominator);
        const bool is_level = sign_of(truth_.top.denominator) == 0;
        if (is_level && !add_level()) return;
        for (const bool enters : {true, false}) {
            if (!is_level && add_cap(enters)) return;
            if (!is_upright && add_tube(enters, is_level)) return;
        }
    }

  private:
    void add(const std::string& what, const std::string& asks, const S& value) {
        signs_.push_back({name_ + ": " + what, asks, sign_of(value), value});
    }
    void add_order(const std::string& one, const std::string& other, const std::string& asks,
                   std::partial_ordering sign) {
        signs_.push_back({fmt::format("order: {}, {}", one, other), asks, sign, std::nullopt});
    }

    /// For a ray parallel to the caps. Returns whether it runs between them.
    bool add_level() {
        add("top cap", "whether the ray runs below the top cap of the " + name_, equations_.top.numerator);
        if (sign_of(truth_.top.numerator) < 0) return false;
        add("bottom cap", "whether the ray runs above the bottom cap of the " + name_, equations_.bottom.numerator);
        return sign_of(truth_.bottom.numerator) <= 0;
    }

    /// Returns whether the cap is the true hit.
    bool add_cap(bool enters) {
        const bool falls = sign_of(truth_.top.denominator) < 0;
        const bool is_top = enters == falls;
        const Fraction<S>& cap = is_top ? equations_.top : equations_.bottom;
        const Fraction<Certified>& true_cap = is_top ? truth_.top : truth_.bottom;
        const std::string which = is_top ? "top cap" : "bottom cap";
        add(which + ", rim", fmt::format("whether the ray meets the {} of the {} within its rim", which, name_),
            value_at(equations_.tube, cap));
        if (!(sign_of(value_at(truth_.tube, true_cap)) < 0)) return false;
        add(which + ", t", fmt::format("whether the {} of the {} lies ahead of the ray's start", which, name_),
            falls ? S(-cap.numerator) : cap.numerator);
        return is_ahead(sign_of(true_cap), boundary_) == true;
    }

    /// Returns whether the root on the tube is the true hit.
    bool add_tube(bool enters, bool is_level) {
        const RootChoice choice = enters ? RootChoice::smaller : RootChoice::larger;
        const std::string where = enters ? "enters" : "leaves";
        if (!is_level) {
            const auto add_side = [&](const Fraction<S>& cap, const std::string& which, const std::string& side) {
                add_order(fmt::format("{}'s {} root", name_, enters ? "smaller" : "larger"), which,
                          fmt::format("whether the ray {} the tube of the {} {} its {}", where, name_, side, which),
                          side_of(equations_.tube, choice, cap));
            };
            add_side(equations_.top, "top cap", "below");
            if (side_of(truth_.tube, choice, truth_.top) > 0) return false;
            add_side(equations_.bottom, "bottom cap", "above");
            if (side_of(truth_.tube, choice, truth_.bottom) < 0) return false;
        }
        add_start();
        return is_ahead(sign_of_root(truth_.tube, choice), boundary_) == true;
    }

    /// For both roots on the tube.
    void add_start() {
        if (tells_start_) return;
        tells_start_ = true;
        add("c", fmt::format("whether the ray starts outside the tube of the {}", name_), equations_.tube.c);
        if (sign_of(truth_.tube.c) >= 0)
            add("b", fmt::format("whether the tube of the {} lies ahead of the ray's start", name_), equations_.tube.b);
    }

    Signs<S>& signs_;
    std::string name_;
    const CylinderEquations<S>& equations_;
    const CylinderEquations<Certified>& truth_;
    Boundary boundary_;
    bool tells_start_ = false;
};

template <class S>
void add_orders(Signs<S>& signs, const std::vector<SphereAnswers<S>>& spheres,
                const std::vector<TriangleAnswers<S>>& triangles, const std::vector<CylinderAnswers<S>>& cylinders,
                const Truth& truth, Boundary boundary) {
    const std::size_t first_sphere = truth.scene.sphere.index;
    const std::size_t first_triangle = truth.scene.triangle.index;
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
    const bool hits_sphere = !spheres.empty() && truth.spheres[first_sphere].t;
    const bool hits_triangle = !triangles.empty() && is_hit(first_triangle);
    if (hits_sphere && hits_triangle) {
        add(sphere(first_sphere), triangle(first_triangle),
            order_of(spheres[first_sphere].quadratic, truth.spheres[first_sphere].choice,
                     triangles[first_triangle].solution));
    }
    if (cylinders.empty()) return;
    const std::size_t first_cylinder = truth.scene.cylinder.index;
    const auto cylinder = [&](std::size_t i) { return name_of("cylinder", i, cylinders.size()); };
    const auto hit_of = [&](std::size_t i) { return hit_parameter(cylinders[i].equations, truth.cylinders[i].part); };
    const auto first = hit_of(first_cylinder);
    if (!first) return;
    for (std::size_t i = 0; i < cylinders.size(); ++i) {
        const auto other = hit_of(i);
        if (i != first_cylinder && other) add(cylinder(first_cylinder), cylinder(i), order_of(*first, *other));
    }
    if (hits_sphere) {
        const HitParameter<S> hit =
            QuadraticRoot<S>{spheres[first_sphere].quadratic, truth.spheres[first_sphere].choice};
        add(sphere(first_sphere), cylinder(first_cylinder), order_of(hit, *first));
    }
    if (hits_triangle) {
        const HitParameter<S> hit = fraction_of(triangles[first_triangle].solution);
        add(triangle(first_triangle), cylinder(first_cylinder), order_of(hit, *first));
    }
}

template <class S>
Signs<S> signs_in(const Scene<S>& scene, const Reading& reading, const Truth& truth) {
    const CameraAnswers<S> camera = answer_camera(scene, reading.convention);
    std::vector<SphereAnswers<S>> spheres;
    std::vector<TriangleAnswers<S>> triangles;
    std::vector<CylinderAnswers<S>> cylinders;
    Signs<S> signs;
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        spheres.push_back(answer_object(camera, scene.spheres[i], reading.boundary));
        add_sphere(signs, name_of("sphere", i, scene.spheres.size()), spheres[i].quadratic, truth.spheres[i].quadratic);
    }
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        triangles.push_back(answer_object(camera, scene.triangles[i], reading.boundary));
        add_triangle(signs, name_of("triangle", i, scene.triangles.size()), triangles[i].solution,
                     truth.triangles[i].solution, truth.surely_missed[i]);
    }
    for (std::size_t i = 0; i < scene.cylinders.size(); ++i) {
        cylinders.push_back(answer_object(camera, scene.cylinders[i], reading.boundary));
        CylinderSigns<S>(signs, name_of("cylinder", i, scene.cylinders.size()), cylinders[i].equations,
                         truth.cylinders[i].equations, reading.boundary)
            .add();
    }
    add_orders(signs, spheres, triangles, cylinders, truth, reading.boundary);
    return signs;
}

Truth truth_of(const Scene<Certified>& scene, const Scene<Interval<float>>& floats, const Reading& reading) {
    const CameraAnswers<Certified> camera = answer_camera(scene, reading.convention);
    const CameraAnswers<Interval<float>> float_camera = answer_camera(floats, reading.convention);
    Truth truth{{}, {}, {}, {}, answer_scene(scene, reading.convention, reading.boundary)};
    for (const Sphere<Certified>& sphere : scene.spheres)
        truth.spheres.push_back(answer_object(camera, sphere, reading.boundary));
    for (const Triangle<Certified>& triangle : scene.triangles)
        truth.triangles.push_back(answer_object(camera, triangle, reading.boundary));
    for (const Cylinder<Certified>& cylinder : scene.cylinders)
        truth.cylinders.push_back(answer_object(camera, cylinder, reading.boundary));
    for (const Triangle<Interval<float>>& triangle : floats.triangles)
        truth.surely_missed.push_back(answer_object(float_camera, triangle, reading.boundary).classification ==
                                      TriangleHit::miss);
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
