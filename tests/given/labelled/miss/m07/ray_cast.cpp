#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <iomanip>
#include <iostream>
using namespace std;

#define P3(v) "(" << (v).x << ", " << (v).y << ", " << (v).z << ")"

int main(void) {
    const glm::dvec3 eye(-2.5, 3, 7), lookat(1, 0.5, -1), vup(0, 1, 0);
    cout << setprecision(7);

    glm::dvec3 p(-1.5 + (200 + 0.5) / 480 * 3, -1 + (240 + 0.5) / 320 * 2, -2.5);
    cout << "QUESTION 1. P_vcs = " << P3(p) << endl;

    glm::dvec3 z = glm::normalize(eye - lookat);
    glm::dvec3 x = glm::normalize(glm::cross(vup, z));
    glm::dvec3 y = glm::cross(z, x);
    cout << "QUESTION 2. X_vcs = " << P3(x) << ", Y_vcs = " << P3(y) << ", Z_vcs = " << P3(z) << endl;

    glm::dmat4 m = glm::inverse(glm::lookAt(eye, lookat, vup));
    cout << "QUESTION 3. M_VCS_to_WCS =" << endl;
    for (int r = 0; r < 4; r++) {
        cout << "            ";
        for (int c = 0; c < 4; c++) cout << left << setw(14) << m[c][r];
        cout << endl;
    }

    glm::dvec4 w = m * glm::dvec4(p, 1);
    cout << "QUESTION 4. P_wcs = " << P3(w) << ", w = " << w.w << endl;

    glm::dvec3 S(w), V = glm::normalize(S - eye);
    cout << "QUESTION 5. V = " << P3(V) << ", length " << glm::length(V) << endl;

    glm::dvec3 cen(3, -1, -2), o = S - cen;
    double a = glm::dot(V, V), b = glm::dot(V, o), c = glm::dot(o, o) - 1.5 * 1.5, d = b * b - 4 * a * c;
    cout << "QUESTION 6. a = " << a << ", b = " << b << ", c = " << c << ", d = " << d << endl;
    double t = d < 0 ? -1 : (-b - sqrt(d)) / (2 * a);
    if (t > 0)
        cout << "            t = " << t << ", P_s = " << P3(S + t * V) << endl;
    else
        cout << "            t = none and P_s = none since d < 0, so the ray doesn't hit the sphere" << endl;

    if (t > 0)
        cout << "QUESTION 7. N = " << P3(glm::normalize(S + t * V - cen)) << endl;
    else
        cout << "QUESTION 7. N = none" << endl;

    glm::dvec3 A(-4, 0.5, -1), B(3, -1.5, 0.5), C(0.5, 6.5, -2), e1 = B - A, e2 = C - A, r = S - A;
    glm::dvec3 pv = glm::cross(V, e2), qv = glm::cross(r, e1);
    double det = glm::dot(pv, e1), u = glm::dot(pv, r) / det, v = glm::dot(qv, V) / det, tt = glm::dot(qv, e2) / det;
    cout << "QUESTION 8. A =" << endl;
    for (int i = 0; i < 3; i++)
        cout << "            " << setw(14) << e1[i] << setw(14) << e2[i] << setw(14) << -V[i] << endl;
    cout << "            right-hand side = " << P3(r) << endl;
    cout << "            (u, v, t) = (" << u << ", " << v << ", " << tt << "), P_t = " << P3(S + tt * V) << endl;

    cout << "QUESTION 9. N = " << P3(glm::normalize(glm::cross(e2, e1))) << endl;

    cout << "QUESTION 10. ray hits " << (t > 0 && t < tt ? "sphere" : "triangle") << " first" << endl;
    return 0;
}
