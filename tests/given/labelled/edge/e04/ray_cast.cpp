// one line per question, as short as possible
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/ext.hpp>
#include <glm/glm.hpp>
#include <iomanip>
#include <iostream>

auto& o = std::cout;
typedef glm::vec3 v3;

std::ostream& operator<<(std::ostream& s, v3 p) {
    return s << '(' << p[0] << ',' << p[1] << ',' << p[2] << ')';
}

int main() {
    o << std::fixed << std::setprecision(3);
    v3 e(6, 1, 0), l(0, 1, 0), up(0, 1, 0), c(1, 0, 1), A(3, 0, -1), B(3, 0, 1), C(1, 3, 2);

    v3 p(glm::mix(-2.f, 2.f, 150 / 300.f), glm::mix(-1.f, 1.f, 100 / 200.f), -2.f);
    o << "Q1: " << p << '\n';

    v3 z = glm::normalize(e - l), x = glm::normalize(glm::cross(up, z)), y = glm::cross(z, x);
    o << "Q2: " << x << ' ' << y << ' ' << z << '\n';

    glm::mat4 m(glm::vec4(x, 0), glm::vec4(y, 0), glm::vec4(z, 0), glm::vec4(e, 1));
    o << "Q3: ";
    for (int r = 0; r < 4; r++) {
        for (int k = 0; k < 4; k++) o << m[k][r] << (k < 3 ? " " : "");
        o << (r < 3 ? "; " : "\n");
    }

    v3 s = m * glm::vec4(p, 1);
    o << "Q4: " << s << '\n';
    v3 v = glm::normalize(s - e);
    o << "Q5: " << v << '\n';

    v3 q = s - c;
    float qa = dot(v, v), qb = 2 * dot(v, q), qc = dot(q, q) - 4, d = qb * qb - 4 * qa * qc,
          t = (-qb - sqrt(d)) / 2 / qa;
    v3 hs = s + t * v;
    o << "Q6: (a,b,c)=(" << qa << ',' << qb << ',' << qc << ") d=" << d << " t=" << t << " P_s=" << hs << '\n';
    o << "Q7: " << glm::normalize(hs - c) << '\n';

    glm::mat3 k(-v, B - A, C - A);
    v3 b = s - A, tuv = glm::inverse(k) * b;
    bool hit = tuv[0] > 0 && tuv[1] > 0 && tuv[2] > 0 && tuv[1] + tuv[2] < 1;
    o << "Q8: A=[";
    for (int r = 0; r < 3; r++) o << k[0][r] << ' ' << k[1][r] << ' ' << k[2][r] << (r < 2 ? "; " : "]");
    o << " rhs=" << b << " (t,u,v)=" << tuv << " P_t=" << s + tuv[0] * v << (hit ? "" : " no true hit, u is not inside")
      << '\n';
    o << "Q9: " << glm::normalize(glm::cross(B - A, C - A)) << '\n';
    o << "Q10: " << (hit && tuv[0] < t ? "ray hits triangle first" : "ray hits sphere first") << '\n';
}
