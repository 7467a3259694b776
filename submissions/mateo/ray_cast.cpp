#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <cmath>
#include <iostream>

int main()
{
    glm::vec3 eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0);

    std::cout << "Question 1:\n";
    glm::vec3 P_vcs(-2 + 4 * 150.0f / 300, -1 + 2 * 100.0f / 200, -2);
    std::cout << "Pixel in VCS: " << glm::to_string(P_vcs) << "\n";

    std::cout << "Question 2:\n";
    glm::vec3 Z = glm::normalize(eye - lookat);
    glm::vec3 X = glm::normalize(glm::cross(vup, Z))
    glm::vec3 Y = glm::cross(Z, X);
    std::cout << "X_vcs: " << glm::to_string(X) << "\n";
    std::cout << "Y_vcs: " << glm::to_string(Y) << "\n";
    std::cout << "Z_vcs: " << glm::to_string(Z) << "\n";

    std::cout << "Question 3:\n";
    glm::mat4 M = glm::inverse(glm::lookAt(eye, lookat, vup));
    std::cout << "M_VCS_to_WCS: " << glm::to_string(M) << "\n";

    std::cout << "Question 4:\n";
    glm::vec3 P_wcs = glm::vec3(M * glm::vec4(P_vcs, 1));
    std::cout << "Pixel in WCS: " << glm::to_string(P_wcs) << "\n";

    std::cout << "Question 5:\n";
    glm::vec3 V = glm::normalize(P_wcs - eye);
    std::cout << "V: " << glm::to_string(V) << "\n";
    return 0;
}
