// An honest student's program, graded next to every hostile program. It must always get all its points. It uses neither
// GLM nor iostream, because it is compiled about two hundred times.
#include <cmath>
#include <cstdio>

namespace {

struct Vec {
    double x, y, z;
};

Vec operator+(Vec a, Vec b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Vec operator-(Vec a, Vec b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Vec operator*(double s, Vec a) {
    return {s * a.x, s * a.y, s * a.z};
}
double dot(Vec a, Vec b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vec cross(Vec a, Vec b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Vec normalize(Vec a) {
    return 1 / std::sqrt(dot(a, a)) * a;
}
/// The determinant of the matrix with these columns.
double determinant(Vec a, Vec b, Vec c) {
    return dot(a, cross(b, c));
}

void print(const char* label, Vec v) {
    std::printf("%s = (%.6f, %.6f, %.6f)\n", label, v.x, v.y, v.z);
}
void print(const char* label, double value) {
    std::printf("%s = %.6f\n", label, value);
}
void print_row(double a, double b, double c, double d) {
    std::printf("%.6f %.6f %.6f %.6f\n", a, b, c, d);
}

}  // namespace

int main() {
    const Vec eye = {0, 0, 4}, lookat = {0, 0, 0}, vup = {0, 1, 0};
    const Vec center = {1, 1, 0};
    const Vec A = {0, -2, 2}, B = {2, 2, 2}, C = {-2, 2, 2};

    const Vec P_VCS = {-2 + 4 * (150 + 0.5) / 301, -1 + 2 * (100 + 0.5) / 201, -2};
    print("Question 1\nP_VCS", P_VCS);
    const Vec Z = normalize(eye - lookat), X = normalize(cross(vup, Z)), Y = cross(Z, X);
    print("Question 2\nX_vcs", X);
    print("Y_vcs", Y);
    print("Z_vcs", Z);
    std::puts("Question 3\nM_VCS_to_WCS =");
    print_row(X.x, Y.x, Z.x, eye.x);
    print_row(X.y, Y.y, Z.y, eye.y);
    print_row(X.z, Y.z, Z.z, eye.z);
    print_row(0, 0, 0, 1);
    const Vec P = P_VCS.x * X + P_VCS.y * Y + P_VCS.z * Z + eye;
    print("Question 4\nP_WCS", P);
    const Vec V = normalize(P - eye);
    print("Question 5\nV", V);

    const double a = dot(V, V), b = 2 * dot(V, P - center), c = dot(P - center, P - center) - 4;
    const double d = b * b - 4 * a * c, t_sphere = (-b - std::sqrt(d)) / (2 * a);
    print("Question 6\na", a);
    print("b", b);
    print("c", c);
    print("d", d);
    print("t", t_sphere);
    print("hit", P + t_sphere * V);
    print("Question 7\nnormal", normalize(P + t_sphere * V - center));

    const Vec AB = B - A, AC = C - A, minus_V = -1.0 * V, rhs = P - A;
    const double all = determinant(minus_V, AB, AC), t = determinant(rhs, AB, AC) / all;
    std::puts("Question 8\nmatrix =");
    std::printf("%.6f %.6f %.6f\n", minus_V.x, AB.x, AC.x);
    std::printf("%.6f %.6f %.6f\n", minus_V.y, AB.y, AC.y);
    std::printf("%.6f %.6f %.6f\n", minus_V.z, AB.z, AC.z);
    print("rhs", rhs);
    print("t", t);
    print("u", determinant(minus_V, rhs, AC) / all);
    print("v", determinant(minus_V, AB, rhs) / all);
    print("hit", P + t * V);
    print("Question 9\nnormal", normalize(cross(AB, AC)));
    std::printf("Question 10\nray hits %s first\n", 0 <= t && t < t_sphere ? "triangle" : "sphere");
}
