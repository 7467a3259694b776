// Reading and matching take time linear in the output's size, for any output. The time bound is wide: it only detects a
// hang.
#include <gtest/gtest.h>

#include <chrono>
#include <ostream>
#include <string>
#include <vector>

#include "harness/match/match.h"
#include "harness/read/transcript.h"
#include "tests/given/nasty_outputs.h"

namespace {

class NastyOutput : public testing::TestWithParam<NastyPattern> {};

TEST_P(NastyOutput, IsReadInTimeAtOneMebibyte) {
    const std::string output = nasty_output(GetParam(), std::size_t{1} << 20U);
    const auto start = std::chrono::steady_clock::now();
    const auto matched = harness::match(harness::read_transcript(output, 10), reference::default_items());
    EXPECT_LE(std::chrono::steady_clock::now() - start, std::chrono::seconds(120));
    EXPECT_EQ(matched.size(), reference::default_items().size());
}

INSTANTIATE_TEST_SUITE_P(Reading, NastyOutput, testing::ValuesIn(nasty_patterns()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
