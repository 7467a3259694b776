// Oskar, CS770 A6
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <iostream>

using namespace std;

// smallest root of a t^2 + b t + c between lo and hi, by bisection
float bisect(float a, float b, float c, float lo, float hi) {
    while (hi - lo > 1e-9f) {
        float mid = (lo + hi) / 2;
        float f = (a * mid + b) * mid + c;
        if (f > 0) lo = mid;
        else hi = mid;
    }
    return lo;
}

int main() {
    glm::vec3 eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0), center(1, 1, 0);
    float R = 2;

    cout << "Question 1" << endl;
    glm::vec3 p(-2 + 4 * (150 + 0.5f) / 301, -1 + 2 * (100 + 0.5f) / 201, -2);
    cout << "P_VCS: " << glm::to_string(p) << endl;

    cout << "Question 2" << endl;
    glm::vec3 z = glm::normalize(eye - lookat), x = glm::normalize(glm::cross(vup, z)), y = glm::cross(z, x);
    cout << "X_vcs: " << glm::to_string(x) << endl;
    cout << "Y_vcs: " << glm::to_string(y) << endl;
    cout << "Z_vcs: " << glm::to_string(z) << endl;

    cout << "Question 3" << endl;
    glm::mat4 m = glm::inverse(glm::lookAt(eye, lookat, vup));
    cout << "M_VCS_to_WCS: " << glm::to_string(m) << endl;

    cout << "Question 4" << endl;
    glm::vec3 s(m * glm::vec4(p, 1));
    cout << "P_WCS: " << glm::to_string(s) << endl;

    cout << "Question 5" << endl;
    glm::vec3 v = glm::normalize(s - eye);
    cout << "V: " << glm::to_string(v) << endl;

    cout << "Question 6" << endl;
    float a = glm::dot(v, v), b = 2 * glm::dot(v, s - center), c = glm::dot(s - center, s - center) - R * R;
    cout << "a: " << a << endl;
    cout << "b: " << b << endl;
    cout << "c: " << c << endl;
    cout << "d: " << b * b - 4 * a * c << endl;
    float t = bisect(a, b, c, 0, -b / (2 * a));
    cout << "t: " << t << endl;
    cout << "P_s: " << glm::to_string(s + t * v) << endl;

    cout << "Question 7" << endl;
    cout << "N: " << glm::to_string(glm::normalize(s + t * v - center)) << endl;
    return 0;
}
