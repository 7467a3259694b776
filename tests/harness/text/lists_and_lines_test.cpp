#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/text/lines.h"
#include "harness/text/listed.h"

namespace harness {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Listed, PutsAndBeforeTheLastPart) {
    EXPECT_EQ(listed({}), "");
    EXPECT_EQ(listed({"4"}), "4");
    EXPECT_EQ(listed({"4", "5"}), "4 and 5");
    EXPECT_EQ(listed({"4", "5", "6"}), "4, 5 and 6");
}

TEST(LinesOf, KeepsEmptyLinesAndALastOneWithoutEnd) {
    EXPECT_THAT(lines_of(""), IsEmpty());
    EXPECT_THAT(lines_of("\n"), ElementsAre(""));
    EXPECT_THAT(lines_of("a\n\nb\r\nc"), ElementsAre("a", "", "b\r", "c"));
    EXPECT_THAT(lines_of("a\n"), ElementsAre("a"));
}

TEST(LinesOf, StopsAfterTheMostThatAreWanted) {
    EXPECT_THAT(lines_of("a\nb\nc", 2), ElementsAre("a", "b"));
    EXPECT_THAT(lines_of("a", 0), IsEmpty());
}

}  // namespace
}  // namespace harness
