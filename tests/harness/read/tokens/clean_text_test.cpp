#include "harness/read/tokens/clean_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "harness/text/escape.h"
#include "harness/text/utf8.h"

namespace harness {
namespace {

using namespace std::string_literals;

TEST(CleanText, RemovesTerminalEscapesAndKeepsTheColouredText) {
    EXPECT_EQ(clean_text("\x1b[1;31mt\x1b[0m = \x1b[38;5;196m1\x1b[K"), "t = 1");
    EXPECT_EQ(clean_text("\x1b]0;title\a1\x1b]8;;x\x1b\\2"), "12");
}

TEST(CleanText, KeepsTheTextAfterAnEscapeThatNeverEnds) {
    EXPECT_EQ(clean_text("\x1b["), "");
    EXPECT_EQ(clean_text("\x1b[12\nt = 1"), "\nt = 1");
    EXPECT_EQ(clean_text("\x1b]0;title\nt = 1"), "0;title\nt = 1");
    EXPECT_EQ(clean_text("\x1b"), "");
}

TEST(CleanText, KeepsTheNumberOfLinesForEveryLineEnd) {
    EXPECT_EQ(clean_text("a\r\nb\rc\nd"), "a\nb\nc\nd");
    EXPECT_EQ(clean_text("a\r\r\nb"), "a\n\nb");
}

TEST(BeginningOfCharacters, CutsNoCharacterInTwo) {
    EXPECT_EQ(beginning_of_characters("abc", 3), "abc");
    EXPECT_EQ(beginning_of_characters("abc", 2), "ab");
    EXPECT_EQ(beginning_of_characters("aé", 2), "a");
    EXPECT_EQ(beginning_of_characters("aéb", 3), "aé");
    for (const std::size_t most : {1, 2, 3, 4}) EXPECT_EQ(beginning_of_characters("a😀b", most), "a") << most;
    EXPECT_EQ(beginning_of_characters("a😀b", 5), "a😀");
    EXPECT_EQ(beginning_of_characters("é", 0), "");
}

TEST(BeginningOfCharacters, LosesLittleOfTextThatIsNotUtf8) {
    EXPECT_EQ(beginning_of_characters(std::string(100, '\x80'), 50), std::string(50, '\x80'));
}

TEST(CleanText, WritesMinusSignsAndDashesAsMinus) {
    EXPECT_EQ(clean_text("−4 –4 —4 －4"), "-4 -4 -4 -4");
}

TEST(CleanText, SpellsOutScriptDigitsAndGreekLetters) {
    EXPECT_EQ(clean_text("t₁ b² Δ √2 ∞"), "t1 b^2 Delta sqrt2 inf");
    EXPECT_EQ(clean_text("n\xCC\x82 p\xE2\x83\x97 ê₂"), "n p e2");
}

TEST(CleanText, WritesFractionsAsDecimals) {
    EXPECT_EQ(clean_text("(−½, ¼, 2¾, ⅓)"), "(-.500000, .250000, 2.750000, .333333)");
}

TEST(CleanText, WritesBracketsAndFramesOfOtherAlphabetsAsAscii) {
    EXPECT_EQ(clean_text("⟨1⟩ │2│ ─ ═"), "<1> |2| - =");
}

TEST(CleanText, WritesFullWidthCharactersAndSuperscriptsAsAscii) {
    EXPECT_EQ(clean_text("a：1　b：-4"), "a:1 b:-4");
    EXPECT_EQ(clean_text("V（0．5， 1、 -2）"), "V(0.5, 1, -2)");
    EXPECT_EQ(clean_text("b² - 4·10⁻¹² = (t u v)ᵀ M⁻¹"), "b^2 - 4*10^-12 = (t u v)^T M^-1");
}

TEST(CleanText, ReplacesBytesThatAreNotUtf8OneByOne) {
    const std::string bad = "\xEF\xBF\xBD";
    EXPECT_EQ(clean_text("\xff"
                         "1"),
              bad + "1");
    EXPECT_EQ(clean_text("\xe2\x88"), bad + bad);            // cut off
    EXPECT_EQ(clean_text("\xc0\xaf"), bad + bad);            // overlong
    EXPECT_EQ(clean_text("\xed\xa0\x80"), bad + bad + bad);  // a surrogate
    EXPECT_EQ(clean_text("\xf5\x80\x80\x80").size(), 12U);   // beyond U+10FFFF
}

TEST(CleanText, MakesControlCharactersBlanks) {
    EXPECT_EQ(clean_text("a\0b\a\x7f\tc"s), "a b  \tc");
}

TEST(CleanText, HasNoControlCharacterWhateverTheByte) {
    for (int first = 0; first < 256; ++first) {
        for (int second = 0; second < 256; ++second) {
            const std::string clean = clean_text(std::string{static_cast<char>(first), static_cast<char>(second)});
            EXPECT_TRUE(
                std::none_of(clean.begin(), clean.end(),
                             [](char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t'; }))
                << first << ' ' << second;
        }
    }
}

TEST(EscapeControl, ShowsTheCharactersThatCleanTextRemoves) {
    EXPECT_EQ(escape_control("\x1b[1mΔ\xff\r\n"), "\\x1b[1mΔ\\xff\\x0d\n");
}

TEST(EscapeControl, ShowsCharactersThatReverseTheTextDirection) {
    EXPECT_EQ(escape_control("a\u202Eb\u2066c\u200F\u061C\u2028"), "a\\u202eb\\u2066c\\u200f\\u061c\\u2028");
    EXPECT_EQ(escape_control("שלום – “x”"), "שלום – “x”");
}

}  // namespace
}  // namespace harness
