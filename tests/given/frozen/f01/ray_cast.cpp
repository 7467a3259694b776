// CS770/870 Assignment 6: Ray Casting
//
// Computes the steps of a ray caster for a single pixel.

#define GLM_ENABLE_EXPERIMENTAL
#include <cmath>
#include <iostream>
#include <glm/glm.hpp>
#include <glm/gtx/string_cast.hpp>

using glm::vec3;
using glm::vec4;
using std::cout;

int main(int argc, char** argv) {
  // The scene
  const vec3 center(1, 1, 0);
  const float radius = 2;
  const vec3 A(0, -2, 2);
  const vec3 B(2, 2, 2);
  const vec3 C(-2, 2, 2);

  // The camera
  const vec3 eye(0, 0, 4);
  const vec3 lookat(0, 0, 0);
  const vec3 vup(0, 1, 0);
  const float left = -2, right = 2, bottom = -1, top = 1, near = 2;
  const float W = 301, H = 201;

  glm::vec2 P_dcs(150, 100);
  cout << "Pixel in DCS: " << glm::to_string(P_dcs) << "\n\n";

  // pixel centers
  vec3 P_vcs(left + (right - left) * (P_dcs.x + 0.5f) / W,
             bottom + (top - bottom) * (P_dcs.y + 0.5f) / H,
             -near);
  cout << "Question 1:\n";
  cout << "P_VCS: " << glm::to_string(P_vcs) << "\n\n";

  vec3 Z = glm::normalize(eye - lookat);
  vec3 X = glm::normalize(glm::cross(vup, Z));
  vec3 Y = glm::cross(Z, X);
  cout << "Question 2:\n";
  cout << "X_vcs: " << glm::to_string(X) << "\n";
  cout << "Y_vcs: " << glm::to_string(Y) << "\n";
  cout << "Z_vcs: " << glm::to_string(Z) << "\n\n";

  glm::mat4 M(vec4(X, 0), vec4(Y, 0), vec4(Z, 0), vec4(eye, 1));
  cout << "Question 3:\n";
  cout << "M_VCS_to_WCS: " << glm::to_string(M) << "\n\n";

  vec4 P_wcs = M * vec4(P_vcs, 1);
  cout << "Question 4:\n";
  cout << "P_WCS: " << glm::to_string(P_wcs) << "\n\n";

  vec3 S = vec3(P_wcs);
  vec3 V = glm::normalize(S - eye);
  cout << "Question 5:\n";
  cout << "V: " << glm::to_string(V) << "\n\n";

  vec3 L = S - center;
  float a = glm::dot(V, V);
  float b = 2 * glm::dot(L, V);
  float c = glm::dot(L, L) - radius * radius;
  float d = b * b - 4 * a * c;
  float t_sphere = (-b - std::sqrt(d)) / (2 * a);
  if (t_sphere <= 0) t_sphere = (-b + std::sqrt(d)) / (2 * a);
  vec3 P_s = S + t_sphere * V;
  cout << "Question 6:\n";
  cout << "a: " << a << "\n";
  cout << "b: " << b << "\n";
  cout << "c: " << c << "\n";
  cout << "discriminant: " << d << "\n";
  cout << "t: " << t_sphere << "\n";
  cout << "hit point: " << glm::to_string(P_s) << "\n\n";

  vec3 N_s = glm::normalize(P_s - center);
  cout << "Question 7:\n";
  cout << "Surface normal: " << glm::to_string(N_s) << "\n\n";

  glm::mat3 K(-V, B - A, C - A);
  vec3 rhs = S - A;
  vec3 x = glm::inverse(K) * rhs;
  vec3 P_t = S + x[0] * V;
  cout << "Question 8:\n";
  cout << "matrix A: " << glm::to_string(K) << "\n";
  cout << "right-hand side: " << glm::to_string(rhs) << "\n";
  cout << "t: " << x[0] << "\n";
  cout << "u: " << x[1] << "\n";
  cout << "v: " << x[2] << "\n";
  cout << "hit point: " << glm::to_string(P_t) << "\n\n";

  cout << "Question 9:\n";
  cout << "Surface normal: " << glm::to_string(glm::normalize(glm::cross(B - A, C - A))) << "\n\n";

  cout << "Question 10:\n";
  cout << (x[0] < t_sphere ? "ray hits triangle first" : "ray hits sphere first") << "\n";
}
