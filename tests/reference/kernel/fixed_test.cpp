// Compares fixed-size integers with GMP's, and sums of products with fractions: at the limits of each size, and across
// word boundaries.
#include "reference/kernel/fixed.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "reference/accuracy/rays/random_numbers.h"
#include "reference/accuracy/rays/truth.h"
#include "reference/kernel/product_sum.h"

namespace {

namespace accuracy = reference::accuracy;
namespace truth = reference::accuracy::truth;

using reference::accuracy::Random;
using namespace reference::kernel;

template <int bits>
struct Both {
    Fixed<bits> fixed;
    mpz_class number;
};

template <int bits>
mpz_class value_of(const Fixed<bits>& x) {
    mpz_class value = 0;
    for (std::size_t i = x.words; i-- > 0;) value = (value << 64U) + mpz_class(static_cast<unsigned long>(x.word(i)));
    if (x.sign_word() != 0) value -= mpz_class(1) << static_cast<mp_bitcnt_t>(64 * x.words);
    return value;
}

/// A sum of shifted mantissas of doubles, below 2^bits: dense, sparse, zero or as large as possible, of either sign.
template <int bits>
Both<bits> drawn(Random& random) {
    constexpr int size = bits < 53 ? bits : 53;
    auto mantissa = static_cast<std::int64_t>(random.bits() >> static_cast<unsigned>(64 - size));
    if (random.whole(0, 3) == 0) mantissa = (std::int64_t{1} << static_cast<unsigned>(size)) - 1;
    if (random.whole(0, 7) == 0) mantissa = random.whole(0, 1);
    if (random.whole(0, 1) == 0) mantissa = -mantissa;
    const int shift = random.whole(0, 2) == 0 ? bits - size : random.whole(0, bits - size);
    return {Fixed<bits>(mantissa, shift), mpz_class(static_cast<long>(mantissa)) << static_cast<mp_bitcnt_t>(shift)};
}

template <int n, int m>
void expect_same(Random& random) {
    for (int i = 0; i < 2000; ++i) {
        const auto x = drawn<n>(random);
        const auto y = drawn<m>(random);
        ASSERT_EQ(value_of(x.fixed), x.number);
        ASSERT_EQ(value_of(x.fixed + y.fixed), x.number + y.number);
        ASSERT_EQ(value_of(x.fixed - y.fixed), x.number - y.number);
        ASSERT_EQ(value_of(x.fixed * y.fixed), x.number * y.number);
        // Dense factors, so that every word matters.
        const auto dense = (x.fixed * y.fixed - y.fixed) * (x.fixed + y.fixed);
        ASSERT_EQ(value_of(dense), (x.number * y.number - y.number) * (x.number + y.number));
        ASSERT_EQ(sign_of(dense), sgn(value_of(dense)) <=> 0);
        ASSERT_EQ(sign_of(x.fixed), sgn(x.number) <=> 0);
    }
}

constexpr std::uint64_t fixed_seed = 20261121;

TEST(Fixed, ComputesAsGmpDoes) {
    Random random(fixed_seed);
    expect_same<28, 28>(random);
    expect_same<29, 61>(random);
    expect_same<61, 61>(random);
    expect_same<61, 62>(random);
    expect_same<62, 125>(random);
    expect_same<63, 64>(random);
    expect_same<64, 127>(random);
    expect_same<125, 125>(random);
    expect_same<126, 128>(random);
    expect_same<252, 61>(random);
    expect_same<380, 508>(random);
}

TEST(Fixed, HasNoMoreWordsThanItNeeds) {
    EXPECT_EQ(Fixed<63>::words, 1U);
    EXPECT_EQ(Fixed<64>::words, 2U);
    EXPECT_EQ(decltype(Fixed<61>() * Fixed<62>())::words, 2U);
    EXPECT_EQ(decltype(Fixed<63>() + Fixed<63>())::words, 2U);
}

/// A double with any exponent, or with one of a few exponents.
double any_double(Random& random, int spread) {
    return random.whole(0, 9) == 0 ? 0 : std::ldexp(random.number(), random.whole(-spread, spread));
}

TEST(ProductSum, HasTheSignThatFractionsHave) {
    Random random(fixed_seed + 1);
    for (int i = 0; i < 20000; ++i) {
        const int spread = std::array{0, 40, 300, 1000}[static_cast<std::size_t>(random.whole(0, 3))];
        std::array<double, 8> x{};
        std::array<double, 8> y{};
        Scale scale;
        for (std::size_t j = 0; j < x.size(); ++j) {
            x[j] = any_double(random, spread);
            y[j] = any_double(random, spread);
        }
        // Half of the sums cancel completely, or except for the last product.
        if (random.whole(0, 1) == 0) {
            for (std::size_t j = 0; j < 3; ++j) {
                x[j + 3] = -y[j];
                y[j + 3] = x[j];
            }
            x[6] = 0;
            if (random.whole(0, 1) == 0) x[7] = 0;
        }
        for (std::size_t j = 0; j < x.size(); ++j) {
            scale.cover(x[j]);
            scale.cover(y[j]);
        }
        ProductSum sum(2 * scale.exponent(), 2 * scale.end());
        truth::Rational truth = 0;
        for (std::size_t j = 0; j < x.size(); ++j) {
            const bool minus = random.whole(0, 1) == 0 && x[6] != 0;
            if (minus) {
                sum.subtract(x[j], y[j]);
                truth -= truth::Rational(x[j]) * truth::Rational(y[j]);
            } else {
                sum.add(x[j], y[j]);
                truth += truth::Rational(x[j]) * truth::Rational(y[j]);
            }
        }
        ASSERT_EQ(sum.sign(), truth.sign() <=> 0);
    }
}

}  // namespace
