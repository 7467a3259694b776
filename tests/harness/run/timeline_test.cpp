#include "harness/run/timeline.h"

#include <gmock/gmock.h>

#include <thread>

namespace {

using namespace std::chrono_literals;
using harness::Stage;
using harness::Timeline;

TEST(Timeline, AddsUpEachStage) {
    Timeline timeline;
    timeline.add(Stage::build, 700ms);
    timeline.add(Stage::build, 500ms);
    timeline.add(Stage::run, 3ms);
    EXPECT_EQ(timeline.total(Stage::build), 1200ms) << "two at a time count twice";
    EXPECT_EQ(timeline.count(Stage::build), 2U);
    EXPECT_EQ(timeline.total(Stage::run), 3ms);
    EXPECT_EQ(timeline.total(Stage::score), 0ms);
}

TEST(Timeline, MeasuresASpanToItsEnd) {
    Timeline timeline;
    {
        const Timeline::Span span(timeline, Stage::read);
        std::this_thread::sleep_for(20ms);
    }
    EXPECT_GE(timeline.total(Stage::read), 20ms);
}

}  // namespace
