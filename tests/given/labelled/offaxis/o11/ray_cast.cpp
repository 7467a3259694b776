#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <iostream>

using namespace std;
using namespace glm;

// Jacobi iteration: repeat until the solution does not change any more
dvec3 solve(dmat3 A, dvec3 b) {
    dvec3 x(0), old;
    do {
        old = x;
        for (int i = 0; i < 3; i++) {
            double s = b[i];
            for (int j = 0; j < 3; j++)
                if (j != i) s -= A[j][i] * old[j];
            x[i] = s / A[i][i];
        }
    } while (!(length(x - old) < 1e-6));
    return x;
}

int main() {
    dvec3 eye(3, 4, 12), lookat(-0.5, 0.8, -1.2), vup(0.1, 1, 0.2);

    cout << "Question 1:" << endl;
    dvec3 P_VCS(-1.6 + (411 + 0.5) * 4 / 640, -1.1 + (129 + 0.5) * 2.4 / 384, -1.5);
    cout << "P_VCS = " << to_string(P_VCS) << endl;

    cout << "Question 2:" << endl;
    dvec3 Z_vcs = normalize(eye - lookat);
    dvec3 X_vcs = cross(vup, Z_vcs);
    dvec3 Y_vcs = cross(Z_vcs, X_vcs);
    cout << "X_vcs = " << to_string(X_vcs) << endl;
    cout << "Y_vcs = " << to_string(Y_vcs) << endl;
    cout << "Z_vcs = " << to_string(Z_vcs) << endl;

    cout << "Question 3:" << endl;
    dmat4 M_VCS_to_WCS(dvec4(X_vcs, 0), dvec4(Y_vcs, 0), dvec4(Z_vcs, 0), dvec4(eye, 1));
    cout << "M_VCS_to_WCS = " << to_string(M_VCS_to_WCS) << endl;

    cout << "Question 4:" << endl;
    dvec4 P_WCS = M_VCS_to_WCS * dvec4(P_VCS, 1);
    cout << "P_WCS = " << to_string(P_WCS) << endl;

    cout << "Question 5:" << endl;
    dvec3 S(P_WCS);
    dvec3 V = normalize(S - eye);
    cout << "V = " << to_string(V) << endl;

    cout << "Question 6:" << endl;
    dvec3 center(6.6, -1.4, 0.5);
    double a = dot(V, V), b = 2 * dot(V, S - center), c = dot(S - center, S - center) - 1.8 * 1.8;
    double d = b * b - 4 * a * c;
    cout << "a = " << a << endl;
    cout << "b = " << b << endl;
    cout << "c = " << c << endl;
    cout << "d = " << d << endl;
    double t = (-b - sqrt(d)) / (2 * a);
    dvec3 P_s = S + t * V;
    cout << "t = " << t << endl;
    cout << "P_s = " << to_string(P_s) << endl;

    cout << "Question 7:" << endl;
    cout << "N = " << to_string(normalize(P_s - center)) << endl;

    cout << "Question 8:" << endl;
    dvec3 A(3.2, -2.25, 3.8), B(8.7, -0.5, 3.1), C(5.4, 4.6, 4.3);
    dmat3 mat(-V, B - A, C - A);
    dvec3 rhs = S - A;
    cout << "A = " << to_string(mat) << endl;
    cout << "rhs = " << to_string(rhs) << endl;
    dvec3 tuv = solve(mat, rhs);
    cout << "t = " << tuv.x << endl;
    cout << "u = " << tuv.y << endl;
    cout << "v = " << tuv.z << endl;
    cout << "P_t = " << to_string(S + tuv.x * V) << endl;

    cout << "Question 9:" << endl;
    cout << "N = " << to_string(normalize(cross(B - A, C - A))) << endl;

    cout << "Question 10:" << endl;
    if (tuv.x < t)
        cout << "ray hits triangle first" << endl;
    else
        cout << "ray hits sphere first" << endl;
    return 0;
}
