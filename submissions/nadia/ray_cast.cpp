#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <cmath>
#include <iostream>
#include <vector>

using namespace std;

struct Sphere {
    glm::vec3 center;
    float radius;
};

int main() {
    glm::vec3 eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0);
    vector<Sphere *> spheres(1);   // one sphere in the scene

    cout << "Question 1:" << endl;
    glm::vec3 P_vcs(-2 + 4 * 150.5f / 301, -1 + 2 * 100.5f / 201, -2);
    cout << "Pixel in VCS: " << glm::to_string(P_vcs) << endl;

    cout << "Question 2:" << endl;
    glm::vec3 Z = glm::normalize(eye - lookat);
    glm::vec3 X = glm::normalize(glm::cross(vup, Z));
    glm::vec3 Y = glm::cross(Z, X);
    cout << "X_vcs: " << glm::to_string(X) << endl;
    cout << "Y_vcs: " << glm::to_string(Y) << endl;
    cout << "Z_vcs: " << glm::to_string(Z) << endl;

    cout << "Question 3:" << endl;
    glm::mat4 M = glm::inverse(glm::lookAt(eye, lookat, vup));
    cout << "M_VCS_to_WCS: " << glm::to_string(M) << endl;

    cout << "Question 4:" << endl;
    glm::vec3 S = glm::vec3(M * glm::vec4(P_vcs, 1));
    cout << "Pixel in WCS: " << glm::to_string(S) << endl;

    cout << "Question 5:" << endl;
    glm::vec3 V = glm::normalize(S - eye);
    cout << "V: " << glm::to_string(V) << endl;

    // sphere
    spheres[0]->center = glm::vec3(1, 1, 0);
    spheres[0]->radius = 2;
    glm::vec3 q = S - spheres[0]->center;
    float a = glm::dot(V, V);
    float b = 2 * glm::dot(V, q);
    float c = glm::dot(q, q) - spheres[0]->radius * spheres[0]->radius;
    float d = b * b - 4 * a * c;
    float t = (-b - sqrt(d)) / (2 * a);
    cout << "Question 6:" << endl;
    cout << "a: " << a << endl;
    cout << "b: " << b << endl;
    cout << "c: " << c << endl;
    cout << "d: " << d << endl;
    cout << "t: " << t << endl;
    cout << "hit point: " << glm::to_string(S + t * V) << endl;

    cout << "Question 7:" << endl;
    cout << "N: " << glm::to_string(glm::normalize(S + t * V - spheres[0]->center)) << endl;
    return 0;
}
