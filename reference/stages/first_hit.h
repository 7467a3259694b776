// Which object the ray hits first.
#pragma once

#include <optional>

#include "reference/numbers/vector.h"
#include "reference/stages/items.h"

namespace reference {

enum class Verdict { triangle_first, sphere_first, tie, no_hit, cylinder_first };

/// The verdict that an object of this kind is first.
inline Verdict first(Subject object) {
    if (object == Subject::triangle) return Verdict::triangle_first;
    return object == Subject::sphere ? Verdict::sphere_first : Verdict::cylinder_first;
}

/// The kind of object that is first; empty for a tie and where nothing is hit.
inline std::optional<Subject> object_of(Verdict verdict) {
    for (const Subject object : objects) {
        if (first(object) == verdict) return object;
    }
    return std::nullopt;
}

/// Question 10 from two values of t, as a program compares them: the object with the smaller t; an empty t is an object
/// that the ray does not hit.
/// Empty where the order could not be told (see sign_of).
template <class S>
std::optional<Verdict> first_hit(const std::optional<S>& t_sphere, const std::optional<S>& t_triangle) {
    if (!t_sphere && !t_triangle) return Verdict::no_hit;
    if (!t_sphere) return Verdict::triangle_first;
    if (!t_triangle) return Verdict::sphere_first;
    const auto order = sign_of(S(*t_sphere - *t_triangle));
    if (order < 0) return Verdict::sphere_first;
    if (order > 0) return Verdict::triangle_first;
    if (order == 0) return Verdict::tie;
    return std::nullopt;
}

}  // namespace reference
