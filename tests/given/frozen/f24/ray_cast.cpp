#include <iostream>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

using namespace std;

// output is grouped by object, not by question

void vec(string text, glm::vec3 v)
{
  cout << "  " << text << ": x=" << v.x << " y=" << v.y << " z=" << v.z << endl;
}

int main()
{
  glm::vec3 eye(0, 0, 4);
  glm::vec3 lookat(0, 0, 0);
  glm::vec3 vup(0, 1, 0);
  float winW = 2 - (-2), winH = 1 - (-1), dist = 2;
  float W = 301, H = 201;

  glm::vec3 sphereCenter(1, 1, 0);
  float sphereRadius = 2;
  glm::vec3 A(0, -2, 2), B(2, 2, 2), C(-2, 2, 2);

  // camera and pixel
  glm::vec3 zAxis = glm::normalize(eye - lookat);
  glm::vec3 xAxis = glm::normalize(glm::cross(vup, zAxis));
  glm::vec3 yAxis = glm::cross(zAxis, xAxis);
  glm::mat4 view2world = glm::inverse(glm::lookAt(eye, lookat, vup));
  glm::vec3 pixView(winW * (150 / (W - 1) - 0.5f), winH * (100 / (H - 1) - 0.5f), -dist);
  glm::vec3 pixWorld = glm::vec3(view2world * glm::vec4(pixView, 1));
  glm::vec3 V = glm::normalize(pixWorld - eye);

  cout << "CAMERA" << endl;
  vec("Z axis of the view (2)", zAxis);
  vec("Y axis of the view (2)", yAxis);
  vec("X axis of the view (2)", xAxis);
  cout << "  view to world matrix (3), row by row:" << endl;
  for (int i = 0; i < 4; ++i) {
    cout << "   ";
    for (int j = 0; j < 4; ++j) cout << " " << view2world[j][i];
    cout << endl;
  }

  cout << "PIXEL" << endl;
  vec("in the view, its position (1)", pixView);
  vec("in the world, its position (4)", pixWorld);
  vec("from the eye to it, the unit vector V (5)", V);

  // sphere
  glm::vec3 m = pixWorld - sphereCenter;
  float a = glm::dot(V, V);
  float b = 2 * glm::dot(m, V);
  float c = glm::dot(m, m) - sphereRadius * sphereRadius;
  float d = b * b - 4 * a * c;
  float ts = (-b - sqrt(d)) / (2 * a);
  glm::vec3 hs = pixWorld + ts * V;
  cout << "SPHERE" << endl;
  vec("point that is hit (6)", hs);
  cout << "  ray parameter t (6): " << ts << endl;
  cout << "  discriminant d (6): " << d << endl;
  cout << "  coefficients (6): c=" << c << " b=" << b << " a=" << a << endl;
  vec("normal at this point (7)", glm::normalize(hs - sphereCenter));

  // triangle
  glm::mat3 eq(-V, B - A, C - A);
  glm::vec3 right = pixWorld - A;
  glm::vec3 tuv = glm::inverse(eq) * right;
  cout << "TRIANGLE" << endl;
  vec("point that is hit (8)", pixWorld + tuv.x * V);
  cout << "  ray parameter t (8): " << tuv.x << endl;
  cout << "  barycentric (8): v=" << tuv.z << " u=" << tuv.y << endl;
  vec("right-hand side (8)", right);
  cout << "  matrix A (8), row by row:" << endl;
  for (int i = 0; i < 3; ++i)
    cout << "    " << eq[0][i] << " " << eq[1][i] << " " << eq[2][i] << endl;
  vec("normal (9)", glm::normalize(glm::cross(B - A, C - A)));

  cout << "FIRST (10)" << endl;
  cout << "  " << (tuv.x < ts ? "ray hits triangle first" : "ray hits sphere first") << endl;
  return 0;
}
