#include <cmath>
#include <iostream>
#include <sstream>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

std::string str(glm::vec3 v) {
  std::ostringstream s;
  s << v.x << "\t" << v.y << "\t" << v.z;
  return s.str();
}

int main() {
  // camera
  glm::vec3 eye(0, 0, 4);
  glm::vec3 at(0, 0, 0);
  glm::vec3 up(0, 1, 0);

  // pixel
  float px = 150, py = 100, w = 301, h = 201;
  glm::vec3 pv(-2 + px / (w - 1) * 4, -1 + py / (h - 1) * 2, -2);
  std::cout << "Q.1\tP_VCS\t" << str(pv) << "\n";

  // basis
  glm::vec3 n = glm::normalize(eye - at);
  glm::vec3 u = glm::normalize(glm::cross(up, n));
  glm::vec3 v = glm::cross(n, u);
  std::cout << "Q.2\tX_vcs\t" << str(u) << "\n";
  std::cout << "\tY_vcs\t" << str(v) << "\n";
  std::cout << "\tZ_vcs\t" << str(n) << "\n";

  glm::mat4 rot(1.0f);
  rot[0] = glm::vec4(u, 0);
  rot[1] = glm::vec4(v, 0);
  rot[2] = glm::vec4(n, 0);
  glm::mat4 m = glm::translate(glm::mat4(1.0f), eye) * rot;
  std::cout << "Q.3\tM_VCS_to_WCS\n";
  for (int r = 0; r < 4; r++)
    std::cout << "\t" << m[0][r] << "\t" << m[1][r] << "\t" << m[2][r] << "\t" << m[3][r] << "\n";

  glm::vec3 s = glm::vec3(m * glm::vec4(pv, 1));
  std::cout << "Q.4\tP_WCS\t" << str(s) << "\n";

  glm::vec3 dir = glm::normalize(s - eye);
  std::cout << "Q.5\tV\t" << str(dir) << "\n";

  // sphere
  glm::vec3 cen(1, 1, 0);
  float rad = 2;
  float a = glm::dot(dir, dir);
  float b = 2 * glm::dot(dir, s - cen);
  float c = glm::dot(s - cen, s - cen) - rad;
  float d = b * b - 4 * a * c;
  if (d < 0) {
    std::cout << "no hit with sphere\n";
    return 1;
  }
  float ts = (-b - std::sqrt(d)) / (2 * a);
  glm::vec3 ps = s + ts * dir;
  std::cout << "Q.6\ta\t" << a << "\n\tb\t" << b << "\n\tc\t" << c << "\n";
  std::cout << "\td\t" << d << "\n\tt\t" << ts << "\n";
  std::cout << "\tP_s\t" << str(ps) << "\n";
  std::cout << "Q.7\tN_s\t" << str(glm::normalize(ps - cen)) << "\n";

  // triangle
  glm::vec3 A(0, -2, 2);
  glm::vec3 B(2, 2, 2);
  glm::vec3 C(-2, 2, 2);
  glm::mat3 k(-dir, B - A, C - A);
  glm::vec3 rhs = s - A;
  glm::vec3 sol = glm::inverse(k) * rhs;
  std::cout << "Q.8\tA\n";
  for (int r = 0; r < 3; r++)
    std::cout << "\t" << k[0][r] << "\t" << k[1][r] << "\t" << k[2][r] << "\n";
  std::cout << "\trhs\t" << str(rhs) << "\n";
  std::cout << "\tt\t" << sol.x << "\n\tu\t" << sol.y << "\n\tv\t" << sol.z << "\n";
  std::cout << "\tP_t\t" << str(s + sol.x * dir) << "\n";
  std::cout << "Q.9\tN_t\t" << str(glm::normalize(glm::cross(C - A, B - A))) << "\n";

  std::cout << "Q.10\t";
  if (sol.x < ts)
    std::cout << "ray hits triangle first\n";
  else
    std::cout << "ray hits sphere first\n";
  return 0;
}
