// Ray casting, one pixel.  Everything is printed with printf because
// I like to have the same number of digits everywhere.
#include <cstdio>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#define V3(v) (v).x, (v).y, (v).z

struct Sphere   { glm::vec3 center; float radius; };
struct Triangle { glm::vec3 A, B, C; };
struct Camera   { glm::vec3 eye, lookat, vup; float l, r, b, t, n; int W, H; };

int main(void)
{
    Sphere sph = { glm::vec3(1, 1, 0), 2.0f };
    Triangle tri = { glm::vec3(0, -2, 2), glm::vec3(2, 2, 2), glm::vec3(-2, 2, 2) };
    Camera cam = { glm::vec3(0, 0, 4), glm::vec3(0, 0, 0), glm::vec3(0, 1, 0),
                   -2, 2, -1, 1, 2, 301, 201 };
    int xd = 150, yd = 100;

    float xn = xd / float(cam.W - 1);
    float yn = yd / float(cam.H - 1);
    glm::vec3 pv(cam.l + xn * (cam.r - cam.l), cam.b + yn * (cam.t - cam.b), -cam.n);
    printf("1. Pixel in camera coordinates\n");
    printf("   P_VCS = [ %.3f %.3f %.3f ]\n\n", V3(pv));

    glm::vec3 z = glm::normalize(cam.eye - cam.lookat);
    glm::vec3 x = glm::normalize(glm::cross(cam.vup, z));
    glm::vec3 y = glm::cross(z, x);
    printf("2. Basis vectors\n");
    printf("   X = [ %.3f %.3f %.3f ]\n", V3(x));
    printf("   Y = [ %.3f %.3f %.3f ]\n", V3(y));
    printf("   Z = [ %.3f %.3f %.3f ]\n\n", V3(z));

    glm::mat4 M = glm::inverse(glm::lookAt(cam.eye, cam.lookat, cam.vup));
    printf("3. M_VCS_to_WCS\n");
    for (int c = 0; c < 4; c++)
        printf("   column %d: [ %.3f %.3f %.3f %.3f ]\n", c, M[c][0], M[c][1], M[c][2], M[c][3]);
    printf("\n");

    glm::vec4 pw = M * glm::vec4(pv, 1.0f);
    glm::vec3 S(pw);
    printf("4. Pixel in world coordinates\n");
    printf("   P_WCS = [ %.3f %.3f %.3f %.3f ]\n\n", pw.x, pw.y, pw.z, pw.w);

    glm::vec3 V = glm::normalize(S - cam.eye);
    printf("5. Direction\n");
    printf("   V = [ %.3f %.3f %.3f ]\n\n", V3(V));

    glm::vec3 D = S - sph.center;
    float a = glm::dot(V, V);
    float b = 2 * glm::dot(V, D);
    float c = glm::dot(D, D) - sph.radius * sph.radius;
    float disc = b * b - 4 * a * c;
    float t1 = (-b + sqrtf(disc)) / (2 * a);
    float t2 = (-b - sqrtf(disc)) / (2 * a);
    float t = t1;
    if (t2 > 0 && t2 < t1)
        t = t2;
    glm::vec3 Ps = S + t * V;
    printf("6. Sphere\n");
    printf("   a = %.3f\n   b = %.3f\n   c = %.3f\n   d = %.3f\n", a, b, c, disc);
    printf("   t = %.3f\n   P_s = [ %.3f %.3f %.3f ]\n\n", t, V3(Ps));

    glm::vec3 Ns = glm::normalize(Ps - sph.center);
    printf("7. Sphere normal\n");
    printf("   N = [ %.3f %.3f %.3f ]\n\n", V3(Ns));

    glm::mat3 A(-V, tri.B - tri.A, tri.C - tri.A);
    glm::vec3 rhs = S - tri.A;
    glm::vec3 sol = glm::inverse(A) * rhs;
    glm::vec3 Pt = S + sol.x * V;
    printf("8. Triangle\n   matrix A\n");
    for (int i = 0; i < 3; i++)
        printf("   column %d: [ %.3f %.3f %.3f ]\n", i, V3(A[i]));
    printf("   rhs = [ %.3f %.3f %.3f ]\n", V3(rhs));
    printf("   t = %.3f\n   u = %.3f\n   v = %.3f\n", sol.x, sol.y, sol.z);
    printf("   P_t = [ %.3f %.3f %.3f ]\n\n", V3(Pt));

    glm::vec3 Nt = glm::normalize(glm::cross(tri.B - tri.A, tri.C - tri.A));
    printf("9. Triangle normal\n");
    printf("   N = [ %.3f %.3f %.3f ]\n\n", V3(Nt));

    printf("10. Result\n");
    printf("   ray hits %s first\n", sol.x < t ? "triangle" : "sphere");
    return 0;
}
