#define GLM_ENABLE_EXPERIMENTAL
#include <glm/ext.hpp>
#include <glm/glm.hpp>
#include <glm/gtx/string_cast.hpp>
#include <iostream>
using namespace std;
using namespace glm;

// The book's quadratic with half the linear coefficient: a t^2 + 2 b' t + c = 0,
// so d' = b'^2 - a c and t = (-b' -+ sqrt(d')) / a.
struct HalfQuadratic {
    double a, b, c;
    double d() const { return b * b - a * c; }
    double first() const {
        double near = (-b - sqrt(d())) / a, far = (-b + sqrt(d())) / a;
        return near > 0 ? near : far;
    }
};

int main() {
    dvec3 eye(0, 0, 4), at(0), up(0, 1, 0);
    dvec3 centre(1, 1, 0), A(0, -2, 2), B(2, 2, 2), C(-2, 2, 2);

    dvec3 pixel(mix(-2.0, 2.0, 150.0 / 300.0), mix(-1.0, 1.0, 100.0 / 200.0), -2.0);
    cout << "Question 1: P_VCS = " << to_string(pixel) << endl;

    dvec3 Z = normalize(eye - at), X = normalize(cross(up, Z)), Y = cross(Z, X);
    cout << "Question 2: X_vcs = " << to_string(X) << endl
         << "            Y_vcs = " << to_string(Y) << endl
         << "            Z_vcs = " << to_string(Z) << endl;

    dmat4 toWorld = inverse(lookAt(eye, at, up));
    cout << "Question 3: M_VCS_to_WCS = " << to_string(toWorld) << endl;

    dvec3 S(toWorld * dvec4(pixel, 1));
    cout << "Question 4: P_WCS = " << to_string(S) << endl;

    dvec3 V = normalize(S - eye);
    cout << "Question 5: V = " << to_string(V) << endl;

    dvec3 SC = S - centre;
    HalfQuadratic q{dot(V, V), dot(V, SC), dot(SC, SC) - 2 * 2};
    double t = q.first();
    dvec3 Ps = S + t * V;
    cout << "Question 6: (half-b form: a t^2 + 2 b' t + c = 0)" << endl
         << "            a = " << q.a << endl
         << "            b' = " << q.b << endl
         << "            c = " << q.c << endl
         << "            d' = b'^2 - ac = " << q.d() << endl
         << "            t = " << t << endl
         << "            P_s = " << to_string(Ps) << endl;

    cout << "Question 7: N = " << to_string(normalize(Ps - centre)) << endl;

    dmat3 M(V, A - B, A - C);  // t V + u (A-B) + v (A-C) = A - S
    dvec3 rhs = A - S;
    dvec3 tuv = inverse(M) * rhs;
    dvec3 Pt = S + tuv.x * V;
    cout << "Question 8: A = " << to_string(M) << endl
         << "            rhs = " << to_string(rhs) << endl
         << "            t = " << tuv.x << endl
         << "            u = " << tuv.y << endl
         << "            v = " << tuv.z << endl
         << "            P_t = " << to_string(Pt) << endl;

    cout << "Question 9: N = " << to_string(normalize(cross(B - A, C - A))) << endl;

    cout << "Question 10: " << (tuv.x < t ? "ray hits triangle first" : "ray hits sphere first") << endl;
}
