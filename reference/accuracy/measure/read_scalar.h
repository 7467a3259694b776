// The numbers of an assignment in a scalar, for programs that compute in it.
#pragma once

#include <cmath>
#include <cstdlib>

#include "reference/assignment.h"
#include "reference/exact/rational.h"
#include "reference/interval.h"

namespace reference::accuracy {

template <class S>
struct ReadScalar {
    S operator()(const Decimal& number) const { return scalar_from<S>(number); }
};
template <>
struct ReadScalar<long double> {
    long double operator()(const Decimal& number) const { return std::strtold(number.text().c_str(), nullptr); }
};
/// The number that was read and what it may differ from the one that was written.
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
