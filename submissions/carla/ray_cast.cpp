// Carla -- CS 870
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtx/string_cast.hpp>
#include <cstdio>
#include <cmath>

static void vec(const char* what, const glm::dvec3& v) { printf("%s: %s\n", what, glm::to_string(v).c_str()); }
static void num(const char* what, double x) { printf("%s: %g\n", what, x); }

struct Scene {
    glm::dvec3 eye{0, 0, 4}, lookat{0, 0, 0}, vup{0, 1, 0};
    glm::dvec3 center{1, 1, 0};
    double radius = 2;
    glm::dvec3 A{0, -2, 2}, B{2, 2, 2}, C{-2, 2, 2};
    double l = -2, r = 2, b = -1, t = 1, n = 2;
    int W = 301, H = 201;
} scene;

int main()
{
    puts("Part 1.");
    glm::dvec3 P(scene.l + (scene.r - scene.l) * (150 + 0.5) / scene.W,
                 scene.b + (scene.t - scene.b) * (100 + 0.5) / scene.H, -scene.n);
    vec("P_VCS", P);

    puts("Part 2.");
    glm::dvec3 Z = glm::normalize(scene.eye - scene.lookat);
    glm::dvec3 X = glm::normalize(glm::cross(scene.vup, Z));
    glm::dvec3 Y = glm::cross(Z, X);
    vec("X_vcs", X); vec("Y_vcs", Y); vec("Z_vcs", Z);

    puts("Part 3.");
    glm::dmat4 M(1.0);
    M[0] = glm::dvec4(X, 0); M[1] = glm::dvec4(Y, 0); M[2] = glm::dvec4(Z, 0); M[3] = glm::dvec4(scene.eye, 1);
    printf("M_VCS_to_WCS: %s\n", glm::to_string(M).c_str());

    puts("Part 4.");
    glm::dvec3 S = glm::dvec3(M * glm::dvec4(P, 1));
    vec("P_WCS", S);

    puts("Part 5.");
    glm::dvec3 V = glm::normalize(S - scene.eye);
    vec("V", V);

    puts("Part 6.");
    glm::dvec3 q = S - scene.center;
    double a = glm::dot(V, V), b = 2 * glm::dot(V, q), c = glm::dot(q, q) - pow(scene.radius, 2);
    double disc = pow(b, 2) - 4 * a * c;
    double t = -b - sqrt(disc) / 2 * a;
    if (t < 0) t = -b + sqrt(disc) / 2 * a;
    num("a", a); num("b", b); num("c", c); num("disc d", disc); num("t", t);
    glm::dvec3 hitS = S + V * t;
    vec("P_s", hitS);

    puts("Part 7.");
    vec("normal", glm::normalize(hitS - scene.center));

    puts("Part 8.");
    glm::dmat3 A(-V, scene.B - scene.A, scene.C - scene.A);
    glm::dvec3 rhs = S - scene.A, sol = glm::inverse(A) * rhs;
    printf("matrix: %s\n", glm::to_string(A).c_str());
    vec("right-hand side", rhs);
    num("t", sol.x); num("u", sol.y); num("v", sol.z);
    vec("P_t", S + V * sol.x);

    puts("Part 9.");
    vec("normal", glm::normalize(glm::cross(scene.B - scene.A, scene.C - scene.A)));

    puts("Part 10.");
    puts(sol.x < t ? "ray hits triangle first" : "ray hits sphere first");
}
