// HW6
#include <cmath>
#include <glm/glm.hpp>
#include <iomanip>
#include <iostream>
using namespace std;
using namespace glm;

void out(string label, dvec3 v) {
    cout << left << setw(18) << label << right << setw(11) << v.x << setw(11) << v.y << setw(11) << v.z << "\n";
}
void out(string label, double x) {
    cout << left << setw(18) << label << right << setw(11) << x << "\n";
}

int main() {
    cout << fixed << setprecision(5);
    dvec3 eye(3, 4, 12), lookat(-0.5, 0.8, -1.2), vup(0.1, 1, 0.2);

    cout << "Task 1\n";
    dvec3 P(-1.6 + 411.5 * 4.0 / 640, -1.1 + 129.5 * 2.4 / 384, -1.5);
    out("P_VCS", P);

    cout << "Task 2\n";
    dvec3 Z = normalize(eye - lookat);
    dvec3 Y = normalize(vup);
    dvec3 X = normalize(cross(Y, Z));
    out("X_vcs", X);
    out("Y_vcs", Y);
    out("Z_vcs", Z);

    cout << "Task 3\n";
    dmat4 M(dvec4(X, 0), dvec4(Y, 0), dvec4(Z, 0), dvec4(eye, 1));
    cout << "M_VCS_to_WCS\n";
    for (int i = 0; i < 4; i++)
        cout << setw(29) << M[0][i] << setw(11) << M[1][i] << setw(11) << M[2][i] << setw(11) << M[3][i] << "\n";

    cout << "Task 4\n";
    dvec3 S = dvec3(M * dvec4(P, 1));
    out("P_WCS", S);

    cout << "Task 5\n";
    dvec3 V = normalize(S - eye);
    out("V", V);

    cout << "Task 6\n";
    dvec3 center(6.6, -1.4, 0.5);
    double R = 1.8;
    dvec3 OC = S - center;
    double a = dot(V, V), b = 2 * dot(OC, V), c = dot(OC, OC) - R;
    double d = b * b - 4 * a * c;
    out("a", a);
    out("b", b);
    out("c", c);
    out("d", d);
    bool hit = d >= 0;
    double t = 0;
    dvec3 ps;
    if (hit) {
        t = (-b - sqrt(d)) / (2 * a);
        ps = S + t * V;
        out("t", t);
        out("P_s", ps);
    } else {
        cout << "t                 does not exist (d < 0)\n";
        cout << "P_s               does not exist\n";
    }

    cout << "Task 7\n";
    if (hit)
        out("N_sphere", normalize(ps - center));
    else
        cout << "N_sphere          does not exist\n";

    cout << "Task 8\n";
    dvec3 A(3.2, -2.25, 3.8), B(8.7, -0.5, 3.1), C(5.4, 4.6, 4.3);
    dmat3 m(B - A, C - A, -V);
    dvec3 r = S - A;
    cout << "matrix (columns u, v, t) and right-hand side\n";
    for (int i = 0; i < 3; i++)
        cout << setw(29) << m[0][i] << setw(11) << m[1][i] << setw(11) << m[2][i] << "   |" << setw(11) << r[i] << "\n";
    dvec3 x = inverse(m) * r;
    out("u", x.x);
    out("v", x.y);
    out("t", x.z);
    out("P_t", S + x.z * V);

    cout << "Task 9\n";
    out("N_triangle", normalize(cross(B - A, C - A)));

    cout << "Task 10\n";
    bool inside = x.x >= 0 && x.y >= 0 && x.x + x.y <= 1 && x.z > 0;
    if (inside && (!hit || x.z < t))
        cout << "ray hits triangle first\n";
    else if (hit)
        cout << "ray hits sphere first\n";
    else
        cout << "ray hits nothing\n";
}
