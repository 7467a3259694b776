// How the ray meets the scene, in words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reference/stages/scene_answers.h"

namespace reference {

/// A decision is empty if the scene has no such object. With several spheres, `sphere` is about the sphere that the ray
/// hits first, or about the first in the file if it hits none; likewise for triangles and cylinders.
struct Decisions {
    std::string sphere;               ///< hit, miss, tangent, boundary (the ray starts on the sphere) or unsure
    std::string triangle;             ///< hit, miss, boundary (t = 0), coplanar or unsure
    std::string cylinder;             ///< hit, miss, tangent (to the tube), boundary (the ray starts on it) or unsure
    std::string first;                ///< sphere, triangle, cylinder, tie, none or unsure
    std::vector<std::string> policy;  ///< "boundary" and "pixel convention" where an answer depends on them
};

template <class S>
std::string_view sphere_decision(const SphereAnswers<S>& sphere) {
    switch (sphere.choice) {
        case RootChoice::miss: return "miss";
        case RootChoice::smaller:
        case RootChoice::larger: break;
        case RootChoice::unsure: return "unsure";
    }
    if (sign_of(sphere.quadratic.d) == 0) return "tangent";
    return sign_of(sphere.quadratic.c) == 0 ? "boundary" : "hit";
}

template <class S>
std::string_view cylinder_decision(const CylinderAnswers<S>& cylinder) {
    if (cylinder.part == CylinderPart::unsure) return "unsure";
    if (cylinder.part == CylinderPart::miss) return "miss";
    const bool is_on_tube = tube_root(cylinder.part) != RootChoice::miss;
    if (is_on_tube && sign_of(cylinder.equations.tube.d) == 0) return "tangent";
    return starts_on(cylinder.equations) ? "boundary" : "hit";
}

inline std::string_view triangle_decision(TriangleHit hit) {
    switch (hit) {
        case TriangleHit::hit: return "hit";
        case TriangleHit::boundary: return "boundary";
        case TriangleHit::miss: return "miss";
        case TriangleHit::parallel: return "miss";
        case TriangleHit::coplanar: return "coplanar";
        case TriangleHit::unsure: return "unsure";
    }
    return "";
}

inline std::string_view first_decision(std::optional<Verdict> verdict) {
    if (!verdict) return "unsure";
    switch (*verdict) {
        case Verdict::sphere_first: return "sphere";
        case Verdict::triangle_first: return "triangle";
        case Verdict::cylinder_first: return "cylinder";
        case Verdict::tie: return "tie";
        case Verdict::no_hit: return "none";
    }
    return "";
}

/// The decisions under the boundary that the answers were made with.
template <class S>
Decisions decisions_of(const SceneAnswers<S>& answers) {
    Decisions decisions;
    if (answers.sphere) decisions.sphere = sphere_decision(*answers.sphere);
    if (answers.triangle) decisions.triangle = triangle_decision(answers.triangle->classification);
    if (answers.cylinder) decisions.cylinder = cylinder_decision(*answers.cylinder);
    if (answers.sphere || answers.triangle || answers.cylinder) decisions.first = first_decision(answers.verdict);
    return decisions;
}

}  // namespace reference
