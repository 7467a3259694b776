#define GLM_ENABLE_EXPERIMENTAL
#include <cmath>
#include <iostream>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>

int main() {
  glm::vec3 eye{0, 0, 4}, lookat{0, 0, 0}, vup{0, 1, 0};
  float W = 301, H = 201;

  glm::vec3 P{-2.f + 4.f * (150.f + .5f) / W, -1.f + 2.f * (100.f + .5f) / H, -2.f};
  std::cout << "Question 1 - pixel in VCS\n" << glm::to_string(P) << "\n";

  glm::mat4 view = glm::lookAt(eye, lookat, vup);
  glm::vec3 X{view[0][0], view[1][0], view[2][0]};
  glm::vec3 Y{view[0][1], view[1][1], view[2][1]};
  glm::vec3 Z{view[0][2], view[1][2], view[2][2]};
  std::cout << "Question 2 - X_vcs, Y_vcs, Z_vcs\n"
            << glm::to_string(X) << "\n" << glm::to_string(Y) << "\n" << glm::to_string(Z) << "\n";

  glm::mat4 M = glm::inverse(view);
  std::cout << "Question 3 - M_VCS_to_WCS\n" << glm::to_string(M) << "\n";

  glm::vec4 S = M * glm::vec4{P, 1};
  std::cout << "Question 4 - pixel in WCS\n" << glm::to_string(S) << "\n";

  glm::vec4 V = glm::normalize(S - glm::vec4{eye, 1});
  std::cout << "Question 5 - V\n" << glm::to_string(V) << "\n";

  glm::vec4 SC = S - glm::vec4{1, 1, 0, 1};
  float a = glm::dot(V, V), b = 2 * glm::dot(V, SC), c = glm::dot(SC, SC) - 2 * 2;
  float d = b * b - 4 * a * c;
  float t = (-b - std::sqrt(d)) / (2 * a);
  glm::vec4 hit = S + t * V;
  std::cout << "Question 6 - sphere\n"
            << "a " << a << ", b " << b << ", c " << c << "\n"
            << "d " << d << "\n"
            << "t " << t << "\n"
            << "hit point " << glm::to_string(hit) << "\n";

  std::cout << "Question 7 - sphere normal\n" << glm::to_string(glm::normalize(hit - glm::vec4{1, 1, 0, 1})) << "\n";

  std::cout << "Question 8 - triangle\nran out of time\n";
  return 0;
}
