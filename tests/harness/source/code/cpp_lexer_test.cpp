#include "harness/source/code/cpp_lexer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <iterator>
#include <ostream>
#include <string>
#include <vector>

#include "tests/given/bytes_of.h"

namespace harness::source {

void PrintTo(TokenKind kind, std::ostream* out) {
    *out << "kind " << static_cast<int>(kind);
}

namespace {

using testing::ElementsAre;
using testing::Pair;

/// The tokens without blanks and line ends.
std::vector<std::pair<TokenKind, std::string>> words(const std::string& source) {
    std::vector<std::pair<TokenKind, std::string>> result;
    for (const Token& token : lex_cpp(source)) {
        if (token.kind != TokenKind::blank && token.kind != TokenKind::line_end)
            result.emplace_back(token.kind, source.substr(token.begin, token.end - token.begin));
    }
    return result;
}

/// "" if the tokens cover the source without gap or overlap.
std::string gap_in(const std::string& source) {
    std::size_t at = 0;
    for (const Token& token : lex_cpp(source)) {
        if (token.begin != at || token.end <= token.begin) return "a gap at " + std::to_string(at);
        at = token.end;
    }
    return at == source.size() ? "" : "the end is missing from " + std::to_string(at);
}

TEST(CppLexer, ReadsSeparatorsExponentAndSuffixAsOneNumber) {
    for (const std::string number :
         {"0", "2.0f", ".5F", "2.", "1'000'000", "1e-3", "1.5E+2L", "0x1.8p-3", "0x1F'00ull", "0b101", "017"}) {
        EXPECT_THAT(words(number + ";"), ElementsAre(Pair(TokenKind::number, number), Pair(TokenKind::symbol, ";")));
    }
}

TEST(CppLexer, LeavesASignToTheExpression) {
    EXPECT_THAT(words("x-2"),
                ElementsAre(Pair(TokenKind::name, "x"), Pair(TokenKind::symbol, "-"), Pair(TokenKind::number, "2")));
}

TEST(CppLexer, SeesNoCodeInCommentsAndLiterals) {
    EXPECT_THAT(words("/* 1 \" */ 2 // 3 \\\n 4\n'\\'' \"5 // \\\" 6\" u8\"7\""),
                ElementsAre(Pair(TokenKind::comment, "/* 1 \" */"), Pair(TokenKind::number, "2"),
                            Pair(TokenKind::comment, "// 3 \\\n 4"), Pair(TokenKind::text, "'\\''"),
                            Pair(TokenKind::text, "\"5 // \\\" 6\""), Pair(TokenKind::text, "u8\"7\"")));
}

TEST(CppLexer, EndsARawStringAtItsOwnDelimiter) {
    EXPECT_THAT(words("R\"x(1)\" )y\" \\\n)x\" 2"),
                ElementsAre(Pair(TokenKind::text, "R\"x(1)\" )y\" \\\n)x\""), Pair(TokenKind::number, "2")));
    EXPECT_THAT(words("LR\"(3)\"4"), ElementsAre(Pair(TokenKind::text, "LR\"(3)\""), Pair(TokenKind::number, "4")));
    EXPECT_THAT(words("FR\"5\""), ElementsAre(Pair(TokenKind::name, "FR"), Pair(TokenKind::text, "\"5\"")));
}

TEST(CppLexer, RecognisesADirectiveByItsPlaceInTheLine) {
    EXPECT_THAT(
        words(" /**/ # include <a/1.h>\nx #y < 1"),
        ElementsAre(Pair(TokenKind::comment, "/**/"), Pair(TokenKind::directive, "#"), Pair(TokenKind::name, "include"),
                    Pair(TokenKind::header_name, "<a/1.h>"), Pair(TokenKind::name, "x"), Pair(TokenKind::other, "#"),
                    Pair(TokenKind::name, "y"), Pair(TokenKind::symbol, "<"), Pair(TokenKind::number, "1")));
}

TEST(CppLexer, JoinsLinesThatEndWithABackslash) {
    EXPECT_THAT(words("#define R \\\r\n 2"),
                ElementsAre(Pair(TokenKind::directive, "#"), Pair(TokenKind::name, "define"),
                            Pair(TokenKind::name, "R"), Pair(TokenKind::number, "2")));
    EXPECT_THAT(words("1\\\n5"), ElementsAre(Pair(TokenKind::number, "1\\\n5")));
    for (const Token& token : lex_cpp("#define R \\\n 2")) EXPECT_NE(token.kind, TokenKind::line_end);
}

TEST(CppLexer, TakesTheLongestSymbol) {
    EXPECT_THAT(words("a<=b->c==d"),
                ElementsAre(Pair(TokenKind::name, "a"), Pair(TokenKind::symbol, "<="), Pair(TokenKind::name, "b"),
                            Pair(TokenKind::symbol, "->"), Pair(TokenKind::name, "c"), Pair(TokenKind::symbol, "=="),
                            Pair(TokenKind::name, "d")));
}

TEST(CppLexer, EndsAnOpenLiteralAtTheLineEnd) {
    EXPECT_THAT(words("\"a\n1"), ElementsAre(Pair(TokenKind::text, "\"a"), Pair(TokenKind::number, "1")));
    EXPECT_THAT(words("/* a\n1"), ElementsAre(Pair(TokenKind::comment, "/* a\n1")));
    EXPECT_THAT(words("R\"(a\n1"), ElementsAre(Pair(TokenKind::text, "R\"(a\n1")));
}

TEST(CppLexer, KeepsEveryByteOfASubmissionCutAnywhere) {
    const std::string source = bytes_of(RAYGRADE_PROJECT "/submissions/s06/ray_cast.cpp");
    ASSERT_GT(source.size(), 1000U);
    for (std::size_t length = 0; length <= source.size(); length += 7) ASSERT_EQ(gap_in(source.substr(0, length)), "");
}

/// Patterns that, if repeated, would make a backtracking lexer take hours.
class NastySource : public testing::TestWithParam<std::string> {};

TEST_P(NastySource, IsReadInTimeAtOneMebibyte) {
    std::string source;
    while (source.size() < (std::size_t{1} << 20U)) source += GetParam();
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(gap_in(source), "");
    // A wide bound: it only has to detect a hang.
    EXPECT_LE(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

INSTANTIATE_TEST_SUITE_P(CppLexer, NastySource,
                         testing::Values("R\"", "R\"aaaaaaaaaaaaaaa", "R\"(", "\\ ", "\\", "/", "/*", "\"\\", "'", "1'",
                                         "1e+", "#include <", "<", "\\\n", "#\n", "L", "\r", "u8R\"x(", "a\\\n"));

}  // namespace
}  // namespace harness::source
