/**
 * Ray caster, geometric steps only.
 */
#include <cmath>
#include <glm/glm.hpp>
#include <iomanip>
#include <iostream>
#include <optional>

using vec = glm::dvec3;

struct Ray {
    vec o, d;
    vec at(double t) const { return o + t * d; }
};
struct Tri {
    vec a, b, c;
    vec normal() const { return glm::normalize(glm::cross(b - a, c - a)); }
    // Moller & Trumbore
    std::optional<vec> hit(const Ray& r) const {
        vec e1 = b - a, e2 = c - a, p = glm::cross(r.d, e2);
        double det = glm::dot(e1, p);
        if (std::abs(det) < 1e-12) return {};
        vec s = r.o - a, q = glm::cross(s, e1);
        double u = glm::dot(s, p) / det, v = glm::dot(r.d, q) / det, t = glm::dot(e2, q) / det;
        return vec(u, v, t);
    }
};

std::ostream& operator<<(std::ostream& o, const vec& v) {
    return o << v.x << ", " << v.y << ", " << v.z;
}

int main() {
    std::cout << std::scientific << std::setprecision(8);
    const vec eye{3, 4, 12}, target{-0.5, 0.8, -1.2}, up{0.1, 1, 0.2};
    const double l = -1.6, r = 2.4, b = -1.1, t = 1.3, n = 1.5;

    std::cout << "Q1)\n";
    const vec pixel{l + 411.5 / 640 * (r - l), b + 129.5 / 384 * (t - b), -n};
    std::cout << "  pixel_vcs:  " << pixel << '\n';

    std::cout << "Q2)\n";
    const vec w = glm::normalize(eye - target), u = glm::normalize(glm::cross(up, w)), v = glm::cross(w, u);
    std::cout << "  x_axis:     " << u << "\n  y_axis:     " << v << "\n  z_axis:     " << w << '\n';

    std::cout << "Q3)\n";
    const glm::dmat4 toWorld(glm::dvec4(u, 0), glm::dvec4(v, 0), glm::dvec4(w, 0), glm::dvec4(eye, 1));
    for (int i = 0; i < 4; ++i)
        std::cout << "  col " << i << ":      " << vec(toWorld[i]) << ", " << toWorld[i].w << '\n';

    std::cout << "Q4)\n";
    const vec start = toWorld * glm::dvec4(pixel, 1);
    std::cout << "  pixel_wcs:  " << start << '\n';

    std::cout << "Q5)\n";
    const Ray ray{start, glm::normalize(start - eye)};
    std::cout << "  direction:  " << ray.d << '\n';

    std::cout << "Q6)\n";
    const vec center{6.6, -1.4, 0.5};
    const double radius = 1.8;
    const vec oc = ray.o - center;
    const double qa = glm::dot(ray.d, ray.d), qb = 2 * glm::dot(oc, ray.d), qc = glm::dot(oc, oc) - radius * radius,
                 disc = qb * qb - 4 * qa * qc;
    // numerically stable roots
    const double q = -0.5 * (qb + std::copysign(std::sqrt(disc), qb));
    const double far = q / qa, near = qc / q;
    std::cout << "  a:          " << qa << "\n  b:          " << qb << "\n  c:          " << qc
              << "\n  d:          " << disc << '\n';
    const double ts = near > 0 ? std::min(near, far) : far;
    std::cout << "  t:          " << ts << "\n  hit point:  " << ray.at(ts) << '\n';

    std::cout << "Q7)\n";
    std::cout << "  normal:     " << (ray.at(ts) - center) / radius << '\n';

    std::cout << "Q8)\n";
    // u(A-B) + v(A-C) + tV = A - S
    const Tri tri{{3.2, -2.25, 3.8}, {8.7, -0.5, 3.1}, {5.4, 4.6, 4.3}};
    const vec cols[3] = {tri.a - tri.b, tri.a - tri.c, ray.d};
    for (int i = 0; i < 3; ++i) std::cout << "  col " << i << ":      " << cols[i] << '\n';
    std::cout << "  rhs:        " << tri.a - ray.o << '\n';
    const auto uvt = tri.hit(ray);
    std::cout << "  t:          " << uvt->z << "\n  u:          " << uvt->x << "\n  v:          " << uvt->y << '\n';
    std::cout << "  hit point:  " << ray.at(uvt->z) << '\n';

    std::cout << "Q9)\n";
    std::cout << "  normal:     " << tri.normal() << '\n';

    std::cout << "Q10)\n";
    std::cout << "  ray hits " << (uvt->z < ts ? "triangle" : "sphere") << " first\n";
}
