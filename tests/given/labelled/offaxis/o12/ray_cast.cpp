#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <iostream>

using namespace std;

int main() {
    glm::vec3 eye(3, 4, 12), lookat(-0.5, 0.8, -1.2), vup(0.1, 1, 0.2);

    glm::vec3 P_VCS(-1.6f + (411 + 0.5f) / 640 * 4.0f, -1.1f + (129 + 0.5f) / 384 * 2.4f, -1.5f);
    cout << "Question 1:\n"
         << "P_VCS = " << P_VCS << "\n";

    glm::vec3 Z = glm::normalize(eye - lookat);
    glm::vec3 X = glm::normalize(glm::cross(vup, Z));
    glm::vec3 Y = glm::cross(Z, X);
    cout << "Question 2:\n"
         << "X = " << X << "\nY = " << Y << "\nZ = " << Z << "\n";

    glm::mat4 M = glm::inverse(glm::lookAt(eye, lookat, vup));
    cout << "Question 3:\n"
         << "M = " << M << "\n";

    glm::vec4 P_WCS = M * glm::vec4(P_VCS, 1);
    cout << "Question 4:\n"
         << "P_WCS = " << P_WCS << "\n";

    glm::vec3 S(P_WCS), V = glm::normalize(S - eye);
    cout << "Question 5:\n"
         << "V = " << V << "\n";

    glm::vec3 center(6.6, -1.4, 0.5), L = S - center;
    float a = glm::dot(V, V), b = 2 * glm::dot(V, L), c = glm::dot(L, L) - 1.8f * 1.8f, d = b * b - 4 * a * c;
    float t = (-b - sqrt(d)) / (2 * a);
    glm::vec3 P_s = S + t * V;
    cout << "Question 6:\n"
         << "a = " << a << " b = " << b << " c = " << c << "\nd = " << d << "\nt = " << t << "\nP_s = " << P_s << "\n";

    cout << "Question 7:\n"
         << "N = " << glm::normalize(P_s - center) << "\n";

    glm::vec3 A(3.2, -2.25, 3.8), B(8.7, -0.5, 3.1), C(5.4, 4.6, 4.3);
    glm::mat3 m(-V, B - A, C - A);
    glm::vec3 rhs = S - A, x = glm::inverse(m) * rhs;
    cout << "Question 8:\n"
         << "A = " << m << "\nrhs = " << rhs << "\nt = " << x.x << " u = " << x.y << " v = " << x.z
         << "\nP_t = " << S + x.x * V << "\n";

    cout << "Question 9:\n"
         << "N = " << glm::normalize(glm::cross(B - A, C - A)) << "\n";

    cout << "Question 10:\n" << (x.x < t ? "ray hits triangle first\n" : "ray hits sphere first\n");
}
