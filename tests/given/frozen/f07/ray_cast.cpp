// CS 870 A6 ray casting
#include <iostream>
#include <cmath>
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/ext.hpp>
#include <glm/gtx/string_cast.hpp>
#define PR(x) std::cout << "  " << #x << " = " << glm::to_string(x) << std::endl
using namespace glm;
using std::cout;
using std::endl;

struct Hit { bool yes; float t; vec3 point; vec3 normal; };

int main()
{
    vec3 center(1, 1, 0);
    float R = 2.f;
    vec3 A(0, -2, 2), B(2, 2, 2), C(-2, 2, 2);
    vec3 eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0);
    vec2 clipX(-2, 2), clipY(-1, 1);
    float clipNear = 2.f;
    vec2 size(301, 201);
    vec2 P_DCS(150, 100);

    cout << "Exercise 1." << endl;
    float alpha = P_DCS.x / (size.x - 1);
    float beta = P_DCS.y / (size.y - 1);
    cout << "  (fractions of the window: " << alpha << " across, " << beta << " up)" << endl;
    vec3 P_VCS(mix(clipX[0], clipX[1], alpha), mix(clipY[0], clipY[1], beta), -clipNear);
    PR(P_VCS);

    cout << "Exercise 2." << endl;
    vec3 Z_vcs = normalize(eye - lookat);
    vec3 X_vcs = normalize(cross(vup, Z_vcs));
    vec3 Y_vcs = cross(Z_vcs, X_vcs);
    PR(X_vcs);
    PR(Y_vcs);
    PR(Z_vcs);

    cout << "Exercise 3." << endl;
    mat4 view = lookAt(eye, lookat, vup);
    mat4 M_VCS_to_WCS = inverse(view);
    PR(view);
    PR(M_VCS_to_WCS);

    cout << "Exercise 4." << endl;
    vec4 P_WCS = M_VCS_to_WCS * vec4(P_VCS, 1);
    PR(P_WCS);

    cout << "Exercise 5." << endl;
    vec3 S(P_WCS);
    cout << "  distance from eye to pixel: " << distance(S, eye) << " units" << endl;
    vec3 V = normalize(S - eye);
    PR(V);

    cout << "Exercise 6." << endl;
    vec3 S_minus_C = S - center;
    PR(S_minus_C);
    float a = dot(V, V), b = 2 * dot(V, S_minus_C), c = dot(S_minus_C, S_minus_C) - R * R;
    float disc = b * b - 4 * a * c;
    cout << "  a = " << a << endl << "  b = " << b << endl << "  c = " << c << endl;
    cout << "  d = " << disc << endl;
    Hit sphere = { disc >= 0, 0, vec3(0), vec3(0) };
    float root1 = (-b - sqrt(disc)) / (2 * a), root2 = (-b + sqrt(disc)) / (2 * a);
    cout << "  root1 = " << root1 << ", root2 = " << root2 << endl;
    sphere.t = root1 > 0 ? root1 : root2;
    sphere.yes = sphere.yes && sphere.t > 0;
    sphere.point = S + sphere.t * V;
    cout << "  t = " << sphere.t << " units" << endl;
    cout << "  Hit: " << (sphere.yes ? "yes" : "no") << endl;
    cout << "  P_s = " << to_string(sphere.point) << endl;

    cout << "Exercise 7." << endl;
    sphere.normal = normalize(sphere.point - center);
    cout << "  N = " << to_string(sphere.normal) << endl;
    float angle = degrees(acos(dot(sphere.normal, -V)));
    cout << "  (angle between N and the ray: " << angle << " degrees)" << endl;

    cout << "Exercise 8." << endl;
    mat3 matrixA(-V, B - A, C - A);
    vec3 rhs = S - A;
    vec3 x = inverse(matrixA) * rhs;
    PR(matrixA);
    PR(rhs);
    Hit tri = { false, x.x, S + x.x * V, normalize(cross(B - A, C - A)) };
    tri.yes = x.x >= 0 && x.y >= 0 && x.y <= 1 && x.z >= 0 && x.z <= 1 && x.y + x.z <= 1;
    cout << "  t = " << tri.t << " units" << endl;
    cout << "  u = " << x.y << endl;
    cout << "  v = " << x.z << endl;
    cout << "  Hit: " << (tri.yes ? "yes" : "no") << endl;
    cout << "  P_t = " << to_string(tri.point) << endl;

    cout << "Exercise 9." << endl;
    cout << "  N = " << to_string(tri.normal) << endl;

    cout << "Exercise 10." << endl;
    bool triFirst = tri.yes && (!sphere.yes || tri.t < sphere.t);
    Hit first = triFirst ? tri : sphere;
    cout << "  ray hits " << (triFirst ? "triangle" : "sphere") << " first" << endl;
    cout << "  position " << to_string(first.point) << ", normal " << to_string(first.normal) << endl;
}
