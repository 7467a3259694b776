#include <bits/stdc++.h>
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>

using namespace std;
using namespace glm;

// homogeneous all the way: points have w = 1, vectors w = 0
vec4 point(float x, float y, float z) { return vec4(x, y, z, 1); }
vec4 unit(vec4 v) { return v / length(v); }
vec4 cross4(vec4 a, vec4 b) { return vec4(cross(vec3(a), vec3(b)), 0); }

void q(int n) { cout << "QUESTION " << n << endl; }
void say(vec4 v) { cout << to_string(v) << endl; }
void say(float f) { cout << f << endl; }

int main() {
  vec4 eye = point(0, 0, 4), lookat = point(0, 0, 0), vup(0, 1, 0, 0);
  vec4 A = point(0, -2, 2), B = point(2, 2, 2), C = point(-2, 2, 2);
  vec4 O = point(1, 1, 0);
  float R = 2;

  q(1);
  vec4 p = point(-2 + 150.5f * (4 / 301.f), -1 + 100.5f * (2 / 201.f), -2);
  say(p);

  q(2);
  vec4 Z = unit(eye - lookat), X = unit(cross4(vup, Z)), Y = cross4(Z, X);
  say(X);
  say(Y);
  say(Z);

  q(3);
  mat4 M(X, Y, Z, eye);
  for (int row = 0; row < 4; row++) {
    for (int col = 0; col < 4; col++) cout << M[col][row] << " ";
    cout << endl;
  }

  q(4);
  vec4 S = M * p;
  say(S);

  q(5);
  vec4 V = unit(S - eye);
  say(V);

  q(6);
  float a = dot(V, V), b = 2 * dot(V, S - O), c = dot(S - O, S - O) - R * R, d = b * b - 4 * a * c;
  say(a);
  say(b);
  say(c);
  say(d);
  float t = std::min((-b - sqrt(d)) / (2 * a), (-b + sqrt(d)) / (2 * a));
  if (t < 0) t = (-b + sqrt(d)) / (2 * a);
  say(t);
  vec4 Ps = S + t * V;
  say(Ps);

  q(7);
  vec4 Ns = unit(Ps - O);
  say(Ns);

  q(8);
  mat3 E(vec3(-V), vec3(B - A), vec3(C - A));
  for (int row = 0; row < 3; row++) {
    for (int col = 0; col < 3; col++) cout << E[col][row] << " ";
    cout << endl;
  }
  vec3 rhs(S - A);
  cout << to_string(rhs) << endl;
  vec3 r = inverse(E) * rhs;
  say(r.x);
  say(r.y);
  say(r.z);
  vec4 Pt = S + r.x * V;
  say(Pt);

  q(9);
  vec4 Nt = unit(cross4(B - A, C - A));
  say(Nt);

  q(10);
  if (r.x < t) cout << "The ray hits the triangle first." << endl;
  else cout << "The ray hits the sphere first." << endl;
}
