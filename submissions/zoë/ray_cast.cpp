// Devoir 6, lancer de rayons. Les objets d'abord, la caméra dans une fonction.
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

struct Rayon { glm::dvec3 origine, direction; };

const glm::dvec3 oeil(0, 0, 4), cible(0, 0, 0), haut(0, 1, 0);
const glm::dvec3 C(1, 1, 0);
const double R = 2;
const glm::dvec3 sommets[3] = { {0, -2, 2}, {2, 2, 2}, {-2, 2, 2} };

void titre(int n) { std::cout << "=== Question " << n << " ===" << std::endl; }

template <typename T>
void ecrire(const std::string &nom, const T &valeur) { std::cout << nom << ": " << glm::to_string(valeur) << std::endl; }
void ecrire(const std::string &nom, double valeur) { std::cout << nom << ": " << valeur << std::endl; }

Rayon camera()
{
    // la base d'abord, on en a besoin pour le reste
    glm::dvec3 z = glm::normalize(oeil - cible);
    glm::dvec3 x = glm::normalize(glm::cross(haut, z));
    glm::dvec3 y = glm::normalize(glm::cross(z, x));
    titre(2);
    ecrire("X_vcs", x);
    ecrire("Y_vcs", y);
    ecrire("Z_vcs", z);

    glm::dmat4 M = glm::translate(glm::dmat4(1), oeil) * glm::dmat4(glm::dmat3(x, y, z));
    titre(3);
    ecrire("M_VCS_to_WCS", M);

    titre(1);
    glm::dvec4 p(-2 + (150 + 0.5) / 301 * 4, -1 + (100 + 0.5) / 201 * 2, -2, 1);
    ecrire("P_VCS", glm::dvec3(p));

    titre(4);
    glm::dvec3 s(M * p);
    ecrire("P_WCS", s);

    titre(5);
    glm::dvec3 v = glm::normalize(s - oeil);
    ecrire("V", v);
    return { s, v };
}

int main()
{
    const Rayon r = camera();

    // le triangle avant la sphère
    const glm::dvec3 ab = sommets[1] - sommets[0], ac = sommets[2] - sommets[0];
    titre(9);
    const glm::dvec3 nt = glm::normalize(glm::cross(ab, ac));
    ecrire("normale du triangle N", nt);

    titre(8);
    const glm::dmat3 A(-r.direction, ab, ac);
    const glm::dvec3 b = r.origine - sommets[0];
    const glm::dvec3 tuv = glm::inverse(A) * b;
    ecrire("A", A);
    ecrire("rhs", b);
    ecrire("t", tuv[0]);
    ecrire("u", tuv[1]);
    ecrire("v", tuv[2]);
    ecrire("P_t", r.origine + tuv[0] * r.direction);

    titre(6);
    const glm::dvec3 cs = r.origine - C;
    const double qa = glm::dot(r.direction, r.direction), qb = 2 * glm::dot(r.direction, cs), qc = glm::dot(cs, cs) - R * R;
    const double d = qb * qb - 4 * qa * qc;
    ecrire("a", qa);
    ecrire("b", qb);
    ecrire("c", qc);
    ecrire("d", d);
    // forme stable
    const double q = -0.5 * (qb + std::copysign(std::sqrt(d), qb));
    double t0 = q / qa, t1 = qc / q;
    if (t1 < t0) std::swap(t0, t1);
    const double t = t0 > 0 ? t0 : t1;
    ecrire("t", t);
    const glm::dvec3 ps = r.origine + t * r.direction;
    ecrire("P_s", ps);

    titre(7);
    ecrire("N", glm::normalize(ps - C));

    titre(10);
    if (tuv[0] < t) std::cout << "ray hits triangle first" << std::endl;
    else std::cout << "ray hits sphere first" << std::endl;
    return EXIT_SUCCESS;
}
