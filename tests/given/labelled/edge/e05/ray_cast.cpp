// Ray casting with plain C arrays. Colours so that I can find the answers in my terminal.
#include <math.h>

#include <glm/glm.hpp>
#include <iostream>
#include <string>

using namespace std;

void head(string s) {
    cout << "\033[1;34m== Exercise " << s << " ==\033[0m" << endl;
}
void show(string name, float* p) {
    cout << "\033[32m" << name << "\033[0m\t" << p[0] << "\t" << p[1] << "\t" << p[2] << endl;
}
float det(float a[3], float b[3], float c[3]) {
    return a[0] * (b[1] * c[2] - c[1] * b[2]) - b[0] * (a[1] * c[2] - c[1] * a[2]) + c[0] * (a[1] * b[2] - b[1] * a[2]);
}
void cross(float a[3], float b[3], float r[3]) {
    r[0] = a[1] * b[2] - a[2] * b[1];
    r[1] = a[2] * b[0] - a[0] * b[2];
    r[2] = a[0] * b[1] - a[1] * b[0];
}
void unit(float a[3]) {
    float n = sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    a[0] /= n;
    a[1] /= n;
    a[2] /= n;
}

int main() {
    float eye[] = {6, 1, 0}, at[] = {0, 1, 0}, vup[] = {0, 1, 0};
    float c[] = {1, 0, 1}, R = 2;
    float A[] = {3, 0, -1}, B[] = {3, 0, 1}, C[] = {1, 3, 2};

    head("1");
    float dx = 4.0f / 301, dy = 2.0f / 201;
    float pv[] = {dx * 150.5f - 2, dy * 100.5f - 1, -2};
    show("P_VCS", pv);

    head("2");
    float X[3], Y[3], Z[3];
    for (int i = 0; i < 3; i++) Z[i] = eye[i] - at[i];
    unit(Z);
    cross(vup, Z, X);
    unit(X);
    cross(Z, X, Y);
    show("Z_vcs", Z);
    show("X_vcs", X);
    show("Y_vcs", Y);

    head("3");
    cout << "M_VCS_to_WCS" << endl;
    for (int i = 0; i < 3; i++) cout << X[i] << "\t" << Y[i] << "\t" << Z[i] << "\t" << eye[i] << endl;
    cout << "0\t0\t0\t1" << endl;

    head("4");
    float S[3];
    for (int i = 0; i < 3; i++) S[i] = X[i] * pv[0] + Y[i] * pv[1] + Z[i] * pv[2] + eye[i];
    show("P_WCS", S);

    head("5");
    float V[] = {S[0] - eye[0], S[1] - eye[1], S[2] - eye[2]};
    unit(V);
    show("V", V);

    head("6");
    float qa = 0, qb = 0, qc = -R * R;
    for (int i = 0; i < 3; i++) {
        qa += V[i] * V[i];
        qb += 2 * V[i] * (S[i] - c[i]);
        qc += (S[i] - c[i]) * (S[i] - c[i]);
    }
    float disc = qb * qb - 4 * qa * qc;
    float t = (-qb - sqrt(disc)) / (2 * qa);
    float ps[3];
    for (int i = 0; i < 3; i++) ps[i] = S[i] + t * V[i];
    // answer first, then how I got it
    show("P_s", ps);
    cout << "t\t" << t << endl;
    cout << "discriminant\t" << disc << endl;
    cout << "c\t" << qc << endl << "b\t" << qb << endl << "a\t" << qa << endl;

    head("7");
    float ns[] = {ps[0] - c[0], ps[1] - c[1], ps[2] - c[2]};
    unit(ns);
    show("N", ns);

    head("8");
    float e1[3], e2[3], rhs[3], mv[3];
    for (int i = 0; i < 3; i++) {
        e1[i] = B[i] - A[i];
        e2[i] = C[i] - A[i];
        mv[i] = -V[i];
        rhs[i] = S[i] - A[i];
    }
    float D = det(e1, mv, e2);
    float u = det(rhs, mv, e2) / D, tt = det(e1, rhs, e2) / D, v = det(e1, mv, rhs) / D;
    float pt[3];
    for (int i = 0; i < 3; i++) pt[i] = A[i] + u * e1[i] + v * e2[i];
    show("P_t", pt);
    cout << "u\t" << u << endl << "v\t" << v << endl << "t\t" << tt << endl;
    cout << "matrix, columns for u, t, v" << endl;
    for (int i = 0; i < 3; i++) cout << "\t" << e1[i] << "\t" << mv[i] << "\t" << e2[i] << endl;
    show("right side", rhs);

    head("9");
    float nt[3];
    cross(e1, e2, nt);
    unit(nt);
    show("N", nt);

    head("10");
    if (tt < t)
        cout << "\033[31mray hits triangle first\033[0m" << endl;
    else
        cout << "\033[31mray hits sphere first\033[0m" << endl;
}
