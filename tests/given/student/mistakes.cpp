#include "tests/given/student/mistakes.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/given/student/items.h"
#include "tests/given/student/mistake_parts.h"

namespace student {
namespace {

using glm::cross;
using glm::dot;
using glm::mat3;
using glm::mat4;
using glm::normalize;
using glm::vec3;
using glm::vec4;

vec3 in_window(const Names& n, float x, float y) {
    const auto& w = n.window();
    return {glm::mix(w.clip_left, w.clip_right, x), glm::mix(w.clip_bottom, w.clip_top, y), -w.clip_near};
}

/// Solves the system for t, u and v with the inverse matrix.
vec3 solved(const Names& n, const vec3& start) {
    return glm::inverse(mat3(-n.direction(), n.B() - n.A(), n.C() - n.A())) * (start - n.A());
}

vec3 by_matrix(const Names& n, const mat4& m) {
    const vec4 p = m * vec4(n.vec(P_VCS), 1.0F);
    return vec3(p) / p.w;
}

mat4 view(const Names& n) {
    return glm::lookAt(n.eye(), n.lookat(), n.vup());
}

mat4 axes(const Names& n, const vec3& translation) {
    return mat4(vec4(n.vec(X), 0), vec4(n.vec(Y), 0), vec4(n.vec(Z), 0), vec4(translation, 1));
}

void add(std::vector<NamedMistake>& all, const std::vector<NamedMistake>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

std::vector<NamedMistake> of_pixel() {
    return {
        changed("positive z", P_VCS, [](Floats& p) { p[2] = -p[2]; }),
        on("integer division", P_VCS,
           [](const Names& n) {
               const int W = n.window().width, H = n.window().height;
               const auto x = static_cast<float>(n.program.scene().pixel.x / W),
                          y = static_cast<float>(n.program.scene().pixel.y / H);
               return in_window(n, x, y);
           }),
        on("corner of the pixel", P_VCS, [](const Names& n) { return in_window(n, n.x() / n.W(), n.y() / n.H()); }),
        on("y counted from the top", P_VCS,
           [](const Names& n) { return in_window(n, (n.x() + 0.5F) / n.W(), (n.H() - 1 - n.y() + 0.5F) / n.H()); }),
        on("window not applied", P_VCS,
           [](const Names& n) {
               return vec3(2 * (n.x() + 0.5F) / n.W() - 1, 2 * (n.y() + 0.5F) / n.H() - 1, -n.window().clip_near);
           }),
        on("window not applied", P_VCS,
           [](const Names& n) { return vec3((n.x() + 0.5F) / n.W(), (n.y() + 0.5F) / n.H(), -n.window().clip_near); }),
        on("window not shifted", P_VCS,
           [](const Names& n) {
               const auto& w = n.window();
               return vec3((w.clip_right - w.clip_left) * (n.x() + 0.5F) / n.W(),
                           (w.clip_top - w.clip_bottom) * (n.y() + 0.5F) / n.H(), -w.clip_near);
           }),
        on("one pixel too far", P_VCS,
           [](const Names& n) { return in_window(n, (n.x() + 1) / n.W(), (n.y() + 1) / n.H()); }),
        on("width and height mixed up", P_VCS,
           [](const Names& n) { return in_window(n, (n.x() + 0.5F) / n.H(), (n.y() + 0.5F) / n.W()); }),
        changed("near plane at 1", P_VCS, [](Floats& p) { p[2] = -1; }),
        changed("z forgotten", P_VCS, [](Floats& p) { p[2] = 0; }),
    };
}

std::vector<NamedMistake> of_camera() {
    return {
        on("Z points at lookat", Z, [](const Names& n) { return normalize(n.lookat() - n.eye()); }),
        on("not normalized", Z, [](const Names& n) { return n.eye() - n.lookat(); }),
        on("lookat forgotten", Z, [](const Names& n) { return normalize(n.eye()); }),
        on("opposite direction", X, [](const Names& n) { return normalize(cross(n.vec(Z), n.vup())); }),
        on("not normalized", X, [](const Names& n) { return cross(n.vup(), n.vec(Z)); }),
        on("opposite direction", Y, [](const Names& n) { return cross(n.vec(X), n.vec(Z)); }),
        on("vup taken as Y", Y, [](const Names& n) { return n.vup(); }),
        on("vup taken as Y", Y, [](const Names& n) { return normalize(n.vup()); }),
        on("coordinates of different axes", X, [](const Names& n) { return vec3(view(n)[0]); }),
        on("coordinates of different axes", Y, [](const Names& n) { return vec3(view(n)[1]); }),
        on("coordinates of different axes", Z, [](const Names& n) { return vec3(view(n)[2]); }),
        on("translation missing", M, [](const Names& n) { return axes(n, vec3(0)); }),
        on("matrix transposed", M, [](const Names& n) { return glm::transpose(axes(n, n.eye())); }),
        on("view matrix, not its inverse", M, [](const Names& n) { return view(n); }),
        on("translation negated", M, [](const Names& n) { return axes(n, -n.eye()); }),
        on("axes in rows", M,
           [](const Names& n) {
               mat4 m = glm::transpose(axes(n, vec3(0)));
               m[3] = vec4(n.eye(), 1);
               return m;
           }),
        on("translation missing", P_WCS,
           [](const Names& n) { return vec3(n.program.matrix4(M) * vec4(n.vec(P_VCS), 0)); }),
        on("view matrix, not its inverse", P_WCS, [](const Names& n) { return by_matrix(n, view(n)); }),
        on("matrix transposed", P_WCS,
           [](const Names& n) { return by_matrix(n, glm::transpose(n.program.matrix4(M))); }),
        on("not normalized", V, [](const Names& n) { return n.S() - n.eye(); }),
        on("normalized with w", V, [](const Names& n) { return vec3(normalize(vec4(n.S(), 1) - vec4(n.eye(), 0))); }),
        on("points to the eye", V, [](const Names& n) { return normalize(n.eye() - n.S()); }),
        on("eye forgotten", V, [](const Names& n) { return normalize(n.S()); }),
        on("in view coordinates", V, [](const Names& n) { return normalize(n.vec(P_VCS)); }),
        on("points at lookat", V, [](const Names& n) { return normalize(n.lookat() - n.eye()); }),
    };
}

std::vector<NamedMistake> of_coefficients() {
    const auto plain_c = [](const Names& n, const vec3& start) { return dot(start - n.center(), start - n.center()); };
    return {
        on("ray starts at the eye", b, [](const Names& n) { return 2 * dot(n.direction(), n.eye() - n.center()); }),
        on("factor 2 missing", b, [](const Names& n) { return dot(n.direction(), n.S() - n.center()); }),
        on("sign of b", b, [](const Names& n) { return 2 * dot(n.direction(), n.center() - n.S()); }),
        on("center forgotten", b, [](const Names& n) { return 2 * dot(n.direction(), n.S()); }),
        on("radius not squared", c, [=](const Names& n) { return plain_c(n, n.S()) - n.radius(); }),
        on("ray starts at the eye", c, [=](const Names& n) { return plain_c(n, n.eye()) - n.radius() * n.radius(); }),
        on("radius forgotten", c, [=](const Names& n) { return plain_c(n, n.S()); }),
        on("sign of the radius", c, [=](const Names& n) { return plain_c(n, n.S()) + n.radius() * n.radius(); }),
        on("center forgotten", c, [](const Names& n) { return dot(n.S(), n.S()) - n.radius() * n.radius(); }),
        on("factor 4 missing", d, [](const Names& n) { return n.at(b) * n.at(b) - n.at(a) * n.at(c); }),
        on("sign in the discriminant", d, [](const Names& n) { return n.at(b) * n.at(b) + 4 * n.at(a) * n.at(c); }),
        on("discriminant negated", d, [](const Names& n) { return 4 * n.at(a) * n.at(c) - n.at(b) * n.at(b); }),
        on("factor 2 for 4", d, [](const Names& n) { return n.at(b) * n.at(b) - 2 * n.at(a) * n.at(c); }),
        on("root of the discriminant", d,
           [](const Names& n) { return std::sqrt(n.at(b) * n.at(b) - 4 * n.at(a) * n.at(c)); }),
        on("b not squared", d, [](const Names& n) { return n.at(b) - 4 * n.at(a) * n.at(c); }),
    };
}

std::vector<NamedMistake> of_root() {
    return {
        on("far root", t_s, [](const Names& n) { return (-n.at(b) + std::sqrt(n.at(d))) / (2 * n.at(a)); }),
        on("operator precedence", t_s, [](const Names& n) { return -n.at(b) - std::sqrt(n.at(d)) / 2 * n.at(a); }),
        on("not divided by 2", t_s, [](const Names& n) { return (-n.at(b) - std::sqrt(n.at(d))) / n.at(a); }),
        on("square root forgotten", t_s, [](const Names& n) { return (-n.at(b) - n.at(d)) / (2 * n.at(a)); }),
        on("sign of b in the root", t_s, [](const Names& n) { return (n.at(b) - std::sqrt(n.at(d))) / (2 * n.at(a)); }),
        on("root behind the start", t_s,
           [](const Names& n) { return (-n.at(b) - std::sqrt(n.at(d))) / (2 * n.at(a)); }),
        on("closest approach", t_s, [](const Names& n) { return -n.at(b) / (2 * n.at(a)); }),
    };
}

std::vector<NamedMistake> of_sphere_point() {
    return {
        on("ray starts at the eye", hit_s, [](const Names& n) { return n.eye() + n.at(t_s) * n.direction(); }),
        on("start forgotten", hit_s, [](const Names& n) { return n.at(t_s) * n.direction(); }),
        on("sign of t", hit_s, [](const Names& n) { return n.S() - n.at(t_s) * n.direction(); }),
        changed("points inward", normal_s, negate),
        on("not normalized", normal_s, [](const Names& n) { return n.vec(hit_s) - n.center(); }),
        on("center forgotten", normal_s, [](const Names& n) { return normalize(n.vec(hit_s)); }),
        on("sign of the center", normal_s, [](const Names& n) { return normalize(n.vec(hit_s) + n.center()); }),
    };
}

std::vector<NamedMistake> of_system() {
    return {
        on("V not negated", matrix, [](const Names& n) { return mat3(n.direction(), n.B() - n.A(), n.C() - n.A()); }),
        on("edges the wrong way round", matrix,
           [](const Names& n) { return mat3(-n.direction(), n.A() - n.B(), n.A() - n.C()); }),
        on("vertices for edges", matrix, [](const Names& n) { return mat3(-n.direction(), n.B(), n.C()); }),
        on("matrix transposed", matrix,
           [](const Names& n) { return glm::transpose(mat3(-n.direction(), n.B() - n.A(), n.C() - n.A())); }),
        on("right-hand side negated", rhs, [](const Names& n) { return n.A() - n.S(); }),
        on("ray starts at the eye", rhs, [](const Names& n) { return n.eye() - n.A(); }),
        on("A forgotten", rhs, [](const Names& n) { return n.S(); }),
    };
}

std::vector<NamedMistake> of_solution() {
    const auto determinant = [](const Names& n) {
        return glm::determinant(mat3(-n.direction(), n.B() - n.A(), n.C() - n.A()));
    };
    const auto undivided = [=](int i) { return [=](const Names& n) { return solved(n, n.S())[i] * determinant(n); }; };
    const auto unknown = [](int i) { return [=](const Names& n) { return solved(n, n.S())[i]; }; };
    const auto weight_of_a = [](const Names& n) { return 1 - solved(n, n.S())[1] - solved(n, n.S())[2]; };
    return {
        on("ray starts at the eye", t_t, [](const Names& n) { return solved(n, n.eye())[0]; }),
        changed("sign of t", t_t, negate),
        on("wrong unknown", t_t, unknown(1)),
        on("wrong unknown", t_t, unknown(2)),
        on("not divided by the determinant", t_t, undivided(0)),
        on("u and v swapped", u, unknown(2)),
        on("wrong unknown", u, unknown(0)),
        on("weight of A", u, weight_of_a),
        changed("sign of u", u, negate),
        on("not divided by the determinant", u, undivided(1)),
        on("u and v swapped", v, unknown(1)),
        on("wrong unknown", v, unknown(0)),
        on("weight of A", v, weight_of_a),
        changed("sign of v", v, negate),
        on("not divided by the determinant", v, undivided(2)),
    };
}

std::vector<NamedMistake> of_triangle_point() {
    return {
        on("ray starts at the eye", hit_t, [](const Names& n) { return n.eye() + n.at(t_t) * n.direction(); }),
        on("start forgotten", hit_t, [](const Names& n) { return n.at(t_t) * n.direction(); }),
        on("sign of t", hit_t, [](const Names& n) { return n.S() - n.at(t_t) * n.direction(); }),
        on("A forgotten", hit_t, [](const Names& n) { return n.at(u) * (n.B() - n.A()) + n.at(v) * (n.C() - n.A()); }),
        on("opposite direction", normal_t,
           [](const Names& n) { return normalize(cross(n.C() - n.A(), n.B() - n.A())); }),
        on("not normalized", normal_t, [](const Names& n) { return cross(n.B() - n.A(), n.C() - n.A()); }),
        on("opposite direction, not normalized", normal_t,
           [](const Names& n) { return cross(n.C() - n.A(), n.B() - n.A()); }),
        on("vertices for edges", normal_t, [](const Names& n) { return normalize(cross(n.B(), n.C())); }),
    };
}

}  // namespace

const std::vector<NamedMistake>& named_mistakes() {
    static const std::vector<NamedMistake> table = [] {
        std::vector<NamedMistake> all;
        for (const auto& part : {of_pixel(), of_camera(), of_coefficients(), of_root(), of_sphere_point(), of_system(),
                                 of_solution(), of_triangle_point(), of_cylinder()}) {
            add(all, part);
        }
        return all;
    }();
    return table;
}

}  // namespace student
