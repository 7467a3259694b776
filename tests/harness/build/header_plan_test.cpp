#include "harness/build/header_plan.h"

#include <gmock/gmock.h>

#include <set>

namespace {

using harness::HeaderLines;
using harness::HeaderPlan;
using testing::ElementsAre;
using testing::IsEmpty;

const HeaderLines glm{"#include <glm/glm.hpp>", "#include <iostream>"};
const HeaderLines other{"#include <iostream>", "#include <vector>"};

std::vector<HeaderLines> classes(std::initializer_list<std::pair<HeaderLines, int>> counted) {
    std::vector<HeaderLines> wanted;
    for (const auto& [lines, count] : counted) wanted.insert(wanted.end(), static_cast<std::size_t>(count), lines);
    return wanted;
}

HeaderPlan plan_headers(const std::vector<HeaderLines>& wanted, const std::set<HeaderLines>& kept = {}) {
    return harness::plan_headers(wanted, [&](const HeaderLines& lines) { return kept.contains(lines); });
}

std::vector<HeaderLines> lines_of(const HeaderPlan& plan) {
    std::vector<HeaderLines> lines;
    for (const auto& header : plan.headers) lines.push_back(header.lines);
    return lines;
}

TEST(PlanHeaders, MakesAHeaderFromTheFourthSource) {
    EXPECT_THAT(plan_headers(classes({{glm, 3}})).headers, IsEmpty());
    const HeaderPlan plan = plan_headers(classes({{glm, 4}, {other, 1}}));
    EXPECT_THAT(lines_of(plan), ElementsAre(glm));
    EXPECT_THAT(plan.headers.front().sources, ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(plan.without_one, ElementsAre(4));
}

TEST(PlanHeaders, UsesAKeptHeaderForASingleSource) {
    EXPECT_THAT(lines_of(plan_headers({glm}, {glm})), ElementsAre(glm));
    EXPECT_THAT(plan_headers({glm}, {other}).headers, IsEmpty());
}

TEST(PlanHeaders, MakesTheMostUsedHeaderFirst) {
    EXPECT_THAT(lines_of(plan_headers(classes({{glm, 5}, {other, 6}}))), ElementsAre(other, glm));
    EXPECT_THAT(lines_of(plan_headers(classes({{other, 5}, {glm, 6}}))), ElementsAre(glm, other));
}

TEST(PlanHeaders, MakesNoHeaderForSourcesThatWantNone) {
    EXPECT_THAT(plan_headers(classes({{{}, 100}})).headers, IsEmpty());
    EXPECT_THAT(plan_headers(classes({{{}, 2}})).without_one, ElementsAre(0, 1));
}

}  // namespace
