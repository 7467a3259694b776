#include <iostream>
#include <iomanip>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

using namespace std;

// prints one component per line
void show(const char* title, glm::vec3 v)
{
    cout << title << endl;
    cout << "  x: " << v.x << endl;
    cout << "  y: " << v.y << endl;
    cout << "  z: " << v.z << endl;
}

int main()
{
    cout << fixed << setprecision(4);

    const glm::vec3 C(1, 1, 0);
    const float R = 2;
    const glm::vec3 tA(0, -2, 2);
    const glm::vec3 tB(2, 2, 2);
    const glm::vec3 tC(-2, 2, 2);
    const glm::vec3 eye(0, 0, 4);
    const glm::vec3 lookat(0, 0, 0);
    const glm::vec3 vup(0, 1, 0);

    // window to view mapping
    float sx = (2.0f - -2.0f) / (301 - 1);
    float sy = (1.0f - -1.0f) / (201 - 1);
    glm::vec3 p_vcs(-2.0f + 150 * sx, -1.0f + 100 * sy, -2.0f);

    cout << "Problem 1 - P_VCS" << endl;
    show("Pixel in VCS", p_vcs);

    glm::vec3 zv = glm::normalize(eye - lookat);
    glm::vec3 xv = glm::normalize(glm::cross(vup, zv));
    glm::vec3 yv = glm::cross(zv, xv);
    cout << "Problem 2 - basis" << endl;
    show("X_vcs", xv);
    show("Y_vcs", yv);
    show("Z_vcs", zv);

    glm::mat4 m = glm::inverse(glm::lookAt(eye, lookat, vup));
    cout << "Problem 3 - M_VCS_to_WCS" << endl;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++)
            cout << setw(10) << m[j][i];
        cout << endl;
    }

    glm::vec3 s = glm::vec3(m * glm::vec4(p_vcs, 1.0f));
    cout << "Problem 4 - P_WCS" << endl;
    show("Pixel in WCS", s);

    glm::vec3 v = glm::normalize(s - eye);
    cout << "Problem 5 - V" << endl;
    show("Direction V", v);

    // (S + tV - C).(S + tV - C) = R^2
    float a = glm::dot(v, v);
    float b = 2 * glm::dot(v, s - C);
    float c = glm::dot(s - C, s - C) - R * R;
    float d = b * b - 4 * a * c;
    float t = (-b + sqrt(d)) / (2 * a);
    glm::vec3 ps = s + t * v;
    cout << "Problem 6 - sphere" << endl;
    cout << "a: " << a << endl;
    cout << "b: " << b << endl;
    cout << "c: " << c << endl;
    cout << "d: " << d << endl;
    cout << "t: " << t << endl;
    show("P_s", ps);

    cout << "Problem 7 - sphere normal" << endl;
    show("N", glm::normalize(ps - C));

    glm::mat3 A(v, tB - tA, tC - tA);
    glm::vec3 rhs = s - tA;
    glm::vec3 tuv = glm::inverse(A) * rhs;
    cout << "Problem 8 - triangle" << endl;
    cout << "Matrix A" << endl;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            cout << setw(10) << A[j][i];
        cout << endl;
    }
    show("Right-hand side", rhs);
    cout << "t: " << tuv.x << endl;
    cout << "u: " << tuv.y << endl;
    cout << "v: " << tuv.z << endl;
    show("P_t", s + tuv.x * v);

    cout << "Problem 9 - triangle normal" << endl;
    show("N", glm::normalize(glm::cross(tB - tA, tC - tA)));

    cout << "Problem 10" << endl;
    if (tuv.x < t)
        cout << "ray hits triangle first" << endl;
    else
        cout << "ray hits sphere first" << endl;
}
