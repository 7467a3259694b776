#include <gtest/gtest.h>

#include "harness/text/escape.h"

namespace harness {
namespace {

TEST(InAddress, EscapesEveryCharacterWithAMeaningThere) {
    EXPECT_EQ(in_address("feedback/s01-a_b~.html"), "feedback/s01-a_b~.html");
    EXPECT_EQ(in_address("a b?c#d%2Fe"), "a%20b%3Fc%23d%252Fe");
    EXPECT_EQ(in_address("javascript:\"'<&>"), "javascript%3A%22%27%3C%26%3E");
    EXPECT_EQ(in_address("é\xff\n"), "%C3%A9%FF%0A");
}

}  // namespace
}  // namespace harness
