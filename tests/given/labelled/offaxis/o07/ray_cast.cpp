#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <iostream>
#include <string>

class RayCaster {
    glm::vec3 eye{3, 4, 12}, lookat{-0.5, 0.8, -1.2}, vup{0.1, 1, 0.2};
    glm::vec3 center{6.6, -1.4, 0.5};
    float radius = 1.8f;
    glm::vec3 A{3.2, -2.25, 3.8}, B{8.7, -0.5, 3.1}, C{5.4, 4.6, 4.3};
    glm::vec3 pVcs, pWcs, X, Y, Z, V, hitS, hitT, nS, nT;
    glm::mat4 M;
    float tS = -1, tT = -1;
    bool sphereHit = false, triangleHit = false;

  public:
    void pixel(int px, int py, int W, int H) {
        float dx = (2.4f - -1.6f) / W, dy = (1.3f - -1.1f) / H;
        pVcs = glm::vec3(-1.6f + (px + 0.5f) * dx, 1.3f - (py + 0.5f) * dy, -1.5f);
        std::cout << "Q1> P_VCS: " << glm::to_string(pVcs) << "\n";
    }
    void basis() {
        Z = glm::normalize(eye - lookat);
        X = glm::normalize(glm::cross(vup, Z));
        Y = glm::cross(Z, X);
        std::cout << "Q2> X_vcs: " << glm::to_string(X) << "\nQ2> Y_vcs: " << glm::to_string(Y)
                  << "\nQ2> Z_vcs: " << glm::to_string(Z) << "\n";
    }
    void matrix() {
        M = glm::inverse(glm::lookAt(eye, lookat, vup));
        std::cout << "Q3> M_VCS_to_WCS:\n";
        for (int i = 0; i < 4; i++)
            std::cout << "Q3>   " << M[0][i] << " " << M[1][i] << " " << M[2][i] << " " << M[3][i] << "\n";
    }
    void ray() {
        pWcs = glm::vec3(M * glm::vec4(pVcs, 1));
        std::cout << "Q4> P_WCS: " << glm::to_string(pWcs) << "\n";
        V = glm::normalize(pWcs - eye);
        std::cout << "Q5> V: " << glm::to_string(V) << "\n";
    }
    void sphere() {
        glm::vec3 L = pWcs - center;
        float a = glm::dot(V, V), b = 2 * glm::dot(V, L), c = glm::dot(L, L) - radius * radius, d = b * b - 4 * a * c;
        std::cout << "Q6> a: " << a << "\nQ6> b: " << b << "\nQ6> c: " << c << "\nQ6> d: " << d << "\n";
        if (d >= 0) {
            tS = (-b - std::sqrt(d)) / (2 * a);
            sphereHit = tS > 0;
        }
        if (sphereHit) {
            hitS = pWcs + tS * V;
            nS = glm::normalize(hitS - center);
            std::cout << "Q6> t: " << tS << "\nQ6> P_s: " << glm::to_string(hitS) << "\n";
            std::cout << "Q7> N: " << glm::to_string(nS) << "\n";
        } else {
            std::cout << "Q6> t: no solution\nQ6> P_s: no hit\nQ7> N: no hit\n";
        }
    }
    void triangle() {
        glm::mat3 m(-V, B - A, C - A);
        glm::vec3 r = pWcs - A, x = glm::inverse(m) * r;
        tT = x.x;
        triangleHit = x.x > 0 && x.y >= 0 && x.z >= 0 && x.y + x.z <= 1;
        std::cout << "Q8> A:\n";
        for (int i = 0; i < 3; i++) std::cout << "Q8>   " << m[0][i] << " " << m[1][i] << " " << m[2][i] << "\n";
        std::cout << "Q8> rhs: " << glm::to_string(r) << "\nQ8> t: " << x.x << "\nQ8> u: " << x.y << "\nQ8> v: " << x.z
                  << "\n";
        hitT = pWcs + tT * V;
        std::cout << "Q8> P_t: " << glm::to_string(hitT) << "\n";
        nT = glm::cross(B - A, C - A);
        std::cout << "Q9> N: " << glm::to_string(nT) << "\n";
    }
    void decide() {
        std::string s = "ray hits nothing";
        if (sphereHit && !(triangleHit && tT < tS))
            s = "ray hits sphere first";
        else if (triangleHit)
            s = "ray hits triangle first";
        std::cout << "Q10> " << s << "\n";
    }
};

int main() {
    RayCaster rc;
    rc.pixel(411, 129, 640, 384);
    rc.basis();
    rc.matrix();
    rc.ray();
    rc.sphere();
    rc.triangle();
    rc.decide();
}
