#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <iostream>
using namespace std;

struct Answer {
    bool hit;
    double t;
    glm::dvec3 p;
};

int main() {
    const glm::dvec3 eye(6, 1, 0), lookat(0, 1, 0), vup(0, 1, 0);

    cout << "Part 1" << endl;
    glm::dvec3 pixel;
    pixel.x = 150.0 / 300 * 4 - 2;
    pixel.y = 100.0 / 200 * 2 - 1;
    pixel.z = -2;
    cout << "  Pixel (VCS) ......... " << glm::to_string(pixel) << endl;

    cout << "Part 2" << endl;
    glm::dvec3 n = glm::normalize(eye - lookat);
    glm::dvec3 u = glm::normalize(glm::cross(vup, n));
    glm::dvec3 v = glm::cross(n, u);
    cout << "  u (= X_vcs) ......... " << glm::to_string(u) << endl;
    cout << "  v (= Y_vcs) ......... " << glm::to_string(v) << endl;
    cout << "  n (= Z_vcs) ......... " << glm::to_string(n) << endl;

    cout << "Part 3" << endl;
    glm::dmat4 M = glm::lookAt(eye, lookat, vup);
    cout << "  M_VCS_to_WCS ........ " << glm::to_string(M) << endl;

    cout << "Part 4" << endl;
    glm::dvec3 S(M * glm::dvec4(pixel, 1.0));
    cout << "  Pixel (WCS) ......... " << glm::to_string(S) << endl;

    cout << "Part 5" << endl;
    glm::dvec3 V = glm::normalize(S - eye);
    cout << "  V ................... " << glm::to_string(V) << endl;

    cout << "Part 6" << endl;
    Answer sph = {false, 0, glm::dvec3(0)};
    const glm::dvec3 ctr(1, 0, 1);
    const double R = 2;
    double a = glm::dot(V, V);
    double b = 2 * glm::dot(V, S - ctr);
    double c = glm::dot(S - ctr, S - ctr) - R * R;
    double d = b * b - 4 * a * c;
    cout << "  a ................... " << a << endl;
    cout << "  b ................... " << b << endl;
    cout << "  c ................... " << c << endl;
    cout << "  d ................... " << d << endl;
    if (d < 0) {
        cout << "  t ................... there is none, d is negative" << endl;
        cout << "  P_s ................. there is none" << endl;
    } else {
        double r1 = (-b - sqrt(d)) / (2 * a), r2 = (-b + sqrt(d)) / (2 * a);
        cout << "  roots ............... " << r1 << " " << r2 << endl;
        if (r2 > 0) {
            sph.hit = true;
            sph.t = r1 > 0 ? r1 : r2;
            sph.p = S + sph.t * V;
            cout << "  t ................... " << sph.t << endl;
            cout << "  P_s ................. " << glm::to_string(sph.p) << endl;
        } else {
            cout << "  t ................... there is none, the roots are negative" << endl;
            cout << "  P_s ................. there is none" << endl;
        }
    }

    cout << "Part 7" << endl;
    if (sph.hit)
        cout << "  N ................... " << glm::to_string(glm::normalize(sph.p - ctr)) << endl;
    else
        cout << "  N ................... there is none" << endl;

    cout << "Part 8" << endl;
    const glm::dvec3 A(3, 0, -1), B(3, 0, 1), C(1, 3, 2);
    glm::dmat3 T(-V, B - A, C - A);
    glm::dvec3 rhs = S - A;
    glm::dvec3 x = glm::inverse(T) * rhs;
    Answer tri = {x[0] > 0 && x[1] >= 0 && x[2] >= 0 && x[1] + x[2] <= 1, x[0], S + x[0] * V};
    cout << "  matrix .............. " << glm::to_string(T) << endl;
    cout << "  right-hand side ..... " << glm::to_string(rhs) << endl;
    cout << "  t, u, v ............. " << x[0] << " " << x[1] << " " << x[2] << endl;
    cout << "  P_t ................. " << glm::to_string(tri.p) << endl;
    cout << "  true hit ............ " << (tri.hit ? "yes" : "no") << endl;

    cout << "Part 9" << endl;
    cout << "  N ................... " << glm::to_string(glm::normalize(glm::cross(B - A, C - A))) << endl;

    cout << "Part 10" << endl;
    if (!sph.hit && !tri.hit)
        cout << "  ray hits neither of them" << endl;
    else if (tri.hit && (!sph.hit || tri.t < sph.t))
        cout << "  ray hits triangle first" << endl;
    else
        cout << "  ray hits sphere first" << endl;
}
