#include <iostream>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
using namespace std;

typedef glm::dvec3 vec;

void out(vec v) { cout << v.x << ", " << v.y << ", " << v.z << "\n"; }

int main()
{
  vec eye(0,0,4), look(0,0,0), up(0,1,0);
  vec sc(1,1,0);
  double sr = 2;
  vec A(0,-2,2), B(2,2,2), C(-2,2,2);

  // window
  double l=-2, r=2, b=-1, t=1, n=2;
  int w=301, h=201;
  int i=150, j=100;

  // q1
  vec p(l + (r-l)*(i+0.5)/w, b + (t-b)*(j+0.5)/h, -n);
  cout << "q1: ";
  out(p);

  // q2
  vec z = glm::normalize(eye-look);
  vec x = glm::normalize(glm::cross(up,z));
  vec y = glm::cross(z,x);
  cout << "q2:\n";
  cout << "x = "; out(x);
  cout << "y = "; out(y);
  cout << "z = "; out(z);

  // q3
  glm::dmat4 m = glm::inverse(glm::lookAt(eye,look,up));
  cout << "q3:\n";
  for (int row=0; row<4; row++)
    cout << m[0][row] << ", " << m[1][row] << ", " << m[2][row] << ", " << m[3][row] << "\n";

  // q4
  vec s = vec(m * glm::dvec4(p,1));
  cout << "q4: ";
  out(s);

  // q5
  vec v = (s-eye) / glm::length(s-eye);
  cout << "q5: ";
  out(v);

  // q6
  double qa = glm::dot(v,v), qb = 2*glm::dot(v,s-sc), qc = glm::dot(s-sc,s-sc) - sr*sr;
  double qd = qb*qb - 4*qa*qc;
  double t1 = (-qb-glm::sqrt(qd))/(2*qa);
  vec ps = s + t1*v;
  cout << "q6:\n";
  cout << "a, b, c = " << qa << ", " << qb << ", " << qc << "\n";
  cout << "d = " << qd << "\n";
  cout << "t = " << t1 << "\n";
  cout << "hit = "; out(ps);

  // q7
  cout << "q7: ";
  out(glm::normalize(ps-sc));

  // q8
  glm::dmat3 k(-v, B-A, C-A);
  vec sol = glm::inverse(k)*(s-A);
  cout << "q8:\n";
  for (int row=0; row<3; row++)
    cout << k[0][row] << ", " << k[1][row] << ", " << k[2][row] << "\n";
  cout << "rhs = "; out(s-A);
  cout << "t, u, v = "; out(sol);
  cout << "hit = "; out(s+sol.x*v);

  // q9
  cout << "q9: ";
  out(glm::normalize(glm::cross(B-A,C-A)));

  // q10
  cout << "q10: ";
  if (sol.x < t1) cout << "ray hits triangle first\n";
  else cout << "ray hits sphere first\n";
}
