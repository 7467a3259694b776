// CS770/870 Assignment 6: Ray Casting. The model solution.
#ifndef GLM_ENABLE_EXPERIMENTAL  // string_cast.hpp is one of GLM's experimental headers
#define GLM_ENABLE_EXPERIMENTAL
#endif

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/string_cast.hpp>
#include <iostream>
#include <optional>

namespace {

struct Camera {
    glm::vec3 eye;
    glm::vec3 lookat;
    glm::vec3 vup;
};

struct ImagePlane {
    float clipLeft, clipRight;
    float clipBottom, clipTop;
    float clipNear;
    int W, H;  // pixels
};

struct Sphere {
    glm::vec3 C;
    float R;
};

struct Triangle {
    glm::vec3 A, B, C;
};

// P = S + tV
struct Ray {
    glm::vec3 S;
    glm::vec3 V;

    glm::vec3 at(float t) const { return S + t * V; }
};

// at^2 + bt + c = 0
struct Quadratic {
    float a, b, c;

    float discriminant() const { return b * b - 4.0f * a * c; }

    // None where the ray misses.
    std::optional<float> smallestPositiveRoot() const {
        const float d = discriminant();
        if (d < 0.0f) return std::nullopt;
        const float near = (-b - std::sqrt(d)) / (2.0f * a);
        const float far = (-b + std::sqrt(d)) / (2.0f * a);
        if (near > 0.0f) return near;
        if (far > 0.0f) return far;
        return std::nullopt;
    }
};

// The center of the pixel, on the image plane.
glm::vec3 pixelToVCS(const ImagePlane& plane, int x_DCS, int y_DCS) {
    const float across = (static_cast<float>(x_DCS) + 0.5f) / static_cast<float>(plane.W);
    const float up = (static_cast<float>(y_DCS) + 0.5f) / static_cast<float>(plane.H);
    return {glm::mix(plane.clipLeft, plane.clipRight, across), glm::mix(plane.clipBottom, plane.clipTop, up),
            -plane.clipNear};
}

// (P - C).(P - C) = R^2 with P = S + tV, ordered by powers of t.
Quadratic intersect(const Ray& ray, const Sphere& sphere) {
    const glm::vec3 CS = ray.S - sphere.C;
    return {glm::dot(ray.V, ray.V), 2.0f * glm::dot(ray.V, CS), glm::dot(CS, CS) - sphere.R * sphere.R};
}

void print(const char* label, const glm::vec3& value) {
    std::cout << label << ": " << glm::to_string(value) << "\n";
}

void print(const char* label, float value) {
    std::cout << label << ": " << value << "\n";
}

// A value that exists only where the ray hits.
template <class T>
void print(const char* label, const std::optional<T>& value) {
    if (value) {
        print(label, *value);
    } else {
        std::cout << label << ": none\n";
    }
}

}  // namespace

int main() {
    const Camera camera{{0, 0, 4}, {0, 0, 0}, {0, 1, 0}};
    const ImagePlane plane{-2, 2, -1, 1, 2, 301, 201};
    const Sphere sphere{{1, 1, 0}, 2};
    const Triangle triangle{{0, -2, 2}, {2, 2, 2}, {-2, 2, 2}};

    std::cout << "Question 1:\n";
    const glm::vec3 P_VCS = pixelToVCS(plane, 150, 100);
    print("Pixel in VCS", P_VCS);

    std::cout << "Question 2:\n";
    const glm::vec3 Z_vcs = glm::normalize(camera.eye - camera.lookat);
    const glm::vec3 X_vcs = glm::normalize(glm::cross(camera.vup, Z_vcs));
    const glm::vec3 Y_vcs = glm::cross(Z_vcs, X_vcs);
    print("X_vcs", X_vcs);
    print("Y_vcs", Y_vcs);
    print("Z_vcs", Z_vcs);

    std::cout << "Question 3:\n";
    const glm::mat4 view = glm::lookAt(camera.eye, camera.lookat, camera.vup);
    const glm::mat4 M_VCS_to_WCS = glm::inverse(view);
    std::cout << "M_VCS_to_WCS: " << glm::to_string(M_VCS_to_WCS) << "\n";

    std::cout << "Question 4:\n";
    const glm::vec3 P_WCS(M_VCS_to_WCS * glm::vec4(P_VCS, 1.0f));
    print("Pixel in WCS", P_WCS);

    std::cout << "Question 5:\n";
    const glm::vec3 V = glm::normalize(P_WCS - camera.eye);
    print("V", V);

    std::cout << "Question 6:\n";
    const Ray ray{P_WCS, V};
    const Quadratic quadratic = intersect(ray, sphere);
    const std::optional<float> t_s = quadratic.smallestPositiveRoot();
    std::optional<glm::vec3> P_s, N_s;
    if (t_s) {
        P_s = ray.at(*t_s);
        N_s = glm::normalize(*P_s - sphere.C);
    }
    print("a", quadratic.a);
    print("b", quadratic.b);
    print("c", quadratic.c);
    print("d", quadratic.discriminant());
    print("t", t_s);
    print("Hit point P_s", P_s);

    std::cout << "Question 7:\n";
    print("Sphere normal", N_s);

    // A + u(B-A) + v(C-A) = S + tV, so  t(-V) + u(B-A) + v(C-A) = S - A.
    std::cout << "Question 8:\n";
    const glm::vec3 AB = triangle.B - triangle.A;
    const glm::vec3 AC = triangle.C - triangle.A;
    const glm::mat3 A(-ray.V, AB, AC);  // by columns: t, u, v
    const glm::vec3 rhs = ray.S - triangle.A;
    const bool has_solution = glm::determinant(A) != 0.0f;  // the ray is not parallel to the triangle's plane
    std::optional<float> t, u, v;
    std::optional<glm::vec3> P_t;
    if (has_solution) {
        const glm::vec3 solution = glm::inverse(A) * rhs;
        t = solution[0];
        u = solution[1];
        v = solution[2];
        P_t = ray.at(*t);
    }
    std::cout << "Matrix A: " << glm::to_string(A) << "\n";
    print("Right-hand side", rhs);
    print("t", t);
    print("u", u);
    print("v", v);
    print("Hit point P_t", P_t);

    std::cout << "Question 9:\n";
    const glm::vec3 N_t = glm::normalize(glm::cross(AB, AC));
    print("Triangle normal", N_t);

    // In this scene the ray starts on the triangle, at t = 0. That point is on the ray, so it counts as hit.
    std::cout << "Question 10:\n";
    const bool hits_triangle = has_solution && *t >= 0.0f && *u >= 0.0f && *v >= 0.0f && *u + *v <= 1.0f;
    if (!hits_triangle && !t_s) {
        std::cout << "ray hits nothing\n";
    } else if (hits_triangle && (!t_s || *t < *t_s)) {
        print("Position", P_t);
        print("Normal", N_t);
        std::cout << "ray hits triangle first\n";
    } else {
        print("Position", P_s);
        print("Normal", N_s);
        std::cout << "ray hits sphere first\n";
    }
    return 0;
}
