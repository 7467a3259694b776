// Assignment 6, 2024: bruno
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

std::ostream& operator<<(std::ostream& out, const vec3& v) {
    return out << "(" << v.x << ", " << v.y << ", " << v.z << ")";
}

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
            normal = glm::normalize(vec3(cylinderCenter.x - p.x, 0, cylinderCenter.z - p.z));
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
    float tSphere = (-b - std::sqrt(d)) / (2 * a);
    vec3 P_s = S + tSphere * V;
    vec3 N_s = glm::normalize(P_s - sphereCenter);

    mat3 system(-V, B - A, C - A);
    vec3 rhs = S - A;
    vec3 tuv = glm::inverse(system) * rhs;
    vec3 P_t = S + tuv.x * V;
    vec3 N_t = glm::normalize(glm::cross(B - A, C - A));

    vec3 P_c, N_c;
    float tCylinder = hitCylinder(S, V, P_c, N_c);

    std::cout << "Question 1\n";
    std::cout << "a) P_VCS = " << P_VCS << "\n";
    std::cout << "b) X = " << X << "\n   Y = " << Y << "\n   Z = " << Z << "\n";
    std::cout << "c) M =\n";
    for (int row = 0; row < 4; row++)
        std::cout << M[0][row] << " " << M[1][row] << " " << M[2][row] << " " << M[3][row] << "\n";
    std::cout << "d) P_WCS = " << P_WCS << "\n";
    std::cout << "e) V = " << V << "\n";
    std::cout << "\nQuestion 2\n";
    std::cout << "a) a = " << a << ", b = " << b << ", c = " << c << "\n";
    std::cout << "b) d = " << d << "\n";
    std::cout << "c) t = " << tSphere << "\n";
    std::cout << "d) P_s = " << P_s << "\n";
    std::cout << "e) N = " << N_s << "\n";
    std::cout << "\nQuestion 3\n";
    std::cout << "a) A =\n";
    for (int row = 0; row < 3; row++)
        std::cout << system[0][row] << " " << system[1][row] << " " << system[2][row] << "\n";
    std::cout << "b) rhs = " << rhs << "\n";
    std::cout << "c) t = " << tuv.x << ", u = " << tuv.y << ", v = " << tuv.z << "\n";
    std::cout << "d) P_t = " << P_t << "\n";
    std::cout << "e) N = " << N_t << "\n";
    std::cout << "\nQuestion 4\n";
    std::cout << "a) t = " << tCylinder << "\n";
    std::cout << "b) P_c = " << P_c << "\n";
    std::cout << "c) N = " << N_c << "\n";
    std::cout << "\nQuestion 5\n";
    if (tCylinder < tSphere && tCylinder < tuv.x) {
        std::cout << "ray hits cylinder first\n";
    } else if (tSphere < tuv.x) {
        std::cout << "ray hits sphere first\n";
    } else {
        std::cout << "ray hits triangle first\n";
    }
    return 0;
}
