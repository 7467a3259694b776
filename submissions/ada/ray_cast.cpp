// ada.cpp -- CS770 a6, ray casting
#define GLM_ENABLE_EXPERIMENTAL
#include <iostream>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>

using std::cout;
using glm::to_string;

int main()
{
    // Scene
    glm::vec3 center(1, 1, 0);
    float radius = 2;
    glm::vec3 A(0, -2, 2), B(2, 2, 2), C(-2, 2, 2);

    // Camera
    glm::vec3 eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0);
    float clipL = -2, clipR = 2, clipB = -1, clipT = 1, clipNear = 2;
    float W = 301, H = 201;
    float x_dcs = 150, y_dcs = 100;

    // pixel 0 is on clipL, pixel W-1 is on clipR
    glm::vec3 P_vcs;
    P_vcs.x = clipL + x_dcs / (W - 1) * (clipR - clipL);
    P_vcs.y = clipB + y_dcs / (H - 1) * (clipT - clipB);
    P_vcs.z = -clipNear;
    cout << "Question 1:\n";
    cout << "Pixel in VCS: " << to_string(P_vcs) << "\n";

    glm::vec3 Zv = glm::normalize(eye - lookat);
    glm::vec3 Xv = glm::normalize(glm::cross(vup, Zv));
    glm::vec3 Yv = glm::cross(Zv, Xv);
    cout << "Question 2:\n";
    cout << "X_vcs: " << to_string(Xv) << "\n";
    cout << "Y_vcs: " << to_string(Yv) << "\n";
    cout << "Z_vcs: " << to_string(Zv) << "\n";

    glm::mat4 M = glm::inverse(glm::lookAt(eye, lookat, vup));
    cout << "Question 3:\n";
    cout << "M_VCS_to_WCS: " << to_string(M) << "\n";

    glm::vec3 P_wcs = glm::vec3(M * glm::vec4(P_vcs, 1));
    cout << "Question 4:\n";
    cout << "Pixel in WCS: " << to_string(P_wcs) << "\n";

    glm::vec3 V = glm::normalize(P_wcs - eye);
    cout << "Question 5:\n";
    cout << "Ray direction V: " << to_string(V) << "\n";

    glm::vec3 S = P_wcs;
    float a = glm::dot(V, V);
    float b = 2 * glm::dot(V, S - center);
    float c = glm::dot(S - center, S - center) - radius * radius;
    float d = b * b - 4 * a * c;
    float t_s = (-b - std::sqrt(d)) / (2 * a);
    if (t_s <= 0) t_s = (-b + std::sqrt(d)) / (2 * a);
    glm::vec3 P_s = S + t_s * V;
    cout << "Question 6:\n";
    cout << "a: " << a << "\n";
    cout << "b: " << b << "\n";
    cout << "c: " << c << "\n";
    cout << "Discriminant d: " << d << "\n";
    cout << "t: " << t_s << "\n";
    cout << "Hit point: " << to_string(P_s) << "\n";

    glm::vec3 N_s = glm::normalize(P_s - center);
    cout << "Question 7:\n";
    cout << "Sphere normal: " << to_string(N_s) << "\n";

    // t*(-V) + u*(B-A) + v*(C-A) = S - A
    glm::mat3 mat(-V, B - A, C - A);
    glm::vec3 rhs = S - A;
    glm::vec3 tuv = glm::inverse(mat) * rhs;
    glm::vec3 P_t = A + tuv.y * (B - A) + tuv.z * (C - A);
    cout << "Question 8:\n";
    cout << "Matrix A: " << to_string(mat) << "\n";
    cout << "Right-hand side: " << to_string(rhs) << "\n";
    cout << "t: " << tuv.x << "\n";
    cout << "u: " << tuv.y << "\n";
    cout << "v: " << tuv.z << "\n";
    cout << "Hit point: " << to_string(P_t) << "\n";

    glm::vec3 N_t = glm::normalize(glm::cross(B - A, C - A));
    cout << "Question 9:\n";
    cout << "Triangle normal: " << to_string(N_t) << "\n";

    cout << "Question 10:\n";
    if (tuv.x < t_s)
        cout << "ray hits triangle first\n";
    else
        cout << "ray hits sphere first\n";
    return 0;
}
