#include "harness/text/printable.h"

#include <gtest/gtest.h>

namespace {

using harness::printable;

TEST(Printable, KeepsTextUnchanged) {
    for (const char* text : {"", "s01 50%", "Zoë", "名前", "🙂", "\xF4\x8F\xBF\xBF"})
        EXPECT_EQ(printable(text), text);
}

TEST(Printable, PercentEncodesControlCharacters) {
    EXPECT_EQ(printable("a\n\x1b[31m\x7f"), "a%0A%1B[31m%7F");
    EXPECT_EQ(printable("\xC2\x9B"), "%C2%9B");
    EXPECT_EQ(printable("\xC2\xA0"), "\xC2\xA0");
    EXPECT_EQ(printable(std::string_view("\0", 1)), "%00");
    EXPECT_EQ(printable("a\u202Eb"), "a%E2%80%AEb") << "turns the order of what follows around";
}

TEST(Printable, PercentEncodesInvalidUtf8) {
    EXPECT_EQ(printable("\xFF"), "%FF");
    EXPECT_EQ(printable("\xC0\x80"), "%C0%80");
    EXPECT_EQ(printable("\xE0\x9F\xBF"), "%E0%9F%BF");
    EXPECT_EQ(printable("\xED\xA0\x80"), "%ED%A0%80");
    EXPECT_EQ(printable("\xF4\x90\x80\x80"), "%F4%90%80%80");
    EXPECT_EQ(printable("\xE5\x90"), "%E5%90");
    EXPECT_EQ(printable("\xE5\x90x"), "%E5%90x");
}

}  // namespace
