#include "harness/run/limits.h"

#include <gmock/gmock.h>

#include <sstream>
#include <string>
#include <tuple>

#include "tests/given/bytes_of.h"
#include "tests/given/message_of.h"

namespace {

using namespace std::chrono_literals;
using harness::describe_limits;
using harness::LimitDescription;
using harness::read_limits;
using testing::AllOf;
using testing::HasSubstr;

reference::LimitEntry entry(const std::string& name, double value) {
    return {name, value, "a.toml:7: limits." + name};
}

std::string why_not(const std::vector<reference::LimitEntry>& from_assignment,
                    const std::vector<std::string>& from_command_line) {
    return message_of<std::runtime_error>([&] { read_limits(from_assignment, from_command_line); }, "accepted");
}

TEST(ReadLimits, HasTheDefaultsOfTheManual) {
    const auto [compile, run] = read_limits({}, {});
    EXPECT_EQ(std::tie(run.cpu, run.wall, run.processes, run.open_files), std::make_tuple(2s, 10s, 16, 64));
    EXPECT_EQ(std::tie(run.memory_bytes, run.file_bytes, run.stack_bytes, run.output_bytes, run.error_bytes),
              std::make_tuple(256U << 20U, 16U << 20U, 64U << 20U, 1U << 20U, 64U << 10U));
    EXPECT_EQ(std::tie(compile.cpu, compile.memory_bytes, compile.file_bytes, compile.error_bytes),
              std::make_tuple(20s, 1U << 30U, 64U << 20U, 64U << 10U));
}

TEST(ReadLimits, OverridesTheAssignmentsLimitsByTheCommandLines) {
    const auto limits = read_limits({entry("run.cpu_seconds", 1.5), entry("run.memory_mib", 64)},
                                    {"run.memory_mib=128", "compile.processes=48"});
    EXPECT_EQ(limits.run.cpu, 1500ms);
    EXPECT_EQ(limits.run.memory_bytes, 128ULL << 20);
    EXPECT_EQ(limits.compile.processes, 48);
}

TEST(ReadLimits, SetsEveryNamedLimit) {
    const auto defaults = read_limits({}, {});
    for (const LimitDescription& limit : describe_limits()) {
        const auto changed = read_limits({}, {limit.name + "=9"});
        const auto bytes = [](const harness::StageLimits& all) {
            std::ostringstream text;
            for (const auto& one : {all.compile, all.run}) {
                text << one.cpu.count() << ' ' << one.wall.count() << ' ' << one.memory_bytes << ' ' << one.file_bytes
                     << ' ' << one.stack_bytes << ' ' << one.output_bytes << ' ' << one.error_bytes << ' '
                     << one.processes << ' ' << one.open_files << ' ';
            }
            return text.str();
        };
        EXPECT_NE(bytes(changed), bytes(defaults)) << limit.name;
    }
    EXPECT_EQ(describe_limits().size(), 18U);
}

TEST(ReadLimits, SetsTheWallTimeToFiveTimesTheCpuTimeByDefault) {
    EXPECT_EQ(read_limits({}, {"run.cpu_seconds=10"}).run.wall, 50s);
    EXPECT_EQ(read_limits({}, {"run.cpu_seconds=1"}).run.wall, 10s);
    EXPECT_EQ(read_limits({}, {"run.cpu_seconds=10", "run.wall_seconds=12"}).run.wall, 12s);
    EXPECT_EQ(read_limits({entry("run.wall_seconds", 12)}, {"run.cpu_seconds=10"}).run.wall, 12s);
}

TEST(ReadLimits, ReportsMistakesWithTheirPlace) {
    EXPECT_THAT(why_not({entry("run.cpu", 1)}, {}),
                AllOf(HasSubstr("a.toml:7: limits.run.cpu is not a limit"), HasSubstr("run.cpu_seconds")));
    EXPECT_EQ(why_not({entry("run.cpu_seconds", 0)}, {}),
              "a.toml:7: limits.run.cpu_seconds must be a number from 0.01 to 86400");
    EXPECT_EQ(why_not({entry("run.processes", 1.5)}, {}),
              "a.toml:7: limits.run.processes must be a whole number from 1 to 4096");
    EXPECT_THAT(why_not({}, {"run.cpu_seconds"}), HasSubstr("run.cpu_seconds needs a value"));
    EXPECT_EQ(why_not({}, {"run.cpu_seconds=fast"}), "--limit run.cpu_seconds is \"fast\", which is not a number");
    EXPECT_EQ(why_not({}, {"run.cpu_seconds=nan"}), "--limit run.cpu_seconds must be a number from 0.01 to 86400");
    EXPECT_THAT(why_not({}, {"=3"}), HasSubstr("is not a limit"));
}

TEST(ReadLimits, SuggestsTheStageForALimitWithoutItOrWithAWrongOne) {
    const std::string meant = "is not a limit; did you mean run.cpu_seconds or compile.cpu_seconds?";
    EXPECT_EQ(why_not({entry("cpu_seconds", 3)}, {}), "a.toml:7: limits.cpu_seconds " + meant);
    EXPECT_EQ(why_not({}, {"build.cpu_seconds=3"}), "--limit build.cpu_seconds " + meant);
}

TEST(ReadLimits, SuggestsTheNearestNameOfAStage) {
    EXPECT_EQ(why_not({entry("run.cpu_second", 3)}, {}),
              "a.toml:7: limits.run.cpu_second is not a limit; did you mean run.cpu_seconds?");
    EXPECT_THAT(why_not({}, {"compile.colour=3"}),
                AllOf(HasSubstr("is not a limit; there are run.cpu_seconds, "), HasSubstr("compile.memory_mib")));
}

}  // namespace
