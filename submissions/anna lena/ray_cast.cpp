// Anna Lena, CS770, a6
#ifndef GLM_ENABLE_EXPERIMENTAL
#define GLM_ENABLE_EXPERIMENTAL
#endif
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <cmath>
#include <iomanip>
#include <iostream>

typedef glm::vec3 V3;

std::ostream &operator<<(std::ostream &os, const V3 &v)
{
    return os << "(" << v.x << ", " << v.y << ", " << v.z << ")";
}

V3 barycentric(const glm::mat3 &m, const V3 &r)
{
    // Cramer
    float det = glm::determinant(m);
    V3 x;
    for (int i = 0; i < 3; ++i) {
        glm::mat3 mi = m;
        mi[i] = r;
        x[i] = glm::determinant(mi) / det;
    }
    return x;
}

int main()
{
    std::cout << std::setprecision(3);

    V3 eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0);
    V3 sc(1, 1, 0);
    float R = 2;
    V3 A(0, -2, 2), B(2, 2, 2), C(-2, 2, 2);

    std::cout << "--- Question 1 ---" << std::endl;
    V3 pv(-2 + 4 * (150 + 0.5f) / 301, -1 + 2 * (100 + 0.5f) / 201, -2);
    std::cout << "P_VCS: " << pv << std::endl;

    std::cout << "--- Question 2 ---" << std::endl;
    V3 z = glm::normalize(eye - lookat), x = glm::normalize(glm::cross(vup, z)), y = glm::cross(z, x);
    std::cout << "X_vcs: " << x << std::endl;
    std::cout << "Y_vcs: " << y << std::endl;
    std::cout << "Z_vcs: " << z << std::endl;

    std::cout << "--- Question 3 ---" << std::endl;
    glm::mat4 M = glm::inverse(glm::lookAt(eye, lookat, vup));
    std::cout << "M_VCS_to_WCS: " << glm::to_string(M) << std::endl;

    std::cout << "--- Question 4 ---" << std::endl;
    V3 S(M * glm::vec4(pv, 1));
    std::cout << "P_WCS: " << S << std::endl;

    std::cout << "--- Question 5 ---" << std::endl;
    V3 V = glm::normalize(S - eye);
    std::cout << "V: " << V << std::endl;

    std::cout << "--- Question 6 ---" << std::endl;
    float a = glm::dot(V, V);
    float b = 2 * glm::dot(V, S - sc);
    float c = glm::dot(S - sc, S - sc) - R * R;
    float d = b * b - 4 * a * c;
    float tSphere = (-b - std::sqrt(d)) / (2 * a);
    if (!(tSphere > 0))
        tSphere = (-b + std::sqrt(d)) / (2 * a);
    V3 ps = S + tSphere * V;
    std::cout << "a: " << a << std::endl;
    std::cout << "b: " << b << std::endl;
    std::cout << "c: " << c << std::endl;
    std::cout << "d: " << d << std::endl;
    std::cout << "t: " << tSphere << std::endl;
    std::cout << "hit point: " << ps << std::endl;

    std::cout << "--- Question 7 ---" << std::endl;
    V3 ns = (ps - sc) / R;
    std::cout << "N: " << ns << std::endl;

    std::cout << "--- Question 8 ---" << std::endl;
    glm::mat3 m(-V, B - A, C - A);
    V3 rhs = S - A;
    V3 r = barycentric(m, rhs);
    V3 pt = S + r[0] * V;
    std::cout << "A: " << glm::to_string(m) << std::endl;
    std::cout << "right-hand side: " << rhs << std::endl;
    std::cout << "t: " << r[0] << std::endl;
    std::cout << "u: " << r[1] << std::endl;
    std::cout << "v: " << r[2] << std::endl;
    std::cout << "hit point: " << pt << std::endl;
    // "true hit if t is positive": 0 is not positive
    bool hit = r[0] > 0 && r[1] >= 0 && r[2] >= 0 && r[1] + r[2] <= 1;
    std::cout << "true hit: " << (hit ? "yes" : "no") << std::endl;

    std::cout << "--- Question 9 ---" << std::endl;
    std::cout << "N: " << glm::normalize(glm::cross(B - A, C - A)) << std::endl;

    std::cout << "--- Question 10 ---" << std::endl;
    if (hit && r[0] < tSphere)
        std::cout << "ray hits triangle first" << std::endl;
    else
        std::cout << "ray hits sphere first" << std::endl;
    return 0;
}
