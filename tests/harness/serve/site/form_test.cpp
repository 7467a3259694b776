#include "harness/serve/site/form.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/intake/intake.h"
#include "harness/intake/source_file.h"

namespace harness::serve {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::string_view type = "multipart/form-data; boundary=X";
constexpr std::string_view file_head =
    "Content-Disposition: form-data; name=\"source\"; filename=\"ray_cast.cpp\"\r\nContent-Type: text/x-c++src\r\n";
constexpr std::string_view text_head = "Content-Disposition: form-data; name=\"source\"\r\n";

std::string part(std::string_view head, std::string_view content) {
    return "--X\r\n" + std::string(head) + "\r\n" + std::string(content) + "\r\n";
}

std::string form(std::string_view head, std::string_view content) {
    return part(head, content) + "--X--\r\n";
}

TEST(Boundary, IsReadFromTheContentType) {
    EXPECT_EQ(boundary_of("multipart/form-data; boundary=----WebKitFormBoundaryAb1"), "----WebKitFormBoundaryAb1");
    EXPECT_EQ(boundary_of("Multipart/Form-Data;charset=utf-8; BOUNDARY=\"a b:c\""), "a b:c");
}

TEST(Boundary, IsEmptyForADifferentTypeOrForm) {
    for (const std::string& wrong :
         {std::string("text/plain"), std::string("application/x-www-form-urlencoded; boundary=X"),
          std::string("multipart/form-data"), std::string("multipart/form-data; boundary="),
          std::string("multipart/form-data; boundary=\"ends with a space \""),
          std::string("multipart/form-data; boundary=\"no end"), std::string("multipart/form-data; boundary=a\r\nb"),
          "multipart/form-data; boundary=" + std::string(71, 'a')}) {
        EXPECT_EQ(boundary_of(wrong), std::nullopt) << wrong;
    }
}

TEST(Form, ReturnsAFilesBytesUnchanged) {
    const std::string bytes("int main() {}\r\n--Y is no end\r\n\1\xff", 32);
    const HandedIn handed = source_of(type, form(file_head, bytes));
    EXPECT_THAT(handed.problem, IsEmpty());
    EXPECT_EQ(handed.source, bytes);
}

TEST(Form, ConvertsPastedLinesToLinuxLineEnds) {
    EXPECT_EQ(source_of(type, form(text_head, "int main()\r\n{\r\n}\r\n")).source, "int main()\n{\n}\n");
}

TEST(Form, IgnoresOtherFieldsAndNames) {
    const std::string body =
        part("content-disposition: form-data; name=other\r\n", "x") +
        part("Content-Disposition: form-data; name=\"source\"; filename=\"../../a \\\" b.cpp\"\r\n", "int main() {}") +
        "--X--";
    EXPECT_EQ(source_of(type, body).source, "int main() {}");
}

TEST(Form, ReturnsAPrintableFileName) {
    const auto name = [](const std::string& field) {
        return source_of(type, form("Content-Disposition: form-data; name=\"source\"" + field + "\r\n", "int x;")).file;
    };
    EXPECT_EQ(name("; filename=\"my <b> try.cpp\""), "my <b> try.cpp");
    EXPECT_EQ(name("; filename=\"C:\\\\work\\\\ray.cpp\""), "ray.cpp");
    EXPECT_EQ(name("; filename=\"../../etc/ray.cpp\""), "ray.cpp");
    EXPECT_EQ(name("; filename=\"a\x1b\xff.cpp\""), "a%1B%FF.cpp");
    EXPECT_EQ(name("; filename=\"\""), "ray_cast.cpp");
    EXPECT_EQ(name("; filename=" + std::string(3000, 'x')), std::string(100, 'x'));
    EXPECT_EQ(name(""), "pasted text");
}

TEST(Form, AcceptsExactlyAsManyBytesAsIntake) {
    const std::string most(largest_source_bytes, 'x');
    EXPECT_EQ(source_of(type, form(file_head, most)).source.size(), largest_source_bytes);
    EXPECT_THAT(source_of(type, form(file_head, most + 'x')).problem, HasSubstr("1 MiB"));
}

}  // namespace
}  // namespace harness::serve
