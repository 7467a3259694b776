#include "reference/numbers/affine.h"

#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace reference {
namespace {

/// An upper bound of the error of a sum of up to thousands of doubles, relative to the sum of their sizes: each term is
/// off by a few 2^-53, and summing n terms adds n 2^-53.
constexpr double own_error = 0x1p-40;

/// Sums in lanes, because the compiler may not reorder additions of doubles to vectorise them.
using Lanes = std::array<double, 8>;

double sum(const Lanes& lanes) {
    return std::accumulate(lanes.begin(), lanes.end(), 0.0);
}

struct Sizes {
    double results = 0;   ///< the sum of |r_i|
    double operands = 0;  ///< the sum of |p x_i| + |q y_i|
};

/// r = p x + q y for n numbers.
Sizes combine(double* r, double p, const double* x, double q, const double* y, std::size_t n) {
    Lanes results{};
    Lanes operands{};
    const auto add = [&](std::size_t i, std::size_t lane) {
        const double one = p * x[i];
        const double other = q * y[i];
        r[i] = one + other;
        results[lane] += std::abs(r[i]);
        operands[lane] += std::abs(one) + std::abs(other);
    };
    std::size_t i = 0;
    for (; i + results.size() <= n; i += results.size()) {
        for (std::size_t lane = 0; lane < results.size(); ++lane) add(i + lane, lane);
    }
    for (; i < n; ++i) add(i, i % results.size());
    return {sum(results), sum(operands)};
}

/// r = p x for n numbers. Returns the sum of their sizes.
double scale(double* r, double p, const double* x, std::size_t n) {
    Lanes results{};
    const auto add = [&](std::size_t i, std::size_t lane) {
        r[i] = p * x[i];
        results[lane] += std::abs(r[i]);
    };
    std::size_t i = 0;
    for (; i + results.size() <= n; i += results.size()) {
        for (std::size_t lane = 0; lane < results.size(); ++lane) add(i + lane, lane);
    }
    for (; i < n; ++i) add(i, i % results.size());
    return sum(results);
}

}  // namespace

template <std::floating_point T>
Affine<T>::Affine(const Interval<double>& range, Roundings& roundings) : roundings_(&roundings) {
    if (!range.is_bounded()) {
        *this = unbounded();
        return;
    }
    center_ = range.lo() / 2 + range.hi() / 2;
    if (range.lo() == range.hi()) return;
    const double size = std::max(center_ - range.lo(), range.hi() - center_) * (1 + own_error);
    deviate(size + std::numeric_limits<double>::denorm_min());
}

template <std::floating_point T>
void Affine<T>::deviate(double size) {
    if (roundings_ == nullptr) {
        slack_ += size;
        return;
    }
    deviations_.resize(roundings_->next() + 1);
    deviations_.back() = size;
    sizes_ += size;
}

template <std::floating_point T>
double Affine<T>::radius() const {
    return (sizes_ + slack_) * (1 + own_error);
}

template <std::floating_point T>
Interval<double> Affine<T>::range() const {
    const double r = radius();
    if (!std::isfinite(r) || !std::isfinite(center_)) return Interval<double>::whole();
    if (r == 0) return Interval<double>(center_);
    return Interval<double>::widened(center_ - r, center_ + r);
}

template <std::floating_point T>
Affine<T> Affine<T>::unbounded() {
    Affine result;
    result.slack_ = std::numeric_limits<double>::infinity();
    return result;
}

template <std::floating_point T>
Affine<T> Affine<T>::operator-() const {
    Affine result = *this;
    result.center_ = 0.0 - center_;
    for (double& deviation : result.deviations_) deviation = -deviation;
    return result;
}

template <std::floating_point T>
Affine<T> Affine<T>::combination(double p, const Affine& x, double q, const Affine& y) {
    Affine result;
    result.roundings_ = x.roundings_ != nullptr ? x.roundings_ : y.roundings_;
    result.center_ = p * x.center_ + q * y.center_;
    result.slack_ = std::abs(p) * x.slack_ + std::abs(q) * y.slack_;
    const Deviations& longer = x.deviations_.size() < y.deviations_.size() ? y.deviations_ : x.deviations_;
    const std::size_t common = std::min(x.deviations_.size(), y.deviations_.size());
    const double factor = &longer == &x.deviations_ ? p : q;
    // Reserves room for the rounding that follows.
    if (result.roundings_ != nullptr) result.deviations_.reserve(result.roundings_->count() + 1);
    result.deviations_.resize(longer.size(), boost::container::default_init);
    const Sizes sizes = combine(result.deviations_.data(), p, x.deviations_.data(), q, y.deviations_.data(), common);
    result.sizes_ = sizes.results +
                    scale(result.deviations_.data() + common, factor, longer.data() + common, longer.size() - common);
    // Terms that cancel here leave the roundings of the two products.
    result.slack_ += 0x1p-51 * (1 + own_error) * sizes.operands;
    result.slack_ += 0x1p-51 * (std::abs(p * x.center_) + std::abs(q * y.center_));
    return result;
}

template <std::floating_point T>
void Affine<T>::add_own_errors() {
    slack_ += own_error * radius() + std::numeric_limits<double>::denorm_min();
}

template <std::floating_point T>
Affine<T> Affine<T>::rounded() && {
    constexpr double half_unit = static_cast<double>(std::numeric_limits<T>::epsilon()) / 2;
    add_own_errors();
    const double most = std::abs(center_) + radius();
    if (!(most < static_cast<double>(std::numeric_limits<T>::max()))) return unbounded();
    const double size = half_unit * (1 + own_error) * most + static_cast<double>(std::numeric_limits<T>::denorm_min());
    deviate(size);
    return std::move(*this);
}

template <std::floating_point T>
Affine<T> Affine<T>::plus(const Affine& y) const {
    if (is_exactly(0)) return y;
    if (y.is_exactly(0)) return *this;
    return combination(1, *this, 1, y).rounded();
}

template <std::floating_point T>
Affine<T> Affine<T>::minus(const Affine& y) const {
    if (is_exactly(0)) return -y;
    if (y.is_exactly(0)) return *this;
    return combination(1, *this, -1, y).rounded();
}

template <std::floating_point T>
Affine<T> Affine<T>::exact_product(const Affine& y) const {
    Affine result = combination(y.center_, *this, center_, y);
    // combination() counts the product of the centers twice.
    result.center_ = center_ * y.center_;
    result.slack_ += radius() * y.radius();
    result.add_own_errors();
    return result;
}

template <std::floating_point T>
Affine<T> Affine<T>::times(const Affine& y) const {
    if (is_exactly(0) || y.is_exactly(1)) return *this;
    if (y.is_exactly(0) || is_exactly(1)) return y;
    if (is_exactly(-1)) return -y;
    if (y.is_exactly(-1)) return -*this;
    if (!std::isfinite(radius()) || !std::isfinite(y.radius())) return unbounded();
    return exact_product(y).rounded();
}

template <std::floating_point T>
Affine<T> Affine<T>::over(const Affine& y) const {
    const double r = y.radius();
    const double c = y.center_;
    const double least = std::abs(c) - r;
    if (!(least > 0) || !std::isfinite(radius())) return unbounded();
    if (is_exactly(0) || y.is_exactly(1)) return *this;
    // 1/(c + x) = 1/c - x/c² + x²/(c² (c + x)).
    Affine reciprocal = combination(-1 / (c * c), y, 0, Affine());
    reciprocal.center_ = 1 / c;
    reciprocal.slack_ += r * r / (c * c * least) * (1 + own_error) + 0x1p-50 * (1 / std::abs(c) + r / (c * c));
    return exact_product(reciprocal).rounded();
}

template <std::floating_point T>
Affine<T> Affine<T>::root() const {
    const double r = radius();
    if (!(center_ + r >= 0) || !std::isfinite(r)) return unbounded();
    if (is_exactly(0)) return *this;
    if (center_ - r > 0) {
        // √(c + x) = √c + x/(2√c) - x²/(2√c (√c + √(c+x))²), and the last term is at most x²/(2 c √c).
        const double root = std::sqrt(center_);
        Affine result = combination(1 / (2 * root), *this, 0, Affine());
        result.center_ = root;
        result.slack_ += r * r / (2 * center_ * root) * (1 + own_error) + 0x1p-50 * (root + r / root);
        return std::move(result).rounded();
    }
    const double half = std::sqrt(center_ + r) / 2 * (1 + own_error);
    Affine result;
    result.roundings_ = roundings_;
    result.center_ = half;
    result.slack_ = half;
    return std::move(result).rounded();
}

template class Affine<float>;
template class Affine<double>;

}  // namespace reference
