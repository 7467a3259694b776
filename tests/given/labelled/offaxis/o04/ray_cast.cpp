#include <cmath>
#include <glm/glm.hpp>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>

using namespace std;
typedef glm::dvec3 V3;

// a proper minus sign
string f(double x) {
    ostringstream o;
    o << fixed << setprecision(4) << fabs(x);
    return (x < -0.00005 ? "−" : "") + o.str();
}
string f(V3 p) {
    return "⟨" + f(p.x) + ", " + f(p.y) + ", " + f(p.z) + "⟩";
}

int main() {
    V3 eye(3, 4, 12), lookat(-0.5, 0.8, -1.2), vup(0.1, 1, 0.2), Q(6.6, -1.4, 0.5), A(3.2, -2.25, 3.8),
        B(8.7, -0.5, 3.1), C(5.4, 4.6, 4.3);
    double r = 1.8;

    cout << "§1 Pixel → VCS\n";
    V3 p(-1.6 + 4.0 * (411 + 0.5) / 640, -1.1 + 2.4 * (129 + 0.5) / 384, -1.5);
    cout << "  p⃗ = " << f(p) << "\n";

    cout << "§2 Basis\n";
    V3 ez = normalize(eye - lookat), ex = normalize(cross(vup, ez)), ey = cross(ez, ex);
    cout << "  ê₁ = " << f(ex) << "\n  ê₂ = " << f(ey) << "\n  ê₃ = " << f(ez) << "\n";

    cout << "§3 M (VCS → WCS)\n";
    const char *left[] = {"⎡", "⎢", "⎢", "⎣"}, *right[] = {"⎤", "⎥", "⎥", "⎦"};
    for (int i = 0; i < 4; i++) {
        cout << "  " << left[i];
        if (i < 3)
            cout << " " << f(ex[i]) << "  " << f(ey[i]) << "  " << f(ez[i]) << "  " << f(eye[i]) << " ";
        else
            cout << " " << f(0) << "  " << f(0) << "  " << f(0) << "  " << f(1) << " ";
        cout << right[i] << "\n";
    }

    cout << "§4 Pixel → WCS\n";
    V3 S = eye + p.x * ex + p.y * ey + p.z * ez;
    cout << "  S⃗ = " << f(S) << "\n";

    cout << "§5 Ray\n";
    V3 v = normalize(S - eye);
    cout << "  v̂ = " << f(v) << "\n";

    cout << "§6 Sphere: α t² + 2β t + γ = 0\n";
    V3 w = S - Q;
    double alpha = dot(v, v), beta = dot(v, w), gamma = dot(w, w) - r * r, delta = beta * beta - alpha * gamma;
    cout << "  α = " << f(alpha) << "\n  β = " << f(beta) << "\n  γ = " << f(gamma) << "\n  Δ = β² − αγ = " << f(delta)
         << "\n";
    double t = (-beta - sqrt(delta)) / alpha;
    V3 h = S + t * v;
    cout << "  t = " << f(t) << "\n  P⃗ₛ = " << f(h) << "\n";

    cout << "§7 Normal of the sphere\n  n̂ = " << f(normalize(h - Q)) << "\n";

    cout << "§8 Triangle\n";
    glm::dmat3 m(-v, B - A, C - A);
    V3 rhs = S - A, x = inverse(m) * rhs;
    const char *l3[] = {"⎡", "⎢", "⎣"}, *r3[] = {"⎤", "⎥", "⎦"};
    const char* names[] = {"t", "u", "v"};
    for (int i = 0; i < 3; i++)
        cout << "  " << l3[i] << " " << f(m[0][i]) << "  " << f(m[1][i]) << "  " << f(m[2][i]) << " " << r3[i] << " "
             << l3[i] << names[i] << r3[i] << (i == 1 ? " = " : "   ") << l3[i] << " " << f(rhs[i]) << " " << r3[i]
             << "\n";
    cout << "  t = " << f(x[0]) << "\n  u = " << f(x[1]) << "\n  v = " << f(x[2]) << "\n  P⃗ₜ = " << f(S + x[0] * v)
         << "\n";

    cout << "§9 Normal of the triangle\n  n̂ = " << f(normalize(cross(B - A, C - A))) << "\n";

    cout << "§10 First hit\n  " << f(min(t, x[0])) << " is the smaller t ⇒ ray hits "
         << (x[0] < t ? "triangle" : "sphere") << " first\n";
}
