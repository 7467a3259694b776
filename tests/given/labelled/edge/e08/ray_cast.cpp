// Assignment 6
#include <glm/glm.hpp>
#include <iostream>
#include <sstream>
#include <string>

using glm::cross;
using glm::dot;
using glm::mat3;
using glm::mat4;
using glm::normalize;
using glm::vec3;

// "{x; y; z}"
std::string str(vec3 v) {
    std::ostringstream o;
    o << "{" << v.x << "; " << v.y << "; " << v.z << "}";
    return o.str();
}

class Printer {
    int question = 0;

  public:
    void next() { std::cout << "#" << ++question << "\n"; }
    template <class T>
    void item(const char* label, T value) {
        std::cout << "\t- " << label << ": " << value << "\n";
    }
    void item(const char* label, vec3 value) { item(label, str(value)); }
};

int main() {
    Printer out;
    vec3 eye(6, 1, 0), lookat(0, 1, 0), vup(0, 1, 0), sphere(1, 0, 1);
    float radius = 2;
    vec3 A(3, 0, -1), B(3, 0, 1), C(1, 3, 2);

    out.next();
    vec3 P((150 + .5f - 301 / 2.f) * 4 / 301, (100 + .5f - 201 / 2.f) * 2 / 201, -2);
    out.item("pixel in camera space", P);

    out.next();
    vec3 Z = normalize(eye - lookat);
    vec3 X = normalize(cross(vup, Z));
    vec3 Y = normalize(cross(X, Z));
    out.item("X", X);
    out.item("Y", Y);
    out.item("Z", Z);

    out.next();
    mat4 M(1.0f);
    for (int i = 0; i < 3; i++) {
        M[0][i] = X[i];
        M[1][i] = Y[i];
        M[2][i] = Z[i];
        M[3][i] = eye[i];
    }
    std::cout << "\t- camera to world:\n";
    for (int r = 0; r < 4; r++)
        std::cout << "\t\t" << M[0][r] << "\t" << M[1][r] << "\t" << M[2][r] << "\t" << M[3][r] << "\n";

    out.next();
    vec3 S = vec3(M * glm::vec4(P, 1));
    out.item("pixel in world space", S);

    out.next();
    vec3 V = normalize(S - eye);
    out.item("direction", V);

    out.next();
    float a = dot(V, V), b = 2 * dot(V, S - sphere), c = dot(S - sphere, S - sphere) - 2 * radius;
    float d = b * b - 4 * a * c, t = (-b - sqrtf(d)) / (2 * a);
    vec3 ps = S + t * V;
    out.item("a", a);
    out.item("b", b);
    out.item("c", c);
    out.item("discriminant", d);
    out.item("t", t);
    out.item("hit", ps);

    out.next();
    out.item("normal", normalize(sphere - ps));

    out.next();
    mat3 K(B - A, C - A, -V);
    vec3 rhs = S - A, uvt = inverse(K) * rhs;
    std::cout << "\t- system (u v t | rhs):\n";
    for (int r = 0; r < 3; r++)
        std::cout << "\t\t" << K[0][r] << "\t" << K[1][r] << "\t" << K[2][r] << "\t|\t" << rhs[r] << "\n";
    out.item("u", uvt.x);
    out.item("v", uvt.y);
    out.item("t", uvt.z);
    out.item("hit", S + uvt.z * V);

    out.next();
    out.item("normal", normalize(cross(B - A, C - A)));

    out.next();
    std::cout << "\t- ray hits " << (uvt.z < t ? "triangle" : "sphere") << " first\n";
    return 0;
}
