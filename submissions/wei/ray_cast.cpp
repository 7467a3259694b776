#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <iostream>
using std::cout; using std::string;

// Points as vec4, as in the lecture.

static string show(glm::vec4 v) { return glm::to_string(v); }

int main()
{
    glm::vec3 eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0);

    cout << "*** Question 1 ***\n";
    glm::vec4 P_VCS(-2.f + 4.f * 150.f / 300.f, -1.f + 2.f * 100.f / 200.f, -2.f, 1.f);
    cout << "P_VCS: " << show(P_VCS) << "\n";

    cout << "*** Question 2 ***\n";
    glm::vec3 Z = glm::normalize(eye - lookat), X = glm::normalize(glm::cross(vup, Z)), Y = glm::cross(Z, X);
    cout << "X_vcs: " << glm::to_string(X) << "\n";
    cout << "Y_vcs: " << glm::to_string(Y) << "\n";
    cout << "Z_vcs: " << glm::to_string(Z) << "\n";

    cout << "*** Question 3 ***\n";
    glm::mat4 M = glm::inverse(glm::lookAt(eye, lookat, vup));
    cout << "M_VCS_to_WCS: " << glm::to_string(M) << "\n";

    cout << "*** Question 4 ***\n";
    glm::vec4 P_WCS = M * P_VCS;
    cout << "P_WCS: " << show(P_WCS) << "\n";

    cout << "*** Question 5 ***\n";
    glm::vec4 direction = P_WCS - glm::vec4(eye, 0);
    glm::vec3 V = glm::vec3(glm::normalize(direction));
    cout << "V: " << glm::to_string(V) << "\n";

    cout << "*** Question 6 ***\n";
    glm::vec3 S(P_WCS), C(1, 1, 0);
    float a = glm::dot(V, V);
    float b = 2 * glm::dot(V, S - C);
    float c = glm::dot(S - C, S - C) - 2 * 2;
    float d = b * b - 4 * a * c;
    float t = (-b - glm::sqrt(d)) / (2 * a);
    if (t <= 0)
        t = (-b + glm::sqrt(d)) / (2 * a);
    glm::vec3 P_s = S + t * V;
    cout << "a: " << a << "\nb: " << b << "\nc: " << c << "\nd: " << d << "\nt: " << t << "\n";
    cout << "P_s: " << glm::to_string(P_s) << "\n";

    cout << "*** Question 7 ***\n";
    cout << "N: " << glm::to_string(glm::normalize(P_s - C)) << "\n";

    cout << "*** Question 8 ***\n";
    glm::vec3 T1(0, -2, 2), T2(2, 2, 2), T3(-2, 2, 2);
    glm::mat3 A(-V, T2 - T1, T3 - T1);
    glm::vec3 rhs = S - T1;
    glm::vec3 tuv = glm::inverse(A) * rhs;
    cout << "A: " << glm::to_string(A) << "\nright-hand side: " << glm::to_string(rhs) << "\n";
    cout << "(t, u, v): " << glm::to_string(tuv) << "\n";
    cout << "P_t: " << glm::to_string(S + tuv.x * V) << "\n";

    cout << "*** Question 9 ***\n";
    cout << "N: " << glm::to_string(glm::normalize(glm::cross(T2 - T1, T3 - T1))) << "\n";

    cout << "*** Question 10 ***\n";
    if (tuv.x < t)
        cout << "ray hits triangle first\n";
    else
        cout << "ray hits sphere first\n";
}
