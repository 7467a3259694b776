#include "harness/build/header_plan.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

namespace {

using harness::HeaderLines;
using harness::HeaderPlan;
using testing::ElementsAre;
using testing::IsEmpty;

const HeaderLines glm{"#include <glm/glm.hpp>", "#include <iostream>"};
const HeaderLines printing{"#include <glm/glm.hpp>", "#include <glm/gtx/string_cast.hpp>", "#include <iostream>"};
const HeaderLines other{"#include <iostream>", "#include <vector>"};

std::vector<HeaderLines> classes(std::initializer_list<std::pair<HeaderLines, int>> counted) {
    std::vector<HeaderLines> blocks;
    for (const auto& [lines, count] : counted) blocks.insert(blocks.end(), static_cast<std::size_t>(count), lines);
    return blocks;
}

HeaderPlan plan_headers(const std::vector<HeaderLines>& blocks, const std::set<HeaderLines>& kept = {}) {
    return harness::plan_headers(blocks, [&](const HeaderLines& lines) { return kept.contains(lines); });
}

TEST(PlanHeaders, MakesAHeaderFromTheFourthSource) {
    EXPECT_THAT(plan_headers(classes({{glm, 3}})).headers, IsEmpty());
    const HeaderPlan plan = plan_headers(classes({{glm, 4}, {other, 1}}));
    EXPECT_THAT(plan.headers, ElementsAre(glm));
    EXPECT_THAT(plan.header_of, ElementsAre(0, 0, 0, 0, std::nullopt));
}

TEST(PlanHeaders, UsesAKeptHeaderForASingleSource) {
    EXPECT_THAT(plan_headers({glm}, {glm}).headers, ElementsAre(glm));
    EXPECT_THAT(plan_headers({glm}, {printing}).headers, IsEmpty()) << "never more than was written";
    EXPECT_THAT(plan_headers({glm}, {HeaderLines(glm.rbegin(), glm.rend())}).headers, IsEmpty());
}

TEST(PlanHeaders, SharesAHeaderAmongSourcesThatIncludeTheSameInAnyOrder) {
    HeaderLines turned(printing.rbegin(), printing.rend());
    turned.insert(turned.begin() + 1, "#define MINE 1");
    const HeaderPlan plan = plan_headers(classes({{printing, 2}, {turned, 2}}));
    EXPECT_THAT(plan.headers, ElementsAre(printing));
    EXPECT_THAT(plan.header_of, ElementsAre(0, 0, 0, 0));
}

TEST(PlanHeaders, MakesTheMostUsedHeaderFirstInAnyOrderOfTheSources) {
    auto blocks = classes({{printing, 5}, {other, 6}, {glm, 4}});
    const HeaderPlan plan = plan_headers(blocks);
    EXPECT_THAT(plan.headers, ElementsAre(other, printing, glm));
    std::reverse(blocks.begin(), blocks.end());
    HeaderPlan reversed = plan_headers(blocks);
    std::reverse(reversed.header_of.begin(), reversed.header_of.end());
    EXPECT_EQ(reversed.headers, plan.headers);
    EXPECT_EQ(reversed.header_of, plan.header_of);
}

TEST(PlanHeaders, SharesNoHeaderAmongSourcesOfDifferentSettings) {
    HeaderLines left_handed = glm;
    left_handed.insert(left_handed.begin(), "#define GLM_FORCE_LEFT_HANDED");
    EXPECT_THAT(plan_headers(classes({{glm, 3}, {left_handed, 3}})).headers, IsEmpty());
    EXPECT_THAT(plan_headers(classes({{glm, 4}, {left_handed, 5}})).headers, ElementsAre(left_handed, glm));
}

TEST(PlanHeaders, MakesNoHeaderWithoutIncludes) {
    EXPECT_THAT(plan_headers(classes({{{"#define NDEBUG"}, 100}, {{}, 100}})).headers, IsEmpty());
    EXPECT_THAT(plan_headers({}).headers, IsEmpty());
}

}  // namespace
