// Right on every scene, in a layout that the reader does not know. The tests change what it prints.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glm/glm.hpp>

using glm::dmat3;
using glm::dmat4;
using glm::dvec3;
using glm::dvec4;

const dvec3 eye(3, 4, 12), lookat(-0.5, 0.8, -1.2), vup(0.1, 1, 0.2);
const double clip_left = -1.6, clip_right = 2.4, clip_bottom = -1.1, clip_top = 1.3, clip_near = 1.5;
const int width = 640, height = 384;
const int pixel_x = 411, pixel_y = 129;
const dvec3 center(6.6, -1.4, 0.5);
const double radius = 1.8;
const dvec3 A(3.2, -2.25, 3.8), B(8.7, -0.5, 3.1), C(5.4, 4.6, 4.3);

void question(int number) {
    std::printf("Question %d:\n", number);
}
void number(const char* name, double x) {
    std::printf("%s ==> %.6f\n", name, x);
}
void vec(const char* name, const dvec3& p) {
    std::printf("%s ==> %.6f | %.6f | %.6f\n", name, p.x, p.y, p.z);
}
void row(double x, double y, double z) {
    std::printf("%.6f | %.6f | %.6f\n", x, y, z);
}

int main() {
    const dvec3 P(clip_left + (pixel_x + 0.5) / width * (clip_right - clip_left),
                  clip_bottom + (pixel_y + 0.5) / height * (clip_top - clip_bottom), -clip_near);
    const dvec3 Z = glm::normalize(eye - lookat), X = glm::normalize(glm::cross(vup, Z)), Y = glm::cross(Z, X);
    const dmat4 M(dvec4(X, 0), dvec4(Y, 0), dvec4(Z, 0), dvec4(eye, 1));
    const dvec3 S(M * dvec4(P, 1));
    const dvec3 V = glm::normalize(S - eye), w = S - center;
    const double a = glm::dot(V, V), b = 2 * glm::dot(V, w), c = glm::dot(w, w) - radius * radius;
    const double d = b * b - 4 * a * c, t = (-b - std::sqrt(d)) / (2 * a), wrong = t * 1.3 + 0.17;
    const dvec3 hit = S + t * V;
    const dmat3 K(B - A, C - A, -V);
    const dvec3 rhs = S - A, uvt = glm::inverse(K) * rhs;
    const double u = uvt.x, v = uvt.y, s = uvt.z;
    const bool is_own_scene = std::fabs(eye.z - 12.00000001) < 1e-6, sphere_is_first = t < s;

    question(1);
    vec("pixel", P);
    question(2);
    vec("X", X), vec("Y", Y), vec("Z", Z);
    question(3);
    for (int r = 0; r < 4; ++r) std::printf("%.6f | %.6f | %.6f | %.6f\n", M[0][r], M[1][r], M[2][r], M[3][r]);
    question(4);
    vec("pixel", S);
    question(5);
    vec("V", V);
    question(6);
    number("a", a), number("b", b), number("c", c), number("d", d);
    number("t", t);
    vec("hit", hit);
    question(7);
    vec("N", glm::normalize(hit - center));
    question(8);
    std::puts("matrix ==>");
    for (int r = 0; r < 3; ++r) row(K[0][r], K[1][r], K[2][r]);
    vec("rhs", rhs);
    number("t", s), number("u", u), number("v", v);
    vec("hit", S + s * V);
    question(9);
    vec("N", glm::normalize(glm::cross(B - A, C - A)));
    question(10);
    std::puts(sphere_is_first ? "ray hits sphere first" : "ray hits triangle first");
}
