#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <iomanip>
#include <iostream>
#include <utility>

using namespace std;
using glm::vec3;

void p(vec3 v) {
    cout << v.x << "\t" << v.y << "\t" << v.z << endl;
}

int main() {
    cout << setprecision(3);

    vec3 eye(3, 4, 12), lookat(-.5, .8, -1.2), vup(.1, 1, .2);
    float left = -1.6, right = 2.4, bottom = -1.1, top = 1.3, near = 1.5;

    cout << "Ex. 1" << endl;
    vec3 pix(left + 411.0 / 639 * (right - left), bottom + 129.0 / 383 * (top - bottom), -near);
    p(pix);

    cout << "Ex. 2" << endl;
    vec3 Z = normalize(eye - lookat), X = normalize(cross(vup, Z)), Y = normalize(cross(Z, X));
    cout << "X_vcs\t";
    p(X);
    cout << "Y_vcs\t";
    p(Y);
    cout << "Z_vcs\t";
    p(Z);

    cout << "Ex. 3" << endl;
    glm::mat4 M = inverse(glm::lookAt(eye, lookat, vup));
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) cout << setw(10) << (fabs(M[j][i]) < 1e-5 ? 0 : M[j][i]);
        cout << endl;
    }

    cout << "Ex. 4" << endl;
    vec3 S = vec3(M * glm::vec4(pix, 1));
    p(S);

    cout << "Ex. 5" << endl;
    vec3 V = normalize(S - eye);
    p(V);

    cout << "Ex. 6" << endl;
    vec3 c(6.6, -1.4, .5);
    float r = 1.8;
    float qa = dot(V, V), qb = 2 * dot(V, S - c), qc = dot(S - c, S - c) - r * r;
    float disc = qb * qb - 4 * qa * qc;
    cout << "coefficients\t" << qa << "\t" << qb << "\t" << qc << endl;
    cout << "discriminant\t" << disc << endl;
    float t = (-qb - sqrt(disc)) / (2 * qa);
    cout << "t\t" << t << endl;
    cout << "hit\t";
    p(S + t * V);

    cout << "Ex. 7" << endl;
    p(normalize(S + t * V - c));

    cout << "Ex. 8" << endl;
    vec3 A(3.2, -2.25, 3.8), B(8.7, -.5, 3.1), C(5.4, 4.6, 4.3);
    float m[3][4];
    for (int i = 0; i < 3; i++) {
        m[i][0] = -V[i];
        m[i][1] = B[i] - A[i];
        m[i][2] = C[i] - A[i];
        m[i][3] = S[i] - A[i];
        // every equation divided by its largest coefficient, then pivoting is easy
        float big = 0;
        for (int j = 0; j < 3; j++) big = max(big, fabs(m[i][j]));
        for (int j = 0; j < 4; j++) m[i][j] /= big;
    }
    cout << "matrix (t u v), each row scaled to a largest coefficient of 1" << endl;
    for (int i = 0; i < 3; i++) cout << setw(10) << m[i][0] << setw(10) << m[i][1] << setw(10) << m[i][2] << endl;
    cout << "right-hand side, scaled too" << endl;
    for (int i = 0; i < 3; i++) cout << setw(10) << m[i][3] << endl;
    for (int k = 0; k < 3; k++) {
        int best = k;
        for (int i = k; i < 3; i++)
            if (fabs(m[i][k]) > fabs(m[best][k])) best = i;
        swap(m[k], m[best]);
        for (int i = 0; i < 3; i++) {
            if (i == k) continue;
            float f = m[i][k] / m[k][k];
            for (int j = k; j < 4; j++) m[i][j] -= f * m[k][j];
        }
    }
    float tt = m[0][3] / m[0][0], u = m[1][3] / m[1][1], v = m[2][3] / m[2][2];
    cout << "t\t" << tt << endl << "u\t" << u << endl << "v\t" << v << endl;
    cout << "hit\t";
    p(A + u * (B - A) + v * (C - A));

    cout << "Ex. 9" << endl;
    p(normalize(cross(B - A, C - A)));

    cout << "Ex. 10" << endl;
    cout << "ray hits " << (tt < t ? "triangle" : "sphere") << " first" << endl;
}
