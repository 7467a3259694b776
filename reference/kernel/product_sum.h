// The exact sign of a sum of products of two doubles of any size. Each product is added at its place to one of two long
// integers: one for the positive products, one for the negative products.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>

#include "reference/kernel/integers.h"

namespace reference::kernel {

class ProductSum {
  public:
    /// Every product is a multiple of 2^least and below 2^most; there are fewer than 64.
    ProductSum(int least, int most) : least_(least), words_(static_cast<std::size_t>(most - least + 6) / 64 + 2) {
        std::fill_n(positive_.begin(), words_, 0);
        std::fill_n(negative_.begin(), words_, 0);
    }

    /// Adds 2^doublings x y.
    void add(double x, double y, int doublings = 0) { add(Binary(x), Binary(y), doublings); }
    void subtract(double x, double y, int doublings = 0) { add(Binary(-x), Binary(y), doublings); }

    std::partial_ordering sign() const {
        for (std::size_t i = words_; i-- > 0;) {
            if (positive_[i] != negative_[i]) return positive_[i] <=> negative_[i];
        }
        return std::partial_ordering::equivalent;
    }

  private:
    /// Twice the 2,098 bits of a double's range, with some room; and three more words, since a product may reach into
    /// them.
    using Words = std::array<std::uint64_t, 72>;

    void add(const Binary& x, const Binary& y, int doublings) {
        const auto [x_size, x_exponent] = odd(x);
        const auto [y_size, y_exponent] = odd(y);
        if (x_size == 0 || y_size == 0) return;
        Words& words = (x.mantissa < 0) == (y.mantissa < 0) ? positive_ : negative_;
        const TwoWords product = static_cast<TwoWords>(x_size) * y_size;
        const auto place = static_cast<std::size_t>(x_exponent + y_exponent + doublings - least_);
        const std::size_t word = place / 64;
        const auto shift = static_cast<unsigned>(place % 64);
        TwoWords part = static_cast<TwoWords>(static_cast<std::uint64_t>(product)) << shift;
        TwoWords sum = static_cast<TwoWords>(words[word]) + static_cast<std::uint64_t>(part);
        words[word] = static_cast<std::uint64_t>(sum);
        part = ((product >> 64U) << shift) + (part >> 64U) + (sum >> 64U);
        for (std::size_t i = word + 1; part != 0; ++i) {
            sum = static_cast<TwoWords>(words[i]) + static_cast<std::uint64_t>(part);
            words[i] = static_cast<std::uint64_t>(sum);
            part = (part >> 64U) + (sum >> 64U);
        }
    }

    struct Odd {
        std::uint64_t size;
        int exponent;
    };
    static Odd odd(const Binary& x) {
        const auto size = static_cast<std::uint64_t>(std::abs(x.mantissa));
        if (size == 0) return {0, 0};
        const int zeros = std::countr_zero(size);
        return {size >> static_cast<unsigned>(zeros), x.exponent + zeros};
    }

    int least_;
    std::size_t words_;
    Words positive_;
    Words negative_;
};

}  // namespace reference::kernel
