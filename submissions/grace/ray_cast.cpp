#define GLM_ENABLE_EXPERIMENTAL
#include <cmath>
#include <iostream>
#include <optional>
#include <string>

#include <glm/glm.hpp>
#include <glm/gtx/string_cast.hpp>

// A6. Everything in double, one class per thing in the scene.

class Ray {
public:
  Ray(glm::dvec3 start, glm::dvec3 dir) : S(start), V(dir) {}
  glm::dvec3 operator()(double t) const { return S + t * V; }
  const glm::dvec3 S, V;
};

class Camera {
public:
  Camera(glm::dvec3 eye, glm::dvec3 lookat, glm::dvec3 vup) : eye_(eye) {
    w_ = glm::normalize(eye - lookat);
    u_ = glm::normalize(glm::cross(vup, w_));
    v_ = glm::cross(w_, u_);
  }
  glm::dmat4 toWorld() const {
    return glm::dmat4(glm::dvec4(u_, 0), glm::dvec4(v_, 0), glm::dvec4(w_, 0), glm::dvec4(eye_, 1));
  }
  const glm::dvec3 &eye() const { return eye_; }
  const glm::dvec3 &u() const { return u_; }
  const glm::dvec3 &v() const { return v_; }
  const glm::dvec3 &w() const { return w_; }

private:
  glm::dvec3 eye_, u_, v_, w_;
};

class Sphere {
public:
  Sphere(glm::dvec3 c, double r) : C(c), R(r) {}

  std::optional<double> intersect(const Ray &ray, std::ostream &log) const {
    const glm::dvec3 L = ray.S - C;
    const double a = glm::dot(ray.V, ray.V);
    const double b = 2 * glm::dot(L, ray.V);
    const double c = glm::dot(L, L) - R * R;
    const double d = b * b - 4 * a * c;
    log << "a = " << a << "\nb = " << b << "\nc = " << c << "\ndiscriminant = " << d << "\n";
    if (d < 0) return std::nullopt;
    const double roots[] = {(-b - std::sqrt(d)) / (2 * a), (-b + std::sqrt(d)) / (2 * a)};
    for (double t : roots)
      if (t > 0) return t;
    return std::nullopt;
  }
  glm::dvec3 normal(const glm::dvec3 &p) const { return glm::normalize(p - C); }

private:
  glm::dvec3 C;
  double R;
};

class Triangle {
public:
  Triangle(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) : A(a), AB(b - a), AC(c - a) {}
  glm::dmat3 system(const Ray &ray) const { return glm::dmat3(AB, AC, -ray.V); }
  glm::dvec3 rhs(const Ray &ray) const { return ray.S - A; }
  glm::dvec3 normal() const { return glm::normalize(glm::cross(AB, AC)); }

private:
  glm::dvec3 A, AB, AC;
};

static void heading(int n, const std::string &what) { std::cout << "\n#" << n << " " << what << "\n"; }

template <class T> static void line(const std::string &name, const T &value) {
  std::cout << name << " = " << glm::to_string(value) << "\n";
}

int main() {
  const Camera cam({0, 0, 4}, {0, 0, 0}, {0, 1, 0});
  const Sphere sphere({1, 1, 0}, 2);
  const Triangle tri({0, -2, 2}, {2, 2, 2}, {-2, 2, 2});

  heading(1, "pixel, DCS -> VCS");
  const double pw = 4.0 / 301, ph = 2.0 / 201;
  const glm::dvec3 pv(-2 + (150 + 0.5) * pw, -1 + (100 + 0.5) * ph, -2);
  line("P_VCS", pv);

  heading(2, "basis of the camera");
  line("X_vcs", cam.u());
  line("Y_vcs", cam.v());
  line("Z_vcs", cam.w());

  heading(3, "VCS -> WCS");
  const glm::dmat4 M = cam.toWorld();
  line("M_VCS_to_WCS", M);

  heading(4, "pixel, VCS -> WCS");
  const glm::dvec3 pwcs(M * glm::dvec4(pv, 1));
  line("P_WCS", pwcs);

  heading(5, "ray");
  const Ray ray(pwcs, glm::normalize(pwcs - cam.eye()));
  line("V", ray.V);

  heading(6, "ray against sphere");
  const std::optional<double> ts = sphere.intersect(ray, std::cout);
  if (!ts) {
    std::cout << "missed the sphere\n";
    return 1;
  }
  std::cout << "t = " << *ts << "\n";
  line("P_s", ray(*ts));

  heading(7, "normal of the sphere");
  line("N", sphere.normal(ray(*ts)));

  heading(8, "ray against triangle, unknowns (u v t)");
  const glm::dmat3 sys = tri.system(ray);
  const glm::dvec3 rhs = tri.rhs(ray);
  line("A", sys);
  line("rhs", rhs);
  const glm::dvec3 uvt = glm::inverse(sys) * rhs;
  std::cout << "t = " << uvt.z << "\nu = " << uvt.x << "\nv = " << uvt.y << "\n";
  line("P_t", ray(uvt.z));

  heading(9, "normal of the triangle");
  line("N", tri.normal());

  heading(10, "who is first");
  std::cout << (uvt.z <= *ts ? "ray hits triangle first" : "ray hits sphere first") << "\n";
}
