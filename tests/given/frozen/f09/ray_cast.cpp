// ray_cast.cpp: all computations in double precision, Cramer's rule for
// the triangle (I wanted to see the determinants).
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <cmath>
#include <iostream>

using glm::dvec3;
using glm::dvec4;
using glm::dmat3;
using glm::dmat4;
using glm::to_string;

namespace scene {
const dvec3 center{1, 1, 0};
const double R = 2;
const dvec3 A{0, -2, 2};
const dvec3 B{2, 2, 2};
const dvec3 C{-2, 2, 2};
}

namespace camera {
const dvec3 eye{0, 0, 4};
const dvec3 lookat{0, 0, 0};
const dvec3 vup{0, 1, 0};
const double left = -2, right = 2, bottom = -1, top = 1, near = 2;
const int W = 301, H = 201;
}

int main() {
    using namespace scene;
    using namespace camera;
    auto& o = std::cout;

    double x = 150, y = 100;
    dvec3 pVcs{left + x / (W - 1) * (right - left), bottom + y / (H - 1) * (top - bottom), -near};
    o << "Question 1 (P_VCS):\n" << to_string(pVcs) << "\n\n";

    dvec3 Z = glm::normalize(eye - lookat);
    dvec3 X = glm::normalize(glm::cross(vup, Z));
    dvec3 Y = glm::normalize(glm::cross(Z, X));
    o << "Question 2 (X_vcs, Y_vcs, Z_vcs):\n"
      << to_string(X) << "\n" << to_string(Y) << "\n" << to_string(Z) << "\n\n";

    dmat4 M = glm::inverse(glm::lookAt(eye, lookat, vup));
    o << "Question 3 (M_VCS_to_WCS):\n" << to_string(M) << "\n"
      << "note: glm is column-major, each pair of inner parentheses is a column\n\n";

    dvec4 pWcs = M * dvec4(pVcs, 1);
    o << "Question 4 (P_WCS):\n" << to_string(pWcs) << "\n\n";

    dvec3 S(pWcs);
    dvec3 V = glm::normalize(S - eye);
    o << "Question 5 (V):\n" << to_string(V) << "\n\n";

    dvec3 SC = S - center;
    double a = glm::dot(V, V);
    double b = 2 * glm::dot(V, SC);
    double c = glm::dot(SC, SC) - R * R;
    double d = b * b - 4 * a * c;
    double ts = (-b - std::sqrt(d)) / (2 * a);
    if (ts <= 0) ts = (-b + std::sqrt(d)) / (2 * a);
    dvec3 Ps = S + ts * V;
    o << "Question 6 (a, b, c, d, t, hit point):\n"
      << a << "\n" << b << "\n" << c << "\n" << d << "\n" << ts << "\n" << to_string(Ps) << "\n\n";

    o << "Question 7 (normal of the sphere):\n" << to_string(glm::normalize(Ps - center)) << "\n\n";

    dvec3 e1 = B - A, e2 = C - A, rhs = S - A;
    dmat3 K(-V, e1, e2);
    double det = glm::determinant(K);
    double t = glm::determinant(dmat3(rhs, e1, e2)) / det;
    double u = glm::determinant(dmat3(-V, rhs, e2)) / det;
    double v = glm::determinant(dmat3(-V, e1, rhs)) / det;
    dvec3 Pt = S + t * V;
    o << "Question 8 (matrix, right-hand side, t, u, v, hit point):\n"
      << to_string(K) << "\n" << to_string(rhs) << "\n"
      << t << "\n" << u << "\n" << v << "\n" << to_string(Pt) << "\n"
      << "note: the determinant of the matrix is " << det << "\n\n";

    o << "Question 9 (normal of the triangle):\n" << to_string(glm::normalize(glm::cross(e1, e2))) << "\n\n";

    o << "Question 10:\n" << (t < ts ? "ray hits triangle first" : "ray hits sphere first") << "\n";
}
