#include "harness/report/compile_error/compiler_hints.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace harness::report {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// The messages are those of g++ 12.2 and Debian 12's linkers.

std::vector<std::string> missing_header(const std::string& header, const std::string& source = "") {
    return compiler_hints("ray_cast.cpp:1:10: fatal error: " + header +
                              ": No such file or directory\n    1 | #include <" + header +
                              ">\n      |          ^~~~\ncompilation terminated.\n",
                          source);
}

TEST(CompilerHints, SayThatGlmNeedsAFloat) {
    const std::string message =
        "ray_cast.cpp: In function 'int main()':\nray_cast.cpp:3:56: error: no match for 'operator*' (operand types "
        "are "
        "'double' and 'glm::vec3' {aka 'glm::vec<3, float, glm::packed_highp>'})\n"
        "ray_cast.cpp:3:57: note:   mismatched types 'const glm::vec<2, T, Q>' and 'double'\n";
    EXPECT_THAT(compiler_hints(message, ""),
                ElementsAre("Line 3: GLM has no * for double and glm::vec3. Make the number a float: declare it as "
                            "float, or write float(x) for x and 2.0f for 2.0."));
    EXPECT_THAT(compiler_hints("ray_cast.cpp:9:1: error: no match for 'operator/' (operand types are 'glm::vec3' {aka "
                               "'glm::vec<3, float, glm::packed_highp>'} and 'int')\n",
                               ""),
                ElementsAre(HasSubstr("no / for glm::vec3 and int. Make the number a float")));
    EXPECT_THAT(compiler_hints("ray_cast.cpp:9:1: error: no match for 'operator*' (operand types are 'glm::dmat4' {aka "
                               "'x'} and 'glm::vec4' {aka 'y'})\n",
                               ""),
                ElementsAre(HasSubstr("Use the same kind on both sides")));
    EXPECT_THAT(compiler_hints("ray_cast.cpp:9:1: error: no match for 'operator*' (operand types are 'glm::mat4' {aka "
                               "'x'} and 'glm::vec3' {aka 'y'})\n",
                               ""),
                ElementsAre(HasSubstr("A mat4 multiplies a vec4")));
}

TEST(CompilerHints, NameTheHeaderOfGlmThatAPathToACopyOfItMeans) {
    for (const char* path : {"../glm/glm/glm.hpp", "glm/glm/glm.hpp", "../glm.hpp", "C:\\libs\\glm\\glm\\glm.hpp",
                             "GLM/glm.hpp", "/opt/homebrew/include/glm/glm.hpp", "glm-0.9.9.8/glm/glm.hpp",
                             "../../external/glm-master/glm.hpp", "./glm/glm.h", "glm.hpp", "glm"})
        EXPECT_THAT(missing_header(path), ElementsAre(HasSubstr("write #include <glm/glm.hpp>"))) << path;
    EXPECT_THAT(missing_header("../include/glm/gtx/rotate_vector.hpp"),
                ElementsAre(HasSubstr("write #include <glm/gtx/rotate_vector.hpp>")));
    EXPECT_THAT(missing_header("utils/matrix.hpp", "#include \"utils/matrix.hpp\""),
                ElementsAre(HasSubstr("you hand in only one source file")));
    EXPECT_THAT(missing_header("glm/gtx/none.hpp"), ElementsAre(HasSubstr("does not have glm/gtx/none.hpp")));
}

TEST(CompilerHints, NameFeaturesThatAreNewerThanTheStandard) {
    const auto is_of = [](const std::string& what) {
        return ElementsAre("Line 1: " + what +
                           " needs C++20 or newer, but programs are compiled as C++17. Do not use it.");
    };
    EXPECT_THAT(missing_header("format"), is_of("<format>"));
    EXPECT_THAT(compiler_hints("ray_cast.cpp:1:9: error: 'std::numbers' has not been declared\n", ""),
                is_of("std::numbers"));
    EXPECT_THAT(compiler_hints("ray_cast.cpp:1:9: error: 'span' is not a member of 'std'\nray_cast.cpp:1:9: note: "
                               "'std::span' is defined in header '<span>'; this is only available from C++20 onwards\n",
                               ""),
                is_of("std::span"));
    EXPECT_THAT(compiler_hints("ray_cast.cpp:1:9: error: 'numbers' has not been declared\n", "using namespace std;"),
                is_of("std::numbers"));
    EXPECT_THAT(
        compiler_hints("ray_cast.cpp:1:9: error: 'span' was not declared in this scope\n", "using namespace std;"),
        is_of("std::span"));
    EXPECT_THAT(
        compiler_hints("ray_cast.cpp:1:9: error: 'bit' was not declared in this scope\n", "using namespace std;"),
        IsEmpty());
    EXPECT_THAT(compiler_hints("ray_cast.cpp:1:9: error: 'std::string' {aka 'class std::__cxx11::basic_string<char>'} "
                               "has no member named 'starts_with'\n",
                               ""),
                is_of("std::starts_with"));
    EXPECT_THAT(compiler_hints("ray_cast.cpp:1:9: error: 'struct Box' has no member named 'contains'\n", ""),
                IsEmpty());
    EXPECT_THAT(compiler_hints("ray_cast.cpp:1:9: error: 'using enum' only available with '-std=c++20' or "
                               "'-std=gnu++20'\n",
                               ""),
                is_of("using enum"));
    EXPECT_THAT(compiler_hints("ray_cast.cpp:1:22: error: 'concept' does not name a type\n", ""), is_of("concept"));
    EXPECT_THAT(compiler_hints("ray_cast.cpp:1:9: error: expected primary-expression before '>' token\n", "a <=> b;"),
                is_of("<=>"));
    EXPECT_THAT(compiler_hints("ray_cast.cpp:1:9: error: expected primary-expression before '>' token\n", "a < > b;"),
                IsEmpty());
    EXPECT_THAT(compiler_hints("ray_cast.cpp:1:9: error: 'format' was not declared in this scope\n", ""), IsEmpty());
}

TEST(CompilerHints, MentionCharactersFromCopiedText) {
    const auto hint = [](const std::string& message, const std::string& source) {
        return compiler_hints("ray_cast.cpp:1:2: error: " + message + "\n", source);
    };
    EXPECT_THAT(hint("extended character \u00a0 is not valid in an identifier", "int\u00a0x;"),
                ElementsAre(HasSubstr("Line 1: there is a no-break space")));
    EXPECT_THAT(hint("'\\U000000a0std' has not been declared", "\u00a0std::cout;"),
                ElementsAre(HasSubstr("a no-break space")));
    EXPECT_THAT(hint("extended character \u201c is not valid in an identifier", "f(\u201cx\u201d);"),
                ElementsAre(HasSubstr("a curly quote \u201c instead of \"")));
    EXPECT_THAT(hint("stray '\\240' in program", "int\xa0x;"), ElementsAre(HasSubstr("a no-break space")));
    EXPECT_THAT(hint("stray '\\223' in program", "f(\x93x\x94);"), ElementsAre(HasSubstr("a curly quote \u201c")));
    EXPECT_THAT(hint("expected ';' before '\\U00002014'", "x = 1 \u2014 2;"), ElementsAre(HasSubstr("a dash \u2014")));
    EXPECT_THAT(hint("expected ';' before '\\U000000d7'", "x = 1 \u00d7 2;"), IsEmpty());
    EXPECT_THAT(hint("stray '`' in program", "```cpp"), ElementsAre(HasSubstr("``` marks code")));
    EXPECT_THAT(hint("stray '#' in program", "x # y;"), IsEmpty());
}

TEST(CompilerHints, IgnoreNotesAboutHeaders) {
    EXPECT_THAT(compiler_hints("/usr/include/c++/12/bits/postypes.h:41:1: note: 'ptrdiff_t' is defined in header "
                               "'<cstddef>'; did you forget to '#include <cstddef>'?\n",
                               ""),
                IsEmpty());
}

TEST(CompilerHints, KnowThatGlmForceInlineDoesNotCompile) {
    EXPECT_THAT(compiler_hints("/usr/include/glm/gtx/string_cast.inl:21:40: error: function 'std::string "
                               "glm::detail::format(const char*, ...)' can never be inlined because it uses variable "
                               "argument lists\n",
                               ""),
                ElementsAre(HasSubstr("Remove #define GLM_FORCE_INLINE")));
}

TEST(CompilerHints, FindANameOfStdWithoutItsPrefix) {
    const std::string message = "ray_cast.cpp:3:31: error: 'setprecision' was not declared in this scope\n";
    EXPECT_THAT(compiler_hints(message, "using namespace std;\n"),
                ElementsAre(HasSubstr("setprecision needs #include <iomanip>")));
    EXPECT_THAT(compiler_hints(message, "// a function of the student's own\n"), IsEmpty());
    EXPECT_THAT(
        compiler_hints("ray_cast.cpp:3:9: error: 'setfill' was not declared in this scope\n", "using namespace std;\n"),
        ElementsAre(HasSubstr("setfill needs #include <iomanip>")));
}

TEST(CompilerHints, NameTheLineWithoutASemicolon) {
    const std::string source = "int main() {\n    int x = 3\n\n    // y\n    int y = 4;\n    return 0\n}\n";
    EXPECT_THAT(compiler_hints("ray_cast.cpp:5:5: error: expected ',' or ';' before 'int'\n", source),
                ElementsAre("Line 2: this statement needs a ; at its end."));
    EXPECT_THAT(compiler_hints("ray_cast.cpp:6:13: error: expected ';' before '}' token\n", source),
                ElementsAre("Line 6: this statement needs a ; at its end."));
    for (const char* elsewhere : {"ray_cast.cpp:5:9: error: expected ',' or ';' before 'y'\n",
                                  "ray_cast.cpp:1:1: error: expected ',' or ';' before 'int'\n",
                                  "ray_cast.cpp:99:1: error: expected ',' or ';' before 'int'\n",
                                  "ray_cast.cpp:5:1: error: expected ',' or ';' before '\n"})
        EXPECT_THAT(compiler_hints(elsewhere, source), IsEmpty()) << elsewhere;
}

TEST(CompilerHints, IgnoreUnknownOperands) {
    for (const char* operands :
         {"'std::string' {aka 'x'} and 'int'", "'Ray' and 'double'", "'float' and 'glm::vec3'", "'a"}) {
        EXPECT_THAT(
            compiler_hints(
                std::string("ray_cast.cpp:9:1: error: no match for 'operator*' (operand types are ") + operands + ")\n",
                ""),
            IsEmpty())
            << operands;
    }
    EXPECT_THAT(compiler_hints("ray_cast.cpp:9:1: error: no match for 'operator<<' (operand types are 'double' and "
                               "'glm::vec3')\n",
                               ""),
                IsEmpty());
}

TEST(CompilerHints, NameTheHeaderThatANameNeeds) {
    EXPECT_THAT(
        compiler_hints("ray_cast.cpp:2:40: error: 'cout' is not a member of 'std'\n"
                       "ray_cast.cpp:2:1: note: 'std::cout' is defined in header '<iostream>'; did you forget to "
                       "'#include <iostream>'?\n"
                       "ray_cast.cpp:7:40: error: 'cout' is not a member of 'std'\n"
                       "ray_cast.cpp:7:1: note: 'std::cout' is defined in header '<iostream>'; did you forget to "
                       "'#include <iostream>'?\n",
                       ""),
        ElementsAre("std::cout needs #include <iostream> at the top of the source. Other versions of the compiler may "
                    "accept the program without it."));
    EXPECT_THAT(compiler_hints("ray_cast.cpp:2:102: error: 'setprecision' is not a member of 'std'\n"
                               "ray_cast.cpp:2:130: error: 'to_string' is not a member of 'glm'\n"
                               "ray_cast.cpp:2:9: error: 'sqrt' was not declared in this scope\n"
                               "ray_cast.cpp:1:9: error: 'glm' has not been declared\n"
                               "ray_cast.cpp:9:9: error: 'vup' was not declared in this scope\n",
                               ""),
                ElementsAre("Line 2: std::setprecision needs #include <iomanip> at the top of the source. Other "
                            "versions of the compiler may accept the program without it.",
                            "Line 2: glm::to_string needs #include <glm/gtx/string_cast.hpp> at the top of the source.",
                            "Line 2: sqrt needs #include <cmath> at the top of the source. Other versions of the "
                            "compiler may accept the program without it.",
                            "Line 1: glm needs #include <glm/glm.hpp> at the top of the source."));
    EXPECT_THAT(
        compiler_hints("In file included from ray_cast.cpp:2:\n/usr/include/glm/gtx/string_cast.hpp:24:3: error: "
                       "#error \"GLM: GLM_GTX_string_cast is an experimental extension and may change in the "
                       "future. Use #define GLM_ENABLE_EXPERIMENTAL before including it, if you really want to "
                       "use it.\"\n",
                       ""),
        ElementsAre(HasSubstr("Write #define GLM_ENABLE_EXPERIMENTAL above the first #include")));
}

TEST(CompilerHints, ReadOtherQuotationMarksToo) {
    EXPECT_THAT(compiler_hints("ray_cast.cpp:2:9: error: ‘sqrt’ was not declared in this scope\n", ""),
                ElementsAre(HasSubstr("#include <cmath>")));
}

TEST(CompilerHints, NameTheSystemOfAHeader) {
    EXPECT_THAT(missing_header("windows.h"),
                ElementsAre("Line 1: windows.h is a header of Windows, but programs are compiled on Linux. "
                            "Remove it and the code that needs it."));
    EXPECT_THAT(missing_header("Windows.h"), ElementsAre(HasSubstr("of Windows")));
    EXPECT_THAT(missing_header("OpenGL/gl.h"), ElementsAre(HasSubstr("of macOS")));
    EXPECT_THAT(missing_header("stdafx.h"), ElementsAre(HasSubstr("of Visual Studio")));
}

TEST(CompilerHints, FindTheHeaderThatWasMeant) {
    const std::string other_case = "; on Linux, file names are case-sensitive.";
    EXPECT_THAT(missing_header("Glm/glm.hpp"), ElementsAre("Line 1: write #include <glm/glm.hpp>" + other_case));
    EXPECT_THAT(missing_header("Iostream"), ElementsAre("Line 1: write #include <iostream>" + other_case));
    EXPECT_THAT(missing_header("glm.hpp"), ElementsAre("Line 1: write #include <glm/glm.hpp>."));
    EXPECT_THAT(missing_header("glm\\gtx\\string_cast.hpp"),
                ElementsAre("Line 1: write #include <glm/gtx/string_cast.hpp>."));
    EXPECT_THAT(missing_header("glm/glm"), ElementsAre("Line 1: write #include <glm/glm.hpp>."));
    EXPECT_THAT(missing_header("string_cast.hpp"), ElementsAre("Line 1: write #include <glm/gtx/string_cast.hpp>."));
    EXPECT_THAT(missing_header("vec.h", "#include \"vec.h\"\n"),
                ElementsAre("Line 1: the grader does not have vec.h, because you hand in only one source file. Copy "
                            "the code you need into that file."));
    EXPECT_THAT(missing_header("eigen3/Eigen/Dense"), ElementsAre(HasSubstr("Use the standard library and GLM")));
}

TEST(CompilerHints, FindTheFunctionThatIsMeantToBeMain) {
    const std::string of_ld =
        "/usr/bin/ld: /usr/lib/gcc/x86_64-linux-gnu/12/../../../x86_64-linux-gnu/Scrt1.o: in function `_start':\n"
        "(.text+0x17): undefined reference to `main'\ncollect2: error: ld returned 1 exit status\n";
    const std::string of_gold =
        "/usr/lib/gcc/x86_64-linux-gnu/12/../../../x86_64-linux-gnu/Scrt1.o:function _start: error: undefined "
        "reference to "
        "'main'\ncollect2: error: ld returned 1 exit status\n";
    const std::string of_mold = "mold: error: undefined symbol: main\n>>> referenced by <artificial>\n";
    for (const std::string& message : {of_ld, of_gold, of_mold}) {
        EXPECT_THAT(compiler_hints(message, "float x;\nint Main() {\n}\n"),
                    ElementsAre("The source has no main function. Line 2: should Main be main?"));
    }
    EXPECT_THAT(compiler_hints(of_gold, "int mian (int, char**) {}\n"), ElementsAre(HasSubstr("should mian be main")));
    EXPECT_THAT(compiler_hints(of_gold, "int WINAPI WinMain(HINSTANCE) {}\n"),
                ElementsAre(HasSubstr("should WinMain be main")));
    EXPECT_THAT(compiler_hints(of_gold, "glm::vec3 cross(glm::vec3);\n"),
                ElementsAre("The source has no main function. Write int main() { … }."));
    EXPECT_THAT(compiler_hints(
                    "x.o: in function `main':\nray_cast.cpp:(.text+0x5): undefined reference to `main_loop()'\n", ""),
                IsEmpty());
}

TEST(CompilerHints, AreFewAndStandHostileBytes) {
    std::string many;
    for (int i = 1; i <= 40; ++i)
        many += "ray_cast.cpp:" + std::to_string(i) + ":1: error: 'sqrt' was not declared in this scope\n";
    EXPECT_EQ(compiler_hints(many, "").size(), 5U);
    EXPECT_EQ(compiler_hints(many, "", 2).size(), 2U);
    for (const char* text :
         {"ray_cast.cpp:1:1: error: no match for 'operator", "ray_cast.cpp:1:1: error: '", "''''\n'",
          "ray_cast.cpp:1:1: error: : No such file or directory", "x: note: '' is defined in header ''", "\xE2\x80",
          "undefined reference to `", "\xff\x1b'\n"})
        compiler_hints(text, text);
    EXPECT_THAT(compiler_hints("", ""), IsEmpty());
}

TEST(CompilerHints, AreOnlyForASourceThatDoesNotCompile) {
    Graded graded;
    graded.execution.build.diagnostics = "ray_cast.cpp:2:9: error: 'sqrt' was not declared in this scope\n";
    graded.execution.outcome = Outcome::graded;
    EXPECT_THAT(compiler_hints(graded), IsEmpty());
    graded.execution.outcome = Outcome::compile_error;
    EXPECT_THAT(compiler_hints(graded), ElementsAre(HasSubstr("cmath")));
}

}  // namespace
}  // namespace harness::report
