#include "harness/serve/results/pages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace harness::serve {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr std::string_view not_shown_of_ten =
    "The points shown here do not include the points for other scenes (up to 10).";

About about(double variant_points = 0) {
    return {"An <assignment>", std::chrono::hours(24), variant_points};
}

TEST(Pages, SayThatPointsForVariantsAreNotShown) {
    constexpr const char* student = "<head></head>\n<body class=\"sheet\">\n<main>\n<p>98 of 100</p>\n</main></body>";
    EXPECT_EQ(not_shown(about(10)), not_shown_of_ten);
    EXPECT_THAT(front_page(about(10)), HasSubstr(not_shown_of_ten));
    EXPECT_EQ(as_result(about(10), student),
              "<head></head>\n<body class=\"sheet\">\n<nav aria-label=\"Self-check\"><a href=\"../\">Check another "
              "program</a></nav>\n<main>\n<p class=\"note\">" +
                  std::string(not_shown_of_ten) + "</p>\n<p>98 of 100</p>\n</main></body>");
    EXPECT_EQ(not_shown(about()), "");
    for (const std::string& page : {front_page(about()), as_result(about(), student)})
        EXPECT_THAT(page, AllOf(Not(HasSubstr("other scenes")), Not(HasSubstr("<p></p>")), Not(HasSubstr("\"note\""))));
}

}  // namespace
}  // namespace harness::serve
