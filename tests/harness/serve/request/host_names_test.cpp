#include "harness/serve/request/host_names.h"

#include <gtest/gtest.h>

namespace harness::serve {
namespace {

Head asked_at(const std::string& host) {
    Head head;
    head.host = host;
    return head;
}

TEST(HostOf, TakesNamesAndAddressesWithAndWithoutAPort) {
    EXPECT_EQ(host_of("localhost:8080"), "localhost");
    EXPECT_EQ(host_of("Check.Example.edu"), "check.example.edu");
    EXPECT_EQ(host_of("127.0.0.1:80"), "127.0.0.1");
    EXPECT_EQ(host_of("[::1]:8080"), "::1");
}

TEST(HostOf, IsEmptyForAnythingElse) {
    for (const char* wrong : {"", ":80", "a b", "a:80:80", "a:99999999", "a:x", "[::1", "[::1]x", "[name]:80", "a/b",
                              "user@host", "a\"b", "<script>"}) {
        EXPECT_EQ(host_of(wrong), "") << wrong;
    }
}

TEST(IsForUs, AcceptsOnlyLoopbackAndGivenNamesOnLoopback) {
    const Reach reach{true, false, {"check.example.edu"}};
    for (const char* own :
         {"localhost:8080", "127.0.0.1:8080", "127.0.0.1", "[::1]:8080", "LOCALHOST", "check.example.edu:8080"}) {
        EXPECT_TRUE(is_for_us(asked_at(own), reach)) << own;
    }
    for (const char* other : {"evil.example", "evil.example:8080", "192.0.2.1:8080", "localhost.evil.example",
                              "127.0.0.1.evil.example", "", "xcheck.example.edu"}) {
        EXPECT_FALSE(is_for_us(asked_at(other), reach)) << other;
    }
}

TEST(IsForUs, AcceptsAnyAddressAndNoForeignNameForOtherMachines) {
    const Reach reach{false, false, {"lab"}};
    for (const char* own : {"192.0.2.1:8080", "[2001:db8::1]:8080", "localhost:8080", "lab:8080"})
        EXPECT_TRUE(is_for_us(asked_at(own), reach)) << own;
    EXPECT_FALSE(is_for_us(asked_at("evil.example:8080"), reach));
}

TEST(IsForUs, AcceptsOnlyGivenNamesBehindAProxy) {
    const Reach reach{true, true, {"check.example.edu"}};
    EXPECT_TRUE(is_for_us(asked_at("check.example.edu"), reach));
    EXPECT_FALSE(is_for_us(asked_at("127.0.0.1:8080"), reach));
    EXPECT_FALSE(is_for_us(asked_at("localhost"), reach));
}

TEST(IsFromUs, AcceptsOwnPagesAndClientsThatAreNoBrowsers) {
    Head head = asked_at("localhost:8080");
    EXPECT_TRUE(is_from_us(head, {}));  // curl
    head.origin = "http://localhost:8080";
    EXPECT_TRUE(is_from_us(head, {}));
    head.fetch_site = "same-origin";
    EXPECT_TRUE(is_from_us(head, {}));
}

TEST(IsFromUs, RefusesOtherSites) {
    for (const char* origin : {"http://evil.example", "http://localhost:8081", "https://localhost:8080", "null", "",
                               "http://127.0.0.1:8080", "http://localhost:8080.evil.example"}) {
        Head head = asked_at("localhost:8080");
        head.origin = origin;
        EXPECT_FALSE(is_from_us(head, {})) << origin;
    }
    for (const char* site : {"cross-site", "same-site", "whatever"}) {
        Head head = asked_at("localhost:8080");
        head.fetch_site = site;
        EXPECT_FALSE(is_from_us(head, {})) << site;
        head.origin = "http://localhost:8080";
        EXPECT_FALSE(is_from_us(head, {})) << site;
    }
}

TEST(IsFromUs, AcceptsHttpsPagesBehindAProxy) {
    Head head = asked_at("check.example.edu");
    head.origin = "https://check.example.edu";
    EXPECT_FALSE(is_from_us(head, {}));
    EXPECT_TRUE(is_from_us(head, {true, true, {"check.example.edu"}}));
}

}  // namespace
}  // namespace harness::serve
