// Jin, assignment 6
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <cmath>
#include <iostream>

int main()
{
    int W = 301;
    int H = 201;
    int x_DCS = 150;
    int y_DCS = 100;
    int clipLeft = -2, clipRight = 2;
    int clipBottom = -1, clipTop = 1;
    int clipNear = 2;

    glm::vec3 eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0);

    float x = clipLeft + x_DCS / W * (clipRight - clipLeft);
    float y = clipBottom + y_DCS / H * (clipTop - clipBottom);
    glm::vec3 P_VCS(x, y, -clipNear);
    std::cout << "Question 1:\n  P_VCS: " << glm::to_string(P_VCS) << "\n";

    glm::vec3 Z_vcs = glm::normalize(eye - lookat);
    glm::vec3 X_vcs = glm::normalize(glm::cross(vup, Z_vcs));
    glm::vec3 Y_vcs = glm::cross(Z_vcs, X_vcs);
    std::cout << "Question 2:\n  X_vcs: " << glm::to_string(X_vcs) << "\n  Y_vcs: " << glm::to_string(Y_vcs)
              << "\n  Z_vcs: " << glm::to_string(Z_vcs) << "\n";

    glm::mat4 M_VCS_to_WCS = glm::inverse(glm::lookAt(eye, lookat, vup));
    std::cout << "Question 3:\n  M_VCS_to_WCS: " << glm::to_string(M_VCS_to_WCS) << "\n";

    glm::vec3 P_WCS = glm::vec3(M_VCS_to_WCS * glm::vec4(P_VCS, 1.0f));
    std::cout << "Question 4:\n  P_WCS: " << glm::to_string(P_WCS) << "\n";

    glm::vec3 V = glm::normalize(P_WCS - eye);
    std::cout << "Question 5:\n  V: " << glm::to_string(V) << "\n";

    glm::vec3 center(1, 1, 0);
    float R = 2.0f;
    glm::vec3 CS = P_WCS - center;
    float a = glm::dot(V, V);
    float b = 2.0f * glm::dot(V, CS);
    float c = glm::dot(CS, CS) - R * R;
    float d = b * b - 4.0f * a * c;
    bool hitsSphere = d >= 0.0f;
    float ts = 0.0f;
    glm::vec3 Ps(0.0f);
    std::cout << "Question 6:\n  a: " << a << "\n  b: " << b << "\n  c: " << c << "\n  d: " << d << "\n";
    if (hitsSphere) {
        float r1 = (-b - std::sqrt(d)) / (2.0f * a);
        float r2 = (-b + std::sqrt(d)) / (2.0f * a);
        ts = r1 > 0.0f ? r1 : r2;
        hitsSphere = ts > 0.0f;
    }
    if (hitsSphere) {
        Ps = P_WCS + ts * V;
        std::cout << "  t: " << ts << "\n  P_s: " << glm::to_string(Ps) << "\n";
    } else {
        std::cout << "  t: none (d is negative)\n  P_s: none\n";
    }

    std::cout << "Question 7:\n";
    if (hitsSphere)
        std::cout << "  N: " << glm::to_string(glm::normalize(Ps - center)) << "\n";
    else
        std::cout << "  N: none\n";

    glm::vec3 A(0, -2, 2), B(2, 2, 2), C(-2, 2, 2);
    glm::mat3 M(-V, B - A, C - A);
    glm::vec3 rhs = P_WCS - A;
    glm::vec3 tuv = glm::inverse(M) * rhs;
    bool inside = tuv[1] >= 0 && tuv[2] >= 0 && tuv[1] + tuv[2] <= 1;
    std::cout << "Question 8:\n  A: " << glm::to_string(M) << "\n  rhs: " << glm::to_string(rhs) << "\n  t: " << tuv[0]
              << "\n  u: " << tuv[1] << "\n  v: " << tuv[2] << "\n  P_t: " << glm::to_string(P_WCS + tuv[0] * V)
              << (inside ? "" : " (outside the triangle)") << "\n";

    std::cout << "Question 9:\n  N: " << glm::to_string(glm::normalize(glm::cross(B - A, C - A))) << "\n";

    std::cout << "Question 10:\n";
    bool hitsTriangle = inside && tuv[0] >= 0;
    if (hitsTriangle && (!hitsSphere || tuv[0] < ts))
        std::cout << "  ray hits triangle first\n";
    else if (hitsSphere)
        std::cout << "  ray hits sphere first\n";
    else
        std::cout << "  ray hits neither\n";
    return 0;
}
