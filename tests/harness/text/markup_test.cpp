#include "harness/text/markup.h"

#include <gtest/gtest.h>

#include "tests/given/report/helvetica.h"

namespace harness::report {
namespace {

TEST(EscapeMarkup, EscapesEveryCharacterThatEndsATextOrAnAttribute) {
    EXPECT_EQ(escape_markup("a<b>\"c\"'d'&amp;"), "a&lt;b&gt;&quot;c&quot;&#39;d&#39;&amp;amp;");
    EXPECT_EQ(escape_markup(std::string_view("\x1b[2J\0\xff", 6)), "\\x1b[2J\\x00\\xff");
    EXPECT_EQ(escape_markup("é 1.5"), "é 1.5");
}

TEST(TextWidth, ApproximatesTheWidthInTheFont) {
    for (const char* text : {"V", "P_WCS", "A, B, C", "W x H = 301 x 201", "P_DCS (140 90)", "0123456789",
                             "The ray misses the triangle: P_t is in its plane, but outside the triangle."}) {
        for (const double size : {8.0, 12.0}) {
            const double width = drawn::helvetica_width(text, size);
            EXPECT_GE(text_width(text, size), 0.96 * width) << text;
            EXPECT_LE(text_width(text, size), 1.1 * width) << text;
        }
    }
}

TEST(TextWidth, CountsCharactersAndNotBytes) {
    EXPECT_EQ(text_width("", 12), 0);
    EXPECT_DOUBLE_EQ(text_width("\xc3\xa9\xe2\x82\xac", 10), 12) << "two characters of 2 and 3 bytes";
}

}  // namespace
}  // namespace harness::report
