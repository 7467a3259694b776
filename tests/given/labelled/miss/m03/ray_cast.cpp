/* ray_cast.cpp   all in plain C with doubles */
#include <math.h>
#include <stdio.h>

typedef struct {
    double x, y, z;
} v3;

static v3 mk(double x, double y, double z) {
    v3 r = {x, y, z};
    return r;
}
static v3 add(v3 a, v3 b) {
    return mk(a.x + b.x, a.y + b.y, a.z + b.z);
}
static v3 sub(v3 a, v3 b) {
    return mk(a.x - b.x, a.y - b.y, a.z - b.z);
}
static v3 mul(double s, v3 a) {
    return mk(s * a.x, s * a.y, s * a.z);
}
static double dot(v3 a, v3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
static v3 cross(v3 a, v3 b) {
    return mk(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
static v3 unit(v3 a) {
    return mul(1 / sqrt(dot(a, a)), a);
}
static double det(v3 a, v3 b, v3 c) {
    return dot(a, cross(b, c));
}

/* returns -1 when the ray misses */
static double sphere(v3 S, v3 V, v3 C, double R) {
    v3 L = sub(S, C);
    double a = dot(V, V), b = 2 * dot(V, L), c = dot(L, L) - R * R, d = b * b - 4 * a * c;
    printf("     a*t*t + b*t + c = 0 with a=%.4f b=%.4f c=%.4f\n     d=%.4f\n", a, b, c, d);
    if (d < 0) return -1;
    double t = (-b - sqrt(d)) / (2 * a);
    return t > 0 ? t : (-b + sqrt(d)) / (2 * a);
}

int main() {
    v3 eye = mk(-2.5, 3, 7), look = mk(1, 0.5, -1), up = mk(0, 1, 0), C = mk(3, -1, -2);
    v3 P1 = mk(-4, 0.5, -1), P2 = mk(3, -1.5, 0.5), P3 = mk(0.5, 6.5, -2);

    v3 p = mk(-1.5 + 3 * 200.5 / 480, -1 + 2 * 240.5 / 320, -2.5);
    printf("1)   P_VCS=(%.4f %.4f %.4f)\n", p.x, p.y, p.z);

    v3 Z = unit(sub(eye, look)), X = unit(cross(up, Z)), Y = cross(Z, X);
    printf("2)   X_vcs=(%.4f %.4f %.4f)\n     Y_vcs=(%.4f %.4f %.4f)\n     Z_vcs=(%.4f %.4f %.4f)\n", X.x, X.y, X.z,
           Y.x, Y.y, Y.z, Z.x, Z.y, Z.z);

    printf(
        "3)   M=%8.4f %8.4f %8.4f %8.4f\n       %8.4f %8.4f %8.4f %8.4f\n       %8.4f %8.4f %8.4f %8.4f\n       %8.4f "
        "%8.4f %8.4f %8.4f\n",
        X.x, Y.x, Z.x, eye.x, X.y, Y.y, Z.y, eye.y, X.z, Y.z, Z.z, eye.z, 0., 0., 0., 1.);

    v3 S = add(eye, add(mul(p.x, X), add(mul(p.y, Y), mul(p.z, Z))));
    printf("4)   P_WCS=(%.4f %.4f %.4f)\n", S.x, S.y, S.z);

    v3 V = unit(sub(S, eye));
    printf("5)   V=(%.4f %.4f %.4f)\n", V.x, V.y, V.z);

    printf("6)   sphere\n");
    double t = sphere(S, V, C, 1.5);
    v3 Ps = add(S, mul(t, V));
    if (t > 0)
        printf("     t=%.4f\n     P_s=(%.4f %.4f %.4f)\n", t, Ps.x, Ps.y, Ps.z);
    else
        printf("     t=%.4f (-1 means no hit)\n     P_s=n/a\n", t);

    v3 N = unit(sub(Ps, C));
    if (t > 0)
        printf("7)   N=(%.4f %.4f %.4f)\n", N.x, N.y, N.z);
    else
        printf("7)   N=n/a\n");

    /* t V - u e1 - v e2 = P1 - S */
    v3 f1 = sub(P1, P2), f2 = sub(P1, P3), r = sub(P1, S);
    double D = det(V, f1, f2), tt = det(r, f1, f2) / D, u = det(V, r, f2) / D, v = det(V, f1, r) / D;
    printf("8)   t*V + u*(A-B) + v*(A-C) = A-S\n");
    printf("     A=%8.4f %8.4f %8.4f\n       %8.4f %8.4f %8.4f\n       %8.4f %8.4f %8.4f\n", V.x, f1.x, f2.x, V.y, f1.y,
           f2.y, V.z, f1.z, f2.z);
    printf("     rhs=(%.4f %.4f %.4f)\n", r.x, r.y, r.z);
    printf("     t=%.4f u=%.4f v=%.4f\n", tt, u, v);
    v3 Pt = add(S, mul(tt, V));
    printf("     P_t=(%.4f %.4f %.4f)\n", Pt.x, Pt.y, Pt.z);

    v3 Nt = unit(cross(f1, f2));
    printf("9)   N=(%.4f %.4f %.4f)\n", Nt.x, Nt.y, Nt.z);

    printf("10)  %s\n", t > 0 && t < tt ? "ray hits sphere first" : "ray hits triangle first");
    return 0;
}
