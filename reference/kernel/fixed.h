// Integers of a fixed size, for the exact level of the kernel. The size is part of the type and grows with each
// operation, so that no result overflows and none is longer than its formula needs.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>

namespace reference::kernel {

__extension__ typedef unsigned __int128 TwoWords;
__extension__ typedef __int128 SignedTwoWords;

/// |x| < 2^bits, in two's complement.
template <int bits>
class Fixed {
  public:
    static constexpr std::size_t words = bits / 64 + 1;

    Fixed() = default;
    /// mantissa * 2^shift, below 2^bits; shift >= 0.
    Fixed(std::int64_t mantissa, int shift) {
        if constexpr (words == 1) {
            word_[0] = static_cast<std::uint64_t>(mantissa) << static_cast<unsigned>(shift);
        } else {
            const auto first = static_cast<std::size_t>(shift) / 64;
            const auto part = static_cast<unsigned>(shift) % 64;
            const auto shifted = static_cast<TwoWords>(static_cast<SignedTwoWords>(mantissa)) << part;
            word_[first] = static_cast<std::uint64_t>(shifted);
            if (first + 1 < words) word_[first + 1] = static_cast<std::uint64_t>(shifted >> 64U);
            for (std::size_t i = first + 2; i < words; ++i) word_[i] = mantissa < 0 ? ~std::uint64_t{0} : 0;
        }
    }

    /// Word i of the number, sign-extended without end.
    std::uint64_t word(std::size_t i) const { return i < words ? word_[i] : sign_word(); }
    /// All ones below zero, else all zeros.
    std::uint64_t sign_word() const {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(word_[words - 1]) >> 63U);
    }

    friend std::partial_ordering sign_of(const Fixed& x) {
        if (static_cast<std::int64_t>(x.word_[words - 1]) < 0) return std::partial_ordering::less;
        std::uint64_t any = 0;
        for (const std::uint64_t word : x.word_) any |= word;
        return any != 0 ? std::partial_ordering::greater : std::partial_ordering::equivalent;
    }

  private:
    template <int>
    friend class Fixed;
    template <int n, int m>
    friend auto operator+(const Fixed<n>& x, const Fixed<m>& y);
    template <int n, int m>
    friend auto operator-(const Fixed<n>& x, const Fixed<m>& y);
    template <int n, int m>
    friend auto operator*(const Fixed<n>& x, const Fixed<m>& y);

    /// Subtracts y & mask from word `from` and all words above it.
    template <int m>
    void subtract_above(std::size_t from, const Fixed<m>& y, std::uint64_t mask) {
        std::uint64_t borrow = 0;
        for (std::size_t i = 0; from + i < words; ++i) {
            const TwoWords difference = static_cast<TwoWords>(word_[from + i]) - (y.word(i) & mask) - borrow;
            word_[from + i] = static_cast<std::uint64_t>(difference);
            borrow = static_cast<std::uint64_t>(difference >> 64U) & 1U;
        }
    }

    std::array<std::uint64_t, words> word_{};
};

template <int n, int m>
auto operator+(const Fixed<n>& x, const Fixed<m>& y) {
    Fixed<(n > m ? n : m) + 1> sum;
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < sum.words; ++i) {
        const TwoWords part = static_cast<TwoWords>(x.word(i)) + y.word(i) + carry;
        sum.word_[i] = static_cast<std::uint64_t>(part);
        carry = static_cast<std::uint64_t>(part >> 64U);
    }
    return sum;
}

template <int n, int m>
auto operator-(const Fixed<n>& x, const Fixed<m>& y) {
    Fixed<(n > m ? n : m) + 1> difference;
    std::uint64_t borrow = 0;
    for (std::size_t i = 0; i < difference.words; ++i) {
        const TwoWords part = static_cast<TwoWords>(x.word(i)) - y.word(i) - borrow;
        difference.word_[i] = static_cast<std::uint64_t>(part);
        borrow = static_cast<std::uint64_t>(part >> 64U) & 1U;
    }
    return difference;
}

/// Multiplies word by word as if both were unsigned. For a negative x of k words, that adds 2^(64k) y too much, which
/// is subtracted at the end; likewise for a negative y.
template <int n, int m>
auto operator*(const Fixed<n>& x, const Fixed<m>& y) {
    Fixed<n + m> product;
    if constexpr (Fixed<n + m>::words == 1) {
        product.word_[0] = x.word_[0] * y.word_[0];
    } else if constexpr (Fixed<n>::words == 1 && Fixed<m>::words == 1) {
        const auto whole =
            static_cast<SignedTwoWords>(static_cast<std::int64_t>(x.word_[0])) * static_cast<std::int64_t>(y.word_[0]);
        product.word_[0] = static_cast<std::uint64_t>(whole);
        product.word_[1] = static_cast<std::uint64_t>(static_cast<TwoWords>(whole) >> 64U);
    } else {
        for (std::size_t i = 0; i < x.words; ++i) {
            std::uint64_t carry = 0;
            for (std::size_t j = 0; j < y.words && i + j < product.words; ++j) {
                const TwoWords part = static_cast<TwoWords>(x.word_[i]) * y.word_[j] + product.word_[i + j] + carry;
                product.word_[i + j] = static_cast<std::uint64_t>(part);
                carry = static_cast<std::uint64_t>(part >> 64U);
            }
            if (i + y.words < product.words) product.word_[i + y.words] = carry;
        }
        product.subtract_above(x.words, y, x.sign_word());
        product.subtract_above(y.words, x, y.sign_word());
    }
    return product;
}

}  // namespace reference::kernel
