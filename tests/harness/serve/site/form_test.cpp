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

TEST(Form, RefusesAFormWithoutExactlyOneProgram) {
    EXPECT_THAT(source_of("text/plain", "int main() {}").problem, HasSubstr("send it again"));
    EXPECT_THAT(source_of(type, form(text_head, " \r\n\t")).problem, HasSubstr("empty"));
    EXPECT_THAT(source_of(type, form("Content-Disposition: form-data; name=\"other\"\r\n", "x")).problem,
                HasSubstr("did not send a program"));
    EXPECT_THAT(source_of(type, part(text_head, "a") + form(text_head, "b")).problem, HasSubstr("one program"));
}

TEST(Form, RefusesAFileThatIsNotASource) {
    EXPECT_THAT(source_of(type, form(file_head, "PK\x03\x04 and more")).problem, HasSubstr("is a zip"));
    EXPECT_THAT(source_of(type, form(file_head, "%PDF-1.7")).problem, HasSubstr("What you sent is a PDF; "));
    EXPECT_THAT(source_of(type, form(file_head, "\xff\xfei")).problem, HasSubstr("UTF-16; save it as UTF-8"));
    EXPECT_EQ(source_of(type, form(file_head, "%PDF-1.7")).source, "");
    EXPECT_EQ(source_of(type, form(file_head, "\xef\xbb\xbfint x;")).source, "\xef\xbb\xbfint x;");
}

TEST(Form, AcceptsExactlyAsManyBytesAsIntake) {
    const std::string most(largest_source_bytes, 'x');
    EXPECT_EQ(source_of(type, form(file_head, most)).source.size(), largest_source_bytes);
    EXPECT_THAT(source_of(type, form(file_head, most + 'x')).problem, HasSubstr("1 MiB"));
}

TEST(Form, IsRejectedIfCutOffAnywhere) {
    const std::string whole = part(text_head, "int main() {}") + "--X--";
    ASSERT_TRUE(parts_of(whole, "X"));
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_FALSE(parts_of(std::string_view(whole).substr(0, size), "X")) << size;
}

TEST(Form, IsRejectedIfItHasTooManyPartsOrAHeadThatIsTooLong) {
    std::string body;
    for (int i = 0; i < 8; ++i) body += part(text_head, "x");
    EXPECT_TRUE(parts_of(body + "--X--", "X"));
    EXPECT_FALSE(parts_of(body + part(text_head, "x") + "--X--", "X"));
    EXPECT_FALSE(parts_of(form(std::string(text_head) + "X-Long: " + std::string(5000, 'a') + "\r\n", "x"), "X"));
}

}  // namespace
}  // namespace harness::serve
