#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <iostream>

#define PRINT(x) std::cout << #x << " = " << glm::to_string(x) << std::endl
#define PRINTF(x) std::cout << #x << " = " << x << std::endl

int main(int argc, char **argv)
{
    const glm::vec3 eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0);
    const glm::vec3 sphere(1, 1, 0);
    const float R = 2;
    const glm::vec3 A(0, -2, 2), B(2, 2, 2), C(-2, 2, 2);

    std::cout << "Question #1" << std::endl;
    const glm::vec3 P_vcs(-2 + 4 * 150.5f / 301, -1 + 2 * 100.5f / 201, -2);
    PRINT(P_vcs);

    std::cout << "Question #2" << std::endl;
    const glm::vec3 Z_vcs = glm::normalize(eye - lookat);
    const glm::vec3 X_vcs = glm::normalize(glm::cross(vup, Z_vcs));
    const glm::vec3 Y_vcs = glm::cross(Z_vcs, X_vcs);
    PRINT(X_vcs);
    PRINT(Y_vcs);
    PRINT(Z_vcs);

    std::cout << "Question #3" << std::endl;
    const glm::mat4 M_VCS_to_WCS = glm::inverse(glm::lookAt(eye, lookat, vup));
    PRINT(M_VCS_to_WCS);

    std::cout << "Question #4" << std::endl;
    const glm::vec3 P_wcs = glm::vec3(M_VCS_to_WCS * glm::vec4(P_vcs, 1));
    PRINT(P_wcs);

    std::cout << "Question #5" << std::endl;
    const glm::vec3 V = glm::normalize(P_wcs - eye);
    PRINT(V);

    std::cout << "Question #6" << std::endl;
    float t_sphere;
    glm::vec3 P_s;
    {
        // the ray starts at the eye
        const glm::vec3 q = eye - sphere;
        const float a = glm::dot(V, V);
        const float b = 2 * glm::dot(V, q);
        const float c = glm::dot(q, q) - R * R;
        const float d = b * b - 4 * a * c;
        const float t1 = (-b - glm::sqrt(d)) / (2 * a), t2 = (-b + glm::sqrt(d)) / (2 * a);
        const float t = t1 > 0 ? t1 : t2;
        P_s = eye + t * V;
        t_sphere = t;
        PRINTF(a);
        PRINTF(b);
        PRINTF(c);
        PRINTF(d);
        PRINTF(t);
        PRINT(P_s);
    }

    std::cout << "Question #7" << std::endl;
    const glm::vec3 N_sphere = glm::normalize(P_s - sphere);
    PRINT(N_sphere);

    std::cout << "Question #8" << std::endl;
    float t_triangle;
    {
        const glm::mat3 matrixA(-V, B - A, C - A);
        const glm::vec3 rhs = eye - A;
        const glm::vec3 tuv = glm::inverse(matrixA) * rhs;
        const float t = tuv.x, u = tuv.y, v = tuv.z;
        const glm::vec3 P_t = eye + t * V;
        t_triangle = t;
        PRINT(matrixA);
        PRINT(rhs);
        PRINTF(t);
        PRINTF(u);
        PRINTF(v);
        PRINT(P_t);
    }

    std::cout << "Question #9" << std::endl;
    const glm::vec3 N_triangle = glm::normalize(glm::cross(B - A, C - A));
    PRINT(N_triangle);

    std::cout << "Question #10" << std::endl;
    if (t_triangle < t_sphere)
        std::cout << "ray hits triangle first" << std::endl;
    else
        std::cout << "ray hits sphere first" << std::endl;
    return 0;
}
