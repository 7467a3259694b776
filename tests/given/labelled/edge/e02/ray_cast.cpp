/* ray_cast.cpp -- doubles, printf */
#include <cmath>
#include <cstdio>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
typedef glm::dvec3 vec;

#define LINE "+----------------------+-------------+-------------+-------------+\n"

static double z0(double x) {
    return x == 0 ? 0.0 : x;
} /* no minus zero */
static void row3(const char* s, vec p) {
    printf("| %-20s | %11.6f | %11.6f | %11.6f |\n", s, z0(p.x), z0(p.y), z0(p.z));
}
static void row1(const char* s, double x) {
    printf("| %-20s | %11.6f |             |             |\n", s, z0(x));
}
static void title(int n, const char* s) {
    printf(LINE "| Q%-2d %-57s |\n" LINE, n, s);
}

int main(void) {
    vec eye(6, 1, 0), at(0, 1, 0), up(0, 1, 0);
    vec cen(1, 0, 1);
    double R = 2;
    vec A(3, 0, -1), B(3, 0, 1), C(1, 3, 2);

    title(1, "pixel, view coordinates");
    vec pv(-2 + 4 * (150 / 300.0), -1 + 2 * (100 / 200.0), -2);
    row3("P_VCS", pv);

    title(2, "basis");
    vec z = glm::normalize(eye - at), x = glm::normalize(glm::cross(up, z)), y = glm::cross(z, x);
    row3("X_vcs", x);
    row3("Y_vcs", y);
    row3("Z_vcs", z);

    title(3, "M_VCS_to_WCS, by rows");
    glm::dmat4 M = glm::inverse(glm::lookAt(eye, at, up));
    for (int i = 0; i < 4; i++) {
        printf("|");
        for (int j = 0; j < 4; j++) printf(" %13.6f", z0(M[j][i]));
        printf("       |\n");
    }

    title(4, "pixel, world coordinates");
    vec S = vec(M * glm::dvec4(pv, 1));
    row3("P_WCS", S);

    title(5, "direction");
    vec V = glm::normalize(S - eye);
    row3("V", V);

    /* with b = 2h the root is (-h - sqrt(h^2 - ac)) / a */
    title(6, "sphere: a t^2 + 2h t + c = 0");
    vec q = S - cen;
    double a = glm::dot(V, V), h = glm::dot(V, q), c = glm::dot(q, q) - R * R;
    double d = h * h - a * c, t = (-h - sqrt(d)) / a;
    row1("a", a);
    row1("h = b/2", h);
    row1("c", c);
    row1("d/4 = h*h - a*c", d);
    row1("t", t);
    vec ps = S + t * V;
    row3("hit point", ps);

    title(7, "sphere normal");
    row3("N", (ps - cen) / R);

    title(8, "triangle (unknowns u, v, t)");
    vec e1 = B - A, e2 = C - A, r = S - A;
    for (int i = 0; i < 3; i++) {
        char s[20];
        snprintf(s, sizeof s, "matrix row %d", i + 1);
        row3(s, vec(e1[i], e2[i], -V[i]));
    }
    row3("right-hand side", r);
    glm::dmat3 m(e1, e2, -V);
    double D = glm::determinant(m);
    double u = glm::determinant(glm::dmat3(r, e2, -V)) / D;
    double v = glm::determinant(glm::dmat3(e1, r, -V)) / D;
    double tt = glm::determinant(glm::dmat3(e1, e2, r)) / D;
    row1("t", tt);
    row1("u", u);
    row1("v", v);
    row3("hit point", A + u * e1 + v * e2);

    title(9, "triangle normal");
    row3("N", glm::normalize(glm::cross(e1, e2)));

    title(10, "first hit");
    bool hit = tt > 0 && u >= 0 && v >= 0 && u + v <= 1;
    printf("| ray hits %-53s |\n" LINE, hit && tt < t ? "triangle first" : "sphere first");
    return 0;
}
