#include "harness/report/compile_error/compiler_hints.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace harness::report {
namespace {

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

std::string error(const std::string& message, int line = 1) {
    return "ray_cast.cpp:" + std::to_string(line) + ":9: error: " + message + "\n";
}

/// For "'double' and 'glm::vec3'", say.
std::string no_match(const std::string& sign, const std::string& operands) {
    return error("no match for 'operator" + sign + "' (operand types are " + operands + ")");
}

TEST(CompilerHints, KnowTheUsualMessages) {
    const std::string vec3 = "'glm::vec3' {aka 'glm::vec<3, float, glm::packed_highp>'}", std_ = "using namespace std;",
                      newer = " needs C++20 or newer, but programs are compiled as C++17. Do not use it.";
    const struct {
        std::string message, hint, source = "";  ///< a part of the only hint; empty if there is none
    } cases[] = {
        {"ray_cast.cpp: In function 'int main()':\n" + no_match("*", "'double' and " + vec3) +
             "ray_cast.cpp:3:57: note:   mismatched types 'const glm::vec<2, T, Q>' and 'double'\n",
         "Line 1: GLM has no * for double and glm::vec3. Make the number a float: declare it as float, or write "
         "float(x) for x and 2.0f for 2.0."},
        {no_match("/", vec3 + " and 'int'"), "no / for glm::vec3 and int. Make the number a float"},
        {no_match("*", "'glm::dmat4' {aka 'x'} and 'glm::vec4' {aka 'y'}"), "Use the same kind on both sides"},
        {no_match("*", "'glm::mat4' {aka 'x'} and 'glm::vec3' {aka 'y'}"), "A mat4 multiplies a vec4"},
        {no_match("*", "'std::string' {aka 'x'} and 'int'"), ""},
        {no_match("*", "'Ray' and 'double'"), ""},
        {no_match("*", "'float' and 'glm::vec3'"), ""},
        {no_match("*", "'a"), ""},
        {no_match("<<", "'double' and 'glm::vec3'"), ""},
        {error("'std::numbers' has not been declared"), "std::numbers" + newer},
        {error("'span' is not a member of 'std'") +
             "ray_cast.cpp:1:9: note: 'std::span' is defined in header '<span>'; this is only available from C++20\n",
         "std::span" + newer},
        {error("'numbers' has not been declared"), "std::numbers" + newer, std_},
        {error("'span' was not declared in this scope"), "std::span" + newer, std_},
        {error("'bit' was not declared in this scope"), "", std_},
        {error("'std::string' {aka 'class std::__cxx11::basic_string<char>'} has no member named 'starts_with'"),
         "std::starts_with" + newer},
        {error("'struct Box' has no member named 'contains'"), ""},
        {error("'using enum' only available with '-std=c++20' or '-std=gnu++20'"), "using enum" + newer},
        {error("'concept' does not name a type"), "concept" + newer},
        {error("expected primary-expression before '>' token"), "<=>" + newer, "a <=> b;"},
        {error("expected primary-expression before '>' token"), "", "a < > b;"},
        {error("'format' was not declared in this scope"), ""},
        {error("extended character \u00a0 is not valid in an identifier"), "Line 1: there is a no-break space",
         "int\u00a0x;"},
        {error("'\\U000000a0std' has not been declared"), "a no-break space", "\u00a0std::cout;"},
        {error("extended character \u201c is not valid in an identifier"), "a curly quote \u201c instead of \"",
         "f(\u201cx\u201d);"},
        {error("stray '\\240' in program"), "a no-break space", "int\xa0x;"},
        {error("stray '\\223' in program"), "a curly quote \u201c", "f(\x93x\x94);"},
        {error("expected ';' before '\\U00002014'"), "a dash \u2014", "x = 1 \u2014 2;"},
        {error("expected ';' before '\\U000000d7'"), "", "x = 1 \u00d7 2;"},
        {error("stray '`' in program"), "``` marks code", "```cpp"},
        {error("stray '#' in program"), "", "x # y;"},
        {"/usr/include/c++/12/bits/postypes.h:41:1: note: 'ptrdiff_t' is defined in header '<cstddef>'; did you forget "
         "to '#include <cstddef>'?\n",
         ""},
        {"/usr/include/glm/gtx/string_cast.inl:21:40: error: function 'std::string glm::detail::format(const char*, "
         "...)' can never be inlined because it uses variable argument lists\n",
         "Remove #define GLM_FORCE_INLINE"},
        {"In file included from ray_cast.cpp:2:\n/usr/include/glm/gtx/string_cast.hpp:24:3: error: #error \"GLM: "
         "GLM_GTX_string_cast is an experimental extension and may change in the future. Use #define "
         "GLM_ENABLE_EXPERIMENTAL before including it, if you really want to use it.\"\n",
         "Write #define GLM_ENABLE_EXPERIMENTAL above the first #include"},
        {error("'setprecision' was not declared in this scope"), "setprecision needs #include <iomanip>", std_},
        {error("'setprecision' was not declared in this scope"), "", "// a function of the student's own\n"},
        {error("'setfill' was not declared in this scope"), "setfill needs #include <iomanip>", std_},
        {error("\u2018sqrt\u2019 was not declared in this scope"), "#include <cmath>"},
        {error("'to_string' is not a member of 'glm'"), "glm::to_string needs #include <glm/gtx/string_cast.hpp>"},
        {error("'glm' has not been declared"), "Line 1: glm needs #include <glm/glm.hpp> at the top of the source."},
        {error("'vup' was not declared in this scope"), ""},
    };
    for (const auto& [message, hint, source] : cases) {
        if (hint.empty()) {
            EXPECT_THAT(compiler_hints(message, source), IsEmpty()) << message;
        } else {
            EXPECT_THAT(compiler_hints(message, source), ElementsAre(HasSubstr(hint))) << message;
        }
    }
}

TEST(CompilerHints, NameEachHeaderOnce) {
    const std::string
        cout = error("'cout' is not a member of 'std'") +
               "ray_cast.cpp:1:1: note: 'std::cout' is defined in header '<iostream>'; did you forget to "
               "'#include <iostream>'?\n",
        end = " at the top of the source. Other versions of the compiler may accept the program without it.";
    EXPECT_THAT(compiler_hints(cout + cout, ""), ElementsAre("std::cout needs #include <iostream>" + end));
    EXPECT_THAT(compiler_hints(error("'setprecision' is not a member of 'std'", 2) +
                                   error("'sqrt' was not declared in this scope", 3),
                               ""),
                ElementsAre("Line 2: std::setprecision needs #include <iomanip>" + end,
                            "Line 3: sqrt needs #include <cmath>" + end));
}

TEST(CompilerHints, FindTheHeaderThatWasMeant) {
    const std::string glm = "Line 1: write #include <glm/glm.hpp>",
                      string_cast = "write #include <glm/gtx/string_cast.hpp>.",
                      other_case = "; on Linux, file names are case-sensitive.";
    const std::pair<std::string, std::string> cases[] = {
        {"../glm/glm/glm.hpp", glm},
        {"glm/glm/glm.hpp", glm},
        {"../glm.hpp", glm},
        {"C:\\libs\\glm\\glm\\glm.hpp", glm},
        {"GLM/glm.hpp", glm},
        {"/opt/homebrew/include/glm/glm.hpp", glm},
        {"glm-0.9.9.8/glm/glm.hpp", glm},
        {"../../external/glm-master/glm.hpp", glm},
        {"./glm/glm.h", glm},
        {"glm", glm},
        {"glm.hpp", glm + "."},
        {"glm/glm", glm + "."},
        {"Glm/glm.hpp", glm + other_case},
        {"Iostream", "Line 1: write #include <iostream>" + other_case},
        {"../include/glm/gtx/rotate_vector.hpp", "write #include <glm/gtx/rotate_vector.hpp>"},
        {"glm\\gtx\\string_cast.hpp", string_cast},
        {"string_cast.hpp", string_cast},
        {"glm/gtx/none.hpp", "does not have glm/gtx/none.hpp"},
        {"eigen3/Eigen/Dense", "Use the standard library and GLM"},
        {"format", "Line 1: <format> needs C++20 or newer"},
        {"windows.h", "windows.h is a header of Windows, but programs are compiled on Linux. Remove it"},
        {"Windows.h", "of Windows"},
        {"OpenGL/gl.h", "of macOS"},
        {"stdafx.h", "of Visual Studio"},
    };
    for (const auto& [header, hint] : cases)
        EXPECT_THAT(missing_header(header), ElementsAre(HasSubstr(hint))) << header;
    for (const char* own : {"vec.h", "utils/matrix.hpp"}) {
        EXPECT_THAT(missing_header(own, std::string("#include \"") + own + "\"\n"),
                    ElementsAre(HasSubstr("because you hand in only one source file. Copy the code you need")));
    }
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
