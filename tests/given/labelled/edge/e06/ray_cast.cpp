#define GLM_ENABLE_EXPERIMENTAL
#include <cmath>
#include <cstdlib>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <iostream>

using namespace std;
using namespace glm;

void print(const char* name, vec3 v) {
    cout << name << endl;
    cout << "   x = " << v.x << endl;
    cout << "   y = " << v.y << endl;
    cout << "   z = " << v.z << endl;
}

int main(int argc, char* argv[]) {
    // camera
    vec3 eye = vec3(6.0f, 1.0f, 0.0f);
    vec3 lookat = vec3(0.0f, 1.0f, 0.0f);
    vec3 vup = vec3(0.0f, 1.0f, 0.0f);
    float clipLeft = -2.0f, clipRight = 2.0f, clipBottom = -1.0f, clipTop = 1.0f, clipNear = 2.0f;
    float W = 301.0f, H = 201.0f;
    vec2 P_dcs = vec2(150.0f, 100.0f);

    cout << "QUESTION 1" << endl;
    float dx = (clipRight - clipLeft) / W;
    float dy = (clipTop - clipBottom) / H;
    vec3 P_vcs = vec3(clipLeft + dx / 2 + P_dcs.x * dx, clipBottom + dy / 2 + P_dcs.y * dy, -clipNear);
    print("P_vcs", P_vcs);

    cout << "QUESTION 2" << endl;
    vec3 Z = normalize(eye - lookat);
    vec3 X = normalize(cross(vup, Z));
    vec3 Y = cross(Z, X);
    print("X_vcs", X);
    print("Y_vcs", Y);
    print("Z_vcs", Z);

    cout << "QUESTION 3" << endl;
    mat4 M = inverse(lookAt(eye, lookat, vup));
    for (int c = 0; c < 4; c++) {
        cout << "column " << c << endl;
        for (int r = 0; r < 4; r++) cout << "   " << M[c][r] << endl;
    }

    cout << "QUESTION 4" << endl;
    vec3 P_wcs = vec3(M * vec4(P_vcs, 1.0f));
    print("P_wcs", P_wcs);

    cout << "QUESTION 5" << endl;
    vec3 V = normalize(P_wcs - eye);
    print("V", V);

    cout << "QUESTION 6" << endl;
    vec3 center = vec3(1.0f, 0.0f, 1.0f);
    float radius = 2.0f;
    vec3 sc = P_wcs - center;
    float a = dot(V, V);
    float b = 2 * dot(sc, V);
    float c = dot(sc, sc) - radius * radius;
    float d = b * b - 4 * a * c;
    cout << "a" << endl << "   " << a << endl;
    cout << "b" << endl << "   " << b << endl;
    cout << "c" << endl << "   " << c << endl;
    cout << "d" << endl << "   " << d << endl;
    float t = -1;
    if (d >= 0) {
        float t0 = (-b - sqrt(d)) / (2 * a);
        float t1 = (-b + sqrt(d)) / (2 * a);
        if (t0 > 0) t = t0;
        if (t1 > 0) t = t1;
    }
    cout << "t" << endl << "   " << t << endl;
    vec3 P_s = P_wcs + t * V;
    print("P_s", P_s);

    cout << "QUESTION 7" << endl;
    vec3 N_s = normalize(P_s - center);
    print("N", N_s);

    cout << "QUESTION 8" << endl;
    vec3 A = vec3(3.0f, 0.0f, -1.0f), B = vec3(3.0f, 0.0f, 1.0f), C = vec3(1.0f, 3.0f, 2.0f);
    mat3 mat = mat3(-V, B - A, C - A);
    vec3 rhs = P_wcs - A;
    for (int c = 0; c < 3; c++) {
        cout << "column " << c << endl;
        for (int r = 0; r < 3; r++) cout << "   " << mat[c][r] << endl;
    }
    print("rhs", rhs);
    vec3 sol = inverse(mat) * rhs;
    cout << "t" << endl << "   " << sol.x << endl;
    cout << "u" << endl << "   " << sol.y << endl;
    cout << "v" << endl << "   " << sol.z << endl;
    vec3 P_t = P_wcs + sol.x * V;
    print("P_t", P_t);

    cout << "QUESTION 9" << endl;
    vec3 N_t = normalize(cross(B - A, C - A));
    print("N", N_t);

    cout << "QUESTION 10" << endl;
    if (sol.x < t)
        cout << "ray hits triangle first" << endl;
    else
        cout << "ray hits sphere first" << endl;
    return EXIT_SUCCESS;
}
