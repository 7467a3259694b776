#include <iostream>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

std::ostream& operator<<(std::ostream& out, const glm::vec3& v) {
    return out << "<" << v.x << ", " << v.y << ", " << v.z << ">";
}
std::ostream& operator<<(std::ostream& out, const glm::vec4& v) {
    return out << "<" << v.x << ", " << v.y << ", " << v.z << ", " << v.w << ">";
}
std::ostream& operator<<(std::ostream& out, const glm::mat4& m) {
    glm::mat4 t = glm::transpose(m); // so that t[i] is row i
    return out << t[0] << "\n" << t[1] << "\n" << t[2] << "\n" << t[3];
}
std::ostream& operator<<(std::ostream& out, const glm::mat3& m) {
    glm::mat3 t = glm::transpose(m);
    return out << t[0] << "\n" << t[1] << "\n" << t[2];
}

void answer(int n) {
    std::cout << "\nAnswer to question " << n << ":\n";
}

int main() {
    // objects
    glm::vec3 center = glm::vec3(1, 1, 0);
    float radius = 2;
    glm::vec3 A = glm::vec3(0, -2, 2);
    glm::vec3 B = glm::vec3(2, 2, 2);
    glm::vec3 C = glm::vec3(-2, 2, 2);
    // camera
    glm::vec3 eye = glm::vec3(0, 0, 4);
    glm::vec3 lookat = glm::vec3(0, 0, 0);
    glm::vec3 vup = glm::vec3(0, 1, 0);
    float clipLeft = -2, clipRight = 2, clipBottom = -1, clipTop = 1, clipNear = 2;
    float W = 301, H = 201;
    float xDCS = 150, yDCS = 100;

    answer(1);
    float xVCS = clipLeft + xDCS * ((clipRight - clipLeft) / (W - 1));
    float yVCS = clipBottom + yDCS * ((clipTop - clipBottom) / (H - 1));
    glm::vec4 pVCS(xVCS, yVCS, -clipNear, 1);
    std::cout << "P_VCS is " << pVCS << "\n";

    answer(2);
    glm::vec3 Z = glm::normalize(eye - lookat);
    glm::vec3 X = glm::normalize(glm::cross(vup, Z));
    glm::vec3 Y = glm::normalize(glm::cross(Z, X));
    std::cout << "X_vcs is " << X << "\n";
    std::cout << "Y_vcs is " << Y << "\n";
    std::cout << "Z_vcs is " << Z << "\n";

    answer(3);
    glm::mat4 M = glm::inverse(glm::lookAt(eye, lookat, vup));
    std::cout << "M_VCS_to_WCS is (row by row)\n" << M << "\n";

    answer(4);
    glm::vec4 pWCS = M * pVCS;
    std::cout << "P_WCS is " << pWCS << "\n";

    answer(5);
    glm::vec3 S = glm::vec3(pWCS);
    glm::vec3 V = glm::normalize(S - eye);
    std::cout << "V is " << V << "\n";

    answer(6);
    float a = glm::dot(V, V);
    float b = 2 * glm::dot(V, S - center);
    float c = glm::dot(S - center, S - center) - radius * radius;
    float d = b * b - 4 * a * c;
    float tSphere = (-b - sqrt(d)) / (2 * a);
    if (tSphere < 0) tSphere = (-b + sqrt(d)) / (2 * a);
    glm::vec3 hitSphere = S + tSphere * V;
    std::cout << "a is " << a << "\n" << "b is " << b << "\n" << "c is " << c << "\n";
    std::cout << "the discriminant d is " << d << "\n";
    std::cout << "t is " << tSphere << "\n";
    std::cout << "the hit point is " << hitSphere << "\n";

    answer(7);
    glm::vec3 nSphere = glm::normalize(hitSphere - center);
    std::cout << "N is " << nSphere << "\n";

    answer(8);
    glm::mat3 mat(B - A, C - A, -V);
    glm::vec3 rhs = S - A;
    glm::vec3 x = glm::inverse(mat) * rhs;
    float t = x[0], u = x[1], v = x[2];
    glm::vec3 hitTri = S + t * V;
    std::cout << "the matrix A is (row by row)\n" << mat << "\n";
    std::cout << "the right-hand side is " << rhs << "\n";
    std::cout << "t is " << t << "\n" << "u is " << u << "\n" << "v is " << v << "\n";
    std::cout << "the hit point is " << hitTri << "\n";

    answer(9);
    glm::vec3 nTri = glm::normalize(glm::cross(B - A, C - A));
    std::cout << "N is " << nTri << "\n";

    answer(10);
    if (t < tSphere) std::cout << "ray hits triangle first\n";
    else std::cout << "ray hits sphere first\n";
    return 0;
}
