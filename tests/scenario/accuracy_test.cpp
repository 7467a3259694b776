// `raygrade accuracy` as a person runs it: what it prints and writes, and the files it refuses to overwrite.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

Result accuracy(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"accuracy", "--quick", "--rays", "256"});
    return raygrade(arguments);
}

TEST(Accuracy, WritesPageAndFigures) {
    const TemporaryFolder folder;
    const Result result = accuracy({"--seed", "5", "--out", (folder / "out").string(), "--format", "json"});
    ASSERT_EQ(result.status, 0) << result.both();
    EXPECT_EQ(json::parse(result.output), read_json(folder / "out/accuracy.json"));
    EXPECT_EQ(json::parse(result.output).at("seed"), 5);
    EXPECT_THAT(read(folder / "out/accuracy.html"), HasSubstr("<h1>What accuracy costs in time</h1>"));
    EXPECT_THAT(result.voice, HasSubstr("accuracy.html"));
}

TEST(Accuracy, PrintsTheFrontier) {
    const Result result = accuracy({});
    EXPECT_THAT(result.output, HasSubstr("Ray and sphere"));
    EXPECT_THAT(result.output, HasSubstr("Never to be wrong takes"));
}

TEST(Accuracy, ReplacesItsEarlierResultsOnlyWithForce) {
    const TemporaryFolder folder;
    write(folder / "out/accuracy.json", "earlier");
    const std::vector<std::string> arguments{"--out", (folder / "out").string()};
    const Result refused = accuracy(arguments);
    EXPECT_EQ(refused.status, usage);
    EXPECT_THAT(refused.voice, HasSubstr("--force"));
    EXPECT_EQ(read(folder / "out/accuracy.json"), "earlier");
    std::vector<std::string> forced = arguments;
    forced.emplace_back("--force");
    EXPECT_EQ(accuracy(forced).status, 0);
    EXPECT_NE(read(folder / "out/accuracy.json"), "earlier");
}

TEST(Accuracy, ExaminesAnAssignmentWithoutMeasuringRays) {
    const Result result = raygrade({"accuracy", "--assignment", "a6-2021"});
    EXPECT_EQ(result.status, 0) << result.both();
    EXPECT_THAT(result.output, HasSubstr("triangle: t is exactly 0"));
    EXPECT_THAT(result.output, Not(HasSubstr("rays of each distribution")));
}

TEST(Accuracy, RefusesAnUnknownMethod) {
    const Result result = accuracy({"--kernel", "nonsense"});
    EXPECT_EQ(result.status, usage);
    EXPECT_THAT(result.voice, HasSubstr("nonsense"));
    const Result none = raygrade({"accuracy", "--kernel", "certified", "--assignment", "a6-2021"});
    EXPECT_EQ(none.status, usage);
    EXPECT_THAT(none.voice, HasSubstr("--out"));
}

}  // namespace
}  // namespace scenario
