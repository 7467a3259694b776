#include <iostream>
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>

int main()
{
    const glm::vec3 eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0);
    const glm::vec3 center(1, 1, 0);
    const float radius = 2;
    const glm::vec3 A(0, -2, 2), B(2, 2, 2), C(-2, 2, 2);
    const int W = 301, H = 201;
    const float clipLeft = -2, clipRight = 2, clipBottom = -1, clipTop = 1, clipNear = 2;
    const glm::vec2 P_DCS(150, 100);

    // scale and translate, as on the slides
    glm::mat4 DCS_to_VCS(1);
    DCS_to_VCS = glm::translate(DCS_to_VCS, glm::vec3(clipLeft, clipBottom, -clipNear));
    DCS_to_VCS = glm::scale(DCS_to_VCS, glm::vec3((clipRight - clipLeft) / (W - 1), (clipTop - clipBottom) / (H - 1), 1));
    glm::vec4 P_VCS = DCS_to_VCS * glm::vec4(P_DCS, 0, 1);
    std::cout << "P_VCS: " << glm::to_string(P_VCS) << "\n\n";

    glm::vec3 Z_vcs = glm::normalize(eye - lookat);
    glm::vec3 X_vcs = glm::normalize(glm::cross(vup, Z_vcs));
    glm::vec3 Y_vcs = glm::cross(Z_vcs, X_vcs);
    std::cout << "X_vcs: " << glm::to_string(X_vcs) << "\n";
    std::cout << "Y_vcs: " << glm::to_string(Y_vcs) << "\n";
    std::cout << "Z_vcs: " << glm::to_string(Z_vcs) << "\n\n";

    glm::mat4 M_VCS_to_WCS(glm::vec4(X_vcs, 0), glm::vec4(Y_vcs, 0), glm::vec4(Z_vcs, 0), glm::vec4(eye, 1));
    std::cout << "M_VCS_to_WCS: " << glm::to_string(M_VCS_to_WCS) << "\n\n";

    glm::vec4 P_WCS = M_VCS_to_WCS * P_VCS;
    std::cout << "P_WCS: " << glm::to_string(P_WCS) << "\n\n";

    glm::vec3 S(P_WCS);
    glm::vec3 V = glm::normalize(S - eye);
    std::cout << "V: " << glm::to_string(V) << "\n\n";

    glm::vec3 Q = S - center;
    float a = glm::dot(V, V);
    float b = 2 * glm::dot(V, Q);
    float c = glm::dot(Q, Q) - radius * radius;
    float d = b * b - 4 * a * c;
    float t_s = (-b - glm::sqrt(d)) / (2 * a);
    glm::vec3 P_s = S + t_s * V;
    std::cout << "a: " << a << "\n";
    std::cout << "b: " << b << "\n";
    std::cout << "c: " << c << "\n";
    std::cout << "d: " << d << "\n";
    std::cout << "t_s: " << t_s << "\n";
    std::cout << "P_s: " << glm::to_string(P_s) << "\n\n";

    glm::vec3 N_s = glm::normalize(P_s - center);
    std::cout << "N_s: " << glm::to_string(N_s) << "\n\n";

    glm::mat3 matrix(-V, B - A, C - A);
    glm::vec3 rhs = S - A;
    glm::vec3 tuv = glm::inverse(matrix) * rhs;
    glm::vec3 P_t = S + tuv.x * V;
    std::cout << "A: " << glm::to_string(matrix) << "\n";
    std::cout << "rhs: " << glm::to_string(rhs) << "\n";
    std::cout << "t_t: " << tuv.x << "\n";
    std::cout << "u: " << tuv.y << "\n";
    std::cout << "v: " << tuv.z << "\n";
    std::cout << "P_t: " << glm::to_string(P_t) << "\n\n";

    glm::vec3 N_t = glm::normalize(glm::cross(B - A, C - A));
    std::cout << "N_t: " << glm::to_string(N_t) << "\n\n";

    if (tuv.x < t_s)
        std::cout << "ray hits triangle first\n";
    else
        std::cout << "ray hits sphere first\n";
}
