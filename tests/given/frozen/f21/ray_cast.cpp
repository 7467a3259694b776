#include <iostream>
#include <iomanip>
#include <sstream>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

// everything the ten questions ask for
struct Results
{
    glm::vec3 pVcs, x, y, z;
    glm::mat4 toWorld;
    glm::vec3 pWcs, dir;
    float a, b, c, d, tSphere;
    glm::vec3 hitSphere, normalSphere;
    glm::mat3 mat;
    glm::vec3 rhs;
    float tTri, u, v;
    glm::vec3 hitTri, normalTri;
    bool triangleFirst;

    void print() const;
};

static void put(const glm::vec3& v, const char* what)
{
    std::ostringstream s;
    s << "(" << v.x << ", " << v.y << ", " << v.z << ")";
    std::cout << std::left << std::setw(34) << s.str() << "<- " << what << "\n";
}

static void put(float f, const char* what)
{
    std::cout << std::left << std::setw(34) << f << "<- " << what << "\n";
}

void Results::print() const
{
    put(pVcs, "1: pixel in VCS");
    put(x, "2: X_vcs");
    put(y, "2: Y_vcs");
    put(z, "2: Z_vcs");
    for (int r = 0; r < 4; r++) {
        std::ostringstream s;
        s << "(" << toWorld[0][r] << ", " << toWorld[1][r] << ", " << toWorld[2][r] << ", " << toWorld[3][r] << ")";
        std::cout << std::setw(34) << std::left << s.str() << "<- 3: M_VCS_to_WCS, row " << r << "\n";
    }
    put(pWcs, "4: pixel in WCS");
    put(dir, "5: V");
    put(a, "6: a");
    put(b, "6: b");
    put(c, "6: c");
    put(d, "6: discriminant");
    put(tSphere, "6: t");
    put(hitSphere, "6: hit point on sphere");
    put(normalSphere, "7: normal of sphere");
    for (int r = 0; r < 3; r++) {
        std::string what = "8: matrix, row " + std::to_string(r);
        put(glm::vec3(mat[0][r], mat[1][r], mat[2][r]), what.c_str());
    }
    put(rhs, "8: right-hand side");
    put(tTri, "8: t");
    put(u, "8: u");
    put(v, "8: v");
    put(hitTri, "8: hit point on triangle");
    put(normalTri, "9: normal of triangle");
    std::cout << std::setw(34) << (triangleFirst ? "ray hits triangle first" : "ray hits sphere first") << "<- 10: result\n";
}

int main()
{
    glm::vec3 center(1, 1, 0);
    float radius = 2;
    glm::vec3 A(0, -2, 2), B(2, 2, 2), C(-2, 2, 2);
    glm::vec3 eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0);

    Results r;
    r.pVcs = glm::vec3(-2 + 150.5f * 4 / 301, -1 + 100.5f * 2 / 201, -2);
    r.z = glm::normalize(eye - lookat);
    r.x = glm::normalize(glm::cross(vup, r.z));
    r.y = glm::cross(r.z, r.x);
    r.toWorld = glm::inverse(glm::lookAt(eye, lookat, vup));
    r.pWcs = glm::vec3(r.toWorld * glm::vec4(r.pVcs, 1));
    r.dir = glm::normalize(r.pWcs - eye);

    glm::vec3 k = r.pWcs - center;
    r.a = glm::dot(r.dir, r.dir);
    r.b = 2 * glm::dot(r.dir, k);
    r.c = glm::dot(k, k) - radius * radius;
    r.d = r.b * r.b - 4 * r.a * r.c;
    r.tSphere = (-r.b - glm::sqrt(r.d)) / (2 * r.a);
    r.hitSphere = r.pWcs + r.tSphere * r.dir;
    r.normalSphere = glm::normalize(r.hitSphere - center);

    r.mat = glm::mat3(-r.dir, B - A, C - A);
    r.rhs = r.pWcs - A;
    glm::vec3 sol = glm::inverse(r.mat) * r.rhs;
    r.tTri = sol.x;
    r.u = sol.y;
    r.v = sol.z;
    r.hitTri = r.pWcs + r.tTri * r.dir;
    r.normalTri = glm::normalize(glm::cross(B - A, C - A));
    r.triangleFirst = r.tTri < r.tSphere;

    r.print();
}
