// The answers by the items' names, over any scalar.
#pragma once

#include <map>
#include <string_view>
#include <utility>
#include <variant>

#include "reference/scene_answers.h"

namespace reference {

/// There is no such value: the ray misses, or the linear system has no solution.
struct NoValue {
    friend bool operator==(NoValue, NoValue) = default;
};

/// The components of a scalar, a vector or a matrix, a matrix column by column (GLM's order); or the verdict.
template <class S>
using ItemValue = std::variant<NoValue, std::vector<S>, Verdict>;

/// Question and name, as in ItemSpec.
using ItemId = std::pair<int, std::string_view>;

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
    ItemValues<S> values{{{1, "P_VCS"}, components(camera.P_VCS)},
                         {{2, "X_vcs"}, components(camera.basis.X_vcs)},
                         {{2, "Y_vcs"}, components(camera.basis.Y_vcs)},
                         {{2, "Z_vcs"}, components(camera.basis.Z_vcs)},
                         {{3, "M_VCS_to_WCS"}, components(camera.M_VCS_to_WCS)},
                         {{4, "P_WCS"}, components(camera.P_WCS)},
                         {{5, "V"}, components(camera.V)}};
    if (answers.sphere) {
        const Quadratic<S>& quadratic = answers.sphere->quadratic;
        values[{6, "a"}] = components(quadratic.a);
        values[{6, "b"}] = components(quadratic.b);
        values[{6, "c"}] = components(quadratic.c);
        values[{6, "d"}] = components(quadratic.d);
        values[{6, "t"}] = present<S>(answers.sphere->t);
        values[{6, "hit"}] = present<S>(answers.sphere->hit);
        values[{7, "normal"}] = present<S>(answers.sphere->normal);
    }
    if (answers.triangle) {
        const TriangleAnswers<S>& triangle = *answers.triangle;
        const bool no_hit_at_start =
            triangle.classification == TriangleHit::boundary && !hit_distance(triangle, boundary);
        values[{8, "matrix"}] = components(triangle.system.matrix);
        values[{8, "rhs"}] = components(triangle.system.rhs);
        values[{8, "t"}] = present<S>(triangle.t);
        values[{8, "u"}] = present<S>(triangle.u);
        values[{8, "v"}] = present<S>(triangle.v);
        values[{8, "hit"}] = no_hit_at_start ? ItemValue<S>() : present<S>(triangle.hit);
        values[{9, "normal"}] = components(triangle.normal);
    }
    if (answers.sphere && answers.triangle && answers.verdict) values[{10, "verdict"}] = *answers.verdict;
    return values;
}

}  // namespace reference
