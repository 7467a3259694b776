#include "reference/numbers/decimal.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using reference::Decimal;

TEST(Decimal, KeepsTheTextAsWrittenWithoutPlusAndUnderscores) {
    EXPECT_EQ(Decimal::parse("+1_000.50")->text(), "1000.50");
    EXPECT_EQ(Decimal::parse("-0.1")->text(), "-0.1");
    EXPECT_EQ(Decimal::parse("6.02e+23")->text(), "6.02e+23");
}

TEST(Decimal, RefusesWhatIsNotADecimalNumber) {
    for (const char* text : {"", "-", ".5", "5.", "1e", "1e+", "inf", "nan", "0x10", "1 ", "1__0", "_1", "1_", "--1"}) {
        EXPECT_FALSE(Decimal::parse(text).has_value()) << '"' << text << '"';
    }
    EXPECT_FALSE(Decimal::parse(std::string(401, '1')).has_value());
}

TEST(Decimal, ConvertsToTheNearestFloatAndTheNearestDouble) {
    // 1 + 2^-24 + 10^-20 lies just above the middle of two floats. Rounding to double first would lose the excess.
    const auto number = Decimal::parse("1.00000005960464477540062500");
    ASSERT_TRUE(number);
    EXPECT_EQ(number->to_float(), std::nextafter(1.0F, 2.0F));
    EXPECT_EQ(Decimal::parse("0.1")->to_double(), 0.1);
}

TEST(Decimal, ConvertsOutOfRangeToSignedInfinityOrZero) {
    EXPECT_EQ(Decimal::parse("1e999")->to_double(), HUGE_VAL);
    EXPECT_EQ(Decimal::parse("-1e999")->to_double(), -HUGE_VAL);
    EXPECT_EQ(Decimal::parse("1e-999")->to_double(), 0.0);
    EXPECT_TRUE(std::isinf(Decimal::parse("1e39")->to_float()));
}

TEST(Decimal, ConvertsOutOfRangeByItsSizeHoweverItIsWritten) {
    const std::string zeros(350, '0');
    const auto read = [](const std::string& text) { return Decimal::parse(text)->to_double(); };
    EXPECT_EQ(read("0." + zeros + "1"), 0.0) << "no exponent";
    EXPECT_EQ(read("-0." + zeros + "1"), 0.0);
    EXPECT_EQ(read("1" + zeros), HUGE_VAL);
    EXPECT_EQ(read("1" + zeros + "e-10"), HUGE_VAL) << "the exponent's sign says nothing";
    EXPECT_EQ(read("0." + zeros + "1e+10"), 0.0);
    EXPECT_EQ(read("1E-999"), 0.0);
    EXPECT_EQ(read("-1E999"), -HUGE_VAL);
    EXPECT_EQ(read("1e-99999999999999999999"), 0.0);
    EXPECT_EQ(read("1e+99999999999999999999"), HUGE_VAL);
    EXPECT_EQ(Decimal::parse("0." + std::string(50, '0') + "1")->to_float(), 0.0F);
}

TEST(Decimal, HasItsExactSignEvenWhereTheNearestDoubleIsZero) {
    EXPECT_EQ(Decimal::parse("1e-999")->sign(), 1);
    EXPECT_EQ(Decimal::parse("-0.000")->sign(), 0);
    EXPECT_EQ(Decimal::parse("0e5")->sign(), 0);
    EXPECT_EQ(Decimal::parse("-3")->sign(), -1);
}

}  // namespace
