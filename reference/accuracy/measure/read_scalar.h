// Reads the numbers of an assignment like a program that computes in a given scalar type.
#pragma once

#include <cmath>

#include "reference/numbers/interval.h"
#include "reference/numbers/rational.h"
#include "reference/toml/assignment.h"

namespace reference::accuracy {

template <class S>
struct ReadScalar {
    S operator()(const Decimal& number) const { return scalar_from<S>(number); }
};
/// The number that was read, widened by one step unless it is exactly the number that was written.
template <class T>
struct ReadScalar<Interval<T>> {
    Interval<T> operator()(const Decimal& number) const {
        const T x = scalar_from<T>(number);
        if (!std::isfinite(x)) return Interval<T>::whole();
        const std::optional<Rational> written = to_rational(number);
        return written && *written == Rational(x) ? Interval<T>(x) : Interval<T>::widened(x, x);
    }
};

template <class S>
Scene<S> scene_in(const Assignment& assignment) {
    return convert_scene<S>(assignment.scene, ReadScalar<S>());
}

}  // namespace reference::accuracy
