// Reading and matching take time linear in the output's size, whatever is in it. The bound on the clock is wide: it is
// to stop what hangs. tests/bench/reading_growth compares the times of one size and its double.
#include <gtest/gtest.h>

#include <chrono>
#include <ostream>
#include <string>
#include <vector>

#include "harness/match.h"
#include "harness/transcript.h"
#include "tests/nasty_outputs.h"

namespace {

class NastyOutput : public testing::TestWithParam<NastyPattern> {};

TEST_P(NastyOutput, OfOneMebibyteIsReadInTime) {
    const std::string output = nasty_output(GetParam(), std::size_t{1} << 20U);
    const auto start = std::chrono::steady_clock::now();
    const auto matched = harness::match(harness::read_transcript(output), reference::all_items());
    EXPECT_LE(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
    EXPECT_EQ(matched.size(), reference::all_items().size());
}

INSTANTIATE_TEST_SUITE_P(Reading, NastyOutput, testing::ValuesIn(nasty_patterns()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
