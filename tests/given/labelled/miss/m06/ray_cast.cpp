#define GLM_ENABLE_EXPERIMENTAL
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <iostream>

namespace cs870 {
struct Camera {
    glm::vec3 eye, lookat, vup;
};
struct Window {
    float left, right, bottom, top, near;
    int W, H;
};
struct Sphere {
    glm::vec3 C;
    float R;
};
struct Triangle {
    glm::vec3 A, B, C;
};
}  // namespace cs870
using namespace cs870;
using glm::to_string;

int main() {
    Camera cam{{-2.5, 3, 7}, {1, 0.5, -1}, {0, 1, 0}};
    Window win{-1.5, 1.5, -1, 1, 2.5, 480, 320};
    Sphere sph{{3, -1, -2}, 1.5};
    Triangle tri{{-4, 0.5, -1}, {3, -1.5, 0.5}, {0.5, 6.5, -2}};

    auto q = [](int n) { std::cout << "-----Q" << n << "-----\n"; };

    q(1);
    glm::vec3 Pv(win.left + 200 * (win.right - win.left) / (win.W - 1),
                 win.bottom + 240 * (win.top - win.bottom) / (win.H - 1), -win.near);
    std::cout << "P_VCS=" << to_string(Pv) << "\n";

    q(2);
    glm::vec3 Z = glm::normalize(cam.eye - cam.lookat);
    glm::vec3 X = glm::normalize(glm::cross(cam.vup, Z));
    glm::vec3 Y = glm::normalize(glm::cross(Z, X));
    std::cout << "X_vcs=" << to_string(X) << "\nY_vcs=" << to_string(Y) << "\nZ_vcs=" << to_string(Z) << "\n";

    q(3);
    glm::mat4 M = glm::inverse(glm::lookAt(cam.eye, cam.lookat, cam.vup));
    std::cout << "M_VCS_to_WCS=" << to_string(M) << "\n";

    q(4);
    glm::vec4 Pw = M * glm::vec4(Pv, 0);
    std::cout << "P_WCS=" << to_string(Pw) << "\n";

    q(5);
    glm::vec3 S(Pw), V = glm::normalize(S - cam.eye);
    std::cout << "V=" << to_string(V) << "\n";

    q(6);
    glm::vec3 D = S - sph.C;
    float a = glm::dot(V, V), b = 2 * glm::dot(V, D), c = glm::dot(D, D) - sph.R * sph.R, d = b * b - 4 * a * c;
    std::cout << "a=" << a << "\nb=" << b << "\nc=" << c << "\nd=" << d << "\n";
    float ts = -1;
    if (d > 0) {
        float r1 = (-b - std::sqrt(d)) / (2 * a), r2 = (-b + std::sqrt(d)) / (2 * a);
        ts = r1 > 0 ? r1 : r2;
    }
    if (ts > 0)
        std::cout << "t=" << ts << "\nP_s=" << to_string(S + ts * V) << "\n";
    else
        std::cout << "t=none\nP_s=none\n";

    q(7);
    if (ts > 0)
        std::cout << "N=" << to_string(glm::normalize(S + ts * V - sph.C)) << "\n";
    else
        std::cout << "N=none\n";

    q(8);
    glm::mat3 A(-V, tri.B - tri.A, tri.C - tri.A);
    glm::vec3 B = S - tri.A, x = glm::inverse(A) * B;
    bool ht = x.x > 0 && x.y >= 0 && x.z >= 0 && x.y + x.z <= 1;
    std::cout << "A=" << to_string(A) << "\nB=" << to_string(B) << "\nt=" << x.x << "\nu=" << x.y << "\nv=" << x.z
              << "\nP_t=" << to_string(S + x.x * V) << (ht ? "" : " (not inside)") << "\n";

    q(9);
    glm::vec3 n = (tri.A + tri.B + tri.C) / 3.0f;
    n = glm::normalize(glm::cross(tri.A - n, tri.B - n));
    std::cout << "N=" << to_string(n) << "\n";

    q(10);
    if (ht && (ts < 0 || x.x < ts))
        std::cout << "ray hits triangle first\n";
    else if (ts > 0)
        std::cout << "ray hits sphere first\n";
    else
        std::cout << "ray hits neither sphere nor triangle\n";
}
