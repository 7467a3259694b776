#include "harness/build/include_block.h"

#include <gmock/gmock.h>

namespace {

using harness::include_block;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> texts(std::string_view source) {
    std::vector<std::string> texts;
    for (const auto& directive : include_block(source)) texts.push_back(directive.text);
    return texts;
}

TEST(IncludeBlock, TakesTheLeadingDirectivesInTheirOrder) {
    EXPECT_THAT(texts("#define GLM_ENABLE_EXPERIMENTAL\n#include <iostream>\n\n#include <glm/glm.hpp>\nint a;\n"),
                ElementsAre("#define GLM_ENABLE_EXPERIMENTAL", "#include <iostream>", "#include <glm/glm.hpp>"));
    EXPECT_THAT(texts("#include <b>\n#include <a>\n"), ElementsAre("#include <b>", "#include <a>"));
}

TEST(IncludeBlock, SkipsCommentsAndEmptyLines) {
    EXPECT_THAT(
        texts("// me\n/* a\n b */\n\n  #include <iostream> // cout\n\t\n#define A 1 /* one */\n/**/#include <b>"),
        ElementsAre("#include <iostream>", "#define A 1", "#include <b>"));
}

TEST(IncludeBlock, NormalisesBlanks) {
    EXPECT_THAT(texts("#include<a>\n #  include\t\"glm/glm.hpp\"  \r\n#\tdefine  A\r\n"),
                ElementsAre("#include <a>", "#include \"glm/glm.hpp\"", "#define A"));
    EXPECT_THAT(texts("\xef\xbb\xbf#include <a>\n"), ElementsAre("#include <a>"));
}

TEST(IncludeBlock, EndsAtTheFirstOtherLine) {
    for (const char* other : {"int a;", "using namespace std;", "#undef A", "#if 1", "#ifndef A", "#error x",
                              "#include_next <b>", "#import <b>", "#", "#line 7", "# 7 \"x\"", "%:include <b>",
                              "?\?=include <b>", ";", "\x01", "\f", "\\", "#includes <b>", "#defined A"}) {
        EXPECT_THAT(texts(std::string("#include <a>\n") + other + "\n#include <c>\n"), ElementsAre("#include <a>"))
            << other;
    }
}

TEST(IncludeBlock, LeavesIncludesThatMayNotBeSystemHeaders) {
    for (const char* odd : {"#include MACRO",
                            "#include \"local.h\"",
                            "#include \"../glm/glm.hpp\"",
                            "#include \"./glm/glm.hpp\"",
                            "#include \"/etc/passwd\"",
                            "#include <../a>",
                            "#include </dev/stdin>",
                            "#include <a/../b>",
                            "#include <a//b>",
                            "#include <a",
                            "#include <>",
                            "#include \"\"",
                            "#include",
                            "#include <a> <b>",
                            "#include <a>;",
                            "#include <a>x",
                            "#include <a\"",
                            "#include <a b>",
                            "#include <a\\b>",
                            "#include <\xc3\xa9>"}) {
        EXPECT_THAT(texts(std::string(odd) + "\n#include <c>\n"), IsEmpty()) << odd;
    }
}

TEST(IncludeBlock, LeavesDefinesThatCouldHideAComment) {
    for (const char* odd : {"#define A \"//\"", "#define A '\"'", "#define A R\"(", "#define A \\", "#define A \\ \nB",
                            "#define A 1 ?\?/", "#define A+1", "#define 1 2", "#define", "#defineA", "#define A \x80",
                            "#define A /* 1 */ 2", "#define A /* 1\n */ 2", "#define A 1\f", "#define A 1\rB"}) {
        EXPECT_THAT(texts(std::string(odd) + "\n#include <c>\n"), IsEmpty()) << odd;
    }
    EXPECT_THAT(texts("#define SQR(x) ((x)*(x)/2)\n#define cat(a, b) a##b\n"),
                ElementsAre("#define SQR(x) ((x)*(x)/2)", "#define cat(a, b) a##b"));
}

TEST(IncludeBlock, EndsBeforeACommentContinuedByABackslash) {
    EXPECT_THAT(texts("#include <a>\n// more \\\n#include <b>\n#include <c>\n"), ElementsAre("#include <a>"));
    EXPECT_THAT(texts("#include <a>\n// more \\ \t\r\n#include <b>\n"), ElementsAre("#include <a>"));
    EXPECT_THAT(texts("#include <a>\n// more ?\?/\n#include <b>\n"), ElementsAre("#include <a>"));
    EXPECT_THAT(texts("#include <a> // more \\\n#include <b>\n"), IsEmpty());
    EXPECT_THAT(texts("#include <a>\n/* *\\\n/\n#include <b>\n/* */\n#include <c>\n"), ElementsAre("#include <a>"));
    EXPECT_THAT(texts("#include <a>\n/* *?\?/\n/\n#include <b>\n/* */\n#include <c>\n"), ElementsAre("#include <a>"));
    EXPECT_THAT(texts(std::string("#include <a>\n/* \0 */\n#include <b>\n", 32)), ElementsAre("#include <a>"));
    EXPECT_THAT(texts("#include <a>\n/* open\n#include <b>\n"), ElementsAre("#include <a>"));
    EXPECT_THAT(texts("#include <a> /* over\nlines */ int b;\n"), IsEmpty());
    EXPECT_THAT(texts("#define A /* over\nlines */ 2\n"), IsEmpty()) << "the 2 belongs to it";
    EXPECT_THAT(texts("#include <a> /* over\nlines */\n#include <b>\n"), ElementsAre("#include <a>", "#include <b>"));
    EXPECT_THAT(texts("// C:\\folder\n#include <a>\n"), ElementsAre("#include <a>"));
}

TEST(IncludeBlock, IsEmptyIfTheSourceUsesItsPlaceOrTime) {
    for (const char* asks :
         {"int n = __COUNTER__;", "__INCLUDE_LEVEL__", "__BASE_FILE__", "__DATE__", "__TIME__", "__TIMESTAMP__",
          "__FILE__", "#pragma once", "_Pragma(\"pack(1)\")", "__COUN\\\nTER__", "__FI\\ \t\nLE__"}) {
        EXPECT_THAT(texts(std::string("#include <a>\n") + asks + "\n"), IsEmpty()) << asks;
    }
}

TEST(IncludeBlock, AcceptsEmptyAndCutOffSources) {
    for (const char* source : {"", "\n", "#", "//", "/*", "/", "#include", "#include <", "#define ", "\xef\xbb\xbf"})
        EXPECT_THAT(texts(source), IsEmpty()) << source;
}

}  // namespace
