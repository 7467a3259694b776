#include "harness/text/encoding.h"

#include <gtest/gtest.h>

namespace harness {
namespace {

TEST(Composed, IsTheSameForEachUnicodeFormOfAName) {
    EXPECT_EQ(composed("Mu\u0308ller"), "M\u00fcller");
    EXPECT_EQ(composed("M\u00fcller"), "M\u00fcller");
    EXPECT_EQ(composed("\u1100\u1161"), "\uac00") << "Hangul";
    EXPECT_EQ(composed("M\xfcller"), std::nullopt);
    EXPECT_EQ(composed_name("M\xfcller"), "M\xfcller");
    EXPECT_EQ(composed(""), "");
}

TEST(Utf8From, ConvertsWhatWindowsWrites) {
    EXPECT_EQ(utf8_from("CP1252", "M\xfcller \x80"), "M\u00fcller \u20ac");
    EXPECT_EQ(utf8_from("CP1252", "a\x81z"), "a\uFFFDz") << "of no character";
    EXPECT_EQ(utf8_from("UTF-16", std::string_view("\xff\xfet\0=\0", 6)), "t=");
    EXPECT_EQ(utf8_from("UTF-16", std::string_view("\xfe\xff\0t\0=", 6)), "t=");
    const std::string long_one(10'000, '\xfc');
    EXPECT_EQ(utf8_from("CP1252", long_one).size(), 2 * long_one.size());
}

}  // namespace
}  // namespace harness
