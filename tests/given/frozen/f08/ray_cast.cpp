#include <iostream>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/string_cast.hpp>

using namespace glm;
using namespace std;

vec3 eye(0, 0, 4);
vec3 lookat(0, 0, 0);
vec3 vup(0, 1, 0);

vec3 sphereC(1, 1, 0);
float sphereR = 2;

vec3 A(0, -2, 2);
vec3 B(2, 2, 2);
vec3 C(-2, 2, 2);

float lerpf(float lo, float hi, float f) { return lo + (hi - lo) * f; }

int main() {
    cout << "=== 1. Pixel in view coordinates ===" << endl;
    vec3 pv = vec3(lerpf(-2, 2, 150.0f / 300.0f), lerpf(-1, 1, 100.0f / 200.0f), -2);
    cout << to_string(pv) << endl;

    cout << "=== 2. Basis vectors of VCS ===" << endl;
    vec3 Z = normalize(lookat - eye);
    vec3 X = normalize(cross(vup, Z));
    vec3 Y = cross(Z, X);
    cout << "X " << to_string(X) << endl;
    cout << "Y " << to_string(Y) << endl;
    cout << "Z " << to_string(Z) << endl;

    cout << "=== 3. VCS to WCS ===" << endl;
    mat4 M = inverse(lookAt(eye, lookat, vup));
    cout << to_string(M) << endl;

    cout << "=== 4. Pixel in world coordinates ===" << endl;
    vec4 pw = M * vec4(pv, 1);
    cout << to_string(pw) << endl;

    cout << "=== 5. Ray direction ===" << endl;
    vec3 S = vec3(pw);
    vec3 V = normalize(S - eye);
    cout << to_string(V) << endl;

    cout << "=== 6. Sphere ===" << endl;
    float a = dot(V, V);
    float b = 2.0f * dot(V, S - sphereC);
    float c = dot(S - sphereC, S - sphereC) - sphereR * sphereR;
    float d = b * b - 4 * a * c;
    float t = (-b - sqrt(d)) / (2 * a);
    vec3 hit = S + t * V;
    cout << "a " << a << endl;
    cout << "b " << b << endl;
    cout << "c " << c << endl;
    cout << "d " << d << endl;
    cout << "t " << t << endl;
    cout << "hit point " << to_string(hit) << endl;

    cout << "=== 7. Sphere normal ===" << endl;
    cout << to_string(normalize(hit - sphereC)) << endl;

    cout << "=== 8. Triangle ===" << endl;
    mat3 mat(-V, B - A, C - A);
    vec3 rhs = S - A;
    vec3 tuv = inverse(mat) * rhs;
    cout << "matrix " << to_string(mat) << endl;
    cout << "right-hand side " << to_string(rhs) << endl;
    cout << "t " << tuv[0] << endl;
    cout << "u " << tuv[1] << endl;
    cout << "v " << tuv[2] << endl;
    cout << "hit point " << to_string(S + tuv[0] * V) << endl;

    cout << "=== 10. Which one is first ===" << endl;
    cout << (tuv[0] < t ? "ray hits triangle first" : "ray hits sphere first") << endl;
    return 0;
}
