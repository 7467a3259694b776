#include <iostream>
#include <iomanip>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

/*
 * Assignment 6
 * prints its own vectors, fixed with four decimals
 */

using namespace std;

void print(const char* label, glm::vec3 p) {
    cout << left << setw(16) << label << "[" << p.x << "; " << p.y << "; " << p.z << "]" << endl;
}
void print(const char* label, float f) {
    cout << left << setw(16) << label << f << endl;
}

int main() {
    cout << fixed << setprecision(4);

    glm::vec3 eye(0, 0, 4), at(0, 0, 0), up(0, 1, 0);
    glm::vec3 tri[3] = {glm::vec3(0, -2, 2), glm::vec3(2, 2, 2), glm::vec3(-2, 2, 2)};
    glm::vec3 ball(1, 1, 0);
    float R = 2;

    cout << "QUESTION 1" << endl;
    glm::vec3 pv(-2 + 4 * 150.0f / 300.0f, -1 + 2 * 100.0f / 200.0f, -2);
    print("P_VCS", pv);

    cout << "QUESTION 2" << endl;
    glm::vec3 n = glm::normalize(eye - at), u = glm::normalize(glm::cross(up, n)), v = glm::cross(n, u);
    print("X_vcs", u);
    print("Y_vcs", v);
    print("Z_vcs", n);

    cout << "QUESTION 3" << endl;
    glm::mat4 M = glm::inverse(glm::lookAt(eye, at, up));
    cout << "M_VCS_to_WCS" << endl;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) cout << right << setw(10) << M[j][i];
        cout << endl;
    }

    cout << "QUESTION 4" << endl;
    glm::vec4 pw = M * glm::vec4(pv, 1);
    glm::vec3 S(pw);
    print("P_WCS", S);

    cout << "QUESTION 5" << endl;
    glm::vec3 V = glm::normalize(S - eye);
    print("V", V);

    cout << "QUESTION 6" << endl;
    float a = glm::dot(V, V);
    float b = 2 * glm::dot(V, S - ball);
    float c = glm::dot(S - ball, S - ball) - R;
    float d = b * b - 4 * a * c;
    print("a", a);
    print("b", b);
    print("c", c);
    print("d", d);
    float t = -1;
    if (d < 0) {
        cout << "no hit" << endl;
        return 0;
    }
    float lo = (-b - sqrt(d)) / (2 * a), hi = (-b + sqrt(d)) / (2 * a);
    t = lo > 0 ? lo : hi;
    print("t", t);
    glm::vec3 Ps = S + t * V;
    print("hit point", Ps);

    cout << "QUESTION 7" << endl;
    glm::vec3 Ns = glm::normalize(Ps - ball);
    print("normal", Ns);

    cout << "QUESTION 8" << endl;
    glm::vec3 e1 = tri[1] - tri[0], e2 = tri[2] - tri[0];
    glm::mat3 A(-V, e1, e2);
    cout << "A" << endl;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) cout << right << setw(10) << A[j][i];
        cout << endl;
    }
    glm::vec3 rhs = S - tri[0];
    print("rhs", rhs);
    glm::vec3 x = glm::inverse(A) * rhs;
    print("t", x.x);
    print("u", x.y);
    print("v", x.z);
    glm::vec3 Pt = S + x.x * V;
    print("hit point", Pt);

    cout << "QUESTION 9" << endl;
    print("normal", glm::normalize(glm::cross(e1, e2)));

    cout << "QUESTION 10" << endl;
    if (x.x < t) cout << "ray hits triangle first" << endl;
    else cout << "ray hits sphere first" << endl;
    return 0;
}
