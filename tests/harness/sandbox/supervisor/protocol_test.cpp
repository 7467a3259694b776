#include "harness/sandbox/supervisor/protocol.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace std::chrono_literals;
using harness::from_arguments;
using harness::from_line;
using harness::SupervisorOrders;
using harness::SupervisorStatus;

SupervisorOrders some_orders() {
    return {.status_fd = 7,
            .lifeline_fd = 9,
            .tier = harness::Tier::landlock,
            .purpose = harness::Purpose::compile,
            .account = harness::Account{70000, 80000},
            .counted_alone = true,
            .has_input = true,
            .further_runs = {{10, 11, 12}, {13, 4, 5}},
            .readable = {"/usr/lib", "/a=b c"},
            .limits = {2s, 10s, 1ULL << 40, 3, 4, 0, 0, 16, 64},
            .working_directory = "/a folder=odd",
            .argv = {"/bin/program", "--", "x=y", ""}};
}

TEST(SupervisorProtocol, ReadsOrdersBackUnchanged) {
    const auto orders = from_arguments(to_arguments(some_orders()));
    ASSERT_TRUE(orders);
    EXPECT_EQ(to_arguments(*orders), to_arguments(some_orders()));
    EXPECT_EQ(orders->working_directory, "/a folder=odd");
    EXPECT_EQ(orders->argv, some_orders().argv);
    EXPECT_EQ(orders->tier, harness::Tier::landlock);
    EXPECT_EQ(orders->purpose, harness::Purpose::compile);
    ASSERT_TRUE(orders->account);
    EXPECT_EQ(orders->account->uid, 70000U);
    EXPECT_EQ(orders->account->gid, 80000U);
    EXPECT_TRUE(orders->counted_alone);
    EXPECT_TRUE(orders->has_input);
    EXPECT_EQ(orders->readable, some_orders().readable);
    ASSERT_EQ(orders->further_runs.size(), 2U);
    EXPECT_EQ(orders->further_runs[1].input, 13);
    EXPECT_EQ(orders->further_runs[1].output, 4);
    EXPECT_EQ(orders->further_runs[1].errors, 5);
    EXPECT_EQ(orders->limits.memory_bytes, 1ULL << 40);
    EXPECT_EQ(orders->limits.wall, 10s);
}

TEST(SupervisorProtocol, RefusesIncompleteOrders) {
    const auto complete = to_arguments(some_orders());
    const auto end_of_words = std::find(complete.begin(), complete.end(), "--");
    for (auto left_out = complete.begin(); left_out != end_of_words; ++left_out) {
        if (left_out->starts_with("readable=") || left_out->starts_with("uid=") ||
            left_out->starts_with("further-run="))
            continue;
        auto arguments = complete;
        arguments.erase(arguments.begin() + (left_out - complete.begin()));
        EXPECT_FALSE(from_arguments(arguments)) << *left_out;
    }
    EXPECT_FALSE(from_arguments({complete.begin(), end_of_words + 1})) << "no program";
    EXPECT_FALSE(from_arguments({}));
    for (const char* run : {"", "1", "1,2", "1,2,", "1,2,3,", "1,2,x", "1,2,3,4", ",1,2", "1;2;3"}) {
        auto arguments = complete;
        arguments.insert(arguments.begin(), std::string("further-run=") + run);
        EXPECT_FALSE(from_arguments(arguments)) << run;
    }
}

TEST(SupervisorProtocol, ReadsEveryStatusBackUnchanged) {
    for (int how = 0; how <= static_cast<int>(SupervisorStatus::How::not_executed); ++how) {
        SupervisorStatus status;
        status.how = static_cast<SupervisorStatus::How>(how);
        status.number = 139;
        status.step = "chdir";
        status.cpu = 1234us;
        status.wall = 5678us;
        status.peak_memory_bytes = 1ULL << 40;
        status.machine_ran_out_of_memory = how % 2 == 1;
        const auto read = from_line(to_line(status));
        ASSERT_TRUE(read);
        EXPECT_EQ(read->how, status.how);
        EXPECT_EQ(read->machine_ran_out_of_memory, status.machine_ran_out_of_memory);
        EXPECT_EQ(to_line(*read), to_line(status));
    }
}

TEST(SupervisorProtocol, RefusesALineThatIsNotAStatus) {
    const std::string line = to_line(SupervisorStatus{});
    for (std::size_t size = 0; size < line.size(); ++size) EXPECT_FALSE(from_line(line.substr(0, size))) << size;
    EXPECT_FALSE(from_line(line + line));
    EXPECT_FALSE(from_line("how=rebooted number=0 cpu-us=1 wall-us=1 peak-bytes=1 out-of-memory=0 step=\n"));
    EXPECT_FALSE(from_line("how=exited number=0x cpu-us=1 wall-us=1 peak-bytes=1 out-of-memory=0 step=\n"));
}

}  // namespace
