#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <cstdio>

// Walks along the ray in small steps until it is inside the sphere.
int main()
{
    glm::vec3 eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0);
    glm::vec3 center(1, 1, 0);
    float R = 2;

    printf("Question 1:\n");
    glm::vec3 P_vcs(-2 + 4 * 150.5f / 301, -1 + 2 * 100.5f / 201, -2);
    printf("Pixel in VCS: %s\n", glm::to_string(P_vcs).c_str());

    printf("Question 2:\n");
    glm::vec3 Z = glm::normalize(eye - lookat);
    glm::vec3 X = glm::normalize(glm::cross(vup, Z));
    glm::vec3 Y = glm::cross(Z, X);
    printf("X_vcs: %s\n", glm::to_string(X).c_str());
    printf("Y_vcs: %s\n", glm::to_string(Y).c_str());
    printf("Z_vcs: %s\n", glm::to_string(Z).c_str());

    printf("Question 3:\n");
    glm::mat4 M = glm::inverse(glm::lookAt(eye, lookat, vup));
    printf("M_VCS_to_WCS: %s\n", glm::to_string(M).c_str());

    printf("Question 4:\n");
    glm::vec3 S(M * glm::vec4(P_vcs, 1));
    printf("Pixel in WCS: %s\n", glm::to_string(S).c_str());

    printf("Question 5:\n");
    glm::vec3 V = glm::normalize(S - eye);
    printf("V: %s\n", glm::to_string(V).c_str());

    printf("Question 6:\n");
    float a = glm::dot(V, V);
    float b = 2 * glm::dot(V, S - center);
    float c = glm::dot(S - center, S - center) - R * R;
    printf("a: %f\nb: %f\nc: %f\nd: %f\n", a, b, c, b * b - 4 * a * c);

    glm::vec3 p = S;
    unsigned steps = 0;
    while (glm::distance(p, center) > R) {
        p -= 0.01f * V;
        ++steps;
        printf("still outside after %u steps\n", steps);
    }
    printf("t: %f\n", 0.01f * steps);
    printf("P_s: %s\n", glm::to_string(p).c_str());
    return 0;
}
