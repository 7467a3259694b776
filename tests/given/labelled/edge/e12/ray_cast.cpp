#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <iostream>
using namespace std;
using namespace glm;

void show(vec3 v) {
    cout << v.x << v.y << v.z << endl;
}

int main() {
    vec3 eye(6, 1, 0), lookat(0, 1, 0), vup(0, 1, 0);
    vec3 center(1, 0, 1);
    float R = 2;
    vec3 A(3, 0, -1), B(3, 0, 1), C(1, 3, 2);

    vec3 pvcs(-2 + 4 * 150.5f / 301, -1 + 2 * 100.5f / 201, -2);
    cout << "Question 1:" << endl;
    show(pvcs);

    vec3 z = normalize(eye - lookat);
    vec3 x = normalize(cross(vup, z));
    vec3 y = cross(z, x);
    cout << "Question 2:" << endl;
    show(x);
    show(y);
    show(z);

    mat4 m = inverse(lookAt(eye, lookat, vup));
    cout << "Question 3:" << endl;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) cout << m[j][i];
    }
    cout << endl;

    vec3 s = vec3(m * vec4(pvcs, 1));
    cout << "Question 4:" << endl;
    show(s);

    vec3 v = normalize(s - eye);
    cout << "Question 5:" << endl;
    show(v);

    float a = dot(v, v);
    float b = 2 * dot(v, s - center);
    float c = dot(s - center, s - center) - R * R;
    float d = b * b - 4 * a * c;
    float t = (-b - sqrt(d)) / (2 * a);
    vec3 ps = s + t * v;
    cout << "Question 6:" << endl;
    cout << "abc" << a << b << c << endl;
    cout << "d" << d << endl;
    cout << "t" << t << endl;
    show(ps);

    cout << "Question 7:" << endl;
    show(normalize(ps - center));

    mat3 mm(-v, B - A, C - A);
    vec3 r = s - A;
    vec3 tuv = inverse(mm) * r;
    cout << "Question 8:" << endl;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) cout << mm[j][i];
    cout << endl;
    show(r);
    cout << tuv.x << endl << tuv.y << endl << tuv.z << endl;
    show(s + tuv.x * v);

    cout << "Question 9:" << endl;
    show(normalize(cross(B - A, C - A)));

    cout << "Question 10:" << endl;
    if (t < tuv.x)
        cout << "ray hits sphere first" << endl;
    else
        cout << "ray hits triangle first" << endl;
}
