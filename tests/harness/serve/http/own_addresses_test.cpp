#include "harness/serve/http/own_addresses.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/serve/request/host_names.h"

namespace harness::serve {
namespace {

using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(WebAddress, WritesIPv6InBrackets) {
    EXPECT_EQ(web_address("192.168.1.20", 8080), "http://192.168.1.20:8080/");
    EXPECT_EQ(web_address("::1", 80), "http://[::1]:80/");
}

TEST(WebAddresses, GiveTheSingleAddress) {
    EXPECT_THAT(web_addresses("192.168.1.20", 8080), ElementsAre("http://192.168.1.20:8080/"));
    EXPECT_THAT(web_addresses("localhost", 8080), ElementsAre("http://localhost:8080/"));
}

TEST(WebAddresses, GiveTheAddressesThatABrowserCanOpen) {
    const std::vector<std::string> v4 = web_addresses("0.0.0.0", 8080), both = web_addresses("::", 8080);
    EXPECT_THAT(v4, Not(IsEmpty()));
    EXPECT_THAT(v4, Each(AllOf(Not(HasSubstr("0.0.0.0")), Not(HasSubstr("[")), HasSubstr(":8080/"))));
    EXPECT_THAT(both, Each(Not(HasSubstr("[::]"))));
    EXPECT_GE(both.size(), v4.size());
    for (const std::string& own : own_addresses()) {
        EXPECT_FALSE(is_loopback(own)) << own;
        EXPECT_THAT(both, testing::Contains(web_address(own, 8080)));
    }
}

TEST(OwnName, IsValidInARequest) {
    const std::string name = own_name();
    EXPECT_EQ(host_of(name), name);
    EXPECT_FALSE(is_loopback(name));
}

}  // namespace
}  // namespace harness::serve
