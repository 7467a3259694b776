// `raygrade accuracy` as a person runs it: what it prints and writes, and the files it refuses to overwrite.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

using testing::HasSubstr;
using testing::Not;

Result accuracy(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"accuracy", "--quick", "--rays", "256"});
    return raygrade(arguments);
}

TEST(Accuracy, WritesPageChartAndFigures) {
    const TemporaryFolder folder;
    const Result result = accuracy({"--out", (folder / "out").string()});
    ASSERT_EQ(result.status, 0) << result.both();
    EXPECT_EQ(read_json(folder / "out/accuracy.json").at("rays"), 256);
    EXPECT_THAT(read(folder / "out/accuracy.html"), HasSubstr(read(folder / "out/accuracy.svg")));
    EXPECT_THAT(result.output, testing::ContainsRegex("One key takes .* certified"));
    EXPECT_THAT(result.voice, HasSubstr("accuracy.html"));
}

TEST(Accuracy, ExaminesAnAssignmentWithoutMeasuringRays) {
    const Result result = raygrade({"accuracy", "--assignment", "a6-2021"});
    EXPECT_EQ(result.status, 0) << result.both();
    EXPECT_THAT(result.output, HasSubstr("Is float enough? Yes"));
    EXPECT_THAT(result.output, HasSubstr("triangle: t is exactly 0"));
    EXPECT_THAT(result.output, Not(HasSubstr("rays of each distribution")));
}

}  // namespace
}  // namespace scenario
