// The forms of the review, as browsers send them.
#include "harness/review/form_fields.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace harness::review {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

constexpr std::string_view type = "application/x-www-form-urlencoded";

TEST(FormFields, AreDecodedInTheirOrder) {
    // Python's urllib.parse.urlencode of these fields.
    const auto form = read_form(type, "who=a%26b%3Dc&who=Zo%C3%AB+M%C3%BCller&text=1+%2B+1%0D%0A%25&none=");
    ASSERT_TRUE(form);
    EXPECT_THAT(form->all(), ElementsAre(Pair("who", "a&b=c"), Pair("who", "Zo\xC3\xAB M\xC3\xBCller"),
                                         Pair("text", "1 + 1\r\n%"), Pair("none", "")));
    EXPECT_THAT(form->values("who"), ElementsAre("a&b=c", "Zo\xC3\xAB M\xC3\xBCller"));
    EXPECT_EQ(form->value("text"), "1 + 1\r\n%");
    EXPECT_TRUE(form->has("none"));
    EXPECT_FALSE(form->has("points"));
    EXPECT_EQ(form->value("points"), "");
}

TEST(FormFields, AreRefusedIfOfAnotherType) {
    EXPECT_FALSE(read_form("multipart/form-data; boundary=x", "a=b"));
    EXPECT_FALSE(read_form("text/plain", "a=b"));
    EXPECT_FALSE(read_form("", "a=b"));
    EXPECT_TRUE(read_form("application/x-www-form-urlencoded; charset=UTF-8", "a=b"));
}

TEST(FormFields, AreRefusedIfMalformed) {
    for (const char* body : {"a=%", "a=%4", "a=%4g", "%zz=1", "a=%+1", "a=b&c=%-1"})
        EXPECT_FALSE(read_form(type, body)) << body;
    const auto form = read_form(type, "&&a&=b&c==d&e=%41");
    ASSERT_TRUE(form);
    EXPECT_THAT(form->all(), ElementsAre(Pair("a", ""), Pair("", "b"), Pair("c", "=d"), Pair("e", "A")));
    EXPECT_THAT(read_form(type, "")->all(), IsEmpty());
}

TEST(FormFields, AreAtMostAsManyAsAReviewFormHas) {
    std::string body;
    for (int i = 0; i < 20'000; ++i) body += "who=1&";
    EXPECT_TRUE(read_form(type, body));
    EXPECT_FALSE(read_form(type, body + "who=1"));
}

}  // namespace
}  // namespace harness::review
