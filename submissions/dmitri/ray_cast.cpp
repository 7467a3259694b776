#define GLM_ENABLE_EXPERIMENTAL
#include <cmath>
#include <iostream>
#include "glm/glm.hpp"
#include "glm/gtx/string_cast.hpp"

using glm::vec3;
using glm::vec4;

int main() {
    vec3 eye = {0, 0, 4};
    vec3 lookat = {0, 0, 0};
    vec3 vup = {0, 1, 0};

    // Question 1
    vec3 pixel_vcs = {-2.0f + 4.0f * (150.5f / 301.0f), -1.0f + 2.0f * (100.5f / 201.0f), -2.0f};
    std::cout << "Question 1\n" << "P_VCS " << glm::to_string(pixel_vcs) << "\n\n";

    // Question 2: the camera looks along Z
    vec3 z = glm::normalize(lookat - eye);
    vec3 x = glm::normalize(glm::cross(vup, z));
    vec3 y = glm::cross(z, x);
    std::cout << "Question 2\n"
              << "X_vcs " << glm::to_string(x) << "\n"
              << "Y_vcs " << glm::to_string(y) << "\n"
              << "Z_vcs " << glm::to_string(z) << "\n\n";

    // Question 3
    glm::mat4 m(vec4(x, 0), vec4(y, 0), vec4(z, 0), vec4(eye, 1));
    std::cout << "Question 3\n" << "M_VCS_to_WCS " << glm::to_string(m) << "\n\n";

    // Question 4
    vec3 s = vec3(m * vec4(pixel_vcs, 1));
    std::cout << "Question 4\n" << "P_WCS " << glm::to_string(s) << "\n\n";

    // Question 5
    vec3 v = glm::normalize(s - eye);
    std::cout << "Question 5\n" << "V " << glm::to_string(v) << "\n\n";

    // Question 6
    vec3 center = {1, 1, 0};
    float radius = 2;
    vec3 l = s - center;
    float a = glm::dot(v, v);
    float b = 2 * glm::dot(v, l);
    float c = glm::dot(l, l) - radius * radius;
    float d = b * b - 4 * a * c;
    std::cout << "Question 6\n"
              << "a " << a << "\n" << "b " << b << "\n" << "c " << c << "\n" << "d " << d << "\n";
    bool sphereHit = false;
    float ts = 0;
    if (d >= 0) {
        float t1 = (-b - std::sqrt(d)) / (2 * a);
        float t2 = (-b + std::sqrt(d)) / (2 * a);
        if (t1 > 0) { ts = t1; sphereHit = true; }
        else if (t2 > 0) { ts = t2; sphereHit = true; }
    }
    vec3 ps;
    if (sphereHit) {
        ps = s + ts * v;
        std::cout << "t " << ts << "\n" << "hit point " << glm::to_string(ps) << "\n\n";
    } else {
        std::cout << "t: none, no positive root\n" << "hit point: none, the ray misses the sphere\n\n";
    }

    // Question 7
    std::cout << "Question 7\n";
    if (sphereHit) std::cout << "N " << glm::to_string(glm::normalize(ps - center)) << "\n\n";
    else std::cout << "N: none, the ray misses the sphere\n\n";

    // Question 8
    vec3 A = {0, -2, 2}, B = {2, 2, 2}, C = {-2, 2, 2};
    glm::mat3 mat(-v, B - A, C - A);
    vec3 rhs = s - A;
    vec3 sol = glm::inverse(mat) * rhs;
    vec3 pt = s + sol.x * v;
    std::cout << "Question 8\n"
              << "A " << glm::to_string(mat) << "\n"
              << "rhs " << glm::to_string(rhs) << "\n"
              << "t " << sol.x << "\n" << "u " << sol.y << "\n" << "v " << sol.z << "\n"
              << "hit point " << glm::to_string(pt) << "\n\n";
    bool triangleHit = sol.x >= 0 && sol.y >= 0 && sol.z >= 0 && sol.y + sol.z <= 1;

    // Question 9
    std::cout << "Question 9\n" << "N " << glm::to_string(glm::normalize(glm::cross(B - A, C - A))) << "\n\n";

    // Question 10
    std::cout << "Question 10\n";
    if (triangleHit && (!sphereHit || sol.x < ts)) std::cout << "ray hits triangle first\n";
    else if (sphereHit) std::cout << "ray hits sphere first\n";
    else std::cout << "ray hits neither the sphere nor the triangle\n";
    return 0;
}
