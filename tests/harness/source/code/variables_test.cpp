// Where a source sets a variable. The expected lines are read off by a person.
#include "harness/source/code/variables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace harness::source {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

int line_of(const std::string& source, const Word& word) {
    return 1 +
           static_cast<int>(std::count(source.begin(), source.begin() + static_cast<std::ptrdiff_t>(word.begin), '\n'));
}

/// The use of a name that stands behind "show".
std::size_t shown(const std::vector<Word>& words) {
    for (std::size_t i = 0; i + 2 < words.size(); ++i) {
        if (words[i].text == "show") return i + 2;
    }
    return nowhere;
}

/// The lines that set what show(…) is given; those that only may set it have a minus.
std::vector<int> settings(const std::string& source) {
    const std::vector<Word> words = words_of(source);
    std::vector<int> lines;
    for (const Setting& each : Variables(words).settings_of(shown(words)))
        lines.push_back(each.surely ? line_of(source, words[each.at]) : -line_of(source, words[each.at]));
    return lines;
}

TEST(SettingsOfAVariable, AreItsInitializerAndItsAssignments) {
    EXPECT_THAT(settings("int main() {\n float t = 1;\n t *= 2;\n if (a) t = 3;\n show(t);\n t = 9;\n}"),
                ElementsAre(2, 3, 4));
    EXPECT_THAT(settings("int main() {\n glm::vec3 hit(S + V);\n show(hit);\n}"), ElementsAre(2));
    EXPECT_THAT(settings("int main() {\n const std::vector<float> x{1};\n show(x);\n}"), ElementsAre(2));
    EXPECT_THAT(settings("int main() {\n float a = 1,\n b = f(a, 2),\n c;\n show(b);\n}"), ElementsAre(3));
    EXPECT_THAT(settings("int main() {\n auto [t, u] = solve();\n show(u);\n}"), ElementsAre(2));
}

TEST(SettingsOfAVariable, AreThoseOfItsPartsToo) {
    EXPECT_THAT(settings("int main() {\n vec3 p;\n p.x = 1;\n p[1] = 2;\n show(p);\n}"), ElementsAre(3, 4));
    EXPECT_THAT(settings("int main() {\n Ray r = g();\n r.t = 1;\n r.n = 2;\n show(r.t);\n}"), ElementsAre(2, 3));
}

TEST(SettingsOfAVariable, AreThoseOfTheOneInForceThere) {
    EXPECT_THAT(settings("int main() {\n float t = 1;\n { float t = 2; }\n show(t);\n}"), ElementsAre(2));
    EXPECT_THAT(settings("void f() {\n float t = 1;\n}\nint main() {\n float t = 2;\n show(t);\n}"), ElementsAre(5));
    EXPECT_THAT(
        settings("float t;\nvoid f() {\n t = 1;\n}\nint main() {\n show(t);\n}\nvoid g() {\n t = 2;\n float t = 3;\n}"),
        ElementsAre(3, 9));
    EXPECT_THAT(settings("int main() {\n x.t = 1;\n float t;\n t == 2;\n show(t);\n}"), IsEmpty());
}

TEST(SettingsOfAVariable, AreNoProductsOrCalls) {
    EXPECT_THAT(
        settings("int main() {\n float b = 1;\n float d = sqrt(b * b) + (a & b) - (c ? a : b * b);\n show(b);\n}"),
        ElementsAre(2));
    EXPECT_THAT(settings("int main() {\n show(t);\n float t = 1;\n}"), IsEmpty()) << "declared later";
    EXPECT_THAT(settings("int main() {\n // float t = 1;\n#if 0\n float t = 2;\n#endif\n show(t);\n}"), IsEmpty());
}

TEST(SettingsOfAVariable, MayBeTheFunctionsThatGetItByReference) {
    EXPECT_THAT(
        settings("void sub(const float* p, float* out) { }\nint main() {\n float V[3];\n sub(P, V);\n sub(V, W);\n "
                 "show(V);\n}"),
        ElementsAre(-4));
    EXPECT_THAT(settings("int main() {\n float t = 0;\n intersect(a, t);\n show(t);\n}"), ElementsAre(2))
        << "a function of a library that takes a value";
    EXPECT_THAT(settings("int main() {\n float t;\n glm::intersect(a, t);\n show(t);\n}"), ElementsAre(-3));
    EXPECT_THAT(
        settings("int main() {\n auto solve = [](float& x) { x = 1; };\n float t = 0;\n solve(t);\n show(t);\n}"),
        ElementsAre(3, -4));
}

TEST(CallsOfAParameter, AreWhereItGetsItsValue) {
    const std::string source =
        "void out(const char* what, vec3 v);\n"
        "void out(const char* what, vec3 v) {\n show(v);\n}\n"
        "int main() {\n out(\"V\", V);\n return out(\"N\", N), 0;\n}";
    const std::vector<Word> words = words_of(source);
    std::vector<int> lines;
    for (const std::size_t call : Variables(words).calls_of_parameter(shown(words)))
        lines.push_back(line_of(source, words[call]));
    EXPECT_THAT(lines, ElementsAre(6, 7));
}

TEST(Variables, TakeAnyBytes) {
    for (const char* source :
         {"",        "=",       "{",  "}",     "}}}} t", "float",     "float t", "f(",  "f(float", "void f(int a,",
          "auto [a", "a<b<c<d", "t[", "t[[[=", "x.y.",   "#define t", "::t=",    "(){", "](a){",   "=[](a){"}) {
        const std::vector<Word> words = words_of(source);
        const Variables variables(words);
        for (std::size_t i = 0; i < words.size(); ++i) {
            variables.settings_of(i);
            variables.calls_of_parameter(i);
        }
    }
}

}  // namespace
}  // namespace harness::source
