#include <cmath>
#include <iostream>
#include <string>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

using namespace std;
using namespace glm;

void kv(string key, float f) { cout << key << " -> " << f << "\n"; }
void kv(string key, string s) { cout << key << " -> " << s << "\n"; }
void kv(string key, vec3 v) { cout << key << " -> " << v.x << " " << v.y << " " << v.z << "\n"; }
void kv(string key, vec4 v) { cout << key << " -> " << v.x << " " << v.y << " " << v.z << " " << v.w << "\n"; }

int main()
{
    vec3 sphereCenter(1, 1, 0);
    float sphereRadius = 2;
    vec3 A(0, -2, 2), B(2, 2, 2), C(-2, 2, 2);
    vec3 eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0);
    float l = -2, r = 2, b = -1, t = 1, n = 2;
    float W = 301, H = 201;

    vec3 pixVcs(l + 150 * (r - l) / (W - 1), b + 100 * (t - b) / (H - 1), -n);
    kv("pixel.vcs", pixVcs);

    vec3 Z = normalize(eye - lookat);
    vec3 X = normalize(cross(vup, Z));
    vec3 Y = cross(Z, X);
    kv("camera.x_vcs", X);
    kv("camera.y_vcs", Y);
    kv("camera.z_vcs", Z);

    // view matrix
    mat4 M = lookAt(eye, lookat, vup);
    mat4 rows = transpose(M);
    for (int i = 0; i < 4; i++)
        kv("camera.vcs_to_wcs.row" + to_string(i), rows[i]);

    vec4 pixWcs = M * vec4(pixVcs, 1);
    kv("pixel.wcs", pixWcs);

    vec3 S(pixWcs);
    vec3 V = normalize(S - eye);
    kv("ray.v", V);

    vec3 SC = S - sphereCenter;
    float qa = dot(V, V), qb = 2 * dot(V, SC), qc = dot(SC, SC) - sphereRadius * sphereRadius;
    float qd = qb * qb - 4 * qa * qc;
    kv("sphere.a", qa);
    kv("sphere.b", qb);
    kv("sphere.c", qc);
    kv("sphere.d", qd);
    float ts = (-qb - sqrt(qd)) / (2 * qa);
    if (ts < 0)
        ts = (-qb + sqrt(qd)) / (2 * qa);
    bool sphereHit = qd >= 0 && ts >= 0;
    if (sphereHit) {
        vec3 Ps = S + ts * V;
        kv("sphere.t", ts);
        kv("sphere.hit", Ps);
        kv("sphere.normal", normalize(Ps - sphereCenter));
    } else {
        kv("sphere.t", "none");
        kv("sphere.hit", "none");
        kv("sphere.normal", "none");
    }

    mat3 K(-V, B - A, C - A);
    mat3 krows = transpose(K);
    vec3 rhs = S - A;
    vec3 sol = inverse(K) * rhs;
    for (int i = 0; i < 3; i++)
        kv("triangle.matrix.row" + to_string(i), krows[i]);
    kv("triangle.rhs", rhs);
    kv("triangle.t", sol.x);
    kv("triangle.u", sol.y);
    kv("triangle.v", sol.z);
    kv("triangle.hit", S + sol.x * V);
    kv("triangle.normal", normalize(cross(B - A, C - A)));

    bool triHit = sol.x >= 0 && sol.y >= 0 && sol.z >= 0 && sol.y + sol.z <= 1;
    if (triHit && (!sphereHit || sol.x < ts))
        kv("result", "ray hits triangle first");
    else if (sphereHit)
        kv("result", "ray hits sphere first");
    else
        kv("result", "ray hits nothing");
    return 0;
}
