#include <iostream>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
using namespace std;

int main() {
  // camera stuff
  glm::vec3 eye(0.f, 0.f, 4.f), lookat(0.f), vup(0.f, 1.f, 0.f);
  float left = -2, right = 2, bottom = -1, top = 1, near = 2;
  int W = 301, H = 201, px = 150, py = 100;

  cout << "Question 1:" << endl;
  float dx = (right - left) / (W - 1);
  float dy = (top - bottom) / (H - 1);
  glm::vec3 pixel(left + px * dx, bottom + py * dy, -near);
  cout << "P_VCS = " << glm::to_string(pixel) << endl;
  cout << endl;

  cout << "Question 2:" << endl;
  glm::vec3 zv = glm::normalize(eye - lookat);
  glm::vec3 xv = glm::normalize(glm::cross(vup, zv));
  glm::vec3 yv = glm::cross(zv, xv);
  cout << "X_vcs = " << glm::to_string(xv) << endl;
  cout << "Y_vcs = " << glm::to_string(yv) << endl;
  cout << "Z_vcs = " << glm::to_string(zv) << endl;
  cout << endl;

  cout << "Question 3:" << endl;
  glm::mat4 viewMatrix = glm::lookAt(eye, lookat, vup);
  glm::mat4 inv = glm::inverse(viewMatrix);
  cout << "M_VCS_to_WCS = " << glm::to_string(inv) << endl;
  cout << endl;

  cout << "Question 4:" << endl;
  glm::vec4 world = inv * glm::vec4(pixel, 1.f);
  cout << "P_WCS = " << glm::to_string(world) << endl;
  cout << endl;

  cout << "Question 5:" << endl;
  glm::vec3 S(world.x, world.y, world.z);
  glm::vec3 V = glm::normalize(S - eye);
  cout << "V = " << glm::to_string(V) << endl;
  cout << endl;

  cout << "Question 6:" << endl;
  glm::vec3 C(1.f, 1.f, 0.f);
  float R = 2.f;
  float a = glm::dot(V, V);
  float b = 2.f * glm::dot(V, S - C);
  float c = glm::dot(S - C, S - C) - R * R;
  float d = b * b - 4.f * a * c;
  float root1 = (-b + sqrt(d)) / (2.f * a);
  float root2 = (-b - sqrt(d)) / (2.f * a);
  float t;
  if (root1 > 0) t = root1;   // take the first positive one
  else t = root2;
  glm::vec3 Ps = S + t * V;
  cout << "a = " << a << endl;
  cout << "b = " << b << endl;
  cout << "c = " << c << endl;
  cout << "d = " << d << endl;
  cout << "t = " << t << endl;
  cout << "P_s = " << glm::to_string(Ps) << endl;
  cout << endl;

  cout << "Question 7:" << endl;
  glm::vec3 N = glm::normalize(Ps - C);
  cout << "N = " << glm::to_string(N) << endl;
  cout << endl;

  cout << "Question 8:" << endl;
  glm::vec3 t1(0.f, -2.f, 2.f), t2(2.f, 2.f, 2.f), t3(-2.f, 2.f, 2.f);
  glm::mat3 A(-V, t2 - t1, t3 - t1);
  glm::vec3 rhs = S - t1;
  glm::vec3 x = glm::inverse(A) * rhs;
  glm::vec3 Pt = S + x[0] * V;
  cout << "A = " << glm::to_string(A) << endl;
  cout << "rhs = " << glm::to_string(rhs) << endl;
  cout << "t = " << x[0] << ", u = " << x[1] << ", v = " << x[2] << endl;
  cout << "P_t = " << glm::to_string(Pt) << endl;
  cout << endl;

  cout << "Question 9:" << endl;
  glm::vec3 Nt = glm::normalize(glm::cross(t2 - t1, t3 - t1));
  cout << "N = " << glm::to_string(Nt) << endl;
  cout << endl;

  cout << "Question 10:" << endl;
  if (x[0] < t) cout << "ray hits triangle first" << endl;
  else cout << "ray hits sphere first" << endl;
}
