#include "harness/report/compile_error/compiler_messages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace harness::report {
namespace {

TEST(CompilerMessages, AreOnlyAboutTheSourceWithErrorsFirst) {
    const auto messages = compiler_messages(
        "In file included from ray_cast.cpp:1:\n/usr/include/x.h:9:1: error: theirs\n"
        "ray_cast.cpp:4:7: warning: unused\nray_cast.cpp: In function 'int main()':\n"
        "ray_cast.cpp:12:5: error: expected ';'\n   12 |  x\nray_cast.cpp:12:5: note: here\n"
        "ray_cast.cpp:20: fatal error: no column");
    ASSERT_EQ(messages.size(), 3U);
    EXPECT_EQ(messages[0].line, 12);
    EXPECT_EQ(messages[0].kind, "error");
    EXPECT_EQ(messages[0].text, "expected ';'");
    EXPECT_EQ(messages[1].line, 20);
    EXPECT_EQ(messages[1].text, "no column");
    EXPECT_EQ(messages[2].line, 4);
    EXPECT_EQ(messages[2].kind, "warning");
}

TEST(CompilerMessages, AreLimitedToTheRequestedNumber) {
    std::string many;
    for (int i = 1; i <= 100; ++i) many += "ray_cast.cpp:" + std::to_string(i) + ":1: error: x\n";
    EXPECT_EQ(compiler_messages(many, 7).size(), 7U);
}

TEST(CompilerMessages, AreNotFoundInLookalikes) {
    EXPECT_THAT(compiler_messages("ray_cast.cpp:99999999999:1: error: x\nray_cast.cpp:-1:1: error: x\n"
                                  "ray_cast.cpp::error: x\nxray_cast.cpp:1:1: error: x\nray_cast.cpp:\n"),
                testing::IsEmpty());
}

TEST(BeginningOf, EndsAtALineEndIfPossible) {
    EXPECT_EQ(beginning_of("one\ntwo\nthree", 9), "one\ntwo\n…\n");
    EXPECT_EQ(beginning_of("onetwothree", 3), "one…\n");
    EXPECT_EQ(beginning_of("one", 3), "one");
    EXPECT_EQ(beginning_of("zoé!", 3), "zo…\n");
}

}  // namespace
}  // namespace harness::report
