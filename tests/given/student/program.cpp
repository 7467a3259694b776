#include "tests/given/student/program.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "reference/stages/scene_answers.h"
#include "tests/given/student/items.h"

namespace student {
namespace {

using reference::Boundary;
using reference::FirstObject;
using Arithmetic = Way::Arithmetic;

namespace tube = reference::item::cylinder;

float read(const reference::Decimal& x) {
    return x.to_float();
}

}  // namespace

Floats floats(float x) {
    return {x};
}
Floats floats(const glm::vec3& p) {
    return {p.x, p.y, p.z};
}
Floats floats(const glm::mat3& m) {
    return reference::components(m);
}
Floats floats(const glm::mat4& m) {
    return reference::components(m);
}

Program::Program(const reference::Assignment& assignment, const Way& way, std::optional<Mistake> mistake)
    : scene_(reference::convert_scene<float>(assignment.scene, read)),
      questions_(assignment.questions),
      way_(way),
      mistake_(std::move(mistake)) {
    answer_camera();
    if (!scene_.spheres.empty()) answer_sphere();
    if (!scene_.triangles.empty()) answer_triangle();
    if (!scene_.cylinders.empty()) answer_cylinder();
    compare_hits();
    for (const reference::ItemSpec& spec : reference::asked_items(questions_)) {
        if (spec.shape == reference::Shape::first_object || values_.contains(spec.id)) asked_.push_back(spec);
    }
}

/// "Of all hits the one with the smallest t."
void Program::compare_hits() {
    std::optional<float> smallest;
    const auto compare = [&](const ItemId& t, bool hit, FirstObject is_first) {
        if (!hit || (smallest && scalar(t) > *smallest)) return;
        first_object_ = smallest && scalar(t) == *smallest ? FirstObject::tie : is_first;
        smallest = scalar(t);
    };
    compare(t_s, has(t_s) && is_hit_at(scalar(t_s)), FirstObject(reference::Subject::sphere));
    compare(t_t, has(t_t) && in_triangle() && is_hit_at(scalar(t_t)), FirstObject(reference::Subject::triangle));
    compare(tube::t, has(tube::t) && is_hit_at(scalar(tube::t)), FirstObject(reference::Subject::cylinder));
}

void Program::settle(const ItemId& id, std::optional<Floats> value) {
    values_[id] = mistake_ && mistake_->item == id ? mistake_->compute(*this, value) : std::move(value);
}

glm::vec3 Program::vector(const ItemId& id) const {
    const Floats& p = values_.at(id).value();
    return {p[0], p[1], p[2]};
}

glm::mat4 Program::matrix4(const ItemId& id) const {
    const Floats& p = values_.at(id).value();
    glm::mat4 m(0.0F);
    for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = p[static_cast<std::size_t>(i)];
    return m;
}

void Program::answer_camera() {
    const auto& [eye, lookat, vup] = scene_.camera;
    settle(P_VCS, floats(reference::pixel_to_vcs(scene_.window, scene_.pixel, way_.convention)));
    if (uses_glm()) {
        settle(Z, floats(glm::normalize(eye - lookat)));
        settle(X, floats(glm::normalize(glm::cross(vup, vector(Z)))));
        settle(Y, floats(glm::cross(vector(Z), vector(X))));
    } else {
        settle(Z, floats(reference::normalized(glm::vec3(eye - lookat))));
        settle(X, floats(reference::normalized(reference::cross(vup, vector(Z)))));
        settle(Y, floats(reference::cross(vector(Z), vector(X))));
    }
    // A program with wrong axes uses them for the matrix; lookAt would hide the mistake.
    const bool own_axes = mistake_ && (mistake_->item == X || mistake_->item == Y || mistake_->item == Z);
    if (uses_glm() && !own_axes) {
        settle(M, floats(glm::inverse(glm::lookAt(eye, lookat, vup))));
        settle(P_WCS, floats(glm::vec3(matrix4(M) * glm::vec4(vector(P_VCS), 1.0F))));
    } else {
        settle(M, floats(reference::vcs_to_wcs(reference::Basis<float>{vector(X), vector(Y), vector(Z)}, eye)));
        settle(P_WCS, floats(reference::pixel_to_wcs(matrix4(M), vector(P_VCS))));
    }
    settle(V, floats(uses_glm() ? glm::normalize(vector(P_WCS) - eye) : reference::ray_direction(vector(P_WCS), eye)));
}

void Program::answer_sphere() {
    const reference::Sphere<float>& sphere = scene_.spheres.front();
    const reference::Quadratic<float> right = reference::sphere_quadratic(vector(P_WCS), vector(V), sphere);
    const float k = way_.quadratic_factor;
    settle(a, floats(k * right.a));
    settle(b, floats(k * (way_.half_b ? glm::dot(vector(V), vector(P_WCS) - sphere.center) : right.b)));
    settle(c, floats(k * right.c));
    const float p = scalar(a), q = scalar(b), r = scalar(c);
    settle(d, floats(way_.half_b ? q * q - p * r : q * q - 4 * p * r));
    const float disc = scalar(d);
    std::optional<Floats> t;
    if (disc >= 0) {
        const float divisor = way_.half_b ? p : 2 * p;
        const float one = (-q - std::sqrt(disc)) / divisor;
        const float other = (-q + std::sqrt(disc)) / divisor;
        const float near = std::min(one, other), far = std::max(one, other);
        if (is_hit_at(near))
            t = floats(near);
        else if (is_hit_at(far))
            t = floats(far);
    }
    settle(t_s, t);
    settle(hit_s, has(t_s) ? std::optional(floats(vector(P_WCS) + scalar(t_s) * vector(V))) : std::nullopt);
    std::optional<Floats> normal;
    if (has(hit_s)) {
        const glm::vec3 out = vector(hit_s) - sphere.center;
        normal = floats(uses_glm() ? glm::normalize(out) : reference::normalized(out));
    }
    settle(normal_s, normal);
}

void Program::answer_triangle() {
    const auto& [A, B, C] = scene_.triangles.front();
    Floats columns(9);
    const glm::vec3 right[] = {-vector(V), B - A, C - A};
    for (std::size_t i = 0; i < 9; ++i) {
        const auto place = static_cast<std::size_t>(way_.columns[i / 3]);
        columns[3 * place + i % 3] = way_.row_factors[i % 3] * right[i / 3][static_cast<int>(i % 3)];
    }
    settle(matrix, columns);
    settle(rhs, floats((vector(P_WCS) - A) * glm::vec3(way_.row_factors[0], way_.row_factors[1], way_.row_factors[2])));
    solve_triangle(vector(rhs));
    const bool hit = has(t_t) && in_triangle() && is_hit_at(scalar(t_t));
    const bool has_point = has(t_t) && (hit || !way_.true_hits_only);
    settle(hit_t, has_point ? std::optional(floats(vector(P_WCS) + scalar(t_t) * vector(V))) : std::nullopt);
    settle(normal_t, floats(uses_glm() ? glm::normalize(glm::cross(B - A, C - A))
                                       : reference::triangle_normal(scene_.triangles.front())));
}

void Program::solve_triangle(const glm::vec3& right) {
    const Floats& m = *values_.at(matrix);
    const auto column = [&](int unknown) {
        const auto first = 3 * static_cast<std::size_t>(way_.columns[static_cast<std::size_t>(unknown)]);
        return glm::vec3(m[first], m[first + 1], m[first + 2]);
    };
    const glm::mat3 system(column(0), column(1), column(2));
    glm::vec3 solved;
    if (way_.arithmetic == Arithmetic::glm) {
        solved = glm::inverse(system) * right;
    } else if (way_.arithmetic == Arithmetic::glm_cramer) {
        const float det = glm::determinant(system);
        solved = glm::vec3(glm::determinant(glm::mat3(right, system[1], system[2])),
                           glm::determinant(glm::mat3(system[0], right, system[2])),
                           glm::determinant(glm::mat3(system[0], system[1], right))) /
                 det;
    } else {
        const auto cramer = reference::solve_by_cramer(reference::LinearSystem<float>{system, right});
        solved = glm::vec3(cramer.t_numerator, cramer.u_numerator, cramer.v_numerator) / cramer.det;
    }
    settle(t_t, floats(solved[0]));
    settle(u, floats(solved[1]));
    settle(v, floats(solved[2]));
}

void Program::answer_cylinder() {
    const auto& [center, radius, height] = scene_.cylinders.front();
    const glm::vec3 start = vector(P_WCS), direction = vector(V);
    solve_tube({start.x - center.x, start.z - center.z}, {direction.x, direction.z});
    std::optional<float> smallest = tube_hit(), up;
    for (const float side : {1.0F, -1.0F}) {
        const std::optional<float> t = cap_hit(center.y + side * height / 2);
        if (!t || (smallest && *t >= *smallest)) continue;
        smallest = t;
        up = side;
    }
    const std::optional<Floats> right = smallest ? std::optional(floats(*smallest)) : std::nullopt;
    settle(tube::t, right);
    settle(tube::hit, has(tube::t) ? std::optional(floats(start + scalar(tube::t) * direction)) : std::nullopt);
    if (values_.at(tube::t) != right && has(tube::hit)) {
        // The t is another part's: the point's height tells whether it is on a cap.
        const float above = (vector(tube::hit).y - center.y) / (height / 2);
        up = std::abs(std::abs(above) - 1) < 1e-4F ? std::optional(above > 0 ? 1.0F : -1.0F) : std::nullopt;
    }
    settle(tube::normal, has(tube::hit) ? std::optional(floats(cylinder_normal(up))) : std::nullopt);
}

/// The tube's quadratic for a ray in the plane of x and z, from the axis.
void Program::solve_tube(const glm::vec2& start, const glm::vec2& direction) {
    const float radius = scene_.cylinders.front().radius;
    const float k = way_.quadratic_factor;
    const float half = start.x * direction.x + start.y * direction.y;
    settle(tube::a, floats(k * (direction.x * direction.x + direction.y * direction.y)));
    settle(tube::b, floats(k * (way_.half_b ? half : 2 * half)));
    settle(tube::c, floats(k * (start.x * start.x + start.y * start.y - radius * radius)));
    const float p = scalar(tube::a), q = scalar(tube::b), r = scalar(tube::c);
    settle(tube::d, floats(way_.half_b ? q * q - p * r : q * q - 4 * p * r));
}

/// The tube's smallest positive root, if its y is between the caps.
std::optional<float> Program::tube_hit() const {
    const auto& [center, radius, height] = scene_.cylinders.front();
    const float p = scalar(tube::a), q = scalar(tube::b), d = scalar(tube::d);
    if (p == 0 || !(d >= 0)) return std::nullopt;
    const float divisor = way_.half_b ? p : 2 * p;
    const float one = (-q - std::sqrt(d)) / divisor, other = (-q + std::sqrt(d)) / divisor;
    const float near = std::min(one, other), far = std::max(one, other);
    const float t = is_hit_at(near) ? near : far;
    const float y = vector(P_WCS).y + t * vector(V).y;
    const bool between = center.y - height / 2 <= y && y <= center.y + height / 2;
    return is_hit_at(t) && between ? std::optional(t) : std::nullopt;
}

/// Where the ray hits the cap at this height.
std::optional<float> Program::cap_hit(float y) const {
    const auto& [center, radius, height] = scene_.cylinders.front();
    if (vector(V).y == 0) return std::nullopt;
    const float t = (y - vector(P_WCS).y) / vector(V).y;
    const glm::vec3 from_center = vector(P_WCS) + t * vector(V) - center;
    const float square = from_center.x * from_center.x + from_center.z * from_center.z;
    return is_hit_at(t) && square < radius * radius ? std::optional(t) : std::nullopt;
}

/// `up` is 1 on the top cap, -1 on the bottom cap, and empty on the tube.
glm::vec3 Program::cylinder_normal(std::optional<float> up) const {
    if (up) return {0, *up, 0};
    const glm::vec3 from_center = vector(tube::hit) - scene_.cylinders.front().center;
    return glm::normalize(glm::vec3(from_center.x, 0, from_center.z));
}

bool Program::in_triangle() const {
    return scalar(u) >= 0 && scalar(v) >= 0 && scalar(u) + scalar(v) <= 1;
}

bool Program::is_hit_at(float t) const {
    return way_.boundary == Boundary::positive ? t > 0 : t >= 0;
}

}  // namespace student
