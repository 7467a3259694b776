// CS 870 Assignment 6: ray casting (edge scene)
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <iostream>

using glm::mat3;
using glm::mat4;
using glm::to_string;
using glm::vec3;
using glm::vec4;
using std::cout;

int main() {
    vec3 center(1, 0, 1);
    float R = 2;
    vec3 A(3, 0, -1), B(3, 0, 1), C(1, 3, 2);
    vec3 eye(6, 1, 0), lookat(0, 1, 0), vup(0, 1, 0);
    float l = -2, r = 2, b = -1, t = 1, n = 2;
    int W = 301, H = 201;
    float xd = 150, yd = 100;

    cout << "Consider a pixel with P_DCS = (x_DCS y_DCS) = (150 100).\n\n";

    cout << "Question 1: Transform the pixel P_DCS from DCS (device coordinates) to VCS. Obtain P_VCS, and print it.\n";
    vec3 P_VCS(l + (r - l) * (xd + 0.5f) / W, b + (t - b) * (yd + 0.5f) / H, -n);
    cout << to_string(P_VCS) << "\n\n";

    cout << "Question 2: Obtain the three basis vectors of the VCS system, X_vcs , Y_vcs , and Z_vcs , and print them, "
            "on separate lines.\n";
    vec3 Z = glm::normalize(eye - lookat);
    vec3 X = glm::normalize(glm::cross(vup, Z));
    vec3 Y = glm::cross(Z, X);
    cout << to_string(X) << "\n" << to_string(Y) << "\n" << to_string(Z) << "\n\n";

    cout << "Question 3: Compute M_VCS_to_WCS, the inverse of the view matrix, and print it.\n";
    mat4 M = glm::inverse(glm::lookAt(eye, lookat, vup));
    cout << to_string(M) << "\n\n";

    cout << "Question 4: Use this matrix to obtain P_WCS, the pixel's world coordinates, and print it.\n";
    vec4 P_WCS = M * vec4(P_VCS, 1);
    cout << to_string(P_WCS) << "\n\n";

    cout << "Question 5: Obtain a unit-length vector V in the direction from the eye to the pixel, and print it.\n";
    vec3 S(P_WCS);
    vec3 V = glm::normalize(S - eye);
    cout << to_string(V) << "\n\n";

    cout << "Question 6: You now have a ray P = S + tV, where S is P_WCS. Compute the point P_s where the ray hits the "
            "sphere.\n"
            "The sphere's equation is (P - C).(P - C) = R^2. If there are 2 positive roots, pick the smaller one.\n";
    vec3 D = S - center;
    float qa = glm::dot(V, V), qb = 2 * glm::dot(V, D), qc = glm::dot(D, D) - R * R;
    float d = qb * qb - 4 * qa * qc;
    float ts = (-qb - std::sqrt(d)) / (2 * qa);
    if (ts <= 0) ts = (-qb + std::sqrt(d)) / (2 * qa);
    vec3 Ps = S + ts * V;
    cout << "the quadratic's coefficients, a, b, c: " << qa << ", " << qb << ", " << qc << "\n";
    cout << "the discriminant d: " << d << "\n";
    cout << "the ray parameter t: " << ts << "\n";
    cout << "the hit point: " << to_string(Ps) << "\n\n";

    cout << "Question 7: Get the surface normal at the hit point: N = P_s - C. Normalize this vector, and print it.\n";
    vec3 Ns = glm::normalize(Ps - center);
    cout << to_string(Ns) << "\n\n";

    cout << "Question 8: Now compute the point P_t where the ray hits the triangle.\n"
            "A + u(B-A) + v(C-A) = S + tV. The barycentric coordinates must obey 0 <= u <= 1, 0 <= v <= 1, u+v <= 1\n";
    mat3 m(-V, B - A, C - A);
    vec3 rhs = S - A;
    vec3 x = glm::inverse(m) * rhs;
    vec3 Pt = S + x[0] * V;
    cout << "The matrix A: " << to_string(m) << "\n";
    cout << "the right-hand side of the matrix equation: " << to_string(rhs) << "\n";
    cout << "the values of t, u, and v: " << x[0] << ", " << x[1] << ", " << x[2] << "\n";
    cout << "the hit point: " << to_string(Pt) << "\n\n";

    cout << "Question 9: Get the surface normal of the triangle: N = (B-A)x(C-A). Normalize this vector, and print "
            "it.\n";
    cout << to_string(glm::normalize(glm::cross(B - A, C - A))) << "\n\n";

    cout << "Question 10: Choose the point with smaller t. Print one of: ray hits triangle first / ray hits sphere "
            "first\n";
    cout << (x[0] < ts ? "ray hits triangle first\n" : "ray hits sphere first\n");
}
