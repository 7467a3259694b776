#include "harness/intake/not_a_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace harness {
namespace {

using namespace std::string_literals;
using testing::HasSubstr;
using testing::StartsWith;

constexpr std::string_view program = "// für t\r\nint main() { return 0; }\n";

/// Writes each character as two bytes; either the second or the first byte is 0.
std::string as_utf_16(std::string_view ascii, bool is_little_endian) {
    std::string bytes;
    for (const char c : ascii) bytes += is_little_endian ? std::string{c, '\0'} : std::string{'\0', c};
    return bytes;
}

TEST(WhyNoSource, IsEmptyForAPossibleSource) {
    for (const std::string& source :
         {std::string(program), "\xef\xbb\xbf" + std::string(program), "// f\xfcr t, in Latin-1\nint main() {}\n"s,
          "MZ main() {}\n"s, "x"s, "%: include <cstdio>\n"s, "int main() {}\x1a"s, "PK 7z {rtf"s}) {
        EXPECT_EQ(why_no_source(source), "") << source;
    }
}

TEST(WhyNoSource, NamesTheFilesRealType) {
    for (const auto& [bytes, what] : {std::pair("%PDF-1.7\n%\xe2\xe3\n"s, "is a PDF; "),
                                      {"PK\x03\x04\x14\0"s, "is a zip or "},
                                      {"\x1f\x8b\x08\0"s, "is a gzip archive; "},
                                      {"\x7f"
                                       "ELF\x02\x01\0"s,
                                       "is a built program; "},
                                      {"MZ\x90\0\x03"s, "is a built program; "},
                                      {"\xcf\xfa\xed\xfe\x07\0"s, "is a built program; "},
                                      {"!<arch>\n/ "s, "is a built library; "},
                                      {"{\\rtf1\\ansi int main}"s, "is rich text (RTF); "},
                                      {"\x89PNG\r\n\x1a\n\0"s, "is a picture; "},
                                      {"\xff\xd8\xff\xe0\0"s, "is a picture; "},
                                      {"\xd0\xcf\x11\xe0\xa1\xb1"s, "is an office document; "}}) {
        EXPECT_THAT(why_no_source(bytes), StartsWith(what));
    }
}

TEST(WhyNoSource, RecognisesUtf16WithAndWithoutAByteOrderMark) {
    const std::string_view ascii = "#include <cstdio>\nint main() {}\n";
    const std::string little = as_utf_16(ascii, true), big = as_utf_16(ascii, false);
    for (const std::string& bytes : {"\xff\xfe" + little, "\xfe\xff" + big, little, big})
        EXPECT_EQ(why_no_source(bytes), "is saved as UTF-16; save it as UTF-8.");
    EXPECT_EQ(why_no_source("\xff\xfe\0\0i\0\0\0"s), "is saved as UTF-32; save it as UTF-8.");
}

TEST(WhyNoSource, GivesTheLineOfAZeroByte) {
    EXPECT_THAT(why_no_source("int main() {}\n// \0 there\n"s),
                StartsWith("contains bytes that are not text (a zero in line 2); "));
}

TEST(WhyNoSource, RecognisesEmptyAndBlankFiles) {
    for (const std::string& blank : {""s, " \t\r\n\f\v"s, "\xef\xbb\xbf"s, "\xef\xbb\xbf\n"s})
        EXPECT_THAT(why_no_source(blank), StartsWith("is empty; "));
}

}  // namespace
}  // namespace harness
