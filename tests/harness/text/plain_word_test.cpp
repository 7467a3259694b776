#include "harness/text/plain_word.h"

#include <gtest/gtest.h>

namespace harness {
namespace {

TEST(PlainLetters, HaveNoAccentsAndAreSmall) {
    EXPECT_EQ(plain_letters("Intersecci\u00f3n"), "interseccion");
    EXPECT_EQ(plain_letters("SPH\u00c8RE \u00d7 2"), "sphere");
    EXPECT_EQ(
        plain_letters("Tr\u00f3jk\u0105t, \u0141uk, \u00dc\u00e7gen, \u0131\u015f\u0131n, v\u00e1lec \u0159\u017e"),
        "trojkatlukucgenisinvalecrz");
    EXPECT_EQ(plain_letters("\u03b1\xFF"), "??") << "of another alphabet, and no UTF-8";
}

TEST(IsOneLetterOff, CountsAWrongAMissingAnExtraAndAnExchangedLetter) {
    for (const char* word : {"sphere", "sphera", "spere", "sphhere", "shpere", "spher", "spheres", "phere"})
        EXPECT_TRUE(is_one_letter_off(word, "sphere")) << word;
    for (const char* word : {"spehers", "spore", "sphereal", "", "erehps"})
        EXPECT_FALSE(is_one_letter_off(word, "sphere")) << word;
}

}  // namespace
}  // namespace harness
