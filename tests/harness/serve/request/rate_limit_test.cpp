#include "harness/serve/request/rate_limit.h"

#include <gtest/gtest.h>

namespace harness::serve {
namespace {

using namespace std::chrono_literals;

const RateLimit::Clock::time_point start{1000s};

TEST(RateLimit, AllowsABurstAndThenAnEvenRate) {
    RateLimit rate(6, 3);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(rate.wait_of("a", start), 0s) << i;
        rate.take("a", start);
    }
    EXPECT_EQ(rate.wait_of("a", start), 10s);
    EXPECT_EQ(rate.wait_of("a", start + 9s), 1s);
    EXPECT_EQ(rate.wait_of("a", start + 10s), 0s);
    rate.take("a", start + 10s);
    EXPECT_EQ(rate.wait_of("a", start + 10s), 10s);
}

TEST(RateLimit, NeverSavesUpMoreThanABurst) {
    RateLimit rate(60, 2);
    rate.take("a", start);
    for (int i = 0; i < 2; ++i) rate.take("a", start + 1h);
    EXPECT_EQ(rate.wait_of("a", start + 1h), 1s);
}

TEST(RateLimit, KeepsClientsApart) {
    RateLimit rate(1, 1);
    rate.take("a", start);
    EXPECT_GT(rate.wait_of("a", start), 0s);
    EXPECT_EQ(rate.wait_of("b", start), 0s);
}

TEST(RateLimit, RemembersABoundedNumberOfRecentClients) {
    RateLimit rate(1, 1, 100);
    for (int i = 0; i < 1000; ++i) {
        rate.take(std::to_string(i), start + std::chrono::milliseconds(i));
        ASSERT_LE(rate.remembered(), 100U);
    }
    EXPECT_GT(rate.wait_of("999", start + 1s), 0s);
    EXPECT_GT(rate.wait_of("960", start + 1s), 0s);
    EXPECT_EQ(rate.wait_of("1", start + 1s), 0s);
}

TEST(RateLimit, ForgetsFullBucketsFirst) {
    RateLimit rate(60, 1, 3);
    rate.take("old", start);
    rate.take("new 1", start + 10s);
    rate.take("new 2", start + 10s);
    rate.take("new 3", start + 10s);
    EXPECT_EQ(rate.remembered(), 3U);
    EXPECT_GT(rate.wait_of("new 1", start + 10s), 0s);
}

TEST(RateLimit, CountsAnIPv6NetworkAsOneClient) {
    EXPECT_EQ(client_of("192.0.2.7"), "192.0.2.7");
    EXPECT_EQ(client_of("::ffff:192.0.2.7"), "192.0.2.7");
    EXPECT_EQ(client_of("2001:db8:1:2:aaaa::1"), client_of("2001:db8:1:2:bbbb::2"));
    EXPECT_NE(client_of("2001:db8:1:2::1"), client_of("2001:db8:1:3::1"));
    EXPECT_EQ(client_of("no address"), "no address");
}

}  // namespace
}  // namespace harness::serve
