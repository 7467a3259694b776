// The answers by the items' names, over any scalar.
#pragma once

#include <map>
#include <string_view>
#include <utility>
#include <variant>

#include "reference/stages/items.h"
#include "reference/stages/scene_answers.h"

namespace reference {

/// There is no such value: the ray misses, or the linear system has no solution.
struct NoValue {
    friend bool operator==(NoValue, NoValue) = default;
};

/// The components of a scalar, a vector or a matrix, a matrix column by column (GLM's order); or the verdict.
template <class S>
using ItemValue = std::variant<NoValue, std::vector<S>, Verdict>;

template <class S>
using ItemValues = std::map<ItemId, ItemValue<S>>;

template <class S>
std::vector<S> components(const S& x) {
    return {x};
}
template <class S>
std::vector<S> components(const Vec3<S>& p) {
    return {p.x, p.y, p.z};
}
template <int N, class S>
std::vector<S> components(const glm::mat<N, N, S>& M) {
    std::vector<S> result;
    for (int column = 0; column < N; ++column) {
        for (int row = 0; row < N; ++row) result.push_back(M[column][row]);
    }
    return result;
}

template <class S, class T>
ItemValue<S> present(const std::optional<T>& value) {
    if (!value) return NoValue{};
    return components(*value);
}

/// Every item that the scene calls for. With the boundary at t > 0, a triangle met at t = 0 has t, u and v but no hit
/// point.
template <class S>
ItemValues<S> values_of(const SceneAnswers<S>& answers, Boundary boundary) {
    const CameraAnswers<S>& camera = answers.camera;
    ItemValues<S> values{{item::P_VCS, components(camera.P_VCS)},
                         {item::X_vcs, components(camera.basis.X_vcs)},
                         {item::Y_vcs, components(camera.basis.Y_vcs)},
                         {item::Z_vcs, components(camera.basis.Z_vcs)},
                         {item::M_VCS_to_WCS, components(camera.M_VCS_to_WCS)},
                         {item::P_WCS, components(camera.P_WCS)},
                         {item::V, components(camera.V)}};
    if (answers.sphere) {
        const Quadratic<S>& quadratic = answers.sphere->quadratic;
        values[item::sphere::a] = components(quadratic.a);
        values[item::sphere::b] = components(quadratic.b);
        values[item::sphere::c] = components(quadratic.c);
        values[item::sphere::d] = components(quadratic.d);
        values[item::sphere::t] = present<S>(answers.sphere->t);
        values[item::sphere::hit] = present<S>(answers.sphere->hit);
        values[item::sphere::normal] = present<S>(answers.sphere->normal);
    }
    if (answers.triangle) {
        const TriangleAnswers<S>& triangle = *answers.triangle;
        const bool no_hit_at_start =
            triangle.classification == TriangleHit::boundary && !hit_distance(triangle, boundary);
        values[item::triangle::matrix] = components(triangle.system.matrix);
        values[item::triangle::rhs] = components(triangle.system.rhs);
        values[item::triangle::t] = present<S>(triangle.t);
        values[item::triangle::u] = present<S>(triangle.u);
        values[item::triangle::v] = present<S>(triangle.v);
        values[item::triangle::hit] = no_hit_at_start ? ItemValue<S>() : present<S>(triangle.hit);
        values[item::triangle::normal] = components(triangle.normal);
    }
    if (answers.cylinder) {
        const CylinderAnswers<S>& cylinder = *answers.cylinder;
        const Quadratic<S>& tube = cylinder.equations.tube;
        values[item::cylinder::a] = components(tube.a);
        values[item::cylinder::b] = components(tube.b);
        values[item::cylinder::c] = components(tube.c);
        values[item::cylinder::d] = components(tube.d);
        values[item::cylinder::t] = present<S>(cylinder.t);
        values[item::cylinder::hit] = present<S>(cylinder.hit);
        values[item::cylinder::normal] = present<S>(cylinder.normal);
    }
    // With one kind of object nothing is to be compared.
    const int kinds = (answers.sphere ? 1 : 0) + (answers.triangle ? 1 : 0) + (answers.cylinder ? 1 : 0);
    if (kinds > 1 && answers.verdict) values[item::verdict] = *answers.verdict;
    return values;
}

}  // namespace reference
