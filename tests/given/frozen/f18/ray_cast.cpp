// Assignment 6. The program explains its results in full sentences.
#include <iostream>
#include <sstream>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

std::string s(const glm::vec3& v)
{
    std::stringstream ss;
    ss << "(" << v.x << ", " << v.y << ", " << v.z << ")";
    return ss.str();
}

std::string s(const glm::vec4& v)
{
    std::stringstream ss;
    ss << "(" << v.x << ", " << v.y << ", " << v.z << ", " << v.w << ")";
    return ss.str();
}

int main()
{
    using std::cout;

    glm::vec3 center(1, 1, 0);
    float R = 2;
    glm::vec3 A(0, -2, 2), B(2, 2, 2), C(-2, 2, 2);
    glm::vec3 eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0);
    float clipLeft = -2, clipRight = 2, clipBottom = -1, clipTop = 1, clipNear = 2;
    int W = 301, H = 201;

    glm::vec3 P_vcs(clipLeft + 150 * (clipRight - clipLeft) / (W - 1),
                    clipBottom + 100 * (clipTop - clipBottom) / (H - 1),
                    -clipNear);
    cout << "In view coordinates the pixel is at " << s(P_vcs) << ".\n";

    glm::vec3 Z = glm::normalize(eye - lookat);
    glm::vec3 X = glm::normalize(glm::cross(vup, Z));
    glm::vec3 Y = glm::cross(Z, X);
    cout << "The x axis of the view coordinates is " << s(X) << ".\n";
    cout << "The y axis of the view coordinates is " << s(Y) << ".\n";
    cout << "The z axis of the view coordinates is " << s(Z) << ".\n";

    glm::mat4 M = glm::inverse(glm::lookAt(eye, lookat, vup));
    glm::mat4 R4 = glm::transpose(M);
    cout << "The matrix from VCS to WCS has the rows " << s(R4[0]) << ", " << s(R4[1]) << ", "
         << s(R4[2]) << " and " << s(R4[3]) << ".\n";

    glm::vec3 S = glm::vec3(M * glm::vec4(P_vcs, 1));
    cout << "In world coordinates the pixel is at " << s(S) << ".\n";

    glm::vec3 V = glm::normalize(S - eye);
    cout << "The unit vector from the eye to the pixel is " << s(V) << ".\n\n";

    float a = glm::dot(V, V);
    float b = 2 * glm::dot(V, S - center);
    float c = glm::dot(S - center, S - center) - R * R;
    float d = b * b - 4 * a * c;
    float t = (-b - std::sqrt(d)) / (2 * a);
    glm::vec3 P_s = S + t * V;
    cout << "For the sphere, the quadratic's coefficient a is " << a << ", b is " << b << " and c is " << c << ".\n";
    cout << "Its discriminant d is " << d << ".\n";
    cout << "The ray hits the sphere at parameter t = " << t << ", which is the point " << s(P_s) << ".\n";
    cout << "The unit normal of the sphere there is " << s(glm::normalize(P_s - center)) << ".\n\n";

    glm::mat3 K(-V, B - A, C - A);
    glm::mat3 R3 = glm::transpose(K);
    glm::vec3 rhs = S - A;
    glm::vec3 x = glm::inverse(K) * rhs;
    cout << "For the triangle, the matrix A has the rows " << s(R3[0]) << ", " << s(R3[1]) << " and " << s(R3[2]) << ".\n";
    cout << "The right-hand side of the equation is " << s(rhs) << ".\n";
    cout << "Its solution is t = " << x.x << ", u = " << x.y << " and v = " << x.z << ".\n";
    cout << "So the ray hits the triangle at the point " << s(S + x.x * V) << ".\n";
    cout << "The unit normal of the triangle is " << s(glm::normalize(glm::cross(B - A, C - A))) << ".\n\n";

    cout << "Therefore the ray hits " << (x.x < t ? "the triangle" : "the sphere") << " first.\n";
    return 0;
}
