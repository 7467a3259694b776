#include "harness/sandbox/shim_protocol.h"

#include <gtest/gtest.h>

namespace {

using namespace std::chrono_literals;
using harness::from_arguments;
using harness::from_line;
using harness::ShimOrders;
using harness::ShimStatus;

ShimOrders some_orders() {
    return {.status_fd = 7,
            .lifeline_fd = 9,
            .limits = {2s, 10s, 1ULL << 40, 3, 4, 0, 0, 16, 64},
            .working_directory = "/a folder=odd",
            .argv = {"/bin/program", "--", "x=y", ""}};
}

TEST(ShimProtocol, GivesOrdersBackAsTheyWere) {
    const auto orders = from_arguments(to_arguments(some_orders()));
    ASSERT_TRUE(orders);
    EXPECT_EQ(to_arguments(*orders), to_arguments(some_orders()));
    EXPECT_EQ(orders->working_directory, "/a folder=odd");
    EXPECT_EQ(orders->argv, some_orders().argv);
    EXPECT_EQ(orders->limits.memory_bytes, 1ULL << 40);
    EXPECT_EQ(orders->limits.wall, 10s);
}

TEST(ShimProtocol, RefusesIncompleteOrders) {
    const auto complete = to_arguments(some_orders());
    for (std::size_t left_out = 0; left_out <= 10; ++left_out) {
        auto arguments = complete;
        arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(left_out));
        if (left_out == 10) arguments = {complete.begin(), complete.begin() + 11};
        EXPECT_FALSE(from_arguments(arguments)) << complete[left_out];
    }
    EXPECT_FALSE(from_arguments({}));
}

TEST(ShimProtocol, GivesEveryStatusBackAsItWas) {
    for (int how = 0; how <= static_cast<int>(ShimStatus::How::not_executed); ++how) {
        ShimStatus status;
        status.how = static_cast<ShimStatus::How>(how);
        status.number = 139;
        status.step = "chdir";
        status.cpu = 1234us;
        status.wall = 5678us;
        status.peak_memory_bytes = 1ULL << 40;
        const auto read = from_line(to_line(status));
        ASSERT_TRUE(read);
        EXPECT_EQ(read->how, status.how);
        EXPECT_EQ(to_line(*read), to_line(status));
    }
}

TEST(ShimProtocol, RefusesALineThatIsNotAStatus) {
    const std::string line = to_line(ShimStatus{});
    for (std::size_t size = 0; size < line.size(); ++size) EXPECT_FALSE(from_line(line.substr(0, size))) << size;
    EXPECT_FALSE(from_line(line + line));
    EXPECT_FALSE(from_line("how=rebooted number=0 cpu-us=1 wall-us=1 peak-bytes=1 step=\n"));
    EXPECT_FALSE(from_line("how=exited number=0x cpu-us=1 wall-us=1 peak-bytes=1 step=\n"));
}

}  // namespace
