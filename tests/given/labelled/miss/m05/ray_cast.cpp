#include <cmath>
#include <glm/glm.hpp>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <vector>

typedef glm::dvec3 vec;

// collects the answers and prints them at the end
struct Report {
    std::vector<std::ostringstream> q{11};
    std::ostringstream& operator[](int i) { return q[i]; }
    ~Report() {
        for (int i = 1; i <= 10; i++) std::cout << "[Question " << i << "]\n" << q[i].str() << "\n";
    }
};

std::string s(double x) {
    std::ostringstream o;
    o << std::setprecision(6) << x;
    return o.str();
}
std::string s(vec v) {
    return s(v.x) + " | " + s(v.y) + " | " + s(v.z);
}

int main() {
    Report out;
    vec eye(-2.5, 3, 7), at(1, 0.5, -1), up(0, 1, 0);
    vec A(-4, 0.5, -1), B(3, 1.5, 0.5), C(0.5, 6.5, -2);
    vec centre(3, -1, -2);

    // the triangle needs no ray for its normal, so I do question 9 first
    vec e1 = B - A, e2 = C - A;
    out[9] << "  normal of triangle    " << s(normalize(cross(e1, e2))) << "\n";

    vec p(3 * (200.5 / 480 - 0.5), 2 * (240.5 / 320 - 0.5), -2.5);
    out[1] << "  P_VCS                 " << s(p) << "\n";

    vec z = normalize(eye - at), x = normalize(cross(up, z)), y = cross(z, x);
    out[2] << "  X_vcs                 " << s(x) << "\n  Y_vcs                 " << s(y) << "\n  Z_vcs                 "
           << s(z) << "\n";

    out[3] << "  M_VCS_to_WCS          " << s(vec(x.x, y.x, z.x)) << " | " << s(eye.x) << "\n                        "
           << s(vec(x.y, y.y, z.y)) << " | " << s(eye.y) << "\n                        " << s(vec(x.z, y.z, z.z))
           << " | " << s(eye.z) << "\n                        0 | 0 | 0 | 1\n";

    vec S = eye + p.x * x + p.y * y + p.z * z;
    out[4] << "  P_WCS                 " << s(S) << "\n";

    vec V = normalize(S - eye);
    out[5] << "  V                     " << s(V) << "\n";

    double R = 1.5;
    vec L = S - centre;
    double a = dot(V, V), b = 2 * dot(V, L), c = dot(L, L) - pow(R, 2), d = pow(b, 2) - 4 * a * c;
    // sqrt of a negative number gives nan, so take the absolute value
    double root = sqrt(fabs(d));
    double ta = (-b - root) / (2 * a), tb = (-b + root) / (2 * a), t = ta > 0 ? ta : tb;
    vec ps = S + t * V;
    out[6] << "  a                     " << s(a) << "\n  b                     " << s(b) << "\n  c                     "
           << s(c) << "\n  discriminant          " << s(d) << "\n  both roots            " << s(ta) << " , " << s(tb)
           << "\n  t                     " << s(t) << "\n  P_s                   " << s(ps) << "\n";
    out[7] << "  normal of sphere      " << s(normalize(ps - centre)) << "\n";

    glm::dmat3 m(-V, e1, e2);
    vec r = S - A, k = inverse(m) * r;
    out[8] << "  A                     " << s(vec(m[0].x, m[1].x, m[2].x)) << "\n                        "
           << s(vec(m[0].y, m[1].y, m[2].y)) << "\n                        " << s(vec(m[0].z, m[1].z, m[2].z))
           << "\n  right-hand side       " << s(r) << "\n  t                     " << s(k.x)
           << "\n  u                     " << s(k.y) << "\n  v                     " << s(k.z)
           << "\n  P_t                   " << s(S + k.x * V) << "\n";

    out[10] << "  ray hits " << (k.x < t ? "triangle" : "sphere") << " first\n";
}
