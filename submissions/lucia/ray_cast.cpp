#include <iostream>
#include <math.h>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/gtx/string_cast.hpp>

using namespace glm;

class RayCaster
{
public:
    RayCaster()
        : eye(0.0, 0.0, 4.0), lookat(0.0, 0.0, 0.0), vup(0.0, 1.0, 0.0), width(301), height(201) {}

    void run()
    {
        pixelToView(150, 100);
        computeBasis();
        computeMatrix();
        pixelToWorld();
        computeDirection();
        intersectSphere(dvec3(1.0, 1.0, 0.0), 2.0);
        intersectTriangle(dvec3(0.0, -2.0, 2.0), dvec3(2.0, 2.0, 2.0), dvec3(-2.0, 2.0, 2.0));
        std::cout << "Question 10:\n";
        if (tTriangle < tSphere)
            std::cout << "ray hits triangle first\n";
        else
            std::cout << "ray hits sphere first\n";
    }

private:
    void pixelToView(int i, int j)
    {
        double pixelWidth = (2.0 - -2.0) / width;
        double pixelHeight = (1.0 - -1.0) / height;
        pView = dvec3(-2.0 + i * pixelWidth, -1.0 + j * pixelHeight, -2.0);
        std::cout << "Question 1:\n";
        std::cout << "P_VCS: " << to_string(pView) << "\n";
    }
    void computeBasis()
    {
        z = normalize(eye - lookat);
        x = normalize(cross(vup, z));
        y = cross(z, x);
        std::cout << "Question 2:\n";
        std::cout << "X_vcs: " << to_string(x) << "\n";
        std::cout << "Y_vcs: " << to_string(y) << "\n";
        std::cout << "Z_vcs: " << to_string(z) << "\n";
    }
    void computeMatrix()
    {
        M = dmat4(dvec4(x, 0.0), dvec4(y, 0.0), dvec4(z, 0.0), dvec4(eye, 1.0));
        std::cout << "Question 3:\n";
        std::cout << "M_VCS_to_WCS: " << to_string(M) << "\n";
    }
    void pixelToWorld()
    {
        S = dvec3(M * dvec4(pView, 1.0));
        std::cout << "Question 4:\n";
        std::cout << "P_WCS: " << to_string(S) << "\n";
    }
    void computeDirection()
    {
        V = normalize(S - eye);
        std::cout << "Question 5:\n";
        std::cout << "V: " << to_string(V) << "\n";
    }
    void intersectSphere(dvec3 C, double R)
    {
        double a = dot(V, V);
        double b = 2.0 * dot(V, S - C);
        double c = dot(S - C, S - C) - R * R;
        double d = b * b - 4.0 * a * c;
        double t1 = (-b - ::sqrt(d)) / (2.0 * a);
        double t2 = (-b + ::sqrt(d)) / (2.0 * a);
        tSphere = (t1 > 0.0) ? t1 : t2;
        dvec3 P = S + tSphere * V;
        std::cout << "Question 6:\n";
        std::cout << "a: " << a << "\n" << "b: " << b << "\n" << "c: " << c << "\n" << "d: " << d << "\n";
        std::cout << "t1: " << t1 << "\n" << "t2: " << t2 << "\n";
        std::cout << "t: " << tSphere << "\n";
        std::cout << "P_s: " << to_string(P) << "\n";
        std::cout << "Question 7:\n";
        std::cout << "N: " << to_string(normalize(P - C)) << "\n";
    }
    void intersectTriangle(dvec3 A, dvec3 B, dvec3 C)
    {
        dmat3 mat(-V, B - A, C - A);
        dvec3 rhs = S - A;
        dvec3 sol = inverse(mat) * rhs;
        tTriangle = sol.x;
        std::cout << "Question 8:\n";
        std::cout << "A: " << to_string(mat) << "\n";
        std::cout << "rhs: " << to_string(rhs) << "\n";
        std::cout << "t: " << sol.x << "\n" << "u: " << sol.y << "\n" << "v: " << sol.z << "\n";
        std::cout << "P_t: " << to_string(S + tTriangle * V) << "\n";
        std::cout << "Question 9:\n";
        std::cout << "N: " << to_string(normalize(cross(B - A, C - A))) << "\n";
    }

    dvec3 eye, lookat, vup;
    int width, height;
    dvec3 pView, x, y, z, S, V;
    dmat4 M;
    double tSphere, tTriangle;
};

int main()
{
    RayCaster caster;
    caster.run();
    return 0;
}
