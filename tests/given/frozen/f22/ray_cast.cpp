#include <cmath>
#include <iostream>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
using namespace std;
using namespace glm;
ostream &operator<<(ostream &os, const vec3 &v) { return os << '(' << v.x << ' ' << v.y << ' ' << v.z << ')'; }
ostream &operator<<(ostream &os, const vec4 &v) { return os << '(' << v.x << ' ' << v.y << ' ' << v.z << ' ' << v.w << ')'; }

int main() {
    vec3 Q(1, 1, 0), A(0, -2, 2), B(2, 2, 2), C(-2, 2, 2), eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0);
    float R = 2, cl = -2, cr = 2, cb = -1, ct = 1, cn = 2, W = 301, H = 201, xd = 150, yd = 100;

    // camera
    vec3 P(cl + xd / (W - 1) * (cr - cl), cb + yd / (H - 1) * (ct - cb), -cn);
    vec3 Z = normalize(eye - lookat), X = normalize(cross(vup, Z)), Y = cross(Z, X);
    mat4 M = inverse(lookAt(eye, lookat, vup)), T = transpose(M);
    vec3 S = vec3(M * vec4(P, 1.f)), V = normalize(S - eye);
    cout << "Q1 P_VCS = " << P << "; Q2 X = " << X << ", Y = " << Y << ", Z = " << Z
         << "; Q3 M (rows) = " << T[0] << ' ' << T[1] << ' ' << T[2] << ' ' << T[3]
         << "; Q4 P_WCS = " << S << "; Q5 V = " << V << '\n';

    // sphere
    vec3 D = S - Q;
    float a = dot(V, V), b = 2 * dot(V, D), c = dot(D, D) - R * R, d = b * b - 4 * a * c;
    float ts = (-b - std::sqrt(d)) / (2 * a);
    if (ts < 0) ts = (-b + std::sqrt(d)) / (2 * a);
    vec3 Ps = S + ts * V, Ns = normalize(Ps - Q);
    cout << "Q6 a = " << a << ", b = " << b << ", c = " << c << ", d = " << d << ", t = " << ts
         << ", P_s = " << Ps << "; Q7 N_s = " << Ns << '\n';

    // triangle
    mat3 K(-V, B - A, C - A), L = transpose(K);
    vec3 rhs = S - A, x = inverse(K) * rhs, Pt = S + x.x * V, Nt = normalize(cross(B - A, C - A));
    cout << "Q8 A (rows) = " << L[0] << ' ' << L[1] << ' ' << L[2] << ", rhs = " << rhs
         << ", t = " << x.x << ", u = " << x.y << ", v = " << x.z << ", P_t = " << Pt
         << "; Q9 N_t = " << Nt << '\n';

    cout << "Q10 ray hits " << (x.x < ts ? "triangle" : "sphere") << " first\n";
}
