#include "reference/toml/near_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace reference {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(NearNames, ListTheNearestFirst) {
    EXPECT_THAT(near_names("s5", {"s05", "s55", "x", "S5"}), ElementsAre("S5", "s05", "s55"));
    EXPECT_THAT(near_names("doejane", {"roerick_14", "doejane_12"}), ElementsAre("doejane_12"));
    EXPECT_THAT(near_names("bne", {"ada", "none", "ben"}), ElementsAre("ben"));
    EXPECT_THAT(near_names("tommorow", {"tomorrow", "today"}), ElementsAre("tomorrow"));
}

TEST(NearNames, AreAtMostThreeOrNone) {
    EXPECT_EQ(near_names("s0", {"s01", "s02", "s03", "s04"}).size(), 3U);
    EXPECT_THAT(near_names("quentin", {"ada", "ben"}), IsEmpty());
    EXPECT_THAT(near_names("", {"ada"}), IsEmpty());
}

TEST(DidYouMean, ListsSimilarNamesOrElseAll) {
    EXPECT_EQ(did_you_mean("s0", {"s01", "s02"}), "did you mean s01 or s02?");
    EXPECT_EQ(did_you_mean("quentin", {"ada", "ben"}), "there are ada, ben");
    EXPECT_EQ(did_you_mean("quentin", {}), "there are none");
    std::vector<std::string> many;
    for (int i = 0; i < 100; ++i) many.push_back("name" + std::to_string(100 + i));
    EXPECT_THAT(did_you_mean("xyz", many), HasSubstr("name129 and 70 more"));
    EXPECT_THAT(did_you_mean("xyz", many), Not(HasSubstr("name130")));
}

}  // namespace
}  // namespace reference
