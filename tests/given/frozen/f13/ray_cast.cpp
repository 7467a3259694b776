// A6: intersect one ray with a sphere and a triangle
#include <iostream>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/string_cast.hpp>

using namespace std;
using glm::vec3; using glm::vec4; using glm::mat3; using glm::mat4;

const float INF = 1e30f;

float sphereHit(vec3 S, vec3 V, vec3 C, float R)
{
    float a = glm::dot(V, V);
    float b = 2 * glm::dot(V, S - C);
    float c = glm::dot(S - C, S - C) - R * R;
    float disc = b * b - 4 * a * c;
    cout << "Quadratic: " << a << " t^2 + " << b << " t + " << c << " = 0" << endl;
    cout << "Coefficient a: " << a << endl;
    cout << "Coefficient b: " << b << endl;
    cout << "Coefficient c: " << c << endl;
    cout << "Discriminant d: " << disc << endl;
    if (disc < 0)
        return INF;
    float lo = (-b - sqrt(disc)) / (2 * a);
    float hi = (-b + sqrt(disc)) / (2 * a);
    cout << "debug: roots " << lo << " and " << hi << endl;
    if (lo > 0) return lo;
    if (hi > 0) return hi;
    return INF;
}

float triangleHit(vec3 S, vec3 V, vec3 A, vec3 B, vec3 C)
{
    mat3 M = mat3(-1.0f * V, B - A, C - A);
    vec3 rhs = S - A;
    vec3 sol = glm::inverse(M) * rhs;
    float t = sol.x, u = sol.y, v = sol.z;
    cout << "Matrix A: " << glm::to_string(M) << endl;
    cout << "RHS: " << glm::to_string(rhs) << endl;
    cout << "Parameter t: " << t << endl;
    cout << "Barycentric u: " << u << endl;
    cout << "Barycentric v: " << v << endl;
    cout << "Hit point P_t: " << glm::to_string(S + t * V) << endl;
    bool inside = 0 <= u && u <= 1 && 0 <= v && v <= 1 && u + v <= 1;
    cout << "Check 0 <= u <= 1, 0 <= v <= 1, u + v <= 1: " << (inside ? "ok" : "failed") << endl;
    cout << "Check t > 0: " << (t > 0 ? "ok" : "failed, the triangle lies in the image plane") << endl;
    return inside && t > 0 ? t : INF;
}

int main()
{
    vec3 eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0);
    vec3 center(1, 1, 0);
    vec3 A(0, -2, 2), B(2, 2, 2), C(-2, 2, 2);
    float clip[5] = { -2, 2, -1, 1, 2 };  // left right bottom top near

    vec3 pix(clip[0] + 150 * (clip[1] - clip[0]) / 300, clip[2] + 100 * (clip[3] - clip[2]) / 200, -clip[4]);
    cout << "Question 1 answer" << endl << "Pixel in VCS: " << glm::to_string(pix) << endl;

    vec3 Z = glm::normalize(eye - lookat), X = glm::normalize(glm::cross(vup, Z)), Y = glm::cross(Z, X);
    cout << "Question 2 answer" << endl;
    cout << "X axis of VCS: " << glm::to_string(X) << endl;
    cout << "Y axis of VCS: " << glm::to_string(Y) << endl;
    cout << "Z axis of VCS: " << glm::to_string(Z) << endl;

    mat4 view = glm::lookAt(eye, lookat, vup);
    mat4 inv = glm::inverse(view);
    cout << "Question 3 answer" << endl << "Inverse of view matrix: " << glm::to_string(inv) << endl;

    vec3 S = vec3(inv * vec4(pix, 1));
    cout << "Question 4 answer" << endl << "Pixel in WCS: " << glm::to_string(S) << endl;

    vec3 V = glm::normalize(S - eye);
    cout << "Question 5 answer" << endl << "Unit vector V: " << glm::to_string(V) << endl;

    cout << "Question 6 answer" << endl;
    float ts = sphereHit(S, V, center, 2);
    vec3 Ps = S + ts * V;
    cout << "Parameter t: " << ts << endl;
    cout << "Hit point P_s: " << glm::to_string(Ps) << endl;

    cout << "Question 7 answer" << endl;
    cout << "Normal of sphere: " << glm::to_string(glm::normalize(Ps - center)) << endl;

    cout << "Question 8 answer" << endl;
    float tt = triangleHit(S, V, A, B, C);

    cout << "Question 9 answer" << endl;
    cout << "Normal of triangle: " << glm::to_string(glm::normalize(glm::cross(B - A, C - A))) << endl;

    cout << "Question 10 answer" << endl;
    cout << (tt < ts ? "ray hits triangle first" : "ray hits sphere first") << endl;
    return 0;
}
