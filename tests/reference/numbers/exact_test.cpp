#include <gtest/gtest.h>

#include "reference/numbers/certified.h"
#include "reference/numbers/rational.h"

namespace {

using namespace reference;

Rational rational(const char* text) {
    return *to_rational(*Decimal::parse(text));
}

TEST(Rational, EqualsTheDecimalAsWritten) {
    EXPECT_EQ(rational("0.1"), Rational(1, 10));
    EXPECT_EQ(rational("-12.50e-1"), Rational(-5, 4));
    EXPECT_EQ(rational("6e2"), Rational(600));
    EXPECT_EQ(rational("-0.000e999999"), Rational(0));
}

TEST(Rational, IsRefusedOutsideItsRangeBeforeItIsBuilt) {
    for (const char* text : {"1e999999", "-1e99999999999999999999", "1e-999999", "1.0000001e150", "0.99e-300"}) {
        EXPECT_FALSE(to_rational(*Decimal::parse(text))) << text;
    }
    EXPECT_TRUE(to_rational(*Decimal::parse("1e150")));
    EXPECT_TRUE(to_rational(*Decimal::parse("-1e150")));
    EXPECT_TRUE(to_rational(*Decimal::parse("-1e-300")));
    EXPECT_TRUE(to_rational(*Decimal::parse("1" + std::string(150, '0'))));
}

TEST(Rational, IsEnclosedByItselfOrByNeighbours) {
    const Enclosure half = enclose(Rational(1, 2));
    EXPECT_EQ(half.lo, 0.5);
    EXPECT_EQ(half.hi, 0.5);
    const Enclosure tenth = enclose(Rational(1, 10));
    EXPECT_EQ(tenth.hi, 0.1);  // the double is above one tenth
    EXPECT_EQ(tenth.lo, std::nextafter(0.1, 0.0));
    EXPECT_EQ(tenth.nearest, 0.1);
}

TEST(Rational, IsEnclosedBelowTheNormalDoublesToo) {
    // A third of the smallest double lies between it and 0; five thirds between one and two of it.
    const double least = 0x1p-1074;
    const Rational third = Rational(least) / 3;
    EXPECT_EQ(enclose(third).lo, 0.0);
    EXPECT_EQ(enclose(third).hi, least);
    EXPECT_EQ(enclose(-third).lo, -least);
    EXPECT_EQ(enclose(third * 5).lo, least);
    EXPECT_EQ(enclose(third * 5).hi, 2 * least);
}

TEST(Rational, HasARationalRootOnlyIfBothItsPartsAreSquares) {
    EXPECT_EQ(rational_sqrt(Rational(4, 9)), Rational(2, 3));
    EXPECT_EQ(rational_sqrt(Rational(4)), Rational(2));
    EXPECT_FALSE(rational_sqrt(Rational(4, 3)));
    EXPECT_FALSE(rational_sqrt(Rational(3, 4)));
}

class Field : public testing::Test {
  protected:
    FieldNumber number(long x) const { return FieldNumber(Rational(x), basis_); }
    FieldNumber root(long x) const { return *number(x).sqrt(); }

  private:
    std::shared_ptr<RootBasis> basis_ = std::make_shared<RootBasis>();
};

TEST_F(Field, ASumOfRootsThatCancelsIsZero) {
    // √2 √3 = √6, and √24 = 2 √6. The sum is zero only because the field knows that these roots depend on each other.
    EXPECT_TRUE((root(2) * root(3) - root(6)).is_zero());
    EXPECT_TRUE((root(24) - number(2) * root(6)).is_zero());
    EXPECT_EQ((root(2) * root(2)).rational(), Rational(2));
}

TEST_F(Field, ASumOfRootsThatNearlyCancelsHasItsSign) {
    // 665857/470832 is a convergent of √2, too large by 1.6e-12.
    const FieldNumber difference = root(2) - FieldNumber(Rational(665857, 470832));
    EXPECT_EQ(difference.sign(), std::strong_ordering::less);
    EXPECT_EQ((-difference).sign(), std::strong_ordering::greater);
    EXPECT_EQ((root(2) - FieldNumber(Rational(7, 5))).sign(), std::strong_ordering::greater);
}

TEST_F(Field, InverseTimesItselfIsOne) {
    const FieldNumber x = number(3) + root(2) - root(3) + root(5) * root(2);
    EXPECT_EQ((x * x.inverse()).rational(), Rational(1));
    EXPECT_THROW((root(2) - root(2)).inverse(), std::domain_error);
}

TEST_F(Field, HasNoRootOfNegativeNorOfIrrationalNumbers) {
    EXPECT_THROW(number(-1).sqrt(), std::domain_error);
    EXPECT_FALSE((number(1) + root(2)).sqrt());
}

TEST_F(Field, StopsGrowingAtTheMaximumNumberOfRoots) {
    for (const long prime : {2, 3, 5, 7, 11, 13, 17, 19}) EXPECT_TRUE(number(prime).sqrt());
    EXPECT_FALSE(number(23).sqrt());
    EXPECT_TRUE(number(2 * 3 * 19).sqrt());
}

TEST(CertifiedNumber, IsEnclosedByNeighboursBeyondTheField) {
    const Certified nested = sqrt(Certified(1) + sqrt(Certified(2)));  // 1.5537739740300373...
    const Enclosure enclosure = nested.enclosure();
    EXPECT_EQ(std::nextafter(enclosure.lo, 2.0), enclosure.hi);
    EXPECT_NEAR(enclosure.nearest, 1.5537739740300373, 1e-16);
    EXPECT_EQ(sign_of(nested - Certified(2)), std::partial_ordering::less);
}

TEST(CertifiedNumber, HasASignThatShowsOnlyInManyBits) {
    // 10^-200 is lost beside 1 + √2 at 128 bits, and at 512.
    const Certified nested = sqrt(Certified(1) + sqrt(Certified(2))), tiny(FieldNumber(rational("1e-200")));
    const Certified sum = nested * nested - Certified(1) - sqrt(Certified(2)) + tiny;
    EXPECT_EQ(sign_of(sum), std::partial_ordering::greater);
    EXPECT_EQ(sign_of(sum - tiny - tiny), std::partial_ordering::less);
    EXPECT_EQ(sum.enclosure().nearest, 1e-200);
}

TEST(CertifiedNumber, IsUnorderedAndEnclosedForAHiddenZeroBeyondTheField) {
    const Certified nested = sqrt(Certified(1) + sqrt(Certified(2)));
    const Certified zero = nested * nested - Certified(1) - sqrt(Certified(2));
    EXPECT_EQ(sign_of(zero), std::partial_ordering::unordered);
    EXPECT_LE(zero.enclosure().lo, 0);
    EXPECT_GE(zero.enclosure().hi, 0);
    EXPECT_LT(zero.enclosure().hi, 1e-300);
}

}  // namespace
