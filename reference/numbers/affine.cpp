#include "reference/numbers/affine.h"

#include <algorithm>
#include <array>
#include <boost/container/static_vector.hpp>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace reference {
namespace {

/// An upper bound of the error of a sum of up to thousands of doubles, relative to the sum of their sizes: each term is
/// off by a few 2^-53, and summing n terms adds n 2^-53.
constexpr double own_error = 0x1p-40;

constexpr double smallest_normal = std::numeric_limits<float>::min();
constexpr double largest = std::numeric_limits<float>::max();

/// The relative error of one rounding to float, at most.
constexpr double unit_roundoff = 0x1p-24;

/// Half a unit in the last place of floats of this size, with room for an earlier rounding to double. Numbers below the
/// normal floats may become zero.
double half_unit(double size) {
    if (size < smallest_normal) return smallest_normal;
    return std::ldexp(1 + 0x1p-28, std::ilogb(size) - std::numeric_limits<float>::digits);
}

bool is_float(double x) {
    return static_cast<double>(static_cast<float>(x)) == x && (x == 0 || std::abs(x) >= smallest_normal);
}

/// Sums in lanes, because the compiler may not reorder additions of doubles to vectorise them.
using Lanes = std::array<double, 4>;

double lanes_total(const Lanes& lanes) {
    return std::accumulate(lanes.begin(), lanes.end(), 0.0);
}

struct Sums {
    Lanes sizes{};    ///< of |r_i|
    Lanes squares{};  ///< of r_i squared
};

/// r_i = compute(i) for n numbers.
void fill(Sums& sums, double* r, std::size_t n, auto compute) {
    const auto add = [&](std::size_t i, std::size_t lane) {
        r[i] = compute(i);
        sums.sizes[lane] += std::abs(r[i]);
        sums.squares[lane] += r[i] * r[i];
    };
    std::size_t i = 0;
    for (; i + Lanes().size() <= n; i += Lanes().size()) {
        for (std::size_t lane = 0; lane < Lanes().size(); ++lane) add(i + lane, lane);
    }
    for (; i < n; ++i) add(i, i % Lanes().size());
}

}  // namespace

void Affine::Deviations::add(std::size_t error, double size) {
    if (sizes.size() <= error) sizes.resize(error + 1);
    const double before = sizes[error];
    sizes[error] += size;
    sum += std::abs(sizes[error]) - std::abs(before);
    squares += sizes[error] * sizes[error] - before * before;
}

void Affine::Deviations::scale(double factor) {
    for (double& size : sizes) size *= factor;
    sum *= std::abs(factor);
    squares *= factor * factor;
}

Affine::Affine(const Interval<double>& range, Roundings& roundings) : roundings_(&roundings) {
    if (!range.is_bounded()) {
        *this = unbounded();
        return;
    }
    center_ = range.lo() / 2 + range.hi() / 2;
    if (range.lo() == range.hi()) return;
    const double size = std::max(center_ - range.lo(), range.hi() - center_) * (1 + own_error);
    add_known(size + std::numeric_limits<double>::denorm_min());
}

void Affine::add_random(double size) {
    if (roundings_ == nullptr) {
        slack_ += size;
    } else {
        assert(random_.sizes.size() <= roundings_->random);  // a new error's number must not occur in its terms yet
        random_.add(roundings_->random++, size);
    }
}

void Affine::add_known(double size) {
    if (roundings_ == nullptr) {
        slack_ += size;
    } else {
        assert(known_.sizes.size() <= roundings_->known);
        known_.add(roundings_->known++, size);
    }
}

bool Affine::is_power_of_two() const {
    int exponent = 0;
    return is_exact() && std::abs(std::frexp(center_, &exponent)) == 0.5;
}

double Affine::radius() const {
    double summary = 0;
    for (const double size : summary_) summary += size * size;
    const double random =
        std::min(random_.sum + certainty * std::sqrt(summary), certainty * std::sqrt(random_.squares + summary));
    return (random + known_.sum + slack_) * (1 + own_error);
}

double Affine::largest_size() const {
    return (std::abs(center_) + radius()) * (1 + own_error);
}

Interval<double> Affine::range() const {
    const double r = radius();
    if (!std::isfinite(r) || !std::isfinite(center_)) return Interval<double>::whole();
    if (r == 0) return Interval<double>(center_);
    return Interval<double>::widened(center_ - r, center_ + r);
}

Affine Affine::unbounded() {
    Affine result;
    result.slack_ = std::numeric_limits<double>::infinity();
    return result;
}

Affine Affine::operator-() const {
    return scaled_by(-1);
}

Affine Affine::scaled_by(double power_of_two) const {
    const double most = largest_size() * std::abs(power_of_two);
    if (!(most < largest)) return unbounded();
    Affine result = *this;
    result.center_ = center_ * power_of_two + 0.0;
    result.slack_ *= std::abs(power_of_two);
    result.random_.scale(power_of_two);
    result.known_.scale(power_of_two);
    for (double& size : result.summary_) size *= power_of_two;
    if (most > 0 && most < smallest_normal) result.slack_ += smallest_normal;
    return result;
}

void Affine::combine(Deviations& r, double p, const Deviations& x, double q, const Deviations& y) {
    const bool x_is_longer = x.sizes.size() >= y.sizes.size();
    const std::size_t common = std::min(x.sizes.size(), y.sizes.size());
    const std::size_t all = std::max(x.sizes.size(), y.sizes.size());
    r.sizes.resize(all, boost::container::default_init);
    Sums sums;
    fill(sums, r.sizes.data(), common,
         [&, xs = x.sizes.data(), ys = y.sizes.data()](std::size_t i) { return p * xs[i] + q * ys[i]; });
    const double factor = x_is_longer ? p : q;
    const double* rest = (x_is_longer ? x : y).sizes.data() + common;
    fill(sums, r.sizes.data() + common, all - common, [&](std::size_t i) { return factor * rest[i]; });
    r.sum = lanes_total(sums.sizes);
    r.squares = lanes_total(sums.squares);
}

Affine Affine::combination(double p, const Affine& x, double q, const Affine& y) {
    Affine result;
    result.roundings_ = x.roundings_ != nullptr ? x.roundings_ : y.roundings_;
    result.center_ = p * x.center_ + q * y.center_;
    result.slack_ = std::abs(p) * x.slack_ + std::abs(q) * y.slack_;
    // Reserves room for the rounding that follows.
    if (result.roundings_ != nullptr) result.random_.sizes.reserve(result.roundings_->random + 3);
    combine(result.random_, p, x.random_, q, y.random_);
    combine(result.known_, p, x.known_, q, y.known_);
    // Cancelling terms leave the rounding errors of the two products.
    double operands = std::abs(p) * (x.random_.sum + x.known_.sum + std::abs(x.center_)) +
                      std::abs(q) * (y.random_.sum + y.known_.sum + std::abs(y.center_));
    for (std::size_t i = 0; i < result.summary_.size(); ++i) {
        result.summary_[i] = p * x.summary_[i] + q * y.summary_[i];
        operands += std::abs(p * x.summary_[i]) + std::abs(q * y.summary_[i]);
    }
    result.slack_ += 0x1p-51 * (1 + own_error) * operands;
    return result;
}

void Affine::add_own_errors() {
    slack_ += own_error * radius() + std::numeric_limits<double>::denorm_min();
}

Affine Affine::rounded() && {
    add_own_errors();
    const double most = largest_size();
    if (!(most < largest)) return unbounded();
    add_random(half_unit(most));
    return std::move(*this);
}

Affine Affine::rounded(double z, double error, Roundings* roundings) {
    Affine result;
    result.roundings_ = roundings;
    result.center_ = z;
    result.slack_ = 2 * std::abs(error);
    if (z == 0 && error == 0) return result;
    if (!(std::abs(z) < largest)) return unbounded();
    if (std::abs(z) < smallest_normal) return std::move(result).rounded();
    const double by = static_cast<double>(static_cast<float>(z)) - z;
    if (by == 0) return result;
    result.slack_ += 0x1p-52 * std::abs(z);
    // A number halfway between two floats that is first rounded to double and then to float may become either.
    const bool middle = std::abs(by) > half_unit(std::abs(z)) * (1 - 0x1p-20);
    if (middle || roundings == nullptr) {
        result.add_known(std::abs(by));
        return result;
    }
    // Programs compute everything in float, everything in double, or some of both, in any mix.
    result.center_ = z + by / 2;
    result.known_.add(Roundings::of_float, by / 2);
    result.add_random(std::abs(by) / 2);
    return result;
}

Affine Affine::read(double x, double error, Roundings& roundings) {
    return rounded(x, error, &roundings);
}

/// p x + q y for p and q of size 1, without a rounding, of numbers or ranges.
Affine Affine::exact_sum(double p, const Affine& x, double q, const Affine& y) {
    if (!x.is_exact() || !y.is_exact()) {
        Affine result = combination(p, x, q, y);
        result.add_own_errors();
        return result;
    }
    Affine result;
    result.roundings_ = x.roundings_ != nullptr ? x.roundings_ : y.roundings_;
    const double value = p * x.center_;
    const double other = q * y.center_;
    result.center_ = value + other;
    // Knuth's two-sum: the part that the double leaves out.
    const double part = result.center_ - value;
    result.slack_ = 2 * std::abs((value - (result.center_ - part)) + (other - part));
    return result;
}

Affine Affine::total(std::initializer_list<Term> terms) {
    boost::container::static_vector<Term, 4> left;
    for (const Term& term : terms) {
        if (!std::isfinite(term.value->radius())) return unbounded();
        if (!term.value->is_exactly(0)) left.push_back(term);
    }
    if (left.empty()) return Affine();
    if (left.size() == 1) return left[0].sign < 0 ? -*left[0].value : *left[0].value;
    Affine total = exact_sum(left[0].sign, *left[0].value, left[1].sign, *left[1].value);
    for (std::size_t i = 2; i < left.size(); ++i) total = exact_sum(1, total, left[i].sign, *left[i].value);
    // The order of a program determines the partial sums. Each is rounded, and the largest has the largest error.
    double worst = 0;
    for (unsigned set = 1; set + 1 < 1U << left.size(); ++set) {
        double center = 0, radius = 0;
        bool is_exact = true;
        for (std::size_t i = 0; i < left.size(); ++i) {
            if ((set >> i & 1U) == 0) continue;
            center += left[i].sign * left[i].value->center_;
            radius += left[i].value->radius();
            is_exact = is_exact && left[i].value->is_exact();
        }
        const bool is_term = (set & (set - 1)) == 0;
        const double most = (std::abs(center) + radius) * (1 + own_error);
        if (!is_term && most > 0 && !(is_exact && is_float(center))) worst = std::max(worst, half_unit(most));
    }
    for (std::size_t partial = 2; partial < left.size() && worst > 0; ++partial) total.add_random(worst);
    if (total.is_exact()) return rounded(total.center_, 0, total.roundings_);
    return std::move(total).rounded();
}

Affine either(const Affine& x, const Affine& y) {
    if (!std::isfinite(x.radius()) || !std::isfinite(y.radius())) return Affine::unbounded();
    const Interval<double> difference = Affine::exact_sum(1, y, -1, x).range();
    const double lo = std::min(difference.lo(), 0.0);
    const double hi = std::max(difference.hi(), 0.0);
    Affine result = x;
    if (lo == hi) return result;
    if (result.roundings_ == nullptr) result.roundings_ = y.roundings_;
    result.center_ += lo / 2 + hi / 2;
    result.add_random((hi - lo) / 2);
    result.add_own_errors();
    return result;
}

/// Gram-Schmidt orthogonalisation of the values' deviations, row by row, in the better of its two orders: the rows
/// become those of a lower triangular matrix with the same products of any two rows.
void summarize(Vec3<Affine>& p, Vec3<Affine>& q) {
    const std::array<Affine*, 6> values{&p.x, &p.y, &p.z, &q.x, &q.y, &q.z};
    std::array<std::vector<double>, 6> rows;
    std::size_t errors = 0;
    for (const Affine* value : values) errors = std::max(errors, value->random_.sizes.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto& sizes = values[i]->random_.sizes;
        rows[i].assign(errors + values.size(), 0.0);
        std::copy(sizes.begin(), sizes.end(), rows[i].begin());
        // The result of an earlier summary.
        std::copy(values[i]->summary_.begin(), values[i]->summary_.end(), rows[i].begin() + errors);
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        Affine::Summary summary{};
        for (std::size_t j = 0; j < i; ++j) {
            summary[j] = std::inner_product(rows[i].begin(), rows[i].end(), rows[j].begin(), 0.0);
            for (std::size_t k = 0; k < rows[i].size(); ++k) rows[i][k] -= summary[j] * rows[j][k];
        }
        summary[i] = std::sqrt(std::inner_product(rows[i].begin(), rows[i].end(), rows[i].begin(), 0.0));
        for (double& size : rows[i]) size = summary[i] > 0 ? size / summary[i] : 0;
        Affine& value = *values[i];
        value.slack_ += own_error * value.radius();
        value.random_ = {};
        value.summary_ = summary;
    }
}

Affine Affine::exact_product(const Affine& y) const {
    Affine result = combination(y.center_, *this, center_, y);
    // combination() counts the product of the centers twice.
    result.center_ = center_ * y.center_;
    result.slack_ += radius() * y.radius();
    result.add_own_errors();
    return result;
}

Affine Affine::times(const Affine& y) const {
    if (is_exactly(0) || y.is_exactly(0)) return Affine();
    if (!std::isfinite(radius()) || !std::isfinite(y.radius())) return unbounded();
    if (y.is_power_of_two()) return scaled_by(y.center_);
    if (is_power_of_two()) return y.scaled_by(center_);
    if (!is_exact() || !y.is_exact()) return exact_product(y).rounded();
    const double product = center_ * y.center_;
    return rounded(product, std::fma(center_, y.center_, -product), roundings_ != nullptr ? roundings_ : y.roundings_);
}

Affine Affine::over(const Affine& y) const {
    const double r = y.radius();
    const double c = y.center_;
    const double least = std::abs(c) - r;
    if (!(least > 0) || !std::isfinite(radius())) return unbounded();
    if (is_exactly(0)) return Affine();
    if (y.is_power_of_two()) return scaled_by(1 / c);
    // 1/(c + x) = 1/c - x/c² + x²/(c² (c + x)).
    Affine reciprocal = combination(-1 / (c * c), y, 0, Affine());
    if (reciprocal.roundings_ == nullptr) reciprocal.roundings_ = roundings_;
    reciprocal.center_ = 1 / c;
    reciprocal.slack_ += r * r / (c * c * least) * (1 + own_error) + 0x1p-50 * (1 / std::abs(c) + r / (c * c));
    if (is_power_of_two()) return reciprocal.scaled_by(center_).rounded();
    Affine quotient = exact_product(reciprocal).rounded();
    // The rounding of 1 / y.
    if (std::isfinite(quotient.slack_)) quotient.add_random(unit_roundoff * quotient.largest_size());
    return quotient;
}

Affine Affine::root() const {
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

Affine Affine::reciprocal_root() const {
    // rsqrtss is off by up to 1.5 2^-12; one step of Newton's method leaves 3/2 of the square of that, always below the
    // true value.
    constexpr double estimate = 3.375 * unit_roundoff;
    const double r = radius();
    const double c = center_;
    const double least = c - r;
    if (!(least > 0) || !std::isfinite(r)) return unbounded();
    // 1/√(c + x) = 1/√c - x/(2c√c) + at most 3x²/(8 c' c'√c') for the least c' of the range.
    Affine result = combination(-1 / (2 * c * std::sqrt(c)), *this, 0, Affine());
    result.center_ = 1 / std::sqrt(c);
    result.slack_ += 3 * r * r / (8 * least * least * std::sqrt(least)) * (1 + own_error);
    result.slack_ += 0x1p-50 * (result.center_ + r / (c * std::sqrt(c)));
    const double most = result.largest_size();
    if (!(most < largest)) return unbounded();
    // Without an estimate the error is 0, with it up to the maximum.
    const double quarter = estimate / 4 * most;
    result.center_ -= quarter;
    if (result.roundings_ != nullptr) result.known_.add(Roundings::of_estimate, -quarter);
    if (result.roundings_ == nullptr) result.slack_ += quarter;
    result.add_random(2 * quarter);
    result.add_random(unit_roundoff * most);
    return std::move(result).rounded();
}

}  // namespace reference
