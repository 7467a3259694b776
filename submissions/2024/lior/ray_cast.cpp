// Assignment 6, 2024: lior
#include <cmath>
#include <iostream>

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/string_cast.hpp>

using glm::mat3;
using glm::mat4;
using glm::vec3;
using glm::vec4;

const vec3 eye(6, 1, 0), lookat(0, 1, 0), vup(0, 1, 0);
const float left_ = -2, right_ = 2, bottom_ = -1, top_ = 1, near_ = 2;
const int W = 401, H = 301, pixelX = 200, pixelY = 150;

const vec3 sphereCenter(1, 0, 1);
const float sphereRadius = 2;
const vec3 A(3, -1, -1), B(3, -1, 1), C(1, 3, 0);
const vec3 cylinderCenter(2, 0, 0);
const float cylinderRadius = 1, cylinderHeight = 4;

// The nearest positive hit of the ray S + tV on the cylinder, or a negative number.
float hitCylinder(const vec3& S, const vec3& V, vec3& point, vec3& normal) {
    float best = -1;
    const float top = cylinderCenter.y + cylinderHeight / 2, bottom = cylinderCenter.y - cylinderHeight / 2;
    if (std::fabs(V.y) > 1e-7f) {
        for (int side = 0; side < 2; side++) {
            float t = ((side == 0 ? top : bottom) - S.y) / V.y;
            vec3 p = S + t * V;
            float dx = p.x - cylinderCenter.x, dz = p.z - cylinderCenter.z;
            if (t > 0 && dx * dx + dz * dz < cylinderRadius * cylinderRadius && (best < 0 || t < best)) {
                best = t;
                normal = vec3(0, side == 0 ? 1 : -1, 0);
            }
        }
    }
    float ox = S.x - cylinderCenter.x, oz = S.z - cylinderCenter.z;
    float a = V.x * V.x + V.z * V.z;
    float b = 2 * (ox * V.x + oz * V.z);
    float c = ox * ox + oz * oz - cylinderRadius * cylinderRadius;
    float d = b * b - 4 * a * c;
    if (a > 0 && d >= 0) {
        float t = (-b - std::sqrt(d)) / (2 * a);
        if (t <= 0) t = (-b + std::sqrt(d)) / (2 * a);
        float y = S.y + t * V.y;
        if (t > 0 && y <= top && y >= bottom && (best < 0 || t < best)) {
            best = t;
            vec3 p = S + t * V;
            normal = glm::normalize(vec3(p.x - cylinderCenter.x, 0, p.z - cylinderCenter.z));
        }
    }
    point = S + best * V;
    return best;
}

int main() {
    vec3 P_VCS(left_ + (right_ - left_) * (pixelX + 0.5f) / W, bottom_ + (top_ - bottom_) * (pixelY + 0.5f) / H, -near_);
    vec3 Z = glm::normalize(eye - lookat);
    vec3 X = glm::normalize(glm::cross(vup, Z));
    vec3 Y = glm::cross(Z, X);
    mat4 M(vec4(X, 0), vec4(Y, 0), vec4(Z, 0), vec4(eye, 1));
    vec3 P_WCS = vec3(M * vec4(P_VCS, 1));
    vec3 V = glm::normalize(P_WCS - eye);
    vec3 S = P_WCS;

    vec3 o = S - sphereCenter;
    float a = glm::dot(V, V), b = 2 * glm::dot(V, o), c = glm::dot(o, o) - sphereRadius * sphereRadius;
    float d = b * b - 4 * a * c;
    float tSphere = (-b + std::sqrt(d)) / (2 * a);
    vec3 P_s = S + tSphere * V;
    vec3 N_s = glm::normalize(P_s - sphereCenter);

    mat3 system(-V, B - A, C - A);
    vec3 rhs = S - A;
    vec3 tuv = glm::inverse(system) * rhs;
    vec3 P_t = S + tuv.x * V;
    vec3 N_t = glm::normalize(glm::cross(B - A, C - A));

    vec3 P_c, N_c;
    float tCylinder = hitCylinder(S, V, P_c, N_c);

    std::cout << "=== Question 1: the ray ===\n"
              << "P_VCS = " << glm::to_string(P_VCS) << "\n"
              << "X_vcs = " << glm::to_string(X) << "\n"
              << "Y_vcs = " << glm::to_string(Y) << "\n"
              << "Z_vcs = " << glm::to_string(Z) << "\n"
              << "M_VCS_to_WCS = " << glm::to_string(M) << "\n"
              << "P_WCS = " << glm::to_string(P_WCS) << "\n"
              << "V = " << glm::to_string(V) << "\n";
    std::cout << "=== Question 2: sphere ===\n"
              << "a = " << a << " b = " << b << " c = " << c << " d = " << d << "\n"
              << "t = " << tSphere << "\n"
              << "hit point = " << glm::to_string(P_s) << "\n"
              << "normal = " << glm::to_string(N_s) << "\n";
    std::cout << "=== Question 3: triangle ===\n"
              << "matrix = " << glm::to_string(system) << "\n"
              << "rhs = " << glm::to_string(rhs) << "\n"
              << "t = " << tuv.x << " u = " << tuv.y << " v = " << tuv.z << "\n"
              << "hit point = " << glm::to_string(P_t) << "\n"
              << "normal = " << glm::to_string(N_t) << "\n";
    std::cout << "=== Question 4: cylinder ===\n"
              << "t = " << tCylinder << "\n"
              << "hit point = " << glm::to_string(P_c) << "\n"
              << "normal = " << glm::to_string(N_c) << "\n";
    std::cout << "=== Question 5: first hit ===\n";
    if (tCylinder < tSphere && tCylinder < tuv.x) {
        std::cout << "ray hits cylinder first\n";
    } else if (tSphere < tuv.x) {
        std::cout << "ray hits sphere first\n";
    } else {
        std::cout << "ray hits triangle first\n";
    }
    return 0;
}
