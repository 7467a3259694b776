// The ten stages in a row, over any scalar: what a right program computes for a scene.
#pragma once

#include "reference/stages/camera.h"
#include "reference/stages/cylinder.h"
#include "reference/stages/first_hit.h"
#include "reference/stages/sphere.h"
#include "reference/stages/triangle.h"

namespace reference {

/// Questions 1 to 5.
template <class S>
struct CameraAnswers {
    Vec3<S> P_VCS;
    Basis<S> basis;
    Mat4<S> M_VCS_to_WCS;
    Vec3<S> P_WCS;
    Vec3<S> V;
};

/// Questions 6 and 7. t, hit and normal are empty where the ray misses the sphere.
template <class S>
struct SphereAnswers {
    Quadratic<S> quadratic;
    RootChoice choice;
    std::optional<S> t;
    std::optional<Vec3<S>> hit;
    std::optional<Vec3<S>> normal;
};

/// Question 8 and 9. t, u, v and hit solve the linear system, inside the triangle or not; empty where there is no
/// solution.
template <class S>
struct TriangleAnswers {
    LinearSystem<S> system;
    CramerSolution<S> solution;
    TriangleHit classification;
    std::optional<S> t;
    std::optional<S> u;
    std::optional<S> v;
    std::optional<Vec3<S>> hit;
    Vec3<S> normal;
};

/// The cylinder of 2024. t, hit and normal are empty where the ray misses it.
template <class S>
struct CylinderAnswers {
    CylinderEquations<S> equations;
    CylinderPart part;
    std::optional<S> t;
    std::optional<Vec3<S>> hit;
    std::optional<Vec3<S>> normal;
};

template <class S>
CameraAnswers<S> answer_camera(const Scene<S>& scene, PixelConvention convention) {
    const Vec3<S> P_VCS = pixel_to_vcs(scene.window, scene.pixel, convention);
    const Basis<S> basis = view_basis(scene.camera);
    const Mat4<S> M = vcs_to_wcs(basis, scene.camera.eye);
    const Vec3<S> P_WCS = pixel_to_wcs(M, P_VCS);
    return {P_VCS, basis, M, P_WCS, ray_direction(P_WCS, scene.camera.eye)};
}

template <class S>
SphereAnswers<S> answer_sphere(const CameraAnswers<S>& ray, const Sphere<S>& sphere, Boundary boundary) {
    SphereAnswers<S> answers{sphere_quadratic(ray.P_WCS, ray.V, sphere), {}, {}, {}, {}};
    answers.choice = choose_root(answers.quadratic, boundary);
    answers.t = root(answers.quadratic, answers.choice);
    if (answers.t) {
        answers.hit = point_on_ray(ray.P_WCS, ray.V, *answers.t);
        answers.normal = sphere_normal(*answers.hit, sphere.center);
    }
    return answers;
}

template <class S>
TriangleAnswers<S> answer_triangle(const CameraAnswers<S>& ray, const Triangle<S>& triangle) {
    const LinearSystem<S> system = triangle_system(ray.P_WCS, ray.V, triangle);
    const CramerSolution<S> solution = solve_by_cramer(system);
    TriangleAnswers<S> answers{system, solution, classify(solution), {}, {}, {}, {}, triangle_normal(triangle)};
    const auto det = sign_of(solution.det);
    if (det < 0 || det > 0) {
        answers.t = solution.t_numerator / solution.det;
        answers.u = solution.u_numerator / solution.det;
        answers.v = solution.v_numerator / solution.det;
        answers.hit = point_on_ray(ray.P_WCS, ray.V, *answers.t);
    }
    return answers;
}

template <class S>
CylinderAnswers<S> answer_cylinder(const CameraAnswers<S>& ray, const Cylinder<S>& cylinder, Boundary boundary) {
    CylinderAnswers<S> answers{cylinder_equations(ray.P_WCS, ray.V, cylinder), {}, {}, {}, {}};
    answers.part = hit_part(answers.equations, boundary);
    answers.t = cylinder_t(answers.equations, answers.part);
    if (answers.t) {
        answers.hit = point_on_ray(ray.P_WCS, ray.V, *answers.t);
        answers.normal = cylinder_normal(*answers.hit, cylinder.center, answers.part);
    }
    return answers;
}

/// The triangle's t among the hits: empty where the ray does not hit it.
template <class S>
std::optional<S> hit_distance(const TriangleAnswers<S>& answers, Boundary boundary) {
    const bool at_start = answers.classification == TriangleHit::boundary && boundary == Boundary::nonnegative;
    if (answers.classification == TriangleHit::hit || at_start) return answers.t;
    return std::nullopt;
}

}  // namespace reference
