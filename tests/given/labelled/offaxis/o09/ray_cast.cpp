#include <array>
#include <cmath>
#include <iostream>
// I print JSON because then I can look at it in the browser.

using Vec = std::array<double, 3>;

Vec operator+(Vec a, Vec b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vec operator-(Vec a, Vec b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vec operator*(double s, Vec a) {
    return {s * a[0], s * a[1], s * a[2]};
}
double dot(Vec a, Vec b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vec cross(Vec a, Vec b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec normalize(Vec a) {
    return 1 / std::sqrt(dot(a, a)) * a;
}
double det(Vec a, Vec b, Vec c) {
    return dot(a, cross(b, c));
}

std::ostream& operator<<(std::ostream& o, Vec v) {
    return o << "[" << v[0] << ", " << v[1] << ", " << v[2] << "]";
}

int main() {
    Vec eye{3, 4, 12}, lookat{-0.5, 0.8, -1.2}, vup{0.1, 1, 0.2};
    Vec center{6.6, -1.4, 0.5}, A{3.2, -2.25, 3.8}, B{8.7, -0.5, 3.1}, C{5.4, 4.6, 4.3};
    double R = 1.8;

    std::cout << "{\n";
    Vec p{-1.6 + 4 * 411.5 / 640, -1.1 + 2.4 * 129.5 / 384, -1.5};
    std::cout << "  \"Question 1\": { \"P_VCS\": " << p << " },\n";

    Vec Z = normalize(eye - lookat), X = normalize(cross(vup, Z)), Y = cross(Z, X);
    std::cout << "  \"Question 2\": { \"X_vcs\": " << X << ", \"Y_vcs\": " << Y << ", \"Z_vcs\": " << Z << " },\n";

    std::cout << "  \"Question 3\": { \"M_VCS_to_WCS\": [";
    for (int i = 0; i < 3; i++) std::cout << "[" << X[i] << ", " << Y[i] << ", " << Z[i] << ", " << eye[i] << "], ";
    std::cout << "[0, 0, 0, 1]] },\n";

    Vec S = eye + p[0] * X + p[1] * Y + p[2] * Z;
    std::cout << "  \"Question 4\": { \"P_WCS\": " << S << " },\n";

    Vec V = normalize(lookat - eye);
    std::cout << "  \"Question 5\": { \"V\": " << V << " },\n";

    Vec w = S - center;
    double a = dot(V, V), b = 2 * dot(V, w), c = dot(w, w) - R * R, d = b * b - 4 * a * c;
    bool hs = d >= 0;
    double ts = hs ? (-b - std::sqrt(d)) / (2 * a) : 0;
    std::cout << "  \"Question 6\": { \"a\": " << a << ", \"b\": " << b << ", \"c\": " << c << ", \"d\": " << d;
    if (hs)
        std::cout << ", \"t\": " << ts << ", \"P_s\": " << S + ts * V << " },\n";
    else
        std::cout << ", \"t\": null, \"P_s\": null },\n";
    if (hs)
        std::cout << "  \"Question 7\": { \"N\": " << normalize(S + ts * V - center) << " },\n";
    else
        std::cout << "  \"Question 7\": { \"N\": null },\n";

    Vec c1 = -1 * V, c2 = B - A, c3 = C - A, r = S - A;
    double D = det(c1, c2, c3), tt = det(r, c2, c3) / D, u = det(c1, r, c3) / D, v = det(c1, c2, r) / D;
    std::cout << "  \"Question 8\": { \"matrix\": [";
    for (int i = 0; i < 3; i++) std::cout << "[" << c1[i] << ", " << c2[i] << ", " << c3[i] << (i < 2 ? "], " : "]]");
    std::cout << ", \"rhs\": " << r << ", \"t\": " << tt << ", \"u\": " << u << ", \"v\": " << v
              << ", \"P_t\": " << S + tt * V << " },\n";

    std::cout << "  \"Question 9\": { \"N\": " << normalize(cross(C - A, B - A)) << " },\n";

    bool ht = tt > 0 && u >= 0 && v >= 0 && u + v <= 1;
    std::cout << "  \"Question 10\": \""
              << (ht && (!hs || tt < ts) ? "ray hits triangle first"
                  : hs                   ? "ray hits sphere first"
                                         : "ray hits nothing")
              << "\"\n}\n";
}
