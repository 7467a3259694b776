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
const HeaderLines glm{"#include <glm/glm.hpp>", "#include <iostream>"};
const HeaderLines printing{"#include <glm/glm.hpp>", "#include <glm/gtx/string_cast.hpp>", "#include <iostream>"};
const HeaderLines matrices{"#include <glm/glm.hpp>", "#include <glm/gtc/matrix_transform.hpp>", "#include <iostream>"};
const HeaderLines other{"#include <iostream>", "#include <vector>"};

std::vector<HeaderLines> classes(std::initializer_list<std::pair<HeaderLines, int>> counted) {
    std::vector<HeaderLines> blocks;
    for (const auto& [lines, count] : counted) blocks.insert(blocks.end(), static_cast<std::size_t>(count), lines);
    return blocks;
}

/// Whether the block holds all lines of the header.
bool fits(const HeaderLines& header, const HeaderLines& block) {
    return std::all_of(header.begin(), header.end(),
                       [&](const std::string& line) { return std::count(block.begin(), block.end(), line) > 0; });
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
    EXPECT_THAT(plan_headers({printing}, {glm}).headers, ElementsAre(glm)) << "a part will do";
    EXPECT_THAT(plan_headers({glm}, {printing}).headers, IsEmpty()) << "never more than was written";
    EXPECT_THAT(plan_headers({printing}, {streams, glm}).headers, ElementsAre(glm)) << "the longest";
}

TEST(PlanHeaders, SharesAHeaderAmongSourcesThatIncludeTheSameInAnyOrder) {
    HeaderLines turned(printing.rbegin(), printing.rend());
    turned.insert(turned.begin() + 1, "#define MINE 1");
    const HeaderPlan plan = plan_headers(classes({{printing, 2}, {turned, 2}}), {});
    EXPECT_THAT(plan.headers, ElementsAre(printing));
    EXPECT_THAT(plan.header_of, ElementsAre(0, 0, 0, 0));
}

TEST(PlanHeaders, SharesWhatSourcesHaveInCommon) {
    const HeaderPlan plan = plan_headers(classes({{printing, 3}, {matrices, 3}, {other, 1}}), {});
    EXPECT_THAT(plan.headers, ElementsAre(glm));
    EXPECT_THAT(plan.header_of, ElementsAre(0, 0, 0, 0, 0, 0, std::nullopt));
}

TEST(PlanHeaders, GivesEachLargeGroupItsOwnHeader) {
    const HeaderPlan plan = plan_headers(classes({{printing, 30}, {other, 40}, {matrices, 20}}), {});
    EXPECT_THAT(plan.headers, UnorderedElementsAre(printing, matrices, other));
    EXPECT_EQ(plan.headers.front(), other) << "the most used first";
}

TEST(PlanHeaders, SharesNoHeaderAmongSourcesOfDifferentSettings) {
    HeaderLines left_handed = glm;
    left_handed.insert(left_handed.begin(), "#define GLM_FORCE_LEFT_HANDED");
    EXPECT_THAT(plan_headers(classes({{glm, 3}, {left_handed, 3}}), {}).headers, IsEmpty());
    EXPECT_THAT(plan_headers(classes({{glm, 4}, {left_handed, 5}}), {}).headers, ElementsAre(left_handed, glm));
}

TEST(PlanHeaders, LeavesOutAHeaderWhoseLinesAreInAnOldOrder) {
    EXPECT_THAT(plan_headers({glm}, {HeaderLines(glm.rbegin(), glm.rend())}).headers, IsEmpty());
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
    lines.push_back("#include <regex>");
    EXPECT_THAT(plan_headers(classes({{lines, 10}}), {}).headers, ElementsAre(glm));
}

TEST(PlanHeaders, HandlesTwoThousandDifferentBlocks) {
    std::mt19937 random(1);
    const std::vector<std::string> more{"algorithm", "array", "cassert", "cmath",   "cstdio", "iomanip", "list",
                                        "map",       "regex", "set",     "sstream", "string", "tuple",   "vector"};
    std::vector<HeaderLines> blocks(2000, glm);
    for (HeaderLines& block : blocks) {
        for (const std::string& name : more) {
            if (random() % 2 == 0) block.push_back("#include <" + name + ">");
        }
    }
    const HeaderPlan plan = plan_headers(blocks, {});
    EXPECT_EQ(std::count(plan.header_of.begin(), plan.header_of.end(), std::nullopt), 0);
    EXPECT_GT(plan.headers.size(), 1U);
    EXPECT_LT(plan.headers.size(), 100U);
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
        if (seed % 2 == 1) made.insert({"#include <cmath>", "#include <iostream>"});
        const HeaderPlan plan = plan_headers(blocks, made);
        ASSERT_EQ(plan.header_of.size(), blocks.size());
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            if (!plan.header_of[i]) continue;
            const HeaderLines& header = plan.headers.at(*plan.header_of[i]);
            EXPECT_TRUE(fits(header, blocks[i])) << seed;
            EXPECT_TRUE(std::is_sorted(header.begin(), header.end())) << seed;
        }
        // Each plan with a single header is a lower bound for the best plan.
        EXPECT_GE(worth(plan, made), 0) << seed;
        for (const HeaderLines& block : blocks) {
            std::set<std::string> includes(block.begin(), block.end());
            includes.erase("#define A 1");
            const HeaderLines header(includes.begin(), includes.end());
            HeaderPlan simple{{header}, {}};
            for (const HeaderLines& each : blocks)
                simple.header_of.push_back(fits(header, each) ? std::optional<std::size_t>(0) : std::nullopt);
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
