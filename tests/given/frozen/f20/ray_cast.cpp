// Writes the answers as JSON so I can look at them in the browser.
#include <cmath>
#include <iostream>
#include <string>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

using glm::vec3;

std::string arr(vec3 v) {
  return "[" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + "]";
}

template <int N, class Mat>
std::string rowsOf(const Mat& m) {
  std::string s = "[";
  for (int r = 0; r < N; r++) {
    s += r ? ", [" : "[";
    for (int c = 0; c < N; c++)
      s += (c ? ", " : "") + std::to_string(m[c][r]);
    s += "]";
  }
  return s + "]";
}

int main() {
  vec3 center(1, 1, 0);
  float R = 2;
  vec3 A(0, -2, 2), B(2, 2, 2), C(-2, 2, 2);
  vec3 eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0);
  float W = 301, H = 201;
  float left = -2, right = 2, bottom = -1, top = 1, near = 2;

  vec3 pv(left + 150 / (W - 1) * (right - left), bottom + 100 / (H - 1) * (top - bottom), -near);
  vec3 Z = glm::normalize(eye - lookat);
  vec3 X = glm::normalize(glm::cross(vup, Z));
  vec3 Y = glm::cross(Z, X);
  glm::mat4 M = glm::inverse(glm::lookAt(eye, lookat, vup));
  vec3 S(M * glm::vec4(pv, 1));
  vec3 V = S - eye;

  float a = glm::dot(V, V);
  float b = 2 * glm::dot(V, S - center);
  float c = glm::dot(S - center, S - center) - R * R;
  float d = b * b - 4 * a * c;
  float t1 = (-b - std::sqrt(d)) / (2 * a);
  float t2 = (-b + std::sqrt(d)) / (2 * a);
  float ts = t1 > 0 ? t1 : t2;
  vec3 Ps = S + ts * V;
  vec3 Ns = glm::normalize(Ps - center);

  glm::mat3 K(-V, B - A, C - A);
  vec3 rhs = S - A;
  vec3 x = glm::inverse(K) * rhs;
  vec3 Pt = S + x.x * V;
  vec3 Nt = glm::normalize(glm::cross(B - A, C - A));

  std::cout << "{\n"
            << "  \"question1\": { \"P_VCS\": " << arr(pv) << " },\n"
            << "  \"question2\": { \"X_vcs\": " << arr(X) << ", \"Y_vcs\": " << arr(Y) << ", \"Z_vcs\": " << arr(Z) << " },\n"
            << "  \"question3\": { \"M_VCS_to_WCS_rows\": " << rowsOf<4>(M) << " },\n"
            << "  \"question4\": { \"P_WCS\": " << arr(S) << " },\n"
            << "  \"question5\": { \"V\": " << arr(V) << " },\n"
            << "  \"question6\": {\n"
            << "    \"a\": " << a << ",\n"
            << "    \"b\": " << b << ",\n"
            << "    \"c\": " << c << ",\n"
            << "    \"d\": " << d << ",\n"
            << "    \"t\": " << ts << ",\n"
            << "    \"hit\": " << arr(Ps) << "\n"
            << "  },\n"
            << "  \"question7\": { \"normal\": " << arr(Ns) << " },\n"
            << "  \"question8\": {\n"
            << "    \"matrix_rows\": " << rowsOf<3>(K) << ",\n"
            << "    \"rhs\": " << arr(rhs) << ",\n"
            << "    \"t\": " << x.x << ",\n"
            << "    \"u\": " << x.y << ",\n"
            << "    \"v\": " << x.z << ",\n"
            << "    \"hit\": " << arr(Pt) << "\n"
            << "  },\n"
            << "  \"question9\": { \"normal\": " << arr(Nt) << " },\n"
            << "  \"question10\": \"" << (x.x < ts ? "ray hits triangle first" : "ray hits sphere first") << "\"\n"
            << "}\n";
}
