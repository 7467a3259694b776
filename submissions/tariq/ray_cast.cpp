#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <string>

void vec(std::string label, glm::vec3 v)
{
  std::cout << label << "\n   x = " << v.x << "\n   y = " << v.y << "\n   z = " << v.z << "\n";
}

int main()
{
  std::cout << std::fixed << std::setprecision(5);

  const glm::vec3 eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0);
  const glm::vec3 sphereCenter(1, 1, 0);
  const float sphereRadius = 2;
  const glm::vec3 vertexA(0, -2, 2), vertexB(2, 2, 2), vertexC(-2, 2, 2);

  std::cout << "\n===== Question 1 =====\n";
  glm::vec3 pixelVCS(-2 + 4 * (150 + 0.5f) / 301, -1 + 2 * (100 + 0.5f) / 201, -2);
  vec("pixel in VCS", pixelVCS);

  std::cout << "\n===== Question 2 =====\n";
  glm::vec3 Z = glm::normalize(eye - lookat);
  glm::vec3 X = glm::normalize(glm::cross(vup, Z));
  glm::vec3 Y = glm::cross(Z, X);
  vec("X_vcs", X);
  vec("Y_vcs", Y);
  vec("Z_vcs", Z);

  std::cout << "\n===== Question 3 =====\n";
  glm::mat4 M = glm::inverse(glm::lookAt(eye, lookat, vup));
  std::cout << "M_VCS_to_WCS\n" << glm::to_string(M) << "\n";

  std::cout << "\n===== Question 4 =====\n";
  glm::vec3 pixelWCS = glm::vec3(M * glm::vec4(pixelVCS, 1));
  vec("pixel in WCS", pixelWCS);

  std::cout << "\n===== Question 5 =====\n";
  glm::vec3 V = glm::normalize(pixelWCS - eye);
  vec("V", V);

  std::cout << "\n===== Question 6 =====\n";
  glm::vec3 L = pixelWCS - sphereCenter;
  float a = glm::dot(V, V);
  float b = 2 * glm::dot(V, L);
  float c = glm::dot(L, L) - sphereRadius * sphereRadius;
  float d = b * b - 4 * a * c;
  float t1 = (-b - std::sqrt(d)) / (2 * a);
  float t2 = (-b + std::sqrt(d)) / (2 * a);
  float t = t1 > 0 ? t1 : t2;
  glm::vec3 sphereHit = pixelWCS + t * V;
  std::cout << "a = " << a << "\nb = " << b << "\nc = " << c << "\nd = " << d << "\nt = " << t << "\n";
  vec("hit point", sphereHit);

  std::cout << "\n===== Question 7 =====\n";
  glm::vec3 sphereNormal = sphereHit - sphereCenter;
  vec("sphere normal", sphereNormal);

  std::cout << "\n===== Question 8 =====\n";
  glm::vec3 AB = vertexB - vertexA, AC = vertexC - vertexA;
  glm::mat3 A(-V, AB, AC);
  glm::vec3 rhs = pixelWCS - vertexA;
  float det = glm::determinant(A);
  float tt = glm::determinant(glm::mat3(rhs, AB, AC)) / det;
  float u = glm::determinant(glm::mat3(-V, rhs, AC)) / det;
  float v = glm::determinant(glm::mat3(-V, AB, rhs)) / det;
  std::cout << "matrix A\n" << glm::to_string(A) << "\n";
  vec("right-hand side", rhs);
  std::cout << "t = " << tt << "\nu = " << u << "\nv = " << v << "\n";
  vec("hit point", pixelWCS + tt * V);

  std::cout << "\n===== Question 9 =====\n";
  vec("triangle normal", glm::normalize(glm::cross(AB, AC)));

  std::cout << "\n===== Question 10 =====\n";
  std::cout << (tt < t ? "ray hits triangle first" : "ray hits sphere first") << "\n";
  return 0;
}
