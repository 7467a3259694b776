#include "harness/class_run/progress.h"

#include <gmock/gmock.h>

namespace {

using namespace std::chrono_literals;
using harness::progress_text;

TEST(ProgressText, GivesRateAndTimeLeft) {
    EXPECT_EQ(progress_text(40, 100, 20s), "40 of 100, 2.0 a second, 30 s left");
    EXPECT_EQ(progress_text(100, 10000, 1s), "100 of 10000, 100 a second, 99 s left");
    EXPECT_EQ(progress_text(10, 10000, 10s), "10 of 10000, 1.0 a second, 166 min left");
}

TEST(ProgressText, OmitsTheRateBeforeTheFirstAndTheTimeLeftAfterTheLast) {
    EXPECT_EQ(progress_text(0, 100, 5s), "0 of 100");
    EXPECT_EQ(progress_text(100, 100, 50s), "100 of 100, 2.0 a second");
    EXPECT_EQ(progress_text(0, 0, 0s), "0 of 0");
    EXPECT_EQ(progress_text(3, 5, 0s), "3 of 5");
}

TEST(ShareText, GivesTheTimeLeftOnceWorkIsDone) {
    EXPECT_EQ(harness::share_text(0, 5s), "0 %");
    EXPECT_EQ(harness::share_text(0.25, 10s), "25 %, 30 s left");
    EXPECT_EQ(harness::share_text(1, 40s), "100 %");
}

}  // namespace
