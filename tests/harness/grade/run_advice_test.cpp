#include "harness/grade/run_advice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace harness {
namespace {

using testing::AllOf;
using testing::HasSubstr;

ProcessResult that_printed(const std::string& output, const std::string& errors = "") {
    ProcessResult run;
    run.ended = Ended::exited;
    run.output = output;
    run.errors = errors;
    return run;
}

TEST(RunAdvice, NamesTheLineThatReadsInput) {
    for (const char* source :
         {"int x;\nstd::cin >> x;", "int x;\nscanf(\"%d\", &x);", "\ngetline(cin, s);", "\nc = getchar();",
          "\ncin.getline(s, 80);", "\nfgets(s, 80, stdin);", "\nwhile (std::cin.get() != 'q');", "\ncin.get(c);",
          "\nistream& in = std::cin;", "\nfscanf(stdin, f, &x);", "\nwhile (getchar() != 'q');"})
        EXPECT_THAT(run_advice(source, that_printed("x")), HasSubstr("ray_cast.cpp:2 reads input")) << source;
    for (const char* source : {"// cin >> x;", "std::cin.get();", "\"cin >> x\"", "getchar();", "getline(words, s);",
                               "using std::cin;", "cin.tie(0);", "f(); cin.ignore(80, c);", "fflush(stdin);"})
        EXPECT_EQ(run_advice(source, that_printed("x")), "") << source;
}

TEST(RunAdvice, NamesAMatrixThatIsUsedBeforeItHasAValue) {
    for (const char* source : {"glm::mat4 m;\nm = glm::translate(m, v);", "mat4 m; p = m * q;", "mat3 m; n = k * m;",
                               "mat4 a, m; p = m * q;", "mat4 m; m *= q;"})
        EXPECT_THAT(run_advice(source, that_printed("x")),
                    AllOf(HasSubstr("ray_cast.cpp:1: GLM does not make m the identity matrix"), HasSubstr("m(1.0f)")))
            << source;
    for (const char* source : {"glm::mat4 m = glm::mat4();\nm = glm::translate(m, v);", "m = translate(mat4{}, v);",
                               "auto m = mat4(); p = m * q;", "p = glm::mat4() * q;"})
        EXPECT_THAT(run_advice(source, that_printed("x")),
                    HasSubstr("ray_cast.cpp:1: GLM does not make mat4() the identity matrix; write mat4(1.0f)."))
            << source;
    for (const char* source : {"glm::mat4 m(1.0f);\nm = glm::translate(m, v);", "mat4 m; m = a; p = m * q;",
                               "mat4 m; m[0] = a; p = m * q;", "mat4 m; m = translate(a, v); p = m * q;",
                               "mat4 m; fill(m); p = m * q;", "struct S { mat4 m; }; p = s.m * q;",
                               "mat4 m = mat4(); m[0] = a; p = m * q;", "vec4 f(mat4 m, vec4 v) { return m * v; }",
                               "mat4 f();\np = f * q;", "#define GLM_FORCE_CTOR_INIT\nmat4 m; p = m * q;"})
        EXPECT_EQ(run_advice(source, that_printed("x")), "") << source;
}

TEST(RunAdvice, ReportsAMissingLocale) {
    EXPECT_THAT(run_advice("", that_printed("",
                                            "terminate called after throwing an instance of 'std::runtime_error'\n"
                                            "  what():  locale::facet::_S_create_c_locale name not valid\n")),
                HasSubstr("locale"));
}

TEST(RunAdvice, ReportsAnswersOnlyOnStandardError) {
    EXPECT_THAT(run_advice("", that_printed("", "Question 1")), HasSubstr("only to standard error (std::cerr)"));
    EXPECT_THAT(run_advice("", that_printed("Ray casting\n", "Question 1")), HasSubstr("only to standard error"));
    EXPECT_EQ(run_advice("", that_printed("Question 1", "debug 1")), "");
    EXPECT_EQ(run_advice("", that_printed("", "cannot open scene.txt")), "");
    EXPECT_EQ(run_advice("", that_printed("", "")), "");
}

}  // namespace
}  // namespace harness
