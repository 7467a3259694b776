// ray_cast.cpp, CS870
#include <cmath>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <string>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

const int WIDTH = 52;

std::string bar(int n) { std::string s; while (n-- > 0) s += "─"; return s; }

void boxTop(const std::string& title)
{
    std::cout << "┌─ " << title << " " << bar(WIDTH - 2 - (int)title.size()) << "┐\n";
}
void boxLine(const std::string& text)
{
    std::cout << "│ " << text << std::string(WIDTH - text.size(), ' ') << "│\n";
}
void boxEnd() { std::cout << "└" << bar(WIDTH + 1) << "┘\n"; }

void boxLine(const char* name, const glm::vec3& v)
{
    char buf[100];
    snprintf(buf, sizeof buf, "%s = ( %.4f, %.4f, %.4f )", name, v.x, v.y, v.z);
    boxLine(std::string(buf));
}
void boxLine(const char* name, float f)
{
    char buf[100];
    snprintf(buf, sizeof buf, "%s = %.4f", name, f);
    boxLine(std::string(buf));
}

int main()
{
    glm::vec3 center(1, 1, 0), A(0, -2, 2), B(2, 2, 2), C(-2, 2, 2);
    float R = 2;
    glm::vec3 eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0);

    glm::vec3 pv(-2 + 150 * 4.0f / 300, -1 + 100 * 2.0f / 200, -2);
    boxTop("Question 1"); boxLine("P_VCS", pv); boxEnd();

    glm::vec3 z = glm::normalize(eye - lookat), x = glm::normalize(glm::cross(vup, z)), y = glm::cross(z, x);
    boxTop("Question 2"); boxLine("X_vcs", x); boxLine("Y_vcs", y); boxLine("Z_vcs", z); boxEnd();

    glm::mat4 M = glm::inverse(glm::lookAt(eye, lookat, vup));
    boxTop("Question 3");
    boxLine("M_VCS_to_WCS");
    for (int r = 0; r < 4; r++) {
        char buf[100];
        snprintf(buf, sizeof buf, "%8.4f %8.4f %8.4f %8.4f", M[0][r], M[1][r], M[2][r], M[3][r]);
        boxLine(std::string(buf));
    }
    boxEnd();

    glm::vec3 S = glm::vec3(M * glm::vec4(pv, 1));
    glm::vec3 V = glm::normalize(S - eye);
    boxTop("Question 4"); boxLine("P_WCS", S); boxEnd();
    boxTop("Question 5"); boxLine("V", V); boxEnd();

    float a = glm::dot(V, V), b = 2 * glm::dot(V, S - center), c = glm::dot(S - center, S - center) - R * R;
    float d = b * b - 4 * a * c;
    float ts = (-b - std::sqrt(d)) / (2 * a);
    glm::vec3 Ps = S + ts * V;
    boxTop("Question 6");
    boxLine("a", a); boxLine("b", b); boxLine("c", c); boxLine("d", d); boxLine("t", ts); boxLine("P_s", Ps);
    boxEnd();
    boxTop("Question 7"); boxLine("N_s", glm::normalize(Ps - center)); boxEnd();

    glm::mat3 K(-V, B - A, C - A);
    glm::vec3 rhs = S - B;
    glm::vec3 sol = glm::inverse(K) * rhs;
    boxTop("Question 8");
    boxLine("A");
    for (int r = 0; r < 3; r++) {
        char buf[100];
        snprintf(buf, sizeof buf, "%8.4f %8.4f %8.4f", K[0][r], K[1][r], K[2][r]);
        boxLine(std::string(buf));
    }
    boxLine("rhs", rhs); boxLine("t", sol.x); boxLine("u", sol.y); boxLine("v", sol.z); boxLine("P_t", S + sol.x * V);
    bool inside = sol.y >= 0 && sol.z >= 0 && sol.y + sol.z <= 1;
    boxLine(inside ? "inside the triangle: yes" : "inside the triangle: no");
    boxEnd();
    boxTop("Question 9"); boxLine("N_t", glm::normalize(glm::cross(B - A, C - A))); boxEnd();

    boxTop("Question 10");
    boxLine(inside && sol.x < ts ? "ray hits triangle first" : "ray hits sphere first");
    boxEnd();
    return 0;
}
