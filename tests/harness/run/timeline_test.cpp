#include "harness/run/timeline.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <thread>

namespace {

using namespace std::chrono_literals;
using harness::Stage;
using harness::Timeline;

TEST(Timeline, AddsUpEachStage) {
    Timeline timeline;
    const auto begin = Timeline::Clock::now();
    timeline.add(Stage::build, "a", begin, begin + 700ms);
    timeline.add(Stage::build, "b", begin, begin + 500ms);
    timeline.add(Stage::run, "a", begin, begin + 3ms);
    EXPECT_EQ(timeline.total(Stage::build), 1200ms) << "two at a time count twice";
    EXPECT_EQ(timeline.total(Stage::run), 3ms);
    EXPECT_EQ(timeline.total(Stage::score), 0ms);
}

TEST(Timeline, MeasuresASpanToItsEnd) {
    Timeline timeline;
    {
        const Timeline::Span span(timeline, Stage::read, "a");
        std::this_thread::sleep_for(20ms);
    }
    EXPECT_GE(timeline.total(Stage::read), 20ms);
}

TEST(Timeline, WritesATraceWithARowForEachThread) {
    Timeline timeline;
    const auto begin = Timeline::Clock::now();
    timeline.add(Stage::build, "zo\xc3\xab \xff\x1b", begin, begin + 700ms);
    std::thread([&] { timeline.add(Stage::score, "b", begin + 1ms, begin + 3ms); }).join();
    const auto trace = nlohmann::json::parse(timeline.chrome_trace());
    ASSERT_EQ(trace["traceEvents"].size(), 2U);
    const auto& build = trace["traceEvents"][0];
    EXPECT_EQ(build["ph"], "X");
    EXPECT_EQ(build["name"], "build");
    EXPECT_EQ(build["dur"], 700000);
    EXPECT_EQ(build["args"]["of"], "zo\xc3\xab %FF%1B");
    const auto& score = trace["traceEvents"][1];
    EXPECT_EQ(score["dur"], 2000);
    EXPECT_EQ(score["ts"].get<long>() - build["ts"].get<long>(), 1000);
    EXPECT_NE(score["tid"], build["tid"]);
    EXPECT_EQ(score["pid"], build["pid"]);
}

TEST(Timeline, HoldsWhatIsAppended) {
    Timeline timeline, later;
    const auto begin = Timeline::Clock::now();
    timeline.add(Stage::build, "a", begin, begin + 7ms);
    later.add(Stage::build, "a (any scene)", begin + 9ms, begin + 12ms);
    later.finished = 1;
    timeline.append(later);
    EXPECT_EQ(timeline.total(Stage::build), 10ms);
    EXPECT_EQ(timeline.finished, 0U);
    EXPECT_EQ(nlohmann::json::parse(timeline.chrome_trace())["traceEvents"][1]["args"]["of"], "a (any scene)");
}

TEST(Timeline, WritesAnEmptyTrace) {
    EXPECT_EQ(nlohmann::json::parse(Timeline().chrome_trace())["traceEvents"].size(), 0U);
}

}  // namespace
