#include "harness/text/shell_word.h"

#include <gtest/gtest.h>

namespace harness {
namespace {

TEST(ShellWord, IsQuotedOnlyWhereAShellWouldReadSomethingElse) {
    EXPECT_EQ(shell_word("results/2026-a6_b"), "results/2026-a6_b");
    EXPECT_EQ(shell_word("my results"), "'my results'");
    EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
    EXPECT_EQ(shell_word("~/a"), "'~/a'");
    EXPECT_EQ(shell_word("$(rm x)`y`"), "'$(rm x)`y`'");
    EXPECT_EQ(shell_word("übung"), "'übung'");
    EXPECT_EQ(shell_word(""), "''");
}

TEST(ShellWord, GivesNoControlByteToTheTerminal) {
    EXPECT_EQ(shell_word("a\x1b[2J b"), "$'a\\x1b[2J b'");
    EXPECT_EQ(shell_word("it's\n\\"), "$'it\\'s\\x0a\\\\'");
    EXPECT_EQ(shell_word("\xff"), "$'\\xff'");
}

}  // namespace
}  // namespace harness
