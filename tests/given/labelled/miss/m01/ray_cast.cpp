#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <iostream>

using namespace std;
using namespace glm;

int main() {
    vec3 eye(-2.5, 3, 7), lookat(1, 0.5, -1), vup(0, 1, 0);
    vec3 C(3, -1, -2);
    float R = 1.5;
    vec3 T1(-4, 0.5, -1), T2(3, -1.5, 0.5), T3(0.5, 6.5, -2);
    float W = 480, H = 320;
    vec2 P_DCS(200, 240);

    cout << "Question 1:\tP_VCS\n";
    vec3 P_VCS((P_DCS.x + 0.5) / W * 3 - 1.5, (P_DCS.y + 0.5) / H * 2 - 1, -2.5);
    cout << "\t" << to_string(P_VCS) << "\n";

    cout << "Question 2:\tX_vcs, Y_vcs, Z_vcs\n";
    vec3 Z = normalize(eye - lookat), X = normalize(cross(vup, Z)), Y = cross(Z, X);
    cout << "\t" << to_string(X) << "\n\t" << to_string(Y) << "\n\t" << to_string(Z) << "\n";

    cout << "Question 3:\tM_VCS_to_WCS (column by column)\n";
    mat4 M = inverse(lookAt(eye, lookat, vup));
    for (int i = 0; i < 4; i++) cout << "\t" << to_string(M[i]) << "\n";

    cout << "Question 4:\tP_WCS\n";
    vec3 S = vec3(M * vec4(P_VCS, 1));
    cout << "\t" << to_string(S) << "\n";

    cout << "Question 5:\tV\n";
    vec3 V = normalize(S - eye);
    cout << "\t" << to_string(V) << "\n";

    cout << "Question 6:\ta, b, c; d; t; P_s\n";
    float a = dot(V, V), b = 2 * dot(V, S - C), c = dot(S - C, S - C) - R * R;
    float d = b * b - 4 * a * c;
    cout << "\t" << a << ", " << b << ", " << c << "\n\t" << d << "\n";
    bool sphere = d >= 0;
    float t = 0;
    if (sphere) {
        t = (-b - sqrt(d)) / (2 * a);
        cout << "\t" << t << "\n\t" << to_string(S + t * V) << "\n";
    } else {
        cout << "\tno t, because d is negative\n\tno hit point\n";
    }

    cout << "Question 7:\tN\n";
    if (sphere)
        cout << "\t" << to_string(normalize(S + t * V - C)) << "\n";
    else
        cout << "\tno normal, the ray misses the sphere\n";

    cout << "Question 8:\tA; right-hand side; t, u, v; P_t\n";
    mat3 A(-V, T2 - T1, T3 - T1);
    vec3 rhs = S - T1;
    vec3 x = inverse(A) * rhs;
    for (int i = 0; i < 3; i++) cout << "\t" << to_string(A[i]) << "\n";
    cout << "\t" << to_string(rhs) << "\n";
    cout << "\t" << x[0] << ", " << x[1] << ", " << x[2] << "\n";
    cout << "\t" << to_string(S + x[0] * V) << "\n";

    cout << "Question 9:\tN\n";
    cout << "\t" << to_string(normalize(cross(T2 - T1, T3 - T1))) << "\n";

    cout << "Question 10:\twho is first?\n";
    bool triangle = x[0] > 0 && x[1] >= 0 && x[2] >= 0 && x[1] + x[2] <= 1;
    if (triangle && (!sphere || x[0] < t))
        cout << "\tray hits triangle first\n";
    else if (sphere)
        cout << "\tray hits sphere first\n";
    else
        cout << "\tray hits nothing\n";
}
