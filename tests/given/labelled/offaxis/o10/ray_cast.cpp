#define GLM_ENABLE_EXPERIMENTAL
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <iomanip>
#include <iostream>

typedef glm::vec3 vec3;

int main() {
    std::cout << std::setprecision(7);
    vec3 eye(3, 4, 12), at(-0.5f, 0.8f, -1.2f), up(0.1f, 1, 0.2f);

    std::cout << "Question 1" << std::endl;
    std::cout << "The pixel's width is " << 4.0f / 640 << " and its height is " << 2.4f / 384 << "." << std::endl;
    vec3 pixel(-1.6f + 4.0f / 640 * 411.5f, -1.1f + 2.4f / 384 * 129.5f, -1.5f);
    std::cout << "The pixel in VCS is at (" << pixel.x << ", " << pixel.y << ", " << pixel.z << ")." << std::endl
              << std::endl;

    std::cout << "Question 2" << std::endl;
    vec3 z = glm::normalize(eye - at), x = glm::normalize(glm::cross(up, z)), y = glm::cross(z, x);
    std::cout << "The x axis is (" << x.x << ", " << x.y << ", " << x.z << ")." << std::endl;
    std::cout << "The y axis is (" << y.x << ", " << y.y << ", " << y.z << ")." << std::endl;
    std::cout << "The z axis is (" << z.x << ", " << z.y << ", " << z.z << ")." << std::endl << std::endl;

    std::cout << "Question 3" << std::endl;
    glm::mat4 m = glm::inverse(glm::lookAt(eye, at, up));
    std::cout << "The matrix from VCS to WCS has these rows:" << std::endl;
    for (int i = 0; i < 4; i++)
        std::cout << "row " << i + 1 << ": (" << m[0][i] << ", " << m[1][i] << ", " << m[2][i] << ", " << m[3][i] << ")"
                  << std::endl;
    std::cout << std::endl;

    std::cout << "Question 4" << std::endl;
    glm::vec4 w = m * glm::vec4(pixel, 1);
    std::cout << "The pixel in WCS is at (" << w.x << ", " << w.y << ", " << w.z << ", " << w.w << ")." << std::endl
              << std::endl;

    std::cout << "Question 5" << std::endl;
    vec3 S(w), v = glm::normalize(S - eye);
    std::cout << "The distance from the eye is " << glm::length(S - eye) << "." << std::endl;
    std::cout << "The direction is (" << v.x << ", " << v.y << ", " << v.z << ")." << std::endl << std::endl;

    std::cout << "Question 6" << std::endl;
    vec3 c(6.6f, -1.4f, 0.5f), o = eye - c;
    float r = 1.8f;
    float qa = glm::dot(v, v), qb = 2 * glm::dot(v, o), qc = glm::dot(o, o) - r * r, disc = qb * qb - 4 * qa * qc;
    float t1 = (-qb + std::sqrt(disc)) / (2 * qa), t2 = (-qb - std::sqrt(disc)) / (2 * qa), t = std::min(t1, t2);
    vec3 ps = eye + t * v;
    std::cout << "The coefficients are a = " << qa << ", b = " << qb << " and c = " << qc << "." << std::endl;
    std::cout << "The discriminant is " << disc << ", which is positive, so there are 2 roots." << std::endl;
    std::cout << "The roots are " << t1 << " and " << t2 << ", I pick t = " << t << "." << std::endl;
    std::cout << "The ray hits the sphere at (" << ps.x << ", " << ps.y << ", " << ps.z << ")." << std::endl
              << std::endl;

    std::cout << "Question 7" << std::endl;
    vec3 n = glm::normalize(ps - c);
    std::cout << "The normal is (" << n.x << ", " << n.y << ", " << n.z << ")." << std::endl << std::endl;

    std::cout << "Question 8" << std::endl;
    vec3 A(3.2f, -2.25f, 3.8f), B(8.7f, -0.5f, 3.1f), C(5.4f, 4.6f, 4.3f);
    glm::mat3 k(B - A, C - A, -v);
    vec3 rhs = S - A;
    vec3 sol = glm::inverse(k) * rhs;
    float tt = sol.z, uu = sol.y, vv = sol.x;
    std::cout << "The matrix for (u, v, t) has these rows:" << std::endl;
    for (int i = 0; i < 3; i++)
        std::cout << "row " << i + 1 << ": (" << k[0][i] << ", " << k[1][i] << ", " << k[2][i] << ")" << std::endl;
    std::cout << "The right-hand side is (" << rhs.x << ", " << rhs.y << ", " << rhs.z << ")." << std::endl;
    std::cout << "The solution is t = " << tt << ", u = " << uu << " and v = " << vv << "." << std::endl;
    vec3 pt = S + tt * v;
    std::cout << "The ray hits the triangle at (" << pt.x << ", " << pt.y << ", " << pt.z << ")." << std::endl
              << std::endl;

    std::cout << "Question 9" << std::endl;
    vec3 N = glm::normalize(glm::cross(B - A, C - A));
    std::cout << "The normal is (" << N.x << ", " << N.y << ", " << N.z << ")." << std::endl << std::endl;

    std::cout << "Question 10" << std::endl;
    std::cout << "Because " << std::min(t, tt) << " < " << std::max(t, tt) << ", the ray hits "
              << (tt < t ? "triangle" : "sphere") << " first." << std::endl;
}
