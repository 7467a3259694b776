// What must be the same on all machines, and where two lists of it differ.
#include "harness/shards/conditions.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace harness {
namespace {

TEST(Differences, AreNoneBetweenEqualConditionsInAnyOrder) {
    EXPECT_TRUE(differences({{"raygrade", "1"}, {"compiler", "a"}}, {{"compiler", "a"}, {"raygrade", "1"}}).empty());
}

TEST(Differences, NameWhatDiffersAndWhatEitherListLacks) {
    const auto found = differences({{"raygrade", "1"}, {"sandbox", "bwrap"}, {"--repeat", "2"}},
                                   {{"compiler", "a"}, {"sandbox", "none"}, {"raygrade", "1"}});
    ASSERT_EQ(found.size(), 3U);
    EXPECT_EQ(found[0].what, "sandbox");
    EXPECT_EQ(found[0].here, "bwrap");
    EXPECT_EQ(found[0].there, "none");
    EXPECT_EQ(found[1].what, "--repeat");
    EXPECT_EQ(found[1].there, "");
    EXPECT_EQ(found[2].what, "compiler");
    EXPECT_EQ(found[2].here, "");
}

TEST(Conditions, AreReadOnlyFromAnObjectOfTexts) {
    using Json = nlohmann::ordered_json;
    EXPECT_EQ(conditions_in(Json::parse(R"({"b":"1","a":"2"})")), (std::vector<Condition>{{"b", "1"}, {"a", "2"}}));
    for (const char* wrong : {"[]", "[\"a\"]", "1", "null", "\"a\"", R"({"a":1})", R"({"a":{}})", R"({"a":null})"})
        EXPECT_THROW(conditions_in(Json::parse(wrong)), Json::exception) << wrong;
}

}  // namespace
}  // namespace harness
