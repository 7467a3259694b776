#define GLM_ENABLE_EXPERIMENTAL
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <iostream>

namespace a6 {
template <typename... Parts>
void out(Parts const &... parts) {
  (std::cout << ... << parts) << '\n';
}

struct camera_t {
  glm::vec3 eye, lookat, vup;
  [[nodiscard]] auto basis() const {
    auto const z = glm::normalize(eye - lookat);
    auto const x = glm::normalize(glm::cross(vup, z));
    return std::array<glm::vec3, 3>{x, glm::cross(z, x), z};
  }
  [[nodiscard]] auto to_world() const { return glm::inverse(glm::lookAt(eye, lookat, vup)); }
};

struct sphere_t {
  glm::vec3 c;
  float r;
};

struct triangle_t {
  glm::vec3 a, b, c;
};
}  // namespace a6

auto main() -> int {
  using a6::out;
  using glm::to_string;

  a6::camera_t const camera{{0, 0, 4}, {0, 0, 0}, {0, 1, 0}};
  a6::sphere_t const sphere{{1, 1, 0}, 2};
  a6::triangle_t const tri{{0, -2, 2}, {2, 2, 2}, {-2, 2, 2}};

  auto const pixel = glm::vec3{glm::mix(-2.f, 2.f, 150.5f / 301.f), glm::mix(-1.f, 1.f, 100.5f / 201.f), -2.f};
  out("Question 1: ", to_string(pixel));

  auto const [x, y, z] = camera.basis();
  out("Question 2:");
  out("X_vcs ", to_string(x));
  out("Y_vcs ", to_string(y));
  out("Z_vcs ", to_string(z));

  auto const m = camera.to_world();
  out("Question 3: ", to_string(m));

  auto const s = glm::vec3{m * glm::vec4{pixel, 1}};
  out("Question 4: ", to_string(s));

  auto const v = glm::normalize(s - camera.eye);
  out("Question 5: ", to_string(v));

  auto const oc = s - sphere.c;
  auto const qa = glm::dot(v, v);
  auto const qb = 2 * glm::dot(oc, v);
  auto const qc = glm::dot(oc, oc) - sphere.r * sphere.r;
  auto const disc = qb * qb - 4 * qa * qc;
  auto const t0 = (-qb - std::sqrt(disc)) / (2 * qa);
  auto const t1 = (-qb + std::sqrt(disc)) / (2 * qa);
  auto const ts = t0 > 0 ? t0 : t1;
  auto const ps = s + ts * v;
  out("Question 6:");
  out("a b c: ", qa, " ", qb, " ", qc);
  out("d: ", disc);
  out("t: ", ts);
  out("hit: ", to_string(ps));

  out("Question 7: ", to_string(glm::normalize(ps - sphere.c)));

  auto const lhs = glm::mat3{tri.b - tri.a, tri.c - tri.a, -v};
  auto const rhs = s - tri.a;
  auto const solution = glm::inverse(lhs) * rhs;
  auto const tt = solution[0], u = solution[1], w = solution[2];
  auto const pt = s + tt * v;
  out("Question 8:");
  out("A: ", to_string(lhs));
  out("rhs: ", to_string(rhs));
  out("t: ", tt, ", u: ", u, ", v: ", w);
  out("hit: ", to_string(pt));

  out("Question 9: ", to_string(glm::normalize(glm::cross(tri.b - tri.a, tri.c - tri.a))));

  out("Question 10: ray hits ", tt < ts ? "triangle" : "sphere", " first");
}
