#include <cmath>
#include <glm/glm.hpp>
#include <iomanip>
#include <iostream>
#include <sstream>
using namespace std;
using V3 = glm::dvec3;

// shows a number, and next to it the fraction when it is a simple one
string num(double x) {
    ostringstream s;
    s << setprecision(10) << x;
    for (int q = 2; q <= 12; q++) {
        double p = round(x * q);
        if (fabs(x - round(x)) > 1e-12 && fabs(x - p / q) < 1e-12) {
            s << " (= " << p << "/" << q << ")";
            break;
        }
    }
    return s.str();
}
string vec(const V3& p) {
    return "( " + num(p.x) + " , " + num(p.y) + " , " + num(p.z) + " )";
}

int main() {
    V3 E(6, 1, 0), L(0, 1, 0), U(0, 1, 0);
    V3 Q(1, 0, 1);
    double rho = 2;
    V3 A(3, 0, -1), B(3, 0, 1), C(1, 3, 2);

    V3 p((150.5 / 301 - 0.5) * 4, (100.5 / 201 - 0.5) * 2, -2);
    cout << "1. p_vcs = " << vec(p) << endl;

    V3 z = normalize(E - L), x = normalize(cross(U, z)), y = cross(z, x);
    cout << "2. x_vcs = " << vec(x) << "\n   y_vcs = " << vec(y) << "\n   z_vcs = " << vec(z) << endl;

    cout << "3. M = \n";
    for (int i = 0; i < 4; i++) {
        cout << "   [ ";
        if (i < 3)
            cout << num(x[i]) << "  " << num(y[i]) << "  " << num(z[i]) << "  " << num(E[i]);
        else
            cout << "0  0  0  1";
        cout << " ]\n";
    }

    V3 S = E + p.x * x + p.y * y + p.z * z;
    cout << "4. p_wcs = " << vec(S) << endl;

    V3 v = normalize(S - E);
    cout << "5. v = " << vec(v) << endl;

    V3 w = S - Q;
    double a = dot(v, v), b = 2 * dot(v, w), c = dot(w, w) - rho * rho, delta = b * b - 4 * a * c;
    double lam = (-b - sqrt(delta)) / (2 * a);
    V3 hs = S + lam * v;
    cout << "6. a = " << num(a) << "\n   b = " << num(b) << "\n   c = " << num(c) << "\n   Δ = " << num(delta)
         << "\n   λ = " << num(lam) << "\n   S + λv = " << vec(hs) << endl;

    cout << "7. n = " << vec(normalize(hs - Q)) << endl;

    // A + β(B-A) + γ(C-A) = S + μ v
    V3 e1 = B - A, e2 = C - A, r = S - A, P = cross(v, e2), T = cross(r, e1);
    double det = dot(e1, P);
    double beta = dot(r, P) / det, gamma = dot(v, T) / det, mu = dot(e2, T) / det;
    cout << "8. β(B-A) + γ(C-A) - μv = S - A, with β = u, γ = v, μ = t\n";
    for (int i = 0; i < 3; i++)
        cout << (i == 1 ? "   A = [ " : "       [ ") << num(e1[i]) << "  " << num(e2[i]) << "  " << num(-v[i])
             << " ]\n";
    cout << "   S - A = " << vec(r) << endl;
    cout << "   β = " << num(beta) << ", γ = " << num(gamma) << ", μ = " << num(mu) << endl;
    cout << "   hit = " << vec(S + mu * v) << endl;
    if (beta == 0) cout << "   (β = 0: exactly on the edge AC, I count it as a hit)" << endl;

    cout << "9. n = " << vec(normalize(cross(e1, e2))) << endl;
    cout << "10. " << (lam < mu ? "ray hits sphere first" : "ray hits triangle first") << endl;
}
