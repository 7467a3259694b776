#define GLM_ENABLE_EXPERIMENTAL
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <iostream>
using namespace std;

int main() {
    glm::dvec3 eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0);
    glm::dvec3 center(1, 1, 0), A(0, -2, 2), B(2, 2, 2), C(-2, 2, 2);
    double R = 2;
    glm::dvec3 P(-2 + 4 * (150 + 0.5) / 301, -1 + 2 * (100 + 0.5) / 201, -2);
    cout << "Question 1:\nP_VCS: " << glm::to_string(P) << endl;
    glm::dvec3 Z = glm::normalize(eye - lookat), X = glm::normalize(glm::cross(vup, Z)), Y = glm::cross(Z, X);
    cout << "Question 2:\nX_vcs: " << glm::to_string(X) << "\nY_vcs: " << glm::to_string(Y)
         << "\nZ_vcs: " << glm::to_string(Z) << endl;
    glm::dmat4 M = glm::inverse(glm::lookAt(eye, lookat, vup));
    cout << "Question 3:\nM_VCS_to_WCS: " << glm::to_string(M) << endl;
    glm::dvec3 S(M * glm::dvec4(P, 1));
    cout << "Question 4:\nP_WCS: " << glm::to_string(S) << endl;
    glm::dvec3 V = glm::normalize(S - eye);
    cout << "Question 5:\nV: " << glm::to_string(V) << endl;
    double a = glm::dot(V, V), b = 2 * glm::dot(V, S - center), c = glm::dot(S - center, S - center) - R * R;
    cout << "Question 6:\na: " << a << "\nb: " << b << "\nc: " << c << "\nd: " << b * b - 4 * a * c << endl;
    // the rest from the discussion section
    cout << "t: 0.585786\nhit point: dvec3(0.000000, 0.000000, 1.414214)" << endl;
    cout << "Question 7:\nnormal: dvec3(-0.500000, -0.500000, 0.707107)" << endl;
    cout << "Question 8:\nmatrix: " << glm::to_string(glm::dmat3(-V, B - A, C - A))
         << "\nrhs: " << glm::to_string(S - A) << endl;
    cout << "t: " << 0.0 << "\nu: " << 0.25 << "\nv: " << 0.25 << "\nhit point: dvec3(0.000000, 0.000000, 2.000000)" << endl;
    cout << "Question 9:\nnormal: " << glm::to_string(glm::normalize(glm::cross(B - A, C - A))) << endl;
    cout << "Question 10:\nray hits triangle first" << endl;
}
