#define GLM_ENABLE_EXPERIMENTAL
#include <cmath>
#include <fstream>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>

int main()
{
    std::ofstream out("answers.txt");

    glm::vec3 eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0);
    glm::vec3 center(1, 1, 0), A(0, -2, 2), B(2, 2, 2), C(-2, 2, 2);

    glm::vec3 P_vcs(-2 + 4 * 150.5f / 301, -1 + 2 * 100.5f / 201, -2);
    out << "Question 1:\nPixel in VCS: " << glm::to_string(P_vcs) << "\n";

    glm::vec3 Z = glm::normalize(eye - lookat), X = glm::normalize(glm::cross(vup, Z)), Y = glm::cross(Z, X);
    out << "Question 2:\nX_vcs: " << glm::to_string(X) << "\nY_vcs: " << glm::to_string(Y)
        << "\nZ_vcs: " << glm::to_string(Z) << "\n";

    glm::mat4 M = glm::inverse(glm::lookAt(eye, lookat, vup));
    out << "Question 3:\nM_VCS_to_WCS: " << glm::to_string(M) << "\n";

    glm::vec3 S(M * glm::vec4(P_vcs, 1));
    out << "Question 4:\nPixel in WCS: " << glm::to_string(S) << "\n";

    glm::vec3 V = glm::normalize(S - eye);
    out << "Question 5:\nV: " << glm::to_string(V) << "\n";

    glm::vec3 q = S - center;
    float a = glm::dot(V, V), b = 2 * glm::dot(V, q), c = glm::dot(q, q) - 4, d = b * b - 4 * a * c;
    float ts = (-b - std::sqrt(d)) / (2 * a);
    if (ts < 0) ts = (-b + std::sqrt(d)) / (2 * a);
    out << "Question 6:\na: " << a << "\nb: " << b << "\nc: " << c << "\nd: " << d << "\nt: " << ts
        << "\nP_s: " << glm::to_string(S + ts * V) << "\n";
    out << "Question 7:\nN: " << glm::to_string(glm::normalize(S + ts * V - center)) << "\n";

    glm::mat3 mat(-V, B - A, C - A);
    glm::vec3 rhs = S - A, tuv = glm::inverse(mat) * rhs;
    out << "Question 8:\nA: " << glm::to_string(mat) << "\nrhs: " << glm::to_string(rhs) << "\nt: " << tuv.x
        << "\nu: " << tuv.y << "\nv: " << tuv.z << "\nP_t: " << glm::to_string(S + tuv.x * V) << "\n";
    out << "Question 9:\nN: " << glm::to_string(glm::normalize(glm::cross(B - A, C - A))) << "\n";
    out << "Question 10:\n" << (tuv.x < ts ? "ray hits triangle first" : "ray hits sphere first") << "\n";
    return 0;
}
