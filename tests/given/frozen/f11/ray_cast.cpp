/* Assignment 6, ray casting.  C-style output. */
#include <stdio.h>
#include <math.h>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

void pv(const char *what, glm::dvec3 v) { printf("%s: %g, %g, %g\n", what, v.x, v.y, v.z); }

int main()
{
  /* sphere */
  glm::dvec3 Cs(1, 1, 0);
  double R = 2;
  /* triangle */
  glm::dvec3 A(0, -2, 2), B(2, 2, 2), C(-2, 2, 2);
  /* camera */
  glm::dvec3 eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0);
  double clipLeft = -2, clipRight = 2, clipBottom = -1, clipTop = 1, clipNear = 2;
  int W = 301, H = 201, x_DCS = 150, y_DCS = 100;

  /* DCS -> VCS.  Pixel (0,0) is the lower left corner, pixel (W-1,H-1)
     the upper right corner of the window. */
  glm::dvec3 P(0);
  P.x = clipLeft + (clipRight - clipLeft) * x_DCS / (W - 1.0);
  P.y = clipBottom + (clipTop - clipBottom) * y_DCS / (H - 1.0);
  P.z = -clipNear;
  printf("#1 pixel in VCS\n");
  pv("P_VCS", P);

  glm::dvec3 z = glm::normalize(eye - lookat);
  glm::dvec3 x = glm::normalize(glm::cross(vup, z));
  glm::dvec3 y = glm::cross(z, x);
  printf("#2 camera axes\n");
  pv("X_vcs", x);
  pv("Y_vcs", y);
  pv("Z_vcs", z);

  glm::dmat4 M = glm::inverse(glm::lookAt(eye, lookat, vup));
  printf("#3 M_VCS_to_WCS\n");
  for (int i = 0; i < 4; i++)
    printf("| %5g %5g %5g %5g |\n", M[0][i], M[1][i], M[2][i], M[3][i]);

  glm::dvec3 S = glm::dvec3(M * glm::dvec4(P, 1));
  printf("#4 pixel in WCS\n");
  pv("P_WCS", S);

  glm::dvec3 V = S - eye;
  V /= sqrt(V.x * V.x + V.y * V.y + V.z * V.z);
  printf("#5 direction of the ray\n");
  pv("V", V);

  double a = V.x * V.x + V.y * V.y + V.z * V.z;
  double b = 2 * (V.x * (S.x - Cs.x) + V.y * (S.y - Cs.y) + V.z * (S.z - Cs.z));
  double c = pow(S.x - Cs.x, 2) + pow(S.y - Cs.y, 2) + pow(S.z - Cs.z, 2) - R * R;
  double d = b * b - 4 * a * c;
  double t1 = (-b - sqrt(d)) / (2 * a);
  double t2 = (-b + sqrt(d)) / (2 * a);
  double t = t1 > 0 ? t1 : t2;
  glm::dvec3 Ps = S + t * V;
  printf("#6 sphere\n");
  printf("a: %g\nb: %g\nc: %g\nd: %g\nt: %g\n", a, b, c, d, t);
  pv("P_s", Ps);

  printf("#7 sphere normal\n");
  pv("N_s", glm::normalize(Ps - Cs));

  /* A - S = tV - u(B-A) - v(C-A) */
  glm::dmat3 K(V, A - B, A - C);
  glm::dvec3 rhs = A - S;
  glm::dvec3 sol = glm::inverse(K) * rhs;
  printf("#8 triangle: [V  A-B  A-C] (t u v) = A-S\n");
  printf("A:\n");
  for (int i = 0; i < 3; i++)
    printf("| %5g %5g %5g |\n", K[0][i], K[1][i], K[2][i]);
  pv("rhs", rhs);
  printf("t: %g\nu: %g\nv: %g\n", sol.x, sol.y, sol.z);
  pv("P_t", S + sol.x * V);

  printf("#9 triangle normal\n");
  pv("N_t", glm::normalize(glm::cross(B - A, C - A)));

  printf("#10\n");
  printf(sol.x < t ? "ray hits triangle first\n" : "ray hits sphere first\n");
  return 0;
}
