#define GLM_ENABLE_EXPERIMENTAL
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <iostream>

using namespace std;
using namespace glm;

int main() {
    const dvec3 eye(3, 4, 12);
    const dvec3 lookat(-0.5, 0.8, -1.2);
    const dvec3 vup(0.1, 1.0, 0.2);
    const dvec3 center(6.6, -1.4, 0.5);
    const double R = 1.8;
    const dvec3 A(3.2, -2.25, 3.8);
    const dvec3 B(8.7, -0.5, 3.1);
    const dvec3 C(5.4, 4.6, 4.3);

    // scale then translate
    dmat4 toVcs = translate(dmat4(1), dvec3(-1.6, -1.1, -1.5)) * scale(dmat4(1), dvec3(4.0 / 640, 2.4 / 384, 1));
    dvec4 P_VCS = toVcs * dvec4(411, 129, 0, 1);
    cout << "Problem 1\nDCS to VCS matrix: " << to_string(toVcs) << "\nP_VCS: " << to_string(P_VCS) << "\n";

    dvec3 Z_VCS = normalize(eye - lookat);
    dvec3 X_VCS = normalize(cross(vup, Z_VCS));
    dvec3 Y_VCS = cross(Z_VCS, X_VCS);
    cout << "Problem 2\nX_VCS: " << to_string(X_VCS) << "\nY_VCS: " << to_string(Y_VCS)
         << "\nZ_VCS: " << to_string(Z_VCS) << "\n";

    dmat4 M = inverse(lookAt(eye, lookat, vup));
    cout << "Problem 3\nM_VCS_to_WCS: " << to_string(M) << "\n";

    dvec4 P_WCS = M * P_VCS;
    cout << "Problem 4\nP_WCS: " << to_string(P_WCS) << "\n";

    dvec3 S = dvec3(P_WCS);
    dvec3 V = normalize(S - eye);
    cout << "Problem 5\nV: " << to_string(V) << "\n";

    dvec3 k = S - center;
    double a = dot(V, V);
    double b = 2 * dot(V, k);
    double c = dot(k, k) - R * R;
    double d = b * b - 4 * a * c;
    double t1 = (-b - sqrt(d)) / (2 * a);
    dvec3 P_s = S + t1 * V;
    cout << "Problem 6\na: " << a << "\nb: " << b << "\nc: " << c << "\nd: " << d << "\nt: " << t1
         << "\nP_s: " << to_string(P_s) << "\n";

    cout << "Problem 7\nN: " << to_string(normalize(P_s - center)) << "\n";

    dmat3 L(-V, B - A, C - A);
    dvec3 rhs = S - A;
    dvec3 tuv = inverse(L) * rhs;
    cout << "Problem 8\nA: " << to_string(L) << "\nrhs: " << to_string(rhs) << "\n(t, u, v): " << to_string(tuv)
         << "\nP_t: " << to_string(S + tuv.x * V) << "\n";

    cout << "Problem 9\nN: " << to_string(normalize(cross(B - A, C - A))) << "\n";

    cout << "Problem 10\n" << (tuv.x < t1 ? "ray hits triangle first" : "ray hits sphere first") << "\n";
}
