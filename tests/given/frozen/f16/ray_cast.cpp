// Ray caster, output as a table
#include <cmath>
#include <cstdio>
#include <string>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

void head() {
  printf("%-3s | %-20s | %10s | %10s | %10s | %10s\n", "Q", "item", "x", "y", "z", "w");
  printf("----+----------------------+------------+------------+------------+-----------\n");
}
void row(int q, const char* item, const glm::vec3& v) {
  printf("%-3d | %-20s | %10.5f | %10.5f | %10.5f |\n", q, item, v.x, v.y, v.z);
}
void row(int q, const char* item, const glm::vec4& v) {
  printf("%-3d | %-20s | %10.5f | %10.5f | %10.5f | %10.5f\n", q, item, v.x, v.y, v.z, v.w);
}
void row(int q, const char* item, float f) {
  printf("%-3d | %-20s | %10.5f |            |            |\n", q, item, f);
}

int main() {
  glm::vec3 eye(0.0f, 0.0f, 4.0f);
  glm::vec3 lookat(0.0f, 0.0f, 0.0f);
  glm::vec3 vup(0.0f, 1.0f, 0.0f);
  glm::vec3 center(1.0f, 1.0f, 0.0f);
  float radius = 2.0f;
  glm::vec3 A(0.0f, -2.0f, 2.0f);
  glm::vec3 B(2.0f, 2.0f, 2.0f);
  glm::vec3 C(-2.0f, 2.0f, 2.0f);

  head();

  glm::vec3 pVcs(-2.0f + 4.0f * 150.0f / 300.0f, -1.0f + 2.0f * 100.0f / 200.0f, -2.0f);
  row(1, "P_VCS", pVcs);

  glm::vec3 Z = glm::normalize(eye - lookat);
  glm::vec3 X = glm::normalize(glm::cross(vup, Z));
  glm::vec3 Y = glm::cross(Z, X);
  row(2, "X_vcs", X);
  row(2, "Y_vcs", Y);
  row(2, "Z_vcs", Z);

  glm::mat4 M = glm::inverse(glm::lookAt(eye, lookat, vup));
  glm::mat4 Mt = glm::transpose(M);
  for (int i = 0; i < 4; i++)
    row(3, ("M_VCS_to_WCS, row " + std::to_string(i + 1)).c_str(), Mt[i]);

  glm::vec4 pWcs = M * glm::vec4(pVcs, 1.0f);
  row(4, "P_WCS", pWcs);

  glm::vec3 S(pWcs);
  glm::vec3 V = glm::normalize(S - eye);
  row(5, "V", V);

  float a = glm::dot(V, V);
  float b = 2.0f * glm::dot(V, S - center);
  float c = glm::dot(S - center, S - center) - radius * radius;
  float d = b * b - 4.0f * a * c;
  float ts = (-b - std::sqrt(d)) / (2.0f * a);
  glm::vec3 Ps = S + ts * V;
  row(6, "a", a);
  row(6, "b", b);
  row(6, "c", c);
  row(6, "d", d);
  row(6, "t (sphere)", ts);
  row(6, "P_s", Ps);
  row(7, "normal of sphere", glm::normalize(Ps - center));

  glm::mat3 K(-V, B - A, C - A);
  glm::mat3 Kt = glm::transpose(K);
  glm::vec3 rhs = S - A;
  glm::vec3 sol = glm::inverse(K) * rhs;
  for (int i = 0; i < 3; i++)
    row(8, ("A, row " + std::to_string(i + 1)).c_str(), Kt[i]);
  row(8, "right-hand side", rhs);
  row(8, "t (triangle)", sol.x);
  row(8, "u", sol.y);
  row(8, "v", sol.z);
  row(8, "P_t", S + sol.x * V);
  row(9, "normal of triangle", glm::normalize(glm::cross(B - A, C - A)));

  const char* first = sol.x < ts ? "ray hits triangle first" : "ray hits sphere first";
  printf("%-3d | %s\n", 10, first);
  return 0;
}
