#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <iostream>
using namespace std;

int main() {
    glm::vec3 eye(-2.5f, 3.0f, 7.0f);
    glm::vec3 lookat(1.0f, 0.5f, -1.0f);
    glm::vec3 vup(0.0f, 1.0f, 0.0f);

    // Question 1
    float W = 480.0f, H = 320.0f;
    float x = -1.5f + (200.0f + 0.5f) * 3.0f / W;
    float y = -1.0f + (240.0f + 0.5f) * 2.0f / H;
    glm::vec3 pvcs(x, y, -2.5f);
    cout << "Question 1: " << endl << "Pixel in VCS: " << glm::to_string(pvcs) << endl << endl;

    // Question 2
    glm::vec3 zv = glm::normalize(eye - lookat);
    glm::vec3 xv = glm::normalize(glm::cross(vup, zv));
    glm::vec3 yv = glm::cross(zv, xv);
    cout << "Question 2: " << endl;
    cout << "X_vcs: " << glm::to_string(xv) << endl;
    cout << "Y_vcs: " << glm::to_string(yv) << endl;
    cout << "Z_vcs: " << glm::to_string(zv) << endl << endl;

    // Question 3
    glm::mat4 mvw = glm::inverse(glm::lookAt(eye, lookat, vup));
    cout << "Question 3: " << endl << "M_VCS_to_WCS: " << glm::to_string(mvw) << endl << endl;

    // Question 4
    glm::vec4 pwcs = mvw * glm::vec4(pvcs, 1.0f);
    cout << "Question 4: " << endl << "Pixel in WCS: " << glm::to_string(pwcs) << endl << endl;

    // Question 5
    glm::vec3 S = pwcs;
    glm::vec3 V = glm::normalize(S - eye);
    cout << "Question 5: " << endl << "V: " << glm::to_string(V) << endl << endl;

    // Question 6
    glm::vec3 Cs(3.0f, -1.0f, -2.0f);
    float R = 1.5f;
    float a = glm::dot(V, V);
    float b = 2.0f * glm::dot(V, S - Cs);
    float c = glm::dot(S - Cs, S - Cs) - R * R;
    float d = b * b - 4.0f * a * c;
    float t1 = (-b - sqrt(d)) / (2.0f * a);
    float t2 = (-b + sqrt(d)) / (2.0f * a);
    float t = t2 < t1 ? t2 : t1;
    glm::vec3 ps = S + t * V;
    cout << "Question 6: " << endl;
    cout << "a: " << a << endl;
    cout << "b: " << b << endl;
    cout << "c: " << c << endl;
    cout << "d: " << d << endl;
    cout << "t: " << t << endl;
    cout << "Sphere hit point: " << glm::to_string(ps) << endl << endl;

    // Question 7
    glm::vec3 ns = glm::normalize(ps - Cs);
    cout << "Question 7: " << endl << "Sphere normal: " << glm::to_string(ns) << endl << endl;

    // Question 8
    glm::vec3 A(-4.0f, 0.5f, -1.0f), B(3.0f, -1.5f, 0.5f), C(0.5f, 6.5f, -2.0f);
    glm::mat3 m(B - A, C - A, -V);
    glm::vec3 rhs = S - A;
    glm::vec3 uvt = glm::inverse(m) * rhs;
    glm::vec3 pt = S + uvt.z * V;
    cout << "Question 8: " << endl;
    cout << "Matrix: " << glm::to_string(m) << endl;
    cout << "RHS: " << glm::to_string(rhs) << endl;
    cout << "t: " << uvt.z << endl;
    cout << "u: " << uvt.x << endl;
    cout << "v: " << uvt.y << endl;
    cout << "Triangle hit point: " << glm::to_string(pt) << endl << endl;

    // Question 9
    glm::vec3 nt = glm::normalize(glm::cross(B - A, C - A));
    cout << "Question 9: " << endl << "Triangle normal: " << glm::to_string(nt) << endl << endl;

    // Question 10
    cout << "Question 10: " << endl;
    if (t < uvt.z)
        cout << "ray hits sphere first" << endl;
    else
        cout << "ray hits triangle first" << endl;
    return 0;
}
