#include <cmath>
#include <cstdlib>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <iostream>

using namespace std;

int main() {
    glm::vec3 eye(-2.5, 3, 7), lookat(1, 0.5, -1), vup(0, 1, 0), C(3, -1, -2);
    float R = 1.5;

    // 1
    cout << "1: pixel to VCS" << endl;
    glm::vec3 P_VCS;
    P_VCS.x = (200 + 0.5f) / 480 * 3 - 1.5f;
    P_VCS.y = (240 + 0.5f) / 320 * 2 - 1.0f;
    P_VCS.z = -2.5f;
    cout << "P_VCS.x = " << P_VCS.x << endl;
    cout << "P_VCS.y = " << P_VCS.y << endl;
    cout << "P_VCS.z = " << P_VCS.z << endl;

    // 2
    glm::vec3 z = glm::normalize(eye - lookat);
    glm::vec3 x = glm::normalize(glm::cross(vup, z));
    glm::vec3 y = glm::cross(z, x);

    // 3
    cout << "3: inverse of the view matrix" << endl;
    glm::mat4 M = glm::inverse(glm::lookAt(eye, lookat, vup));
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) cout << "M[" << i << "][" << j << "] = " << M[i][j] << (j < 3 ? "  " : "\n");

    // 4
    cout << "4: pixel to WCS" << endl;
    glm::vec4 P_WCS = M * glm::vec4(P_VCS, 1);
    cout << "P_WCS.x = " << P_WCS.x << endl;
    cout << "P_WCS.y = " << P_WCS.y << endl;
    cout << "P_WCS.z = " << P_WCS.z << endl;
    cout << "P_WCS.w = " << P_WCS.w << endl;

    // 5
    glm::vec3 S(P_WCS);
    glm::vec3 V = glm::normalize(S - eye);

    // 6
    cout << "6: sphere" << endl;
    float a = glm::dot(V, V);
    float b = 2 * glm::dot(V, S - C);
    float c = glm::dot(S - C, S - C) - R * R;
    float d = b * b - 4 * a * c;
    cout << "a = " << a << endl;
    cout << "b = " << b << endl;
    cout << "c = " << c << endl;
    cout << "d = " << d << endl;
    if (d < 0) {
        cout << "The ray misses the sphere!" << endl;
        exit(0);
    }
    float t = (-b - sqrt(d)) / (2 * a);
    glm::vec3 P_s = S + t * V;
    cout << "t = " << t << endl;
    cout << "P_s = " << glm::to_string(P_s) << endl;

    // 7
    cout << "7: normal" << endl;
    cout << "N = " << glm::to_string(glm::normalize(P_s - C)) << endl;

    // 8
    cout << "8: triangle" << endl;
    glm::vec3 A(-4, 0.5, -1), B(3, -1.5, 0.5), D(0.5, 6.5, -2);
    glm::mat3 m(-V, B - A, D - A);
    cout << "A = " << glm::to_string(m) << endl;
    cout << "rhs = " << glm::to_string(S - A) << endl;
    glm::vec3 tuv = glm::inverse(m) * (S - A);
    cout << "t = " << tuv.x << " u = " << tuv.y << " v = " << tuv.z << endl;
    cout << "P_t = " << glm::to_string(S + tuv.x * V) << endl;

    // 10
    cout << "10: first" << endl;
    if (tuv.x < t)
        cout << "ray hits triangle first" << endl;
    else
        cout << "ray hits sphere first" << endl;
}
