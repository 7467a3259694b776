/*
 * ray_cast.cpp
 * Assignment 6
 */
#include <cmath>
#include <iostream>
#include <string>
#include "glm/glm.hpp"
#include "glm/gtc/matrix_transform.hpp"

static void printVec(const std::string& name, const glm::vec3& v)
{
    std::cout << "   " << name << " = (" << v.x << ", " << v.y << ", " << v.z << ")" << std::endl;
}

static void printMat(const std::string& name, const glm::mat4& m)
{
    std::cout << "   " << name << " =" << std::endl;
    for (int r = 0; r < 4; ++r) {
        std::cout << "      [" << m[0][r] << ", " << m[1][r] << ", " << m[2][r] << ", " << m[3][r] << "]" << std::endl;
    }
}

static void printMat3(const std::string& name, const glm::mat3& m)
{
    std::cout << "   " << name << " =" << std::endl;
    for (int r = 0; r < 3; ++r) {
        std::cout << "      [" << m[0][r] << ", " << m[1][r] << ", " << m[2][r] << "]" << std::endl;
    }
}

static void printNum(const std::string& name, float x)
{
    std::cout << "   " << name << " = " << x << std::endl;
}

int main()
{
    glm::vec3 sphereCenter(1.f, 1.f, 0.f);
    float sphereRadius = 2.f;
    glm::vec3 A(0.f, -2.f, 2.f), B(2.f, 2.f, 2.f), C(-2.f, 2.f, 2.f);
    glm::vec3 eye(0.f, 0.f, 4.f), lookat(0.f, 0.f, 0.f), vup(0.f, 1.f, 0.f);
    float l = -2.f, r = 2.f, b = -1.f, t = 1.f, n = 2.f;
    float W = 301.f, H = 201.f;
    float x = 150.f, y = 100.f;

    std::cout << "1)" << std::endl;
    glm::vec3 pv((r - l) * x / (W - 1) + l, (t - b) * y / (H - 1) + b, -n);
    printVec("P_VCS", pv);

    std::cout << "2)" << std::endl;
    glm::vec3 zAxis = glm::normalize(eye - lookat);
    glm::vec3 xAxis = glm::normalize(glm::cross(vup, zAxis));
    glm::vec3 yAxis = glm::normalize(glm::cross(zAxis, xAxis));
    printVec("X_vcs", xAxis);
    printVec("Y_vcs", yAxis);
    printVec("Z_vcs", zAxis);

    std::cout << "3)" << std::endl;
    glm::mat4 toWorld = glm::inverse(glm::lookAt(eye, lookat, vup));
    printMat("M_VCS_to_WCS", toWorld);

    std::cout << "4)" << std::endl;
    glm::vec3 pw = glm::vec3(toWorld * glm::vec4(pv, 1.f));
    printVec("P_WCS", pw);

    std::cout << "5)" << std::endl;
    glm::vec3 V = glm::normalize(pw - eye);
    printVec("V", V);

    std::cout << "6)" << std::endl;
    glm::vec3 oc = pw - sphereCenter;
    float qa = glm::dot(V, V), qb = 2.f * glm::dot(oc, V), qc = glm::dot(oc, oc) - sphereRadius * sphereRadius;
    float disc = qb * qb - 4.f * qa * qc;
    float ts = (-qb - std::sqrt(disc)) / (2.f * qa);
    glm::vec3 ps = pw + ts * V;
    printNum("a", qa);
    printNum("b", qb);
    printNum("c", qc);
    printNum("d", disc);
    printNum("t", ts);
    printVec("P_s", ps);

    std::cout << "7)" << std::endl;
    glm::vec3 ns = ps - sphereCenter;
    printVec("N", ns);

    std::cout << "8)" << std::endl;
    glm::mat3 mat(-V, B - A, C - A);
    glm::vec3 rhs = pw - A;
    glm::vec3 tuv = glm::inverse(mat) * rhs;
    printMat3("A", mat);
    printVec("rhs", rhs);
    printNum("t", tuv.x);
    printNum("u", tuv.y);
    printNum("v", tuv.z);
    printVec("P_t", A + tuv.y * (B - A) + tuv.z * (C - A));

    std::cout << "9)" << std::endl;
    printVec("N", glm::normalize(glm::cross(B - A, C - A)));

    std::cout << "10)" << std::endl;
    std::cout << "   " << (tuv.x <= ts ? "ray hits triangle first" : "ray hits sphere first") << std::endl;
    return 0;
}
