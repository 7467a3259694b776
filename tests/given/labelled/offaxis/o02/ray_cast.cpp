#include <math.h>
#include <stdio.h>
#include <string.h>

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

using glm::dvec3;

void question(int n) {
    char buf[64];
    sprintf(buf, "Question %d ", n);
    printf("%s", buf);
    for (size_t i = strlen(buf); i < 60; i++) putchar('.');
    putchar('\n');
}

/* one column under the other */
void column(const char* name, dvec3 v) {
    printf("%14s | %15.10f |\n", "", v[0]);
    printf("%12s = | %15.10f |\n", name, v[1]);
    printf("%14s | %15.10f |\n", "", v[2]);
}

int main() {
    dvec3 eye(3, 4, 12), lookat(-0.5, 0.8, -1.2), vup(0.1, 1, 0.2);
    double x0 = -1.6, x1 = 2.4, y0 = -1.1, y1 = 1.3, near = 1.5;
    int W = 640, H = 384, px = 411, py = 129;

    question(1);
    dvec3 pv;
    pv.x = x0 + (x1 - x0) * px / (W - 1);
    pv.y = y0 + (y1 - y0) * py / (H - 1);
    pv.z = -near;
    column("P_vcs", pv);

    question(2);
    dvec3 k = glm::normalize(eye - lookat), i = glm::normalize(glm::cross(vup, k)), j = glm::cross(k, i);
    column("X_vcs", i);
    column("Y_vcs", j);
    column("Z_vcs", k);

    question(3);
    glm::dmat4 M = glm::inverse(glm::lookAt(eye, lookat, vup));
    for (int r = 0; r < 4; r++)
        printf("%s| %14.10f %14.10f %14.10f %14.10f |\n", r == 1 ? "M_VCS_to_WCS = " : "               ", M[0][r],
               M[1][r], M[2][r], M[3][r]);

    question(4);
    dvec3 S(M * glm::dvec4(pv, 1));
    column("P_wcs", S);

    question(5);
    dvec3 V = glm::normalize(S - eye);
    column("V", V);

    question(6);
    dvec3 cen(6.6, -1.4, 0.5), q = S - cen;
    double rad = 1.8;
    double a = glm::dot(V, V), b = 2 * glm::dot(V, q), c = glm::dot(q, q) - rad * rad, d = b * b - 4 * a * c;
    printf("%12s = %.10f\n%12s = %.10f\n%12s = %.10f\n%12s = %.10f\n", "a", a, "b", b, "c", c, "d", d);
    double t1 = (-b - sqrt(d)) / (2 * a), t2 = (-b + sqrt(d)) / (2 * a);
    double ts = t1 > 0 ? t1 : t2;
    printf("%12s = %.10f, t2 = %.10f\n%12s = %.10f\n", "t1", t1, t2, "t", ts);
    dvec3 ps = S + ts * V;
    column("P_s", ps);

    question(7);
    column("N", glm::normalize(ps - cen));

    question(8);
    dvec3 A(3.2, -2.25, 3.8), B(8.7, -0.5, 3.1), C(5.4, 4.6, 4.3), e1 = B - A, e2 = C - A, rhs = S - A;
    for (int r = 0; r < 3; r++)
        printf("%s| %14.10f %14.10f %14.10f |   | %s |   | %14.10f |\n", r == 1 ? "  system   " : "           ", e1[r],
               e2[r], -V[r],
               r == 0   ? "u"
               : r == 1 ? "v"
                        : "t",
               rhs[r]);
    dvec3 s = glm::inverse(glm::dmat3(e1, e2, -V)) * rhs;
    printf("%12s = %.10f\n%12s = %.10f\n%12s = %.10f\n", "t", s.z, "u", s.x, "v", s.y);
    column("P_t", S + s.z * V);

    question(9);
    column("N", glm::normalize(glm::cross(e1, e2)));

    question(10);
    puts(s.z > 0 && s.x >= 0 && s.y >= 0 && s.x + s.y <= 1 && s.z < ts ? "ray hits triangle first"
                                                                       : "ray hits sphere first");
    return 0;
}
