// Assignment 6, 2024
#include <cmath>
#include <glm/glm.hpp>
#include <iomanip>
#include <iostream>

using glm::vec3;
using std::cout;

struct Cylinder {
    vec3 center;
    float radius, height;
};

static void print(const char* name, vec3 p) {
    cout << name << " = (" << p.x << ", " << p.y << ", " << p.z << ")\n";
}

int main() {
    const vec3 eye(6, 1, 0), lookat(0, 1, 0), vup(0, 1, 0);
    const float left = -2, right = 2, bottom = -1, top = 1, nearDist = 2;
    const int W = 401, H = 301, px = 200, py = 150;
    const vec3 sphereCenter(1, 0, 1);
    const float R = 2;
    const vec3 A(3, -1, -1), B(3, -1, 1), C(1, 3, 0);
    const Cylinder cyl{vec3(2, 0, 0), 1, 4};
    cout << std::setprecision(7);

    cout << "Question 1\n";
    const vec3 P_VCS(left + (px + 0.5f) / W * (right - left), bottom + (py + 0.5f) / H * (top - bottom), -nearDist);
    print("P_VCS", P_VCS);
    const vec3 Z = glm::normalize(eye - lookat), X = glm::normalize(glm::cross(vup, Z)), Y = glm::cross(Z, X);
    print("X_vcs", X);
    print("Y_vcs", Y);
    print("Z_vcs", Z);
    cout << "M_VCS_to_WCS\n";
    for (int i = 0; i < 3; ++i) cout << X[i] << " " << Y[i] << " " << Z[i] << " " << eye[i] << "\n";
    cout << "0 0 0 1\n";
    const vec3 S = eye + P_VCS.x * X + P_VCS.y * Y + P_VCS.z * Z;
    print("P_WCS", S);
    const vec3 V = glm::normalize(S - eye);
    print("V", V);

    cout << "Question 2\n";
    const vec3 f = S - sphereCenter;
    const float a = glm::dot(V, V), b = 2 * glm::dot(V, f), c = glm::dot(f, f) - R * R, d = b * b - 4 * a * c;
    cout << "a = " << a << "\nb = " << b << "\nc = " << c << "\nd = " << d << "\n";
    float ts = -1;
    if (d >= 0) {
        ts = (-b - std::sqrt(d)) / (2 * a);
        if (ts < 0) ts = (-b + std::sqrt(d)) / (2 * a);
    }
    if (ts > 0) {
        cout << "t = " << ts << "\n";
        print("P_s", S + ts * V);
        print("N", glm::normalize(S + ts * V - sphereCenter));
    } else {
        cout << "t = none\nP_s = none\nN = none\n";
    }

    cout << "Question 3\n";
    const glm::mat3 M(-V, B - A, C - A);
    cout << "Matrix\n";
    for (int i = 0; i < 3; ++i) cout << M[0][i] << " " << M[1][i] << " " << M[2][i] << "\n";
    print("Right-hand side", S - A);
    const vec3 tuv = glm::inverse(M) * (S - A);
    cout << "t = " << tuv.x << "\nu = " << tuv.y << "\nv = " << tuv.z << "\n";
    print("P_t", S + tuv.x * V);
    print("N", glm::normalize(glm::cross(B - A, C - A)));
    const bool in = tuv.x > 0 && tuv.y >= 0 && tuv.z >= 0 && tuv.y + tuv.z <= 1;

    cout << "Question 4\n";
    float tc = -1;
    vec3 Nc(0);
    const float yMax = cyl.center.y + cyl.height / 2, yMin = cyl.center.y - cyl.height / 2;
    const vec3 g = S - cyl.center;
    const float ca = V.x * V.x + V.z * V.z, cb = 2 * (g.x * V.x + g.z * V.z),
                cc = g.x * g.x + g.z * g.z - cyl.radius * cyl.radius, cd = cb * cb - 4 * ca * cc;
    if (ca > 0 && cd >= 0) {
        for (float sign : {-1.0f, 1.0f}) {
            const float t = (-cb + sign * std::sqrt(cd)) / (2 * ca);
            const vec3 P = S + t * V;
            if (t > 0 && P.y >= yMin && P.y <= yMax && (tc < 0 || t < tc)) {
                tc = t;
                Nc = glm::normalize(vec3(P.x - cyl.center.x, 0, P.z - cyl.center.z));
            }
        }
    }
    for (float sign : {-1.0f, 1.0f}) {
        if (V.y == 0) continue;
        const float t = ((sign > 0 ? yMax : yMin) - S.y) / V.y;
        const vec3 P = S + t * V - cyl.center;
        if (t > 0 && P.x * P.x + P.z * P.z < cyl.radius * cyl.radius && (tc < 0 || t < tc)) {
            tc = t;
            Nc = vec3(0, sign, 0);
        }
    }
    if (tc > 0) {
        cout << "t = " << tc << "\n";
        print("P_c", S + tc * V);
        print("N", Nc);
    } else {
        cout << "t = none\nP_c = none\nN = none\n";
    }

    cout << "Question 5\n";
    const float far = 1e30f, s = ts > 0 ? ts : far, t = in ? tuv.x : far, k = tc > 0 ? tc : far;
    if (s == far && t == far && k == far)
        cout << "ray hits nothing\n";
    else if (s <= t && s <= k)
        cout << "ray hits sphere first\n";
    else if (t <= k)
        cout << "ray hits triangle first\n";
    else
        cout << "ray hits cylinder first\n";
}
