// A6 - with my own small matrix class on top of std::vector
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <iostream>
#include <vector>

typedef glm::dvec3 dv;

class Mat {
    std::vector<double> e;
    int n;

  public:
    Mat(int n) : n(n) { e.resize(n * n); }
    double& at(int row, int col) { return e.at(row * n + col); }
    void print() {
        for (int r = 0; r < n; r++) {
            for (int c = 0; c < n; c++) std::cout << at(r, c) << (c + 1 < n ? ", " : "");
            std::cout << std::endl;
        }
    }
    // determinant by the rule of Sarrus
    double det3() {
        double s = 0;
        for (int c = 0; c <= n; c++) {
            s += at(0, c) * at(1, (c + 1) % n) * at(2, (c + 2) % n);
            s -= at(2, c) * at(1, (c + 1) % n) * at(0, (c + 2) % n);
        }
        return s;
    }
};

void print(const char* name, dv p) {
    std::cout << name << ": x=" << p.x << " y=" << p.y << " z=" << p.z << std::endl;
}

int main() {
    dv eye(6, 1, 0), look(0, 1, 0), up(0, 1, 0);

    std::cout << "(1)" << std::endl;
    dv pv(-2 + 150 * 4.0 / 300, -1 + 100 * 2.0 / 200, -2);
    print("P_vcs", pv);

    std::cout << "(2)" << std::endl;
    dv z = glm::normalize(eye - look);
    dv x = glm::normalize(glm::cross(up, z));
    dv y = glm::cross(z, x);
    print("X_vcs", x);
    print("Y_vcs", y);
    print("Z_vcs", z);

    std::cout << "(3)" << std::endl;
    glm::dmat4 m = glm::inverse(glm::lookAt(eye, look, up));
    Mat M(4);
    for (int r = 0; r < 4; r++)
        for (int c = 0; c < 4; c++) M.at(r, c) = m[c][r];
    M.print();

    std::cout << "(4)" << std::endl;
    dv S(m * glm::dvec4(pv, 1));
    print("P_wcs", S);

    std::cout << "(5)" << std::endl;
    dv V = S - eye;
    V /= sqrt(V.x * V.x + V.y * V.y + V.z * V.z);
    print("V", V);

    std::cout << "(6)" << std::endl;
    dv cen(1, 0, 1);
    dv o = S - cen;
    double a = glm::dot(V, V), b = 2 * glm::dot(o, V), c = glm::dot(o, o) - 4, D = b * b - 4 * a * c;
    std::cout << "a=" << a << " b=" << b << " c=" << c << std::endl;
    std::cout << "D=" << D << std::endl;
    double t = (-b - sqrt(D)) / (2 * a);
    std::cout << "t=" << t << std::endl;
    dv ps = eye + t * V;
    print("P_s", ps);

    std::cout << "(7)" << std::endl;
    print("N", glm::normalize(ps - cen));

    std::cout << "(8)" << std::endl;
    dv A(3, 0, -1), B(3, 0, 1), C(1, 3, 2);
    dv e1 = B - A, e2 = C - A, rhs = S - A;
    Mat T(3);
    for (int r = 0; r < 3; r++) {
        T.at(r, 0) = e1[r];
        T.at(r, 1) = e2[r];
        T.at(r, 2) = -V[r];
    }
    T.print();
    print("rhs", rhs);
    double det = T.det3();
    Mat U = T, W = T, Q = T;
    for (int r = 0; r < 3; r++) {
        U.at(r, 0) = rhs[r];
        W.at(r, 1) = rhs[r];
        Q.at(r, 2) = rhs[r];
    }
    double u = U.det3() / det, v = W.det3() / det, tt = Q.det3() / det;
    std::cout << "t=" << tt << " u=" << u << " v=" << v << std::endl;
    print("P_t", S + tt * V);

    std::cout << "(9)" << std::endl;
    print("N", glm::normalize(glm::cross(e1, e2)));

    std::cout << "(10)" << std::endl;
    std::cout << (tt < t ? "ray hits triangle first" : "ray hits sphere first") << std::endl;
}
