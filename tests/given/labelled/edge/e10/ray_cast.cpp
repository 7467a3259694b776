#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <iostream>
using namespace std;

typedef glm::vec3 Point;
typedef glm::vec3 Vector;

ostream& operator<<(ostream& os, glm::vec3 p) {
    return os << "[" << p.x << " " << p.y << " " << p.z << "]";
}

void q(int n) {
    cout << endl << "Answer to question " << n << endl;
}

int main() {
    Point eye(6, 1, 0), lookat(0, 1, 0);
    Vector vup(0, 1, 0);

    q(1);
    float px = (150 + 0.5f) / 301.0f;
    float py = (100 + 0.5f) / 201.0f;
    Point pv(px * 4 - 2, py * 2 - 1, -2);
    cout << "P_VCS " << pv << endl;

    q(2);
    Vector z = glm::normalize(eye - lookat), x = glm::normalize(glm::cross(vup, z)), y = glm::cross(z, x);
    cout << "X_vcs " << x << endl << "Y_vcs " << y << endl << "Z_vcs " << z << endl;

    q(3);
    glm::mat4 M(1);
    M = glm::translate(M, eye);
    glm::mat4 Rot(glm::vec4(x, 0), glm::vec4(y, 0), glm::vec4(z, 0), glm::vec4(0, 0, 0, 1));
    M = M * Rot;
    cout << "M_VCS_to_WCS" << endl;
    for (int i = 0; i < 4; i++)
        cout << "[" << M[0][i] << " " << M[1][i] << " " << M[2][i] << " " << M[3][i] << "]" << endl;

    q(4);
    glm::vec4 pw = M * glm::vec4(pv, 1);
    Point S(pw.x, pw.y, pw.z);
    cout << "P_WCS " << S << endl;

    q(5);
    Vector V = glm::normalize(S - eye);
    cout << "V " << V << endl;

    q(6);
    Point center(1, 0, 1);
    float R = 2;
    float a = glm::dot(V, V);
    float b = 2 * glm::dot(V, S - center);
    float c = glm::dot(S - center, S - center) - R * R;
    float d = b * b - a * c;
    cout << "a " << a << endl << "b " << b << endl << "c " << c << endl << "d " << d << endl;
    float t = (-b - sqrt(d)) / (2 * a);
    if (t < 0) t = (-b + sqrt(d)) / (2 * a);
    Point ps = S + t * V;
    cout << "t " << t << endl << "P_s " << ps << endl;

    q(7);
    Vector ns = ps - center;
    ns = ns / glm::length(ns);
    cout << "N " << ns << endl;

    q(8);
    Point A(3, 0, -1), B(3, 0, 1), C(1, 3, 2);
    Vector c1 = -V, c2 = B - A, c3 = C - A, rhs = A - S;
    cout << "A" << endl;
    for (int i = 0; i < 3; i++) cout << "[" << c1[i] << " " << c2[i] << " " << c3[i] << "]" << endl;
    cout << "rhs " << rhs << endl;
    glm::vec3 sol = glm::inverse(glm::mat3(c1, c2, c3)) * rhs;
    cout << "t " << sol.x << endl << "u " << sol.y << endl << "v " << sol.z << endl;
    Point pt = S + sol.x * V;
    cout << "P_t " << pt << endl;

    q(9);
    cout << "N " << glm::normalize(glm::cross(B - A, C - A)) << endl;

    q(10);
    if (sol.x > 0 && sol.y >= 0 && sol.z >= 0 && sol.y + sol.z <= 1 && sol.x < t)
        cout << "ray hits triangle first" << endl;
    else
        cout << "ray hits sphere first" << endl;
}
