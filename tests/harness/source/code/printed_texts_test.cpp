// Which texts a source prints, and the variables behind each.
#include "harness/source/code/printed_texts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace harness::source {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// "t: t u" for the text "t:" with the variables t and u.
std::vector<std::string> texts(const std::string& statements) {
    const std::string source = "int main() {\n" + statements + "\n}";
    std::vector<std::string> all;
    for (const PrintedText& text : printed_texts(words_of(source))) {
        all.push_back(text.text);
        for (const std::string& variable : text.variables) all.back() += " " + variable;
    }
    return all;
}

TEST(PrintedTexts, HaveTheVariablesUpToTheNextText) {
    EXPECT_THAT(texts(R"(std::cout << "t: " << hit.t << ", u: " << sqrt(u) << std::endl;)"),
                ElementsAre("t: hit", ", u: u"));
    EXPECT_THAT(texts(R"(cout << "V = (" << V.x << ", " << V.y << ")\n";)"), ElementsAre("V = ( V V"));
    EXPECT_THAT(texts(R"(cout << "hit: " << (d ? "yes" : "no");)"), ElementsAre("hit: d", "yes", "no"));
    EXPECT_THAT(texts(R"(print("V", V);)"), ElementsAre("V V"));
    EXPECT_THAT(texts(R"(if (d) cout << "t: " << t; else cout << "u: " << u;)"), ElementsAre("t: t", "u: u"));
}

TEST(PrintedTexts, HaveTheArgumentOfAConversion) {
    EXPECT_THAT(texts(R"(printf("a = %.3f\n  b = %f, c=%+8.2lf %%\n", a, f(b, t), c);)"),
                ElementsAre("a = a", "b = b t", ", c= c"));
    EXPECT_THAT(texts(R"(printf("%d. hit %f %f\n", 6, V.x, V.y);)"), ElementsAre(". hit V V"));
    EXPECT_THAT(texts(R"(printf("Question 6:\nt: %f", t);)"), ElementsAre("Question 6:", "t: t"));
}

TEST(PrintedTexts, HaveNoVariablesIfPrintedAlone) {
    EXPECT_THAT(texts("puts(\"Question 5:\");\ncout << V;"), ElementsAre("Question 5:"));
    EXPECT_THAT(texts("{ cout << \"Hit:\" } cout << V;"), ElementsAre("Hit:")) << "in a different block";
}

TEST(PrintedTexts, ContainLetters) {
    EXPECT_THAT(texts("puts(\": \"); puts(\"\"); putchar('x'); // puts(\"no\")\nputs(\"cut"), IsEmpty());
}

}  // namespace
}  // namespace harness::source
