#include "harness/build/header_plan.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

namespace {

using harness::HeaderLines;
using harness::HeaderPlan;
using harness::plan_headers;
using harness::reading_time_ms;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

const HeaderLines streams{"#include <iostream>"};
const HeaderLines glm{"#include <iostream>", "#include <glm/glm.hpp>"};
const HeaderLines printing{"#include <iostream>", "#include <glm/glm.hpp>", "#include <glm/gtx/string_cast.hpp>"};
const HeaderLines matrices{"#include <iostream>", "#include <glm/glm.hpp>", "#include <glm/gtc/matrix_transform.hpp>"};
const HeaderLines other{"#include <vector>", "#include <iostream>"};

std::vector<HeaderLines> classes(std::initializer_list<std::pair<HeaderLines, int>> counted) {
    std::vector<HeaderLines> blocks;
    for (const auto& [lines, count] : counted) blocks.insert(blocks.end(), static_cast<std::size_t>(count), lines);
    return blocks;
}

/// The compile time saved, minus the time for making the headers.
double worth(const HeaderPlan& plan, const std::set<HeaderLines>& made) {
    double worth = 0;
    for (const HeaderLines& header : plan.headers) worth -= made.contains(header) ? 0 : 3.5 * reading_time_ms(header);
    for (const auto& header : plan.header_of) worth += header ? reading_time_ms(plan.headers[*header]) : 0;
    return worth;
}

TEST(PlanHeaders, MakesAHeaderFromTheFourthUse) {
    EXPECT_THAT(plan_headers(classes({{glm, 3}}), {}).headers, IsEmpty());
    const HeaderPlan plan = plan_headers(classes({{glm, 4}}), {});
    EXPECT_THAT(plan.headers, ElementsAre(glm));
    EXPECT_THAT(plan.header_of, ElementsAre(0, 0, 0, 0));
}

TEST(PlanHeaders, UsesAnExistingHeaderForASingleSource) {
    EXPECT_THAT(plan_headers({glm}, {glm}).headers, ElementsAre(glm));
    EXPECT_THAT(plan_headers({printing}, {glm}).headers, ElementsAre(glm)) << "a beginning will do";
    EXPECT_THAT(plan_headers({glm}, {printing}).headers, IsEmpty()) << "never more than was written";
    EXPECT_THAT(plan_headers({printing}, {streams, glm}).headers, ElementsAre(glm)) << "the longest";
}

TEST(PlanHeaders, SharesABeginningAmongBlocksThatEndDifferently) {
    const HeaderPlan plan = plan_headers(classes({{printing, 3}, {matrices, 3}, {other, 1}}), {});
    EXPECT_THAT(plan.headers, ElementsAre(glm));
    EXPECT_THAT(plan.header_of, ElementsAre(0, 0, 0, 0, 0, 0, std::nullopt));
}

TEST(PlanHeaders, GivesEachLargeGroupItsOwnHeader) {
    const HeaderPlan plan = plan_headers(classes({{printing, 30}, {other, 40}, {matrices, 20}}), {});
    EXPECT_THAT(plan.headers, UnorderedElementsAre(printing, matrices, other));
    EXPECT_EQ(plan.headers.front(), other) << "the most used first";
}

TEST(PlanHeaders, LeavesOutLinesThatTakeNoTimeToRead) {
    EXPECT_THAT(plan_headers(classes({{{"#define A"}, 100}}), {}).headers, IsEmpty());
    EXPECT_THAT(plan_headers(classes({{{"#include <cstdio>"}, 100}}), {}).headers, IsEmpty());
    EXPECT_THAT(plan_headers(classes({{{}, 100}}), {}).headers, IsEmpty());
    EXPECT_THAT(plan_headers({}, {}).headers, IsEmpty());
}

TEST(PlanHeaders, HandlesABlockOfTenThousandLines) {
    HeaderLines lines = glm;
    for (int i = 0; i < 10000; ++i) lines.push_back("#define A" + std::to_string(i));
    const HeaderPlan plan = plan_headers(classes({{lines, 10}}), {});
    ASSERT_EQ(plan.headers.size(), 1U);
    EXPECT_LE(plan.headers[0].size(), 64U);
    EXPECT_TRUE(std::equal(plan.headers[0].begin(), plan.headers[0].end(), lines.begin()));
}

TEST(PlanHeaders, IsNeverWorseThanNoHeaderOrOneHeader) {
    const std::vector<std::string> lines{"#include <iostream>", "#include <glm/glm.hpp>", "#include <cmath>",
                                         "#include <vector>", "#define A 1"};
    for (unsigned seed = 0; seed < 200; ++seed) {
        std::mt19937 random(seed);
        std::vector<HeaderLines> blocks(1 + random() % 40);
        for (HeaderLines& block : blocks) {
            for (std::size_t i = random() % 5; i > 0; --i) block.push_back(lines[random() % lines.size()]);
        }
        std::set<HeaderLines> made;
        if (seed % 2 == 1) made.insert(blocks[random() % blocks.size()]);
        const HeaderPlan plan = plan_headers(blocks, made);
        ASSERT_EQ(plan.header_of.size(), blocks.size());
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            if (!plan.header_of[i]) continue;
            const HeaderLines& header = plan.headers.at(*plan.header_of[i]);
            ASSERT_LE(header.size(), blocks[i].size()) << seed;
            EXPECT_TRUE(std::equal(header.begin(), header.end(), blocks[i].begin())) << seed;
        }
        // Each plan with a single header is a lower bound for the best plan.
        EXPECT_GE(worth(plan, made), 0) << seed;
        for (const HeaderLines& header : blocks) {
            HeaderPlan simple{{header}, {}};
            for (const HeaderLines& block : blocks) {
                const bool fits =
                    block.size() >= header.size() && std::equal(header.begin(), header.end(), block.begin());
                simple.header_of.push_back(fits ? std::optional<std::size_t>(0) : std::nullopt);
            }
            if (reading_time_ms(header) < 20) continue;
            EXPECT_GE(worth(plan, made), worth(simple, made) - 1e-9) << seed;
        }
    }
}

TEST(PlanHeaders, DoesNotDependOnTheOrderOfTheBlocks) {
    auto blocks = classes({{printing, 5}, {matrices, 6}, {other, 3}, {streams, 2}});
    const HeaderPlan plan = plan_headers(blocks, {});
    std::reverse(blocks.begin(), blocks.end());
    HeaderPlan reversed = plan_headers(blocks, {});
    std::reverse(reversed.header_of.begin(), reversed.header_of.end());
    EXPECT_EQ(reversed.headers, plan.headers);
    EXPECT_EQ(reversed.header_of, plan.header_of);
}

TEST(ReadingTime, CountsSharedHeadersOnce) {
    EXPECT_GT(reading_time_ms(glm), reading_time_ms(streams));
    EXPECT_LT(reading_time_ms({"#include <iostream>", "#include <sstream>"}), 2 * reading_time_ms(streams));
    EXPECT_GT(reading_time_ms({"#include <bits/stdc++.h>"}), reading_time_ms(printing));
    EXPECT_EQ(reading_time_ms({}), 0);
}

}  // namespace
