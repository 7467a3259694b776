// Ray Casting, CS 770
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <iostream>
#include <string>

static void exercise(int n, const std::string& what) {
    std::cout << (n > 1 ? "\n" : "") << "Exercise " << n << " - " << what << "\n";
}

template <typename T>
static void show(const std::string& name, const T& value) {
    std::cout << "    " << name << " = " << glm::to_string(value) << "\n";
}

static void show(const std::string& name, float value) {
    std::cout << "    " << name << " = " << value << "\n";
}

int main() {
    const glm::vec3 eye(3.0f, 4.0f, 12.0f), lookat(-0.5f, 0.8f, -1.2f), vup(0.1f, 1.0f, 0.2f);
    const float clipLeft = -1.6f, clipRight = 2.4f, clipBottom = -1.1f, clipTop = 1.3f, clipNear = 1.5f;
    const float W = 640, H = 384;
    const glm::vec2 P_DCS(411, 129);
    const glm::vec3 sphereCenter(6.6f, -1.4f, 0.5f);
    const float R = 1.8f;
    const glm::vec3 A(3.2f, -2.25f, 3.8f), B(8.7f, -0.5f, 3.1f), C(5.4f, 4.6f, 4.3f);

    exercise(1, "DCS to VCS");
    glm::vec3 P_VCS(clipLeft + (P_DCS.x + 0.5f) / W * (clipRight - clipLeft),
                    clipBottom + (P_DCS.y + 0.5f) / H * (clipTop - clipBottom), -clipNear);
    show("P_DCS", P_DCS);
    show("P_VCS", P_VCS);

    exercise(2, "camera basis");
    glm::vec3 Z = glm::normalize(eye - lookat);
    glm::vec3 X = glm::normalize(glm::cross(vup, Z));
    glm::vec3 Y = glm::cross(Z, X);
    show("X_vcs", X);
    show("Y_vcs", Y);
    show("Z_vcs", Z);

    exercise(3, "view matrix inverse");
    glm::mat4 M = glm::inverse(glm::lookAt(eye, lookat, vup));
    show("M_VCS_to_WCS", M);

    exercise(4, "VCS to WCS");
    glm::vec4 P_WCS = M * glm::vec4(P_VCS, 1.0f);
    show("P_WCS", P_WCS);

    exercise(5, "ray");
    glm::vec3 S = glm::vec3(P_WCS);
    glm::vec3 V = glm::normalize(S - eye);
    show("S", S);
    show("V", V);

    exercise(6, "ray and sphere");
    glm::vec3 L = S - sphereCenter;
    float a = glm::dot(V, V), b = 2.0f * glm::dot(V, L), c = glm::dot(L, L) - R * R;
    float d = b * b - 4.0f * a * c;
    show("a", a);
    show("b", b);
    show("c", c);
    show("d", d);
    float ts = (-b - std::sqrt(d)) / (2.0f * a);
    if (ts <= 0.0f) ts = (-b + std::sqrt(d)) / (2.0f * a);
    show("t", ts);
    glm::vec3 P_s = S + ts * V;
    show("P_s", P_s);

    exercise(7, "sphere normal");
    show("N_s", glm::normalize(P_s - sphereCenter));

    exercise(8, "ray and triangle");
    glm::mat3 mat(-V, B - A, C - A);
    glm::vec3 rhs = S - A;
    show("A", mat);
    show("b", rhs);
    glm::vec3 x = glm::inverse(mat) * rhs;
    show("t", x[0]);
    show("u", x[1]);
    show("v", x[2]);
    glm::vec3 P_t = S + x[0] * V;
    show("P_t", P_t);

    exercise(9, "triangle normal");
    show("N_t", glm::normalize(glm::cross(B - A, C - A)));

    exercise(10, "first object");
    bool inside = x[0] > 0 && x[1] >= 0 && x[2] >= 0 && x[1] + x[2] <= 1;
    std::cout << "    ray hits " << (inside && x[0] < ts ? "triangle" : "sphere") << " first\n";
    return 0;
}
