#define GLM_ENABLE_EXPERIMENTAL
#include <cmath>
#include <iomanip>
#include <iostream>

#include "glm/glm.hpp"
#include "glm/gtc/matrix_transform.hpp"
#include "glm/gtx/string_cast.hpp"

using namespace glm;
using std::cout;
using std::endl;

#define BANNER(n) cout << "\n*****************\n*  QUESTION " << std::setw(2) << n << "  *\n*****************\n"

int main() {
    dvec3 eye(6, 1, 0);
    dvec3 lookat(0, 1, 0);
    dvec3 vup(0, 1, 0);
    dvec3 sc(1, 0, 1);
    double sr = 2;
    dvec3 p1(3, 0, -1), p2(3, 0, 1), p3(1, 3, 2);

    cout << std::setprecision(8);

    BANNER(1);
    dvec4 Pvcs(-2 + (150 + 0.5) * 4 / 301, -1 + (100 + 0.5) * 2 / 201, -2, 1);
    cout << "P_VCS = " << to_string(Pvcs) << endl;

    BANNER(2);
    dvec3 zv = normalize(eye - lookat);
    dvec3 xv = normalize(cross(vup, zv));
    dvec3 yv = normalize(cross(zv, xv));
    cout << "X_VCS = " << to_string(xv) << endl;
    cout << "Y_VCS = " << to_string(yv) << endl;
    cout << "Z_VCS = " << to_string(zv) << endl;

    BANNER(3);
    dmat4 view = lookAt(eye, lookat, vup);
    dmat4 inv = inverse(view);
    cout << "view         = " << to_string(view) << endl;
    cout << "M_VCS_to_WCS = " << to_string(inv) << endl;
    cout << "check: view * M_VCS_to_WCS = " << to_string(view * inv) << endl;

    BANNER(4);
    dvec4 Pwcs = inv * Pvcs;
    cout << "P_WCS = " << to_string(Pwcs) << endl;

    BANNER(5);
    dvec4 dir = normalize(Pwcs - dvec4(eye, 1));
    cout << "eye   = " << to_string(eye) << endl;
    cout << "V     = " << to_string(dir) << endl;
    cout << "|V|   = " << length(dir) << endl;

    BANNER(6);
    dvec3 S(Pwcs), V(dir), w = S - sc;
    double a = dot(V, V), b = 2.0 * dot(V, w), c = dot(w, w) - sr * sr, d = pow(b, 2) - 4 * a * c;
    cout << "a = " << a << ",  b = " << b << ",  c = " << c << endl;
    cout << "d = " << d << "  (two roots)" << endl;
    double tplus = (-b + sqrt(d)) / (2 * a), tminus = (-b - sqrt(d)) / (2 * a);
    cout << "t+ = " << tplus << ",  t- = " << tminus << endl;
    double ts = min(tplus, tminus);
    cout << "smaller positive t = " << ts << endl;
    dvec3 Ps = S + ts * V;
    cout << "P_s = " << to_string(Ps) << endl;

    BANNER(7);
    cout << "N = P_s - C = " << to_string(Ps - sc) << endl;
    cout << "normalized  = " << to_string(normalize(Ps - sc)) << endl;

    BANNER(8);
    dvec3 e1 = p2 - p1;
    dvec3 e2 = p3 - p2;
    dmat3 A(-V, e1, e2);
    dvec3 rhs = S - p1;
    dvec3 x = inverse(A) * rhs;
    cout << "A   = " << to_string(A) << endl;
    cout << "rhs = " << to_string(rhs) << endl;
    cout << "inverse of A = " << to_string(inverse(A)) << endl;
    cout << "t = " << x.x << endl << "u = " << x.y << endl << "v = " << x.z << endl;
    cout << "u + v = " << x.y + x.z << endl;
    cout << "P_t = " << to_string(S + x.x * V) << endl;

    BANNER(9);
    cout << "N = " << to_string(cross(e1, e2)) << endl;
    cout << "N normalized = " << to_string(normalize(cross(e1, e2))) << endl;

    BANNER(10);
    cout << "t sphere = " << ts << ", t triangle = " << x.x << endl;
    cout << (ts < x.x ? "ray hits sphere first" : "ray hits triangle first") << endl;
}
