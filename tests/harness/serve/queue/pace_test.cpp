#include "harness/serve/queue/pace.h"

#include <gtest/gtest.h>

namespace harness::serve {
namespace {

using Seconds = Pace::Seconds;

TEST(Pace, IsUnknownBeforeTheFirstProgram) {
    EXPECT_FALSE(Pace().wait(1, 2));
}

TEST(Pace, CountsTheRoundsAheadAndTheOneAtWork) {
    Pace pace;
    pace.took(Seconds(2));
    EXPECT_EQ(pace.wait(1, 2), Seconds(4));
    EXPECT_EQ(pace.wait(2, 2), Seconds(4));
    EXPECT_EQ(pace.wait(3, 2), Seconds(6));
    EXPECT_EQ(pace.wait(3, 0), Seconds(8)) << "as many as one";
}

TEST(Pace, FollowsWhatProgramsTookLately) {
    Pace pace;
    pace.took(Seconds(2));
    pace.took(Seconds(6));
    EXPECT_EQ(pace.wait(1, 1), Seconds(6)) << "twice the mean of 3";
}

}  // namespace
}  // namespace harness::serve
